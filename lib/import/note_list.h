#pragma once

#include <candela/import.h>

#include <cstddef>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace candela {

/// Collects the notes of an import, and merges those of the same kind and text.
class NoteList {
  public:
    /// `element` and `text` are lines of valid UTF-8; `element` is empty where the note is about the file.
    void add(NoteKind kind, const std::string& element, const std::string& text);

    /// The notes in the order of `ImportReport::notes`. The list is empty afterwards.
    std::vector<ImportNote> take();

  private:
    std::vector<ImportNote> notes_;
    std::unordered_map<std::string, std::size_t> indices_;  ///< By kind and text.
    std::unordered_set<std::string> elementKeys_;           ///< Of a note's index and an element of it.
};

/// Throws `Error` (badInput) with the first of the notes, which are in the order of `ImportReport::notes`,
/// unless it is information. `uri` is the file at fault.
void refuseLosses(const std::vector<ImportNote>& notes, const std::string& uri);

}  // namespace candela
