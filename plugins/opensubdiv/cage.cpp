#include "cage.h"

#include <opensubdiv/bfr/limits.h>
#include <opensubdiv/sdc/crease.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string>

#include "../common/failure.h"

namespace candela_plugins::opensubdiv {

namespace {

namespace Osd = OpenSubdiv;

/// OpenSubdiv counts with int.
constexpr std::uint64_t maxElements = std::numeric_limits<int>::max();

/// The members that the host has filled in; those that an older host does not have are zero.
candela_cage filledPart(const candela_cage& given) {
    candela_cage cage{};
    std::memcpy(&cage, &given, std::min<std::size_t>(given.struct_size, sizeof(cage)));
    return cage;
}

template <typename T>
std::span<const T> range(const T* data, std::uint64_t count, const char* noun) {
    if (count > maxElements) throw Failure{"", "it has too many " + std::string(noun)};
    if (data == nullptr && count != 0) throw Failure{"", "its " + std::string(noun) + " are missing"};
    return {data, static_cast<std::size_t>(count)};
}

/// The enumeration may hold any number, so it is not read as an enumerator before it is checked.
template <typename Enumeration>
void checkEnumerator(const Enumeration& given, int maxNumber, const char* noun) {
    int number = 0;
    static_assert(sizeof(given) == sizeof(number));
    std::memcpy(&number, &given, sizeof(number));
    if (number < 0 || number > maxNumber) {
        throw Failure{"",
                      "its " + std::string(noun) + " is " + std::to_string(number) + ", which is unknown"};
    }
}

void checkEnumerators(const candela_cage& cage) {
    checkEnumerator(cage.scheme, CANDELA_SCHEME_BILINEAR, "scheme");
    checkEnumerator(cage.boundary_interpolation, CANDELA_BOUNDARY_EDGES_AND_CORNERS,
                    "boundary interpolation");
    checkEnumerator(cage.face_varying_interpolation, CANDELA_FACE_VARYING_ALL, "face-varying interpolation");
    checkEnumerator(cage.crease_method, CANDELA_CREASE_CHAIKIN, "crease method");
    checkEnumerator(cage.triangle_subdivision, CANDELA_TRIANGLE_SMOOTH, "triangle subdivision");
}

void checkFaceSize(std::uint32_t size, std::uint32_t face, candela_scheme scheme) {
    const auto max = static_cast<std::uint32_t>(Osd::Bfr::Limits::MaxFaceSize());
    if (size < 3) {
        throw Failure{elementName("face", face), "it has " + std::to_string(size) + " corners, less than 3"};
    }
    if (size > max) {
        throw Failure{elementName("face", face), "it has " + std::to_string(size) + " corners, more than " +
                                                     std::to_string(max) + ", OpenSubdiv's limit"};
    }
    if (scheme == CANDELA_SCHEME_LOOP && size != 3) {
        throw Failure{elementName("face", face), "it has " + std::to_string(size) +
                                                     " corners, but the Loop scheme takes only triangles"};
    }
}

std::vector<std::uint32_t> checkedFaceStarts(const CheckedCage& cage) {
    std::vector<std::uint32_t> starts{0};
    starts.reserve(cage.faceSizes.size() + 1);
    std::uint64_t corners = 0;
    for (std::uint32_t face = 0; face < cage.faceCount(); ++face) {
        checkFaceSize(cage.faceSizes[face], face, cage.scheme);
        corners += cage.faceSizes[face];
        if (corners > maxElements) throw Failure{elementName("face", face), "there are too many corners"};
        starts.push_back(static_cast<std::uint32_t>(corners));
    }
    return starts;
}

void checkCornerIndices(const CheckedCage& cage, std::span<const std::uint32_t> indices, std::uint32_t count,
                        const char* noun) {
    for (std::uint32_t face = 0; face < cage.faceCount(); ++face) {
        for (std::uint32_t corner = cage.faceStarts[face]; corner < cage.faceStarts[face + 1]; ++corner) {
            if (indices[corner] < count) continue;
            throw Failure{elementName("face", face), "it names " + std::string(noun) + " " +
                                                         std::to_string(indices[corner]) +
                                                         ", but there are only " + std::to_string(count)};
        }
    }
}

void checkVertices(const CheckedCage& cage) {
    constexpr std::uint32_t noFace = std::numeric_limits<std::uint32_t>::max();
    const auto max = static_cast<std::uint32_t>(Osd::Bfr::Limits::MaxValence());
    std::vector<std::uint32_t> valences(cage.vertexCount, 0), lastFaces(cage.vertexCount, noFace);
    for (std::uint32_t face = 0; face < cage.faceCount(); ++face) {
        for (std::uint32_t corner = cage.faceStarts[face]; corner < cage.faceStarts[face + 1]; ++corner) {
            const std::uint32_t vertex = cage.faceVertices[corner];
            if (lastFaces[vertex] == face) {
                throw Failure{elementName("face", face),
                              "it names vertex " + std::to_string(vertex) + " twice"};
            }
            lastFaces[vertex] = face;
            if (++valences[vertex] <= max) continue;
            throw Failure{elementName("vertex", vertex),
                          "more than " + std::to_string(max) + " faces meet there, OpenSubdiv's limit"};
        }
    }
}

/// The sharpness 10 is infinite to OpenSubdiv; to the ABI all from 10 on are.
float checkedSharpness(float sharpness, const std::string& element) {
    if (!(sharpness >= 0.0f && std::isfinite(sharpness))) {
        throw Failure{element, "its sharpness is " + std::to_string(sharpness) +
                                   ", but must be a finite number, 0 or more"};
    }
    return std::min(sharpness, Osd::Sdc::Crease::SHARPNESS_INFINITE);
}

void takeCreases(CheckedCage& cage, const candela_cage& given) {
    cage.creaseEdges = range(given.crease_edges, std::uint64_t{2} * given.crease_count, "crease edges");
    const auto sharpness = range(given.crease_sharpness, given.crease_count, "crease sharpnesses");
    for (std::size_t crease = 0; crease < sharpness.size(); ++crease) {
        const std::uint32_t vertex0 = cage.creaseEdges[2 * crease];
        const std::uint32_t vertex1 = cage.creaseEdges[2 * crease + 1];
        const std::string element = edgeName(vertex0, vertex1);
        if (std::max(vertex0, vertex1) >= cage.vertexCount) {
            throw Failure{element, "it is a crease, but there are only " + std::to_string(cage.vertexCount) +
                                       " vertices"};
        }
        cage.creaseSharpness.push_back(checkedSharpness(sharpness[crease], element));
    }
}

void takeCorners(CheckedCage& cage, const candela_cage& given) {
    cage.cornerVertices = range(given.corner_vertices, given.corner_count, "corner vertices");
    const auto sharpness = range(given.corner_sharpness, given.corner_count, "corner sharpnesses");
    for (std::size_t corner = 0; corner < sharpness.size(); ++corner) {
        const std::uint32_t vertex = cage.cornerVertices[corner];
        const std::string element = elementName("vertex", vertex);
        if (vertex >= cage.vertexCount) {
            throw Failure{element, "it is a sharp corner, but there are only " +
                                       std::to_string(cage.vertexCount) + " vertices"};
        }
        cage.cornerSharpness.push_back(checkedSharpness(sharpness[corner], element));
    }
}

void takeHoles(CheckedCage& cage, const candela_cage& given) {
    cage.holes = range(given.holes, given.hole_count, "holes");
    for (const std::uint32_t face : cage.holes) {
        if (face < cage.faceCount()) continue;
        throw Failure{elementName("face", face),
                      "it is a hole, but there are only " + std::to_string(cage.faceCount()) + " faces"};
    }
}

void takeFaces(CheckedCage& cage, const candela_cage& given) {
    cage.faceSizes = range(given.face_sizes, given.face_count, "faces");
    if (cage.faceSizes.empty()) throw Failure{"", "it has no faces"};
    cage.faceStarts = checkedFaceStarts(cage);
    cage.faceVertices = range(given.face_vertices, cage.faceStarts.back(), "corners");
    checkCornerIndices(cage, cage.faceVertices, cage.vertexCount, "vertex");
    checkVertices(cage);
    if (cage.uvCount == 0) return;
    cage.faceUvs = range(given.face_uvs, cage.faceStarts.back(), "texture coordinate indices");
    checkCornerIndices(cage, cage.faceUvs, cage.uvCount, "texture coordinate");
}

}  // namespace

std::string edgeName(std::uint32_t vertex0, std::uint32_t vertex1) {
    return "edge " + std::to_string(vertex0) + "-" + std::to_string(vertex1);
}

CheckedCage checkCage(const candela_cage& original) {
    const candela_cage given = filledPart(original);
    checkEnumerators(given);
    CheckedCage cage{};
    cage.scheme = given.scheme;
    cage.boundaryInterpolation = given.boundary_interpolation;
    cage.faceVaryingInterpolation = given.face_varying_interpolation;
    cage.creaseMethod = given.crease_method;
    cage.triangleSubdivision = given.triangle_subdivision;
    cage.vertexCount = given.vertex_count;
    cage.uvCount = given.uv_count;
    cage.positions = range(given.positions, std::uint64_t{3} * given.vertex_count, "positions");
    range(given.uvs, std::uint64_t{2} * given.uv_count, "texture coordinates");
    takeFaces(cage, given);
    takeCreases(cage, given);
    takeCorners(cage, given);
    takeHoles(cage, given);
    return cage;
}

}  // namespace candela_plugins::opensubdiv
