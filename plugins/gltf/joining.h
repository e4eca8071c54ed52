#pragma once

#include <cstdint>
#include <vector>

namespace candela_gltf {

/// Rows of `width` words each; a floating-point number goes in by its bits.
struct Rows {
    std::size_t width = 1;
    std::vector<std::uint32_t> words;

    std::size_t count() const { return words.size() / width; }
};

/// Which rows are equal. Distinct rows are numbered in the order in which they first appear.
struct JoinedRows {
    std::vector<std::uint32_t> groups;  ///< A row: the number of the distinct row it equals.
    std::vector<std::uint32_t> firsts;  ///< A distinct row: the first row that equals it.
};

/// `rows` are at most 4294967295. The time does not depend on what is in them: they are sorted, not hashed.
JoinedRows joinRows(const Rows& rows);

/// The bits of a number, the same ones for 0 and -0.
std::uint32_t bitsOf(float number);

}  // namespace candela_gltf
