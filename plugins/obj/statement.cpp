#include "statement.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace candela_plugins::obj {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

namespace {

std::string_view firstWord(std::string_view text) {
    std::size_t end = 0;
    while (end < text.size() && !isBlank(text[end])) ++end;
    return text.substr(0, end);
}

}  // namespace

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        words.push_back(firstWord(text));
        text.remove_prefix(words.back().size());
    }
    return words;
}

std::string_view textOf(const Bytes& file) {
    return {reinterpret_cast<const char*>(file.data), static_cast<std::size_t>(file.size)};
}

bool isUtf16(std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return true;
    // Without a mark: of ASCII characters every other byte is 0.
    constexpr std::size_t probed = 16;
    if (text.size() < probed) return false;
    std::size_t zeros[2] = {0, 0};
    for (std::size_t i = 0; i < probed; ++i) zeros[i % 2] += text[i] == '\0';
    return (zeros[0] == 0 && zeros[1] == probed / 2) || (zeros[1] == 0 && zeros[0] == probed / 2);
}

Lines::Lines(std::string_view text) : text_(text) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(byteOrderMark)) position_ = byteOrderMark.size();
    newline_ = std::min(text_.find('\n', position_), text_.size());
}

std::string_view Lines::physicalLine() {
    linesRead_ += 1 + emptyLines_;
    emptyLines_ = 0;
    const std::string_view line = text_.substr(position_, newline_ - position_);
    const std::size_t end = line.find('\r');
    const std::size_t next = end == line.npos ? line.npos : line.find_first_not_of('\r', end);
    if (next != line.npos) {
        emptyLines_ = next - end - 1;
        position_ += next;
        return trimmed(line.substr(0, end));
    }
    // Carriage returns before a line feed belong to it.
    position_ = std::min(newline_ + 1, text_.size());
    newline_ = std::min(text_.find('\n', position_), text_.size());
    return trimmed(line.substr(0, end));
}

void Lines::joinContinued(std::string_view first) {
    joined_.assign(first.substr(0, first.size() - 1));
    bool continues = true;
    while (continues && position_ < text_.size()) {
        std::string_view more = physicalLine();
        continues = more.ends_with('\\');
        if (continues) more.remove_suffix(1);
        joined_ += ' ';
        joined_ += more;
    }
    line_ = trimmed(joined_);
}

namespace {

/// "map_Kd C:\textures\" ends with a folder.
bool endsInPath(std::string_view line) {
    constexpr std::string_view keywords[] = {"map_", "mtllib", "bump", "disp", "decal", "refl", "norm"};
    if (line.size() < 2 || isBlank(line[line.size() - 2])) return false;
    return std::any_of(std::begin(keywords), std::end(keywords),
                       [&](std::string_view keyword) { return line.starts_with(keyword); });
}

}  // namespace

bool Lines::next() {
    while (position_ < text_.size()) {
        const std::string_view line = physicalLine();
        number_ = linesRead_;
        // A backslash at the end of a comment, often part of a path, does not continue it.
        if (line.empty() || line.front() == '#') continue;
        line_ = line;
        if (line.ends_with('\\') && !endsInPath(line)) joinContinued(line);
        if (!line_.empty()) return true;
    }
    return false;
}

namespace {

std::string_view withoutPlus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

std::string inQuotes(std::string_view text) {
    return "'" + readable(std::string(text)) + "'";
}

std::optional<double> numberIn(std::string_view word) {
    const std::string_view digits = withoutPlus(word);
    const char* const end = digits.data() + digits.size();
    double value = 0.0;
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc::result_out_of_range) {
        // Overflow and underflow are reported alike, and leave the value unchanged.
        const bool tiny = digits.find("e-") != digits.npos || digits.find("E-") != digits.npos;
        return tiny ? 0.0 : HUGE_VAL;
    }
    return value;
}

std::optional<double> numberWithCommaIn(std::string_view word) {
    const std::size_t comma = word.find(',');
    if (comma == word.npos || word.find('.') != word.npos) return std::nullopt;
    std::string text(word);
    text[comma] = '.';
    return numberIn(text);
}

