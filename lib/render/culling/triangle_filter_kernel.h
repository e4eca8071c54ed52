#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace candela {

namespace layout {
using uint = std::uint32_t;
#include "shared/triangle_filter_records.h"
}  // namespace layout

// The jobs of the kernels. Plain numbers only: each kernel is compiled for its own instruction set and must
// not share inline functions with other files.

/// Up to 64 clusters of an instance.
struct CullClusters {
    const layout::FilterView* view;
    const layout::TriangleCluster* clusters;
    std::uint32_t count;
};

/// Consecutive triangles of an instance.
struct FilterTriangles {
    const layout::FilterView* view;
    const float* vertices;  ///< That of index 0: position and normal, `vertexFloats` each.
    const std::uint32_t* indices;
    std::uint32_t count;  ///< Triangles.
    std::uint32_t* out;
};
constexpr int vertexFloats = 6;

/// The clusters of consecutive triangles of a mesh.
struct BoundClusters {
    const float* positions;  ///< That of vertex 0, three numbers each.
    const std::uint32_t* indices;
    std::uint32_t count;  ///< Triangles.
    layout::TriangleCluster* clusters;
};

/// The functions of one instruction set (shaders/shared/triangle_filter.h).
struct TriangleFilterKernel {
    const char* name;
    /// A bit for each cluster a triangle of which may leave a trace, the first lowest.
    std::uint64_t (*cull)(const CullClusters& job);
    /// Writes the indices of the triangles that may leave a trace, in their order. Returns how many indices
    /// those are.
    std::uint32_t (*filter)(const FilterTriangles& job);
    /// Computes the bounds of clusters.
    void (*bound)(const BoundClusters& job);
};

/// One for each instruction set that this build has and this processor runs, widest first.
std::vector<const TriangleFilterKernel*> triangleFilterKernels();

}  // namespace candela
