#include "query.h"

#include <string_view>

namespace candela_obj {
namespace {

candela_scheme schemeOf(std::string_view name) {
    if (name == "catmullClark") return CANDELA_SCHEME_CATMULL_CLARK;
    if (name == "loop") return CANDELA_SCHEME_LOOP;
    if (name == "bilinear") return CANDELA_SCHEME_BILINEAR;
    throw Failure{"query", "subdivide=" + readable(std::string(name)) +
                               ", but catmullClark, loop or bilinear was expected"};
}

std::uint32_t levelOf(std::string_view digits) {
    if (digits.size() == 1 && digits[0] >= '1' && digits[0] <= '8')
        return static_cast<std::uint32_t>(digits[0] - '0');
    throw Failure{"query", "level=" + readable(std::string(digits)) + ", but 1 to 8 was expected"};
}

void readItem(std::string_view item, Query& query) {
    constexpr std::string_view scheme = "subdivide=", level = "level=";
    query.subdivide = true;
    if (item == "subdivide") return;
    if (item.starts_with(scheme)) {
        query.scheme = schemeOf(item.substr(scheme.size()));
    } else if (item.starts_with(level)) {
        query.level = levelOf(item.substr(level.size()));
    } else {
        throw Failure{"query", "'" + readable(std::string(item)) +
                                   "', but subdivide, subdivide=SCHEME or level=N was expected"};
    }
}

}  // namespace

Query parseQuery(const char* text) {
    Query query;
    if (!text) return query;
    std::string_view left = text;
    while (true) {
        const std::size_t end = left.find('&');
        readItem(left.substr(0, end), query);
        if (end == std::string_view::npos) return query;
        left.remove_prefix(end + 1);
    }
}

}  // namespace candela_obj
