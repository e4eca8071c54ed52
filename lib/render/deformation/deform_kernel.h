#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace candela {

/// Vertices that are deformed together.
constexpr int deformBlockSize = 64;

/// Floats of a vertex at rest: position and normal; with a tangent, its direction and the bitangent's sign.
constexpr int restColumns = 6, restColumnsWithTangents = 10;

/// Vertices whose joints are blended together; a block has several runs.
constexpr int deformRunSize = 8;

/// A joint that moves vertices of a run, with its weight for each of them: neighbours share most of their
/// joints.
struct RunInfluence {
    std::uint32_t joint;
    float weight[deformRunSize];
};

/// What one morph target adds to one vertex.
struct MorphEntry {
    std::uint32_t target;
    float position[3], normal[3], tangent[3];
};

/// A deformation of a mesh as the kernels read it. Plain numbers only: each kernel is compiled for its own
/// instruction set and must not share inline functions with other files.
struct DeformJob {
    std::uint32_t vertices;
    const float*
        rest;  ///< Block after block, in each column after column, in each `deformBlockSize` vertices.
    const std::uint32_t* runs;  ///< The influences of run i: runs[i] to runs[i + 1] - 1.
    const RunInfluence* influences;
    const float* joints;        ///< Three rows of four floats a joint; nullptr: no skin moves the mesh.
    float directionScale;       ///< 1 over the largest element of the linear parts of the joints' matrices.
    const std::uint32_t* rows;  ///< The morph entries of vertex i: rows[i] to rows[i + 1] - 1.
    const MorphEntry* entries;
    const float* morphWeights;  ///< One a target; nullptr: no target moves the mesh.
    float* surface;             ///< Position and normal of each vertex, 6 floats.
    float* tangents;            ///< 4 floats a vertex; nullptr: none.
    /// Positions and normals are written past the caches, which they would not fit; `surface` is a multiple
    /// of 16.
    bool streams;
};

/// The functions of one instruction set.
struct DeformKernel {
    const char* name;
    /// Writes the vertices of the blocks from `first` to `end`.
    void (*deform)(const DeformJob& job, std::uint32_t first, std::uint32_t end);
};

/// One for each instruction set that this build has and this processor runs, widest first.
std::vector<const DeformKernel*> deformKernels();

}  // namespace candela
