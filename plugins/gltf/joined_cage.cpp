#include "joined_cage.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace candela_plugins::gltf {
namespace {

/// Keys of `width` words each; floating-point numbers are compared by their bits.
struct Keys {
    std::size_t width = 1;
    std::vector<std::uint32_t> words;

    std::size_t count() const { return words.size() / width; }
};

/// Which keys are equal. Distinct keys are numbered in the order in which they first appear.
struct JoinedKeys {
    std::vector<std::uint32_t> groups;  ///< A key: the number of the distinct key it equals.
    std::vector<std::uint32_t> firsts;  ///< A distinct key: the first key that equals it.
};

/// `keys` are at most 4294967295. The time does not depend on their values: they are sorted, not hashed.
JoinedKeys joinKeys(const Keys& keys);

/// The bits of a number, the same ones for 0 and -0.
std::uint32_t bitsOf(float number);

int compare(const Keys& keys, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t* first = keys.words.data() + a * keys.width;
    const std::uint32_t* second = keys.words.data() + b * keys.width;
    const auto [x, y] = std::mismatch(first, first + keys.width, second);
    if (x == first + keys.width) return 0;
    return *x < *y ? -1 : 1;
}

JoinedKeys joinKeys(const Keys& keys) {
    std::vector<std::uint32_t> order(keys.count());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const int sign = compare(keys, a, b);
        return sign != 0 ? sign < 0 : a < b;
    });

    // The first key that equals each key; then the numbers of the first keys.
    JoinedKeys joined;
    joined.groups.resize(order.size());
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || compare(keys, order[i - 1], order[i]) != 0) first = order[i];
        joined.groups[order[i]] = first;
    }
    for (std::uint32_t key = 0; key < joined.groups.size(); ++key) {
        const std::uint32_t equal = joined.groups[key];
        joined.groups[key] =
            equal == key ? static_cast<std::uint32_t>(joined.firsts.size()) : joined.groups[equal];
        if (equal == key) joined.firsts.push_back(key);
    }
    return joined;
}

std::uint32_t bitsOf(float number) {
    return std::bit_cast<std::uint32_t>(number == 0.0f ? 0.0f : number);
}

void appendBits(std::vector<std::uint32_t>& words, const std::vector<float>& numbers, std::size_t vertex,
                std::size_t width) {
    for (std::size_t i = 0; i < width; ++i) words.push_back(bitsOf(numbers[vertex * width + i]));
}

/// Vertices with equal keys are joined.
Keys vertexKeys(const CageVertices& vertices) {
    Keys keys;
    keys.width = 3 + 2 * std::size_t(vertices.influenceCount) + 3 * vertices.morphOffsets.size();
    keys.words.reserve(keys.width * vertices.count);
    for (std::size_t vertex = 0; vertex < vertices.count; ++vertex) {
        appendBits(keys.words, vertices.positions, vertex, 3);
        const auto joints =
            vertices.joints.begin() + static_cast<std::ptrdiff_t>(vertex * vertices.influenceCount);
        keys.words.insert(keys.words.end(), joints, joints + vertices.influenceCount);
        appendBits(keys.words, vertices.jointWeights, vertex, vertices.influenceCount);
        for (const std::vector<float>& offsets : vertices.morphOffsets) {
            appendBits(keys.words, offsets, vertex, 3);
        }
    }
    return keys;
}

bool hasDuplicates(std::vector<std::uint32_t> corners) {
    std::sort(corners.begin(), corners.end());
    return std::adjacent_find(corners.begin(), corners.end()) != corners.end();
}

/// Copies the faces without a repeated vertex. `corners` receives the corresponding corners of the source.
void takeFaces(const CageSource& source, const JoinedKeys& joined, JoinedCage& cage,
               std::vector<std::uint32_t>& corners) {
    std::size_t begin = 0;
    std::vector<std::uint32_t> face;
    for (std::size_t i = 0; i < source.faces.sizes.size(); ++i) {
        const std::span own = std::span(source.faces.corners).subspan(begin, source.faces.sizes[i]);
        begin += own.size();
        face.clear();
        for (const std::uint32_t corner : own) face.push_back(joined.groups[corner]);
        if (hasDuplicates(face)) {
            cage.cageFaces.push_back(notInCage);
            continue;
        }
        cage.cageFaces.push_back(static_cast<std::uint32_t>(cage.faceSizes.size()));
        cage.faceSizes.push_back(static_cast<std::uint32_t>(face.size()));
        cage.faceVertices.insert(cage.faceVertices.end(), face.begin(), face.end());
        cage.faceMaterials.push_back(source.faceMaterials[i]);
        corners.insert(corners.end(), own.begin(), own.end());
    }
}

/// Renumbers the vertices so that only those of faces are left, in the order of the file.
void takeVertices(const JoinedKeys& joined, JoinedCage& cage) {
    std::vector<std::uint32_t> numbers(joined.firsts.size(), notInCage);
    for (const std::uint32_t vertex : cage.faceVertices) numbers[vertex] = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] == notInCage) continue;
        numbers[i] = static_cast<std::uint32_t>(cage.vertices.size());
        cage.vertices.push_back(joined.firsts[i]);
    }
    for (std::uint32_t& vertex : cage.faceVertices) vertex = numbers[vertex];
    cage.cageVertices.reserve(joined.groups.size());
    for (const std::uint32_t group : joined.groups) cage.cageVertices.push_back(numbers[group]);
}

/// Corners at one vertex with the same texture coordinates share an index, others are a seam.
void takeUvs(const std::vector<float>& uvs, const std::vector<std::uint32_t>& corners, JoinedCage& cage) {
    if (uvs.empty()) return;
    Keys keys;
    keys.width = 3;
    keys.words.reserve(3 * corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        keys.words.push_back(cage.faceVertices[i]);
        appendBits(keys.words, uvs, corners[i], 2);
    }
    JoinedKeys joined = joinKeys(keys);
    cage.faceUvs = std::move(joined.groups);
    for (const std::uint32_t first : joined.firsts) {
        const std::size_t vertex = corners[first];
        cage.uvs.insert(cage.uvs.end(), {uvs[2 * vertex], uvs[2 * vertex + 1]});
    }
}

}  // namespace

JoinedCage joinCage(const CageSource& source) {
    const JoinedKeys joined = joinKeys(vertexKeys(source.vertices));
    JoinedCage cage;
    std::vector<std::uint32_t> corners;
    takeFaces(source, joined, cage, corners);
    takeVertices(joined, cage);
    takeUvs(source.vertices.uvs, corners, cage);
    return cage;
}

}  // namespace candela_plugins::gltf
