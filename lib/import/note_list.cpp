#include "import/note_list.h"

#include "import/text.h"

#include <candela/error.h>

#include <algorithm>

namespace candela {
namespace {

constexpr std::size_t maxNotes = 1000;

}  // namespace

std::string ImportNote::line() const {
    if (elements.empty()) return count > 1 ? joined(text, " (", count, " times)") : text;
    const std::string others = count > 1 ? joined(" and ", count - 1, " more") : std::string();
    return elements.front() + others + ": " + text;
}

void NoteList::add(NoteKind kind, const std::string& element, const std::string& text) {
    // Neither an element nor a text holds a line break.
    const std::string key = joined(static_cast<int>(kind), element.empty() ? "\n" : "\n\n", text);
    const auto [found, isNew] = indices_.try_emplace(key, notes_.size());
    if (isNew) notes_.push_back({kind, text, {}, 0});
    ImportNote& note = notes_[found->second];
    if (!element.empty()) {
        if (!elementKeys_.insert(joined(found->second, "\n", element)).second) return;
        note.elements.push_back(element);
    }
    ++note.count;
}

std::vector<ImportNote> NoteList::take() {
    std::vector<ImportNote> notes = std::move(notes_);
    *this = {};
    std::ranges::stable_sort(notes, [](const ImportNote& a, const ImportNote& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.count > b.count;
    });
    if (notes.size() <= maxNotes) return notes;
    const std::size_t leftOut = notes.size() - maxNotes;
    notes.resize(maxNotes);
    notes.push_back({NoteKind::information, joined("and ", leftOut, " more notes"), {}, 1});
    return notes;
}

void refuseLosses(const std::vector<ImportNote>& notes, const std::string& uri) {
    if (notes.empty() || notes.front().kind == NoteKind::information) return;
    const auto losses = std::ranges::count_if(
        notes, [](const ImportNote& note) { return note.kind != NoteKind::information; });
    const std::string others = losses > 1 ? joined(" (and ", losses - 1, " more notes)") : std::string();
    throw Error(ErrorKind::badInput, uri, notes.front().line() + others);
}

}  // namespace candela
