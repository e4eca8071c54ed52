#include "file_names.h"

#include <algorithm>

#include "lines.h"

namespace candela_obj {
namespace {

bool endsInMtl(std::string_view text) {
    constexpr std::string_view ending = ".mtl";
    if (text.size() < ending.size()) return false;
    const std::string_view tail = text.substr(text.size() - ending.size());
    return std::equal(tail.begin(), tail.end(), ending.begin(),
                      [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); });
}

}  // namespace

std::vector<std::string> libraryNames(std::string_view rest) {
    std::vector<std::string> names;
    rest = trimmed(rest);
    for (std::size_t end = 0; end < rest.size();) {
        if (++end < rest.size() && !isBlank(rest[end])) continue;
        if (end < rest.size() && !endsInMtl(rest.substr(0, end))) continue;
        names.emplace_back(rest.substr(0, end));
        rest = trimmed(rest.substr(end));
        end = 0;
    }
    return names;
}

std::string besideFile(const std::string& owner, std::string_view name) {
    std::string path(name);
    std::replace(path.begin(), path.end(), '\\', '/');
    const std::size_t slash = owner.rfind('/');
    return slash == std::string::npos ? path : owner.substr(0, slash + 1) + path;
}

}  // namespace candela_obj
