#include "ignored_statements.h"

namespace candela_obj {

void IgnoredStatements::count(std::string_view what, std::string_view kind, std::size_t line) {
    // A file that is no OBJ file at all has many kinds.
    constexpr std::size_t maxKinds = 32;
    for (Kind& known : kinds_) {
        if (known.what != what || known.name != kind) continue;
        ++known.count;
        return;
    }
    if (kinds_.size() < maxKinds)
        kinds_.push_back({std::string(what), std::string(kind), 1, line});
    else
        ++others_;
}

void IgnoredStatements::note(const Host& host, const std::string& file) const {
    const std::string in = file.empty() ? "" : readable(file) + ": ";
    for (const Kind& kind : kinds_) {
        const std::string times =
            kind.count == 1 ? "once, in line " : std::to_string(kind.count) + " times, first in line ";
        host.note(in + kind.what + ": " + readable(kind.name) + " (" + times +
                  std::to_string(kind.firstLine) + ")");
    }
    if (others_ > 0) host.note(in + "not known: " + std::to_string(others_) + " statements of other kinds");
}

void noteMissingUvs(std::size_t corners, const Host& host) {
    if (corners > 0)
        host.note(std::to_string(corners) + " corners have no texture coordinate and take (0, 0)");
}

}  // namespace candela_obj