std::optional<std::int64_t> integerIn(std::string_view word) {
    const std::string_view digits = withoutPlus(word);
    const char* const end = digits.data() + digits.size();
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
    using Limits = std::numeric_limits<std::int64_t>;
    if (error == std::errc::result_out_of_range) return digits[0] == '-' ? Limits::min() : Limits::max();
    return value;
}

Statement::Statement(std::string_view line, std::size_t lineNumber, const std::string& file)
    : keyword_(firstWord(line)),
      rest_(trimmed(line.substr(keyword_.size()))),
      lineNumber_(lineNumber),
      file_(&file) {}

std::optional<std::string_view> Statement::word() {
    if (rest_.empty() || rest_.front() == '#') return std::nullopt;
    const std::string_view found = firstWord(rest_);
    rest_.remove_prefix(found.size());
    while (!rest_.empty() && isBlank(rest_.front())) rest_.remove_prefix(1);
    return found;
}

std::size_t Statement::wordsLeft() const {
    Statement copy(*this);
    std::size_t count = 0;
    while (copy.word()) ++count;
    return count;
}

std::string_view Statement::needWord(const char* what) {
    const auto found = word();
    if (!found) fail(std::string(what) + " was expected, but the line ends");
    return *found;
}

float Statement::needNumber(double limit) {
    return number(needWord("a number"), limit);
}

float Statement::number(std::string_view word, double limit) const {
    const std::optional<double> value = numberIn(word);
    if (!value) fail(inQuotes(word) + " is not a number");
    if (!(std::abs(*value) <= limit)) {
        char bound[32];
        const auto end = std::to_chars(bound, bound + sizeof bound, limit).ptr;
        fail(inQuotes(word) + ", but a number of at most " + std::string(bound, end) + " was expected");
    }
    return static_cast<float>(*value);
}

std::int64_t Statement::integer(std::string_view word) const {
    const std::optional<std::int64_t> value = integerIn(word);
    if (!value) fail(inQuotes(word) + " is not a whole number");
    return *value;
}

std::string Statement::place() const {
    const std::string line = "line " + std::to_string(lineNumber_);
    return file_->empty() ? line : readable(*file_) + ", " + line;
}

Failure Statement::failure(const std::string& reason) const {
    return Failure{place(), readable(std::string(keyword_)) + ": " + reason};
}

void LineNotes::count(candela_note_kind kind, std::string_view text, std::size_t line) {
    for (Entry& entry : entries_) {
        if (entry.kind != kind || entry.text != text) continue;
        ++entry.count;
        return;
    }
    entries_.push_back({kind, std::string(text), 1, line});
}

void LineNotes::countUnknown(std::string_view name, std::size_t line) {
    // A file that is no OBJ file at all has many of them.
    constexpr std::size_t maxNames = 32;
    const auto known = std::find_if(unknown_.begin(), unknown_.end(),
                                    [&](const Entry& entry) { return entry.text == name; });
    if (known != unknown_.end())
        ++known->count;
    else if (unknown_.size() < maxNames)
        unknown_.push_back({CANDELA_NOTE_INFORMATION, std::string(name), 1, line});
    else
        ++otherUnknown_;
}

namespace {

std::string times(std::size_t count, std::size_t firstLine) {
    const std::string often =
        count == 1 ? "once, in line " : std::to_string(count) + " times, first in line ";
    return " (" + often + std::to_string(firstLine) + ")";
}

}  // namespace

void LineNotes::add(const Host& host, const std::string& file) const {
    const std::string element = readable(file);
    for (const Entry& entry : entries_)
        host.note(entry.kind, element, entry.text + times(entry.count, entry.firstLine));
    for (const Entry& entry : unknown_)
        host.note(entry.kind, element,
                  "not known: " + readable(entry.text) + times(entry.count, entry.firstLine));
    if (otherUnknown_ > 0) {
        host.note(CANDELA_NOTE_INFORMATION, element,
                  "not known: " + std::to_string(otherUnknown_) + " statements of other kinds");
    }
}

void noteMissingUvs(std::size_t corners, const Host& host) {
    if (corners == 0) return;
    host.note(CANDELA_NOTE_REPAIRED, "",
              std::to_string(corners) + " corners have no texture coordinate and take (0, 0)");
}

}  // namespace candela_plugins::obj
