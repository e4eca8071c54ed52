#include "refine.h"

#include <algorithm>
#include <memory>

#include "failure.h"
#include "numbering.h"
#include "parallel.h"
#include "stencil_builder.h"
#include "table_size.h"
#include "topology.h"

namespace candela_opensubdiv {
namespace {

/// The faces that one thread turns to at a time: enough to be worth its start, few enough to spread them.
constexpr std::size_t facesAtOnce = 128;

/// The rows of some faces.
struct Part {
    VertexRows points, twins;
};

/// The polygons to draw.
struct Polygons {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> cageFaces;
};

std::vector<Part> makeParts(const GivenCage& cage, const FaceGrids& grids, const Numbering& numbering,
                            const StencilBuilder& stencilBuilder) {
    const std::vector<std::uint32_t>& faces = numbering.faces();
    std::vector<Part> parts((faces.size() + facesAtOnce - 1) / facesAtOnce);
    std::vector<StencilBuilder> stencilBuilders(workerCount(), stencilBuilder);
    inParallel(parts.size(), [&](std::size_t index, std::size_t worker) {
        std::vector<std::uint32_t> slots;
        const std::size_t end = std::min(faces.size(), (index + 1) * facesAtOnce);
        for (std::size_t i = index * facesAtOnce; i < end; ++i) {
            const FaceGrid& grid = grids.of(cage.faceSizes[faces[i]]);
            numbering.ownPoints(faces[i], slots);
            stencilBuilders[worker].add(faces[i], grid, slots, parts[index].points);
            numbering.ownSeamVertices(faces[i], slots);
            stencilBuilders[worker].add(faces[i], grid, slots, parts[index].twins);
        }
    });
    return parts;
}

/// Joins the rows of all points, then those of all twins.
WeightTable joinParts(std::vector<Part>& parts, StencilTable VertexRows::*kind) {
    std::vector<StencilTable*> pieces;
    for (Part& part : parts) pieces.push_back(&(part.points.*kind));
    for (Part& part : parts) pieces.push_back(&(part.twins.*kind));
    return WeightTable(pieces);
}

Polygons makePolygons(const GivenCage& cage, const FaceGrids& grids, const Numbering& numbering) {
    Polygons polygons;
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t face : numbering.faces()) {
        const FaceGrid& grid = grids.of(cage.faceSizes[face]);
        numbering.verticesOf(face, vertices);
        for (const std::uint32_t slot : grid.polygons) polygons.vertices.push_back(vertices[slot]);
        polygons.cageFaces.insert(polygons.cageFaces.end(), grid.polygonCount(), face);
    }
    return polygons;
}

void checkLevel(std::uint32_t level) {
    if (level >= 1 && level <= 8) return;
    throw Failure{"level " + std::to_string(level), "a cage can be refined to the levels 1 to 8"};
}

}  // namespace

void refine(const candela_refinement& host, const candela_cage& original, std::uint32_t level) {
    checkLevel(level);
    const GivenCage cage = checkedCage(original);
    const auto topology = makeTopology(cage);
    checkTableSize(*topology, level);

    const LimitSurface surface(*topology, level, Primvar::position);
    const auto uvSurface =
        cage.uvCount == 0 ? nullptr : std::make_unique<LimitSurface>(*topology, level, Primvar::uv);
    const FaceGrids grids(topology->GetSchemeType(), level, cage.faceSizes);
    const Sectors sectors(cage, *topology);
    const Numbering numbering(cage, *topology, sectors, surface, grids);
    std::vector<Part> parts =
        makeParts(cage, grids, numbering, StencilBuilder(cage, surface, uvSurface.get(), level));
    const WeightTable positions = joinParts(parts, &VertexRows::positions);
    const WeightTable uvs = joinParts(parts, &VertexRows::uvs);
    const Polygons polygons = makePolygons(cage, grids, numbering);

    candela_refined_cage refined{};
    refined.struct_size = sizeof(refined);
    refined.point_count = numbering.pointCount();
    refined.vertex_count = numbering.vertexCount();
    refined.seam_points = numbering.seamPoints().data();
    refined.positions = positions.view();
    refined.uvs = uvs.view();
    refined.face_size = cage.scheme == CANDELA_SCHEME_LOOP ? 3 : 4;
    refined.face_count = static_cast<std::uint32_t>(polygons.cageFaces.size());
    refined.face_vertices = polygons.vertices.data();
    refined.cage_faces = polygons.cageFaces.data();
    if (host.deliver(host.self, &refined) != CANDELA_OK) throw HostRefused{};
}

}  // namespace candela_opensubdiv
