#include "import/cage_struct.h"

#include "import/abi_reader.h"

#include <candela/error.h>

#include <limits>

namespace candela {
namespace {

static_assert(sizeof(glm::vec3) == 3 * sizeof(float) && sizeof(glm::vec2) == 2 * sizeof(float));

template <class T>
std::uint32_t countOf(const std::vector<T>& elements, const char* what, const Cage& cage) {
    if (elements.size() > std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorKind::limit, "",
                    joined(AbiReader("cage", std::nullopt, cage.name.c_str()).label(), ": it has ",
                           elements.size(), " ", what, ", more than 32 bits can count"));
    return static_cast<std::uint32_t>(elements.size());
}

candela_scheme schemeOf(SubdivisionScheme scheme) {
    switch (scheme) {
        case SubdivisionScheme::loop:
            return CANDELA_SCHEME_LOOP;
        case SubdivisionScheme::bilinear:
            return CANDELA_SCHEME_BILINEAR;
        default:
            return CANDELA_SCHEME_CATMULL_CLARK;
    }
}

candela_boundary_interpolation boundaryOf(BoundaryInterpolation boundary) {
    switch (boundary) {
        case BoundaryInterpolation::none:
            return CANDELA_BOUNDARY_NONE;
        case BoundaryInterpolation::edges:
            return CANDELA_BOUNDARY_EDGES;
        default:
            return CANDELA_BOUNDARY_EDGES_AND_CORNERS;
    }
}

candela_face_varying_interpolation faceVaryingOf(FaceVaryingInterpolation faceVarying) {
    switch (faceVarying) {
        case FaceVaryingInterpolation::none:
            return CANDELA_FACE_VARYING_NONE;
        case FaceVaryingInterpolation::cornersPlus1:
            return CANDELA_FACE_VARYING_CORNERS_PLUS1;
        case FaceVaryingInterpolation::cornersPlus2:
            return CANDELA_FACE_VARYING_CORNERS_PLUS2;
        case FaceVaryingInterpolation::boundaries:
            return CANDELA_FACE_VARYING_BOUNDARIES;
        case FaceVaryingInterpolation::all:
            return CANDELA_FACE_VARYING_ALL;
        default:
            return CANDELA_FACE_VARYING_CORNERS_ONLY;
    }
}

}  // namespace

CageStruct::CageStruct(const Cage& cage) {
    struct_.struct_size = sizeof struct_;
    struct_.name = cage.name.c_str();
    setRules(cage);
    setFaces(cage);
    setSharpness(cage);
}

void CageStruct::setRules(const Cage& cage) {
    struct_.scheme = schemeOf(cage.scheme);
    struct_.boundary_interpolation = boundaryOf(cage.boundaryInterpolation);
    struct_.face_varying_interpolation = faceVaryingOf(cage.faceVaryingInterpolation);
    struct_.crease_method =
        cage.creaseMethod == CreaseMethod::chaikin ? CANDELA_CREASE_CHAIKIN : CANDELA_CREASE_UNIFORM;
    struct_.triangle_subdivision = cage.triangleSubdivision == TriangleSubdivision::smooth
                                       ? CANDELA_TRIANGLE_SMOOTH
                                       : CANDELA_TRIANGLE_CATMULL_CLARK;
    struct_.level = cage.level.value_or(0);
}

void CageStruct::setFaces(const Cage& cage) {
    struct_.vertex_count = countOf(cage.positions, "vertices", cage);
    struct_.positions = reinterpret_cast<const float*>(cage.positions.data());
    struct_.face_count = countOf(cage.faceSizes, "faces", cage);
    struct_.face_sizes = cage.faceSizes.data();
    countOf(cage.faceVertices, "corners", cage);
    struct_.face_vertices = cage.faceVertices.data();
    struct_.uv_count = countOf(cage.uvs, "texture coordinates", cage);
    struct_.uvs = reinterpret_cast<const float*>(cage.uvs.data());
    struct_.face_uvs = cage.faceUvs.data();
    struct_.hole_count = countOf(cage.holes, "holes", cage);
    struct_.holes = cage.holes.data();
}

void CageStruct::setSharpness(const Cage& cage) {
    struct_.crease_count = countOf(cage.creases, "creases", cage);
    for (const Crease& crease : cage.creases) {
        creaseEdges_.insert(creaseEdges_.end(), {crease.vertex0, crease.vertex1});
        creaseSharpness_.push_back(crease.sharpness);
    }
    struct_.crease_edges = creaseEdges_.data();
    struct_.crease_sharpness = creaseSharpness_.data();
    struct_.corner_count = countOf(cage.corners, "corners", cage);
    for (const Corner& corner : cage.corners) {
        cornerVertices_.push_back(corner.vertex);
        cornerSharpness_.push_back(corner.sharpness);
    }
    struct_.corner_vertices = cornerVertices_.data();
    struct_.corner_sharpness = cornerSharpness_.data();
}

}  // namespace candela
