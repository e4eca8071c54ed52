#include "joined_cage.h"

#include <algorithm>
#include <span>

#include "joining.h"

namespace candela_gltf {
namespace {

void appendBits(std::vector<std::uint32_t>& words, const std::vector<float>& numbers, std::size_t vertex,
                std::size_t width) {
    for (std::size_t i = 0; i < width; ++i) words.push_back(bitsOf(numbers[vertex * width + i]));
}

/// What makes two vertices the same one of the cage.
Rows vertexRows(const CageVertices& vertices) {
    Rows rows;
    rows.width = 3 + 2 * std::size_t(vertices.influenceCount) + 3 * vertices.morphOffsets.size();
    rows.words.reserve(rows.width * vertices.count);
    for (std::size_t vertex = 0; vertex < vertices.count; ++vertex) {
        appendBits(rows.words, vertices.positions, vertex, 3);
        const auto joints =
            vertices.joints.begin() + static_cast<std::ptrdiff_t>(vertex * vertices.influenceCount);
        rows.words.insert(rows.words.end(), joints, joints + vertices.influenceCount);
        appendBits(rows.words, vertices.jointWeights, vertex, vertices.influenceCount);
        for (const std::vector<float>& offsets : vertices.morphOffsets) {
            appendBits(rows.words, offsets, vertex, 3);
        }
    }
    return rows;
}

bool hasSeamVertices(std::vector<std::uint32_t> corners) {
    std::sort(corners.begin(), corners.end());
    return std::adjacent_find(corners.begin(), corners.end()) != corners.end();
}

/// Takes the faces that do not degenerate. `corners` gets the corners of the source that they keep.
void takeFaces(const CageSource& source, const JoinedRows& joined, JoinedCage& cage,
               std::vector<std::uint32_t>& corners) {
    std::size_t begin = 0;
    std::vector<std::uint32_t> face;
    for (std::size_t i = 0; i < source.faces.sizes.size(); ++i) {
        const std::span own = std::span(source.faces.corners).subspan(begin, source.faces.sizes[i]);
        begin += own.size();
        face.clear();
        for (const std::uint32_t corner : own) face.push_back(joined.groups[corner]);
        if (hasSeamVertices(face)) {
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
void takeVertices(const JoinedRows& joined, JoinedCage& cage) {
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
    Rows rows;
    rows.width = 3;
    rows.words.reserve(3 * corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        rows.words.push_back(cage.faceVertices[i]);
        appendBits(rows.words, uvs, corners[i], 2);
    }
    JoinedRows joined = joinRows(rows);
    cage.faceUvs = std::move(joined.groups);
    for (const std::uint32_t first : joined.firsts) {
        const std::size_t vertex = corners[first];
        cage.uvs.insert(cage.uvs.end(), {uvs[2 * vertex], uvs[2 * vertex + 1]});
    }
}

}  // namespace

JoinedCage joinCage(const CageSource& source) {
    const JoinedRows joined = joinRows(vertexRows(source.vertices));
    JoinedCage cage;
    std::vector<std::uint32_t> corners;
    takeFaces(source, joined, cage, corners);
    takeVertices(joined, cage);
    takeUvs(source.vertices.uvs, corners, cage);
    return cage;
}

}  // namespace candela_gltf
