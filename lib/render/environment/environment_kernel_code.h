#pragma once

// The kernels that filter environments on the CPU. Each render/kernels_*.cpp includes this once and is
// compiled for its own instruction set, with CANDELA_ENVIRONMENT_KERNEL naming the table it defines.
// Everything here has internal linkage, and no inline function of a library is used (see
// lighting/tiled/tile_kernel_code.h).

#include "render/environment/environment_kernel.h"

#include "render/occlusion/visibility_filter_code.h"
#include "render/simd.h"

namespace candela {
namespace {

constexpr int texelsPerFilterBlock = filterBlockSize * filterBlockSize;

inline float scalarMax(float a, float b) {
    return a > b ? a : b;
}
inline float scalarAbs(float a) {
    return a < 0.0f ? -a : a;
}

/// The unit direction of a texel of an octahedral map with `size` texels along a side. The outer ones lie on
/// its edges.
inline void texelDirection(int column, int row, int size, float* direction) {
    float x = 2.0f * static_cast<float>(column) / static_cast<float>(size - 1) - 1.0f;
    float z = 2.0f * static_cast<float>(row) / static_cast<float>(size - 1) - 1.0f;
    const float y = 1.0f - scalarAbs(x) - scalarAbs(z);
    const float below = scalarMax(-y, 0.0f);
    x += x < 0.0f ? below : -below;
    z += z < 0.0f ? below : -below;
    const float scale = 1.0f / __builtin_sqrtf(x * x + y * y + z * z);
    direction[0] = x * scale, direction[1] = y * scale, direction[2] = z * scale;
}

/// The directions of texels, a column of numbers an axis.
template <int count>
struct TexelDirections {
    float x[count], y[count], z[count];

    void set(int i, int column, int row, int size) {
        float direction[3];
        texelDirection(column, row, size, direction);
        x[i] = direction[0], y[i] = direction[1], z[i] = direction[2];
    }
};

using BlockDirections = TexelDirections<texelsPerFilterBlock>;

/// What holds the directions of a block.
struct Cone {
    float x, y, z;
    float radius;  ///< The largest distance on the unit sphere, as a chord.
};

inline Cone coneOf(const BlockDirections& block) {
    Cone cone{0.0f, 0.0f, 0.0f, 0.0f};
    for (int i = 0; i < texelsPerFilterBlock; ++i)
        cone.x += block.x[i], cone.y += block.y[i], cone.z += block.z[i];
    const float scale = 1.0f / __builtin_sqrtf(cone.x * cone.x + cone.y * cone.y + cone.z * cone.z);
    cone.x *= scale, cone.y *= scale, cone.z *= scale;
    float radius2 = 0.0f;
    for (int i = 0; i < texelsPerFilterBlock; ++i) {
        const float x = block.x[i] - cone.x, y = block.y[i] - cone.y, z = block.z[i] - cone.z;
        radius2 = scalarMax(radius2, x * x + y * y + z * z);
    }
    cone.radius = __builtin_sqrtf(radius2);
    return cone;
}

/// Lists the cells that a block reads, each as coarse as `cellShare` allows, and returns their number.
inline int listCells(const FilterJob& job, const Cone& cone, const EnvironmentCell** list) {
    struct Node {
        int level, column, row;
    };
    // Four nodes of the coarsest grid's rows and columns, then three more a level: depth first.
    Node stack[4 * 16];
    int depth = 0, count = 0;
    const int coarsest = job.grids[0].size;
    for (int top = 0; top < coarsest * coarsest; ++top) {
        stack[depth++] = {0, top % coarsest, top / coarsest};
        while (depth > 0) {
            const Node node = stack[--depth];
            const CellGrid& grid = job.grids[node.level];
            const EnvironmentCell& cell = grid.cells[node.row * grid.size + node.column];
            if (cell.solidAngle <= 0.0f) continue;
            const float x = cell.direction[0], y = cell.direction[1], z = cell.direction[2];
            const float dot = x * cone.x + y * cone.y + z * cone.z;
            if (dot < -(cone.radius + cell.side)) continue;  // Below the horizon of the whole block.
            constexpr float lobeWidth = 1.3f;                // Half width at half maximum, over alpha.
            const float needed = cell.side / job.cellShare - lobeWidth * job.alpha + cone.radius;
            const bool isFar = needed <= 0.0f || 2.0f - 2.0f * dot >= needed * needed;
            if (isFar || node.level + 1 == job.gridCount) {
                list[count++] = &cell;
                continue;
            }
            for (int child = 0; child < 4; ++child)
                stack[depth++] = {node.level + 1, 2 * node.column + child % 2, 2 * node.row + child / 2};
        }
    }
    return count;
}

/// The lobe for n = v = r: D(h) (n·l) / 4 up to a factor, where h is half way between l and r. With the chord
/// t = |l - r|, (n·h)² = 1 - t² / 4. Of Karis, "Real shading in Unreal Engine 4", 2013.
inline Floats lobeWeight(Floats chord2, float alpha2) {
    const Floats q = alpha2 + (0.25f * (1.0f - alpha2)) * chord2;
    return max(1.0f - 0.5f * chord2, 0.0f) * reciprocal(q * q);
}

/// A map to be filled.
struct TargetMap {
    float* texels;  ///< RGBA.
    int size;       ///< Texels along a side.

