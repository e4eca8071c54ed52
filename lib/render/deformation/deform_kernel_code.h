#pragma once

// The kernels that deform vertices on the CPU. Each render/kernels_*.cpp includes this once and is compiled
// for its own instruction set, with CANDELA_DEFORM_KERNEL naming the table it defines. Everything here has
// internal linkage, and no inline function of a library is used (see lighting/tiled/tile_kernel_code.h).
//
// A block passes three loops: the joints' matrices are blended into columns, the vertices are transformed in
// vectors along the columns, and the results are interleaved. The GPU's counterpart is
// shaders/deform.comp.

#include "render/deformation/deform_kernel.h"

#include "render/simd.h"

namespace candela {
namespace {

constexpr int matrixColumns = 12;

struct alignas(64) BlockColumns {
    float matrix[matrixColumns][deformBlockSize];  // the rows of a 3 × 4 matrix
    float rest[restColumnsWithTangents][deformBlockSize];
    float result[restColumnsWithTangents][deformBlockSize];
};

inline void storeFour(float* to, Four v) {
    __builtin_memcpy(to, &v, sizeof v);
}

/// Stores to an address that is a multiple of 16, past the caches where the processor can.
inline void streamFour(float* to, Four v) {
#if defined(__x86_64__)
    __builtin_ia32_movntps(to, v);
#else
    storeFour(to, v);
#endif
}

/// Makes what was streamed visible to other threads.
inline void endStreaming() {
#if defined(__x86_64__)
    __builtin_ia32_sfence();
#endif
}

// ---- Blending

/// The lanes of a run that one pass blends.
#if defined(__AVX2__)
constexpr int blendLanes = 8;
#else
constexpr int blendLanes = 4;
#endif
typedef float BlendLanes __attribute__((vector_size(4 * blendLanes)));

/// Writes the weighted sums of the joints' matrices for the lanes of a run from `lane` on.
inline void blendLanesOf(const DeformJob& job, const RunInfluence* influences, std::uint32_t count, int lane,
                         float* to) {
    BlendLanes sums[matrixColumns] = {};
    for (std::uint32_t i = 0; i < count; ++i) {
        const float* matrix = job.joints + matrixColumns * std::size_t{influences[i].joint};
        BlendLanes weight;
        __builtin_memcpy(&weight, influences[i].weight + lane, sizeof weight);
        // Without unrolling the sums would not stay in registers.
#pragma GCC unroll 12
        for (int column = 0; column < matrixColumns; ++column) sums[column] += weight * matrix[column];
    }
#pragma GCC unroll 12
    for (int column = 0; column < matrixColumns; ++column)
        __builtin_memcpy(to + column * deformBlockSize, &sums[column], sizeof(BlendLanes));
}

inline void blendBlock(const DeformJob& job, std::uint32_t block, BlockColumns& columns) {
    constexpr int runsPerBlock = deformBlockSize / deformRunSize;
    const std::uint32_t* runs = job.runs + block * runsPerBlock;
    for (int run = 0; run < runsPerBlock; ++run) {
        for (int lane = 0; lane < deformRunSize; lane += blendLanes)
            blendLanesOf(job, job.influences + runs[run], runs[run + 1] - runs[run], lane,
                         columns.matrix[0] + run * deformRunSize + lane);
    }
}

inline void setIdentity(BlockColumns& columns) {
    for (int column = 0; column < matrixColumns; ++column) {
        const float value = column % 5 == 0 ? 1.0f : 0.0f;
        for (int i = 0; i < deformBlockSize; ++i) columns.matrix[column][i] = value;
    }
}

// ---- Morph targets

/// Copies the block at rest and adds the morph targets to it.
inline void morphBlock(const DeformJob& job, std::uint32_t block, const float* rest, int restWidth,
                       BlockColumns& columns) {
    __builtin_memcpy(columns.rest, rest,
                     sizeof(float) * deformBlockSize * static_cast<std::size_t>(restWidth));
    const std::uint32_t first = block * deformBlockSize;
    for (std::uint32_t i = 0; i < deformBlockSize && first + i < job.vertices; ++i) {
        for (std::uint32_t at = job.rows[first + i]; at < job.rows[first + i + 1]; ++at) {
            const MorphEntry& entry = job.entries[at];
            const float weight = job.morphWeights[entry.target];
            for (int c = 0; c < 3; ++c) {
                columns.rest[c][i] += weight * entry.position[c];
                columns.rest[3 + c][i] += weight * entry.normal[c];
                if (restWidth > restColumns) columns.rest[6 + c][i] += weight * entry.tangent[c];
            }
        }
    }
}

// ---- Transforming

inline Vec3 loadVec3(const float (*columns)[deformBlockSize], int i) {
    return {load(columns[0] + i), load(columns[1] + i), load(columns[2] + i)};
}

inline void storeVec3(float (*columns)[deformBlockSize], int i, Vec3 v) {
    store(columns[0] + i, v.x);
    store(columns[1] + i, v.y);
    store(columns[2] + i, v.z);
}

inline Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Of unit length, or zero where the vector has hardly any.
inline Vec3 unitOrZero(Vec3 v) {
    constexpr float minLength2 = 1e-30f;
    const Floats length2 = dot(v, v);
    const Floats scale = select(length2 > minLength2, inversesqrt(max(length2, minLength2)), splat(0.0f));
    return v * scale;
}

/// A row of the blended matrices: its linear part, and its translation.
struct MatrixRow {
    MatrixRow(const BlockColumns& columns, int row, int i)
        : linear(loadVec3(columns.matrix + 4 * row, i)), translation(load(columns.matrix[4 * row + 3] + i)) {}

