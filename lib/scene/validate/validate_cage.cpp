#include "base/error_context.h"
#include "scene/validate/scene_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <vector>

namespace candela {

namespace {

constexpr std::size_t maxCount = std::numeric_limits<std::uint32_t>::max();

template <typename Enum>
bool isWithin(Enum value, Enum first, Enum last) {
    return value >= first && value <= last;
}

void validateRules(const Cage& cage, const ErrorContext& element) {
    element.require(isWithin(cage.scheme, SubdivisionScheme::catmullClark, SubdivisionScheme::bilinear),
                    "its scheme is unknown");
    element.require(isWithin(cage.boundaryInterpolation, BoundaryInterpolation::none,
                             BoundaryInterpolation::edgesAndCorners),
                    "its boundary interpolation is unknown");
    element.require(isWithin(cage.faceVaryingInterpolation, FaceVaryingInterpolation::none,
                             FaceVaryingInterpolation::all),
                    "its face-varying interpolation is unknown");
    element.require(isWithin(cage.creaseMethod, CreaseMethod::uniform, CreaseMethod::chaikin),
                    "its crease method is unknown");
    element.require(
        isWithin(cage.triangleSubdivision, TriangleSubdivision::catmullClark, TriangleSubdivision::smooth),
        "its triangle subdivision is unknown");
    if (!cage.level || (*cage.level >= 1 && *cage.level <= maxSubdivisionLevel)) return;
    element.refuse("its level is " + std::to_string(*cage.level) + ", but 1 to " +
                   std::to_string(maxSubdivisionLevel) + " was expected");
}

// A part of a cage as errors name it: "face 3".
struct Part {
    const char* kind;
    std::size_t index;