    /// Writes those texels of a block from `first` on that are in the map.
    void write(const Vec3& color, int left, int top, int first) const {
        float red[laneCount], green[laneCount], blue[laneCount];
        store(red, color.x), store(green, color.y), store(blue, color.z);
        for (int lane = 0; lane < laneCount; ++lane) {
            const int column = left + (first + lane) % filterBlockSize,
                      row = top + (first + lane) / filterBlockSize;
            if (column >= size || row >= size) continue;
            float* texel = texels + 4 * (row * size + column);
            texel[0] = red[lane], texel[1] = green[lane], texel[2] = blue[lane], texel[3] = 0.0f;
        }
    }
};

inline void filterBlock(const FilterJob& job, int left, int top, const EnvironmentCell** scratch) {
    BlockDirections block;
    for (int i = 0; i < texelsPerFilterBlock; ++i)
        block.set(i, left + i % filterBlockSize, top + i / filterBlockSize, job.size);
    const int count = listCells(job, coneOf(block), scratch);
    const float alpha2 = job.alpha * job.alpha;
    for (int first = 0; first < texelsPerFilterBlock; first += laneCount) {
        const Vec3 r{load(block.x + first), load(block.y + first), load(block.z + first)};
        Vec3 sum(0.0f);
        Floats whole = splat(0.0f);
        for (int i = 0; i < count; ++i) {
            const EnvironmentCell& cell = *scratch[i];
            const Vec3 way = splat3(cell.direction) - r;
            const Floats weight = lobeWeight(dot(way, way), alpha2);
            sum = sum + splat3(cell.energy) * weight;
            whole = whole + weight * cell.solidAngle;
        }
        // Dividing by the weights of the same cells keeps a constant picture constant.
        TargetMap{job.texels, job.size}.write(sum * (1.0f / max(whole, 1.0e-30f)), left, top, first);
    }
}

void filterRow(const FilterJob& job, int row, const EnvironmentCell** scratch) {
    for (int left = 0; left < job.size; left += filterBlockSize)
        filterBlock(job, left, row * filterBlockSize, scratch);
}

/// The mean over a cell of the cosine to a normal, or 0 where it is negative. `cosine` is that of the cell's
/// middle; the cosines within it are spread evenly by `half` in both directions.
inline Floats meanCellCosine(Floats cosine, float half) {
    const Floats above = min(max(cosine + half, 0.0f), 2.0f * half);
    return above * above * (0.25f / half) + max(cosine - half, 0.0f);
}

struct CellSums {
    Vec3 energy;
    Floats whole;  ///< pi up to the error of the sum.
};

inline void addCell(const EnvironmentCell& cell, const Vec3& normal, CellSums& sums) {
    // The mean of unit vectors over a square is shorter than 1.
    const float length = 1.0f - cell.side * cell.side * (1.0f / 12.0f);
    const Floats cosine = meanCellCosine(dot(normal, splat3(cell.direction)), 0.5f * cell.side) * length;
    sums.energy = sums.energy + splat3(cell.energy) * cosine;
    sums.whole = sums.whole + cosine * cell.solidAngle;
}

/// Where a cell lies for all normals of a block.
enum class HorizonSide { below, crossed, above };

inline HorizonSide horizonSide(const EnvironmentCell& cell, const Cone& cone) {
    const float* d = cell.direction;
    const float cosine = d[0] * cone.x + d[1] * cone.y + d[2] * cone.z, reach = cone.radius + cell.side;
    if (cosine < -reach) return HorizonSide::below;
    return cosine > reach ? HorizonSide::above : HorizonSide::crossed;
}

inline bool isDark(const EnvironmentCell& cell) {
    return cell.energy[0] + cell.energy[1] + cell.energy[2] <= 0.0f;
}

inline int listParts(const CellGrid& parts, int column, int row, const EnvironmentCell** list) {
    int count = 0;
    for (int part = 0; part < 4; ++part) {
        const EnvironmentCell& cell = parts.cells[(2 * row + part / 2) * parts.size + 2 * column + part % 2];
        if (cell.solidAngle > 0.0f) list[count++] = &cell;
    }
    return count;
}

/// Lists the cells that light a block of normals, and returns their number. Above the horizon of all normals
/// irradiance is linear in the direction, so that a cell is as exact as its parts are. Where the horizon may
/// cross it, its parts stand for it.
inline int listLights(const IrradianceJob& job, const Cone& cone, const EnvironmentCell** list) {
    constexpr int side = 4;  // Cells along a side of an outline.
    int count = 0;
    for (int outline = 0; outline < job.outlines.size * job.outlines.size; ++outline) {
        const HorizonSide around = horizonSide(job.outlines.cells[outline], cone);
        if (around == HorizonSide::below) continue;
        for (int i = 0; i < side * side; ++i) {
            const int column = outline % job.outlines.size * side + i % side,
                      row = outline / job.outlines.size * side + i / side;
            const EnvironmentCell& cell = job.cells.cells[row * job.cells.size + column];
            const HorizonSide where = around == HorizonSide::above ? around : horizonSide(cell, cone);
            if (where == HorizonSide::crossed && !isDark(cell))
                count += listParts(job.parts, column, row, list + count);
            else if (where != HorizonSide::below && cell.solidAngle > 0.0f)
                list[count++] = &cell;
        }
    }
    return count;
}

inline void irradianceBlock(const IrradianceJob& job, int left, int top, const EnvironmentCell** scratch) {
    constexpr float pi = 3.14159265f;
    BlockDirections block;
    for (int i = 0; i < texelsPerFilterBlock; ++i)
        block.set(i, left + i % filterBlockSize, top + i / filterBlockSize, job.size);
    const int count = listLights(job, coneOf(block), scratch);
    for (int first = 0; first < texelsPerFilterBlock; first += laneCount) {
        const Vec3 normal{load(block.x + first), load(block.y + first), load(block.z + first)};
        CellSums sums{Vec3(0.0f), splat(0.0f)};
        for (int i = 0; i < count; ++i) addCell(*scratch[i], normal, sums);
        // The quotient cancels the error that both sums have.
        TargetMap{job.texels, job.size}.write(sums.energy * (pi / max(sums.whole, 1.0e-30f)), left, top,
                                              first);
    }
}

void irradianceRow(const IrradianceJob& job, int row, const EnvironmentCell** scratch) {
    for (int left = 0; left < job.size; left += filterBlockSize)
        irradianceBlock(job, left, row * filterBlockSize, scratch);
}

}  // namespace

extern const EnvironmentKernel CANDELA_ENVIRONMENT_KERNEL;
const EnvironmentKernel CANDELA_ENVIRONMENT_KERNEL{CANDELA_KERNEL_NAME, filterRow, irradianceRow,
                                                   filterVisibilityRow};

}  // namespace candela
