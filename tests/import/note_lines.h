#pragma once

#include <candela/import.h>

#include <string>
#include <vector>

using Lines = std::vector<std::string>;

/// The notes as programs print them.
inline Lines noteLines(const std::vector<candela::ImportNote>& notes) {
    Lines lines;
    for (const candela::ImportNote& note : notes) lines.push_back(note.line());
    return lines;
}

inline Lines noteLines(const candela::ImportedScene& imported) {
    return noteLines(imported.report.notes);
}