    std::string label() const { return kind + (" " + std::to_string(index)); }
};

// Refuses an index of `part` that is not below `count`.
void requireNamed(const Part& part, const Part& named, std::size_t count, const ErrorContext& element) {
    if (named.index < count) return;
    element.refuse(part.label() + " names " + named.label() + ", but there are " + std::to_string(count));
}

// The sizes of the faces, and with them those of the arrays "a corner".
void validateFaceSizes(const Cage& cage, const ErrorContext& element) {
    const bool triangles = cage.scheme == SubdivisionScheme::loop;
    for (std::size_t face = 0; face < cage.faceSizes.size(); ++face) {
        const std::uint32_t size = cage.faceSizes[face];
        if (size >= 3 && (size == 3 || !triangles)) continue;
        element.refuse(Part{"face", face}.label() + " has " + std::to_string(size) + " corners, but " +
                       (triangles ? "a face of a Loop cage has 3" : "3 or more were expected"));
    }
    const auto corners = std::accumulate(cage.faceSizes.begin(), cage.faceSizes.end(), std::uint64_t{0});
    element.require(cage.positions.size() <= maxCount && cage.uvs.size() <= maxCount &&
                        cage.faceSizes.size() <= maxCount && corners <= maxCount,
                    "has more vertices, texture coordinates, faces or corners than 32 bits can count");
    element.requireCount("vertices of faces", cage.faceVertices.size(), "corners", corners);
    element.requireCount("texture coordinates of faces", cage.faceUvs.size(), "corners",
                         cage.uvs.empty() ? 0 : corners);
}

void validateFaces(const Cage& cage, const ErrorContext& element) {
    // For each vertex the last face that named it, and 1; 0 before the first.
    std::vector<std::size_t> lastFace(cage.positions.size(), 0);
    std::size_t corner = 0;
    for (std::size_t face = 0; face < cage.faceSizes.size(); ++face) {
        for (const std::size_t end = corner + cage.faceSizes[face]; corner < end; ++corner) {
            const std::uint32_t vertex = cage.faceVertices[corner];
            requireNamed({"face", face}, {"vertex", vertex}, cage.positions.size(), element);
            if (lastFace[vertex] == face + 1) {
                element.refuse(Part{"face", face}.label() + " names " + Part{"vertex", vertex}.label() +
                               " twice");
            }
            lastFace[vertex] = face + 1;
            if (cage.uvs.empty()) continue;
            requireNamed({"face", face}, {"texture coordinate", cage.faceUvs[corner]}, cage.uvs.size(),
                         element);
        }
    }
}

std::uint64_t edgeKey(std::uint32_t vertex0, std::uint32_t vertex1) {
    return std::uint64_t{std::min(vertex0, vertex1)} << 32 | std::max(vertex0, vertex1);
}

std::vector<std::uint64_t> sortedEdges(const Cage& cage) {
    std::vector<std::uint64_t> edges;
    edges.reserve(cage.faceVertices.size());
    const std::uint32_t* face = cage.faceVertices.data();
    for (const std::uint32_t size : cage.faceSizes) {
        for (std::uint32_t i = 0; i < size; ++i) edges.push_back(edgeKey(face[i], face[(i + 1) % size]));
        face += size;
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

bool isSharpness(float sharpness) {
    return sharpness >= 0.0f && std::isfinite(sharpness);
}

[[noreturn]] void refuseSharpness(const std::string& what, float sharpness, const ErrorContext& element) {
    element.refuse(what + ": its sharpness is " + shortNumber(sharpness) +
                   ", but must be a finite number, 0 or more");
}

std::string edgeLabel(const Part& part, const Crease& crease) {
    return part.label() + ", edge " + std::to_string(crease.vertex0) + "-" + std::to_string(crease.vertex1);
}

void validateCreases(const Cage& cage, const ErrorContext& element) {
    if (cage.creases.empty()) return;
    const std::vector<std::uint64_t> edges = sortedEdges(cage);
    for (std::size_t i = 0; i < cage.creases.size(); ++i) {
        const Crease& crease = cage.creases[i];
        const Part part{"crease", i};
        requireNamed(part, {"vertex", crease.vertex0}, cage.positions.size(), element);
        requireNamed(part, {"vertex", crease.vertex1}, cage.positions.size(), element);
        // No face names a vertex twice: an edge joins two vertices.
        if (!std::binary_search(edges.begin(), edges.end(), edgeKey(crease.vertex0, crease.vertex1))) {
            element.refuse(edgeLabel(part, crease) + ": no face has this edge");
        }
        if (!isSharpness(crease.sharpness)) {
            refuseSharpness(edgeLabel(part, crease), crease.sharpness, element);
        }
    }
}

void validateCorners(const Cage& cage, const ErrorContext& element) {
    for (std::size_t i = 0; i < cage.corners.size(); ++i) {
        const Corner& corner = cage.corners[i];
        const Part part{"corner", i}, vertex{"vertex", corner.vertex};
        requireNamed(part, vertex, cage.positions.size(), element);
        if (isSharpness(corner.sharpness)) continue;
        refuseSharpness(part.label() + ", " + vertex.label(), corner.sharpness, element);
    }
}

void validateMaterials(const Cage& cage, const Scene& scene, const ErrorContext& element) {
    std::vector<bool> known(scene.materials.size());
    const UvSets uvSets = cage.uvs.empty() ? 0 : 1;
    const auto requireMaterials = [&](const std::vector<std::optional<std::uint32_t>>& materials) {
        if (materials.empty()) return;
        element.requireCount("materials", materials.size(), "faces", cage.faceSizes.size());
        for (const std::optional<std::uint32_t>& material : materials) {
            element.requireIndex("material", material, scene.materials.size());
            if (!material || known[*material]) continue;
            known[*material] = true;
            requireUvs(uvSets, *material, scene, element);
        }
    };
    requireMaterials(cage.faceMaterials);
    std::set<std::optional<std::uint32_t>> variants;
    for (const CageVariant& entry : cage.variants) {
        element.requireIndex("variant", entry.variant, scene.variants.size());
        element.require(variants.insert(entry.variant).second,
                        "has its materials for the same variant twice");
        requireMaterials(entry.faceMaterials);
    }
    element.require(variants.empty() || variants.contains(std::nullopt),
                    "has materials for variants and none without a variant");
}

}  // namespace

void requireFaces(const Cage& cage, const ErrorContext& element) {
    validateFaceSizes(cage, element);
    element.requireEachFinite("position", cage.positions);
    element.requireEachFinite("texture coordinate", cage.uvs);
    validateFaces(cage, element);
    for (std::size_t i = 0; i < cage.holes.size(); ++i) {
        requireNamed({"hole", i}, {"face", cage.holes[i]}, cage.faceSizes.size(), element);
    }
}

void validateCageSurface(const Cage& cage, const ErrorContext& element) {
    validateRules(cage, element);
    requireFaces(cage, element);
    validateCreases(cage, element);
    validateCorners(cage, element);
    const DeformableVertices shape(cage);
    requireInfluences(shape, element);
    requireMorphTargets(shape, element);
    for (const MorphTarget& target : cage.morphTargets)
        element.require(target.normalOffsets.empty() && target.tangentOffsets.empty(),
                        "a morph target has offsets of normals or tangents, which a cage does not have");
}

void validateCage(const Cage& cage, const Scene& scene, const ErrorContext& element) {
    validateCageSurface(cage, element);
    validateMaterials(cage, scene, element);
}

}  // namespace candela
