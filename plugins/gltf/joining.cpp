#include "joining.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace candela_gltf {
namespace {

int compare(const Rows& rows, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t* first = rows.words.data() + a * rows.width;
    const std::uint32_t* second = rows.words.data() + b * rows.width;
    const auto [x, y] = std::mismatch(first, first + rows.width, second);
    if (x == first + rows.width) return 0;
    return *x < *y ? -1 : 1;
}

}  // namespace

JoinedRows joinRows(const Rows& rows) {
    std::vector<std::uint32_t> order(rows.count());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const int sign = compare(rows, a, b);
        return sign != 0 ? sign < 0 : a < b;
    });

    // The first row that equals each row; then the numbers of the first rows.
    JoinedRows joined;
    joined.groups.resize(order.size());
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || compare(rows, order[i - 1], order[i]) != 0) first = order[i];
        joined.groups[order[i]] = first;
    }
    for (std::uint32_t row = 0; row < joined.groups.size(); ++row) {
        const std::uint32_t equal = joined.groups[row];
        joined.groups[row] =
            equal == row ? static_cast<std::uint32_t>(joined.firsts.size()) : joined.groups[equal];
        if (equal == row) joined.firsts.push_back(row);
    }
    return joined;
}

std::uint32_t bitsOf(float number) {
    return std::bit_cast<std::uint32_t>(number == 0.0f ? 0.0f : number);
}

}  // namespace candela_gltf
