#include <candela/plugin.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "../common/failure.h"
#include "../common/parallel.h"
#include "numbering.h"
#include "stencil_builder.h"
#include "topology.h"

namespace candela_plugins::opensubdiv {

namespace {

/// Enough faces to be worth the overhead of a task, few enough to spread over the workers.
constexpr std::size_t facesPerTask = 128;

/// The stencils of the faces of one task.
struct TaskResult {
    VertexStencils points, seamVertices;
};

/// The faces to draw.
struct Polygons {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> cageFaces;
};

std::vector<TaskResult> buildStencils(const CheckedCage& cage, const FaceGrids& grids,
                                      const VertexNumbering& numbering, const StencilBuilder& prototype,
                                      const candela_refinement& host) {
    const std::vector<std::uint32_t>& faces = numbering.faces();
    std::vector<TaskResult> tasks((faces.size() + facesPerTask - 1) / facesPerTask);
    std::vector<StencilBuilder> builders(workerCount(host), prototype);
    parallelFor(host, static_cast<std::uint32_t>(tasks.size()), [&](std::size_t index, std::uint32_t worker) {
        std::vector<std::uint32_t> slots;
        const std::size_t end = std::min(faces.size(), (index + 1) * facesPerTask);
        for (std::size_t i = index * facesPerTask; i < end; ++i) {
            const FaceGrid& grid = grids.of(cage.faceSizes[faces[i]]);
            numbering.ownPoints(faces[i], slots);
            builders[worker].add(faces[i], grid, slots, tasks[index].points);
            numbering.ownSeamVertices(faces[i], slots);
            builders[worker].add(faces[i], grid, slots, tasks[index].seamVertices);
        }
    });
    return tasks;
}

/// Joins the stencils of all points, then those of all seam vertices.
StencilTable joinTasks(std::vector<TaskResult>& tasks, StencilBuffer VertexStencils::*kind) {
    std::vector<StencilBuffer*> buffers;
    for (TaskResult& task : tasks) buffers.push_back(&(task.points.*kind));
    for (TaskResult& task : tasks) buffers.push_back(&(task.seamVertices.*kind));
    return StencilTable(buffers);
}

Polygons makePolygons(const CheckedCage& cage, const FaceGrids& grids, const VertexNumbering& numbering) {
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

/// Refines a cage and passes the result to the host.
void refine(const candela_refinement& host, const candela_cage& original, std::uint32_t level) {
    checkLevel(level);
    const CheckedCage cage = checkCage(original);
    const auto topology = makeTopology(cage);
    checkTableSize(*topology, level);

    const LimitSurface surface(*topology, level, Primvar::position);
    const auto uvSurface =
        cage.uvCount == 0 ? nullptr : std::make_unique<LimitSurface>(*topology, level, Primvar::uv);
    const FaceGrids grids(topology->GetSchemeType(), level, cage.faceSizes);
    const Sectors sectors(cage, *topology);
    const VertexNumbering numbering(cage, *topology, sectors, surface, grids);
    std::vector<TaskResult> tasks =
        buildStencils(cage, grids, numbering, StencilBuilder(cage, surface, uvSurface.get(), level), host);
    const StencilTable positions = joinTasks(tasks, &VertexStencils::positions);
    const StencilTable uvs = joinTasks(tasks, &VertexStencils::uvs);
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
    if (host.set_result(host.self, &refined) != CANDELA_OK) throw HostRefused{};
}

candela_status refineCage(const candela_refinement* host, const candela_cage* cage, uint32_t level) {
    return runGuarded(*host, [&] { refine(*host, *cage, level); });
}

constexpr candela_subdivider subdivider{sizeof(candela_subdivider), refineCage};
constexpr candela_plugin plugin{sizeof(candela_plugin),
                                CANDELA_PLUGIN_MAJOR,
                                CANDELA_PLUGIN_MINOR,
                                "opensubdiv",
                                CANDELA_OPENSUBDIV_VERSION,
                                "Refines subdivision cages with OpenSubdiv",
                                nullptr,
                                &subdivider,
                                nullptr};

}  // namespace

}  // namespace candela_plugins::opensubdiv

const candela_plugin* candela_plugin_query(uint32_t hostMajor, uint32_t) {
    return hostMajor == CANDELA_PLUGIN_MAJOR ? &candela_plugins::opensubdiv::plugin : nullptr;
}