    Vec3 linear;
    Floats translation;
};

/// `rest` is the block at rest, morph targets included.
template <bool hasTangents>
inline void transformBlock(const DeformJob& job, const float (*rest)[deformBlockSize],
                           BlockColumns& columns) {
    const Floats normalScale = splat(job.directionScale * job.directionScale);
    for (int i = 0; i < deformBlockSize; i += laneCount) {
        const MatrixRow x(columns, 0, i), y(columns, 1, i), z(columns, 2, i);
        const Vec3 position = loadVec3(rest, i), normal = loadVec3(rest + 3, i);
        storeVec3(columns.result, i,
                  {dot(x.linear, position) + x.translation, dot(y.linear, position) + y.translation,
                   dot(z.linear, position) + z.translation});
        // The rows of the cofactor matrix: det(M) times the inverse transpose. The scale brings matrices of
        // any common size to vectors of usual lengths.
        const Vec3 yz = cross(y.linear, z.linear), zx = cross(z.linear, x.linear),
                   xy = cross(x.linear, y.linear);
        const Floats side = select(dot(x.linear, yz) < 0.0f, splat(-1.0f), splat(1.0f));
        const Vec3 cofactor{dot(yz, normal), dot(zx, normal), dot(xy, normal)};
        storeVec3(columns.result + 3, i, unitOrZero(cofactor * normalScale) * side);
        if (!hasTangents) continue;
        const Vec3 tangent = loadVec3(rest + 6, i);
        const Vec3 moved{dot(x.linear, tangent), dot(y.linear, tangent), dot(z.linear, tangent)};
        storeVec3(columns.result + 6, i, unitOrZero(moved * splat(job.directionScale)));
        store(columns.result[9] + i, load(rest[9] + i) * side);
    }
}

// ---- Interleaving

/// Position and normal of the vertices `i` to `i` + 3.
template <typename Store>
inline void interleaveSurface(const BlockColumns& columns, int i, float* to, const Store& store) {
    const auto column = [&](int c) { return loadFour(columns.result[c] + i); };
    const Four x = column(0), y = column(1), z = column(2), nx = column(3), ny = column(4), nz = column(5);
    Four front[4] = {x, y, z, nx}, back[4] = {z, nx, ny, nz};
    transpose(front[0], front[1], front[2], front[3]);
    transpose(back[0], back[1], back[2], back[3]);
    const auto middle = [](Four normals, Four positions) {
        return __builtin_shufflevector(normals, positions, 2, 3, 4, 5);
    };
    store(to, front[0]);
    store(to + 4, middle(back[0], front[1]));
    store(to + 8, back[1]);
    store(to + 12, front[2]);
    store(to + 16, middle(back[2], front[3]));
    store(to + 20, back[3]);
}

inline void interleaveTangents(const BlockColumns& columns, int i, float* to) {
    Four t[4];
    for (int c = 0; c < 4; ++c) t[c] = loadFour(columns.result[6 + c] + i);
    transpose(t[0], t[1], t[2], t[3]);
    for (int v = 0; v < 4; ++v) storeFour(to + 4 * v, t[v]);
}

template <bool hasTangents>
inline void writeBlock(const DeformJob& job, std::uint32_t block, const BlockColumns& columns) {
    const std::uint32_t first = block * deformBlockSize;
    for (std::uint32_t i = 0; i < deformBlockSize && first + i < job.vertices; i += 4) {
        const std::size_t vertex = first + i, left = job.vertices - vertex, count = left < 4 ? left : 4;
        float* surface = job.surface + restColumns * vertex;
        float four[4 * restColumns];
        if (count == 4 && job.streams) {
            interleaveSurface(columns, static_cast<int>(i), surface, streamFour);
        } else {
            interleaveSurface(columns, static_cast<int>(i), count == 4 ? surface : four, storeFour);
        }
        if (count < 4) __builtin_memcpy(surface, four, sizeof(float) * restColumns * count);
        if (!hasTangents) continue;
        interleaveTangents(columns, static_cast<int>(i), count == 4 ? job.tangents + 4 * vertex : four);
        if (count < 4) __builtin_memcpy(job.tangents + 4 * vertex, four, sizeof(float) * 4 * count);
    }
}

template <bool hasTangents>
void deformBlocks(const DeformJob& job, std::uint32_t first, std::uint32_t end) {
    constexpr int restWidth = hasTangents ? restColumnsWithTangents : restColumns;
    BlockColumns columns;
    if (job.joints == nullptr) setIdentity(columns);
    for (std::uint32_t block = first; block < end; ++block) {
        const float* rest = job.rest + std::size_t{block} * restWidth * deformBlockSize;
        if (job.joints != nullptr) blendBlock(job, block, columns);
        if (job.morphWeights != nullptr) {
            morphBlock(job, block, rest, restWidth, columns);
            rest = columns.rest[0];
        }
        transformBlock<hasTangents>(job, reinterpret_cast<const float(*)[deformBlockSize]>(rest), columns);
        writeBlock<hasTangents>(job, block, columns);
    }
}

void deform(const DeformJob& job, std::uint32_t first, std::uint32_t end) {
    if (job.tangents != nullptr) {
        deformBlocks<true>(job, first, end);
    } else {
        deformBlocks<false>(job, first, end);
    }
    if (job.streams) endStreaming();
}

}  // namespace

extern const DeformKernel CANDELA_DEFORM_KERNEL;
const DeformKernel CANDELA_DEFORM_KERNEL{CANDELA_KERNEL_NAME, deform};

}  // namespace candela
