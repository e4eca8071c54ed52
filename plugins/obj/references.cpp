#include "references.h"

#include <algorithm>
#include <charconv>

#include "statement.h"

namespace candela_plugins::obj {
namespace {

std::string withoutQuotes(std::string_view name) {
    name = trimmed(name);
    if (name.size() >= 2 && name.front() == name.back() && (name.front() == '"' || name.front() == '\''))
        name = trimmed(name.substr(1, name.size() - 2));
    return std::string(name);
}

std::string withSlashes(std::string path) {
    std::replace(path.begin(), path.end(), '\\', '/');
    while (path.starts_with("./")) path.erase(0, 2);
    return path;
}

std::string folderOf(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == path.npos ? "" : path.substr(0, slash + 1);
}

/// Also those of Windows: "C:\maps\wood.png" and "C:wood.png".
bool isAbsolute(std::string_view path) {
    const bool hasDrive = path.size() >= 2 && path[1] == ':';
    return path.starts_with('/') || hasDrive || path.find("://") != path.npos;
}

std::string bareName(const std::string& path) {
    return path.substr(path.find_last_of(isAbsolute(path) ? "/:" : "/") + 1);
}

/// The paths at which a file may be, the likeliest first.
struct Candidates {
    std::vector<std::string> asNamed, byBareName;
};

void addOnce(const std::string& path, std::vector<std::string>& paths) {
    if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
}

void addCandidates(const std::string& folder, const std::string& name, Candidates& candidates) {
    const std::string path = withSlashes(name), bare = bareName(path);
    if (!isAbsolute(path)) {
        addOnce(folder + path, candidates.asNamed);
        addOnce(path, candidates.asNamed);
        // An archive that was unpacked on another system may hold a file with backslashes in its name.
        if (path != name) addOnce(folder + name, candidates.asNamed);
    }
    if (bare.empty()) return;
    addOnce(folder + bare, candidates.byBareName);
    addOnce(bare, candidates.byBareName);
}

/// "my%20wood.png" as "my wood.png".
std::string percentDecoded(const std::string& text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned code = 0;
        const char* const digits = text.data() + i + 1;
        const bool isCode = text[i] == '%' && i + 2 < text.size() &&
                            std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2 && code >= 0x20;
        decoded += isCode ? static_cast<char>(code) : text[i];
        if (isCode) i += 2;
    }
    return decoded;
}

/// Bytes from 0x80 on are characters of ISO 8859-1, which older programs write.
std::string utf8OfLatin1(const std::string& text) {
    std::string utf8;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code >= 0x80) utf8 += static_cast<char>(0xC0u | code >> 6u);
        utf8 += code < 0x80 ? c : static_cast<char>(0x80u | (code & 0x3Fu));
    }
    return utf8;
}

Candidates candidatesOf(const std::string& owner, const std::string& name) {
    Candidates candidates;
    for (const std::string& spelling : {name, percentDecoded(name), utf8OfLatin1(name)})
        addCandidates(folderOf(owner), spelling, candidates);
    return candidates;
}

/// The reason of the host without the name of the file, which the note has in its element.
std::string reasonAlone(const std::string& reason, const std::string& path) {
    const std::string name = "file '" + path + "': ";
    return reason.starts_with(name) ? reason.substr(name.size()) : reason;
}

/// Its `reason` is that of the first path.
ReferencedFile firstOf(const std::vector<std::string>& paths, const Host& host) {
    ReferencedFile result;
    for (const std::string& path : paths) {
        try {
            return {host.readOptionalFile(path, ""), path, ""};
        } catch (const Failure& failure) {
            if (result.reason.empty()) result.reason = reasonAlone(failure.reason, path);
        }
    }
    return result;
}

}  // namespace

ReferencedFile findReferenced(const std::string& owner, std::string_view name, const std::string& element,
                              const Host& host) {
    const Candidates candidates = candidatesOf(owner, withoutQuotes(name));
    ReferencedFile named = firstOf(candidates.asNamed, host);
    if (named.bytes) return named;
    const ReferencedFile bare = firstOf(candidates.byBareName, host);
    if (bare.bytes) {
        host.note(CANDELA_NOTE_REPAIRED, element,
                  "not at this path: a file of this name in the scene's folder is read");
        return bare;
    }
    if (candidates.asNamed.empty())
        named.reason = "an absolute path, and the scene's folder has no file of this name";
    return named;
}

bool namesNoFile(std::string_view name) {
    const std::string path = withSlashes(withoutQuotes(name));
    return path.find_first_not_of("./") == path.npos;
}

std::vector<std::string> libraryNames(std::string_view rest) {
    std::vector<std::string> names;
    rest = trimmed(rest);
    for (std::size_t end = 0; end < rest.size();) {
        if (++end < rest.size() && !isBlank(rest[end])) continue;
        if (end < rest.size() && !lowerCase(rest.substr(0, end)).ends_with(".mtl")) continue;
        names.emplace_back(rest.substr(0, end));
        rest = trimmed(rest.substr(end));
        end = 0;
    }
    return names;
}

}  // namespace candela_plugins::obj
