#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace candela {

/// Vertices on the screen, an element of each column a vertex.
struct ScreenColumns {
    float *x, *y;   ///< Pixels from the lower left corner of the picture.
    float* margin;  ///< Pixels by which the rasteriser may place the vertex elsewhere.
    float* depth;   ///< Clip-space w, at least.
};

/// The margin of a vertex that is not placed: at the eye's plane or behind it. Such a vertex may be anywhere.
constexpr float anywhere = 1.0e30f;

/// A run of vertices and where it is on the screen. Plain numbers only: each kernel is compiled for its own
/// instruction set and must not share inline functions with other files.
struct ScreenTransform {
    const float* vertices;  ///< Position and normal, `vertexFloats` each.
    std::uint32_t count;
    float rows[3][4];   ///< From a position to x and y in pixels, both times w, and to w.
    float errors[3];    ///< Of these, at most, together with that of the device.
    ScreenColumns out;  ///< With room for a multiple of `filterPadding` elements.
};
constexpr int vertexFloats = 6;
/// Elements of a vector of the widest instruction set. The kernels write whole vectors.
constexpr int filterPadding = 16;

/// A run of triangles.
struct FilterTriangles {
    ScreenColumns vertices;  ///< That of index 0.
    const std::uint32_t* indices;
    std::uint32_t count;  ///< Triangles.
    float width, height;  ///< Of the picture, pixels.
    float nearDepth;      ///< A triangle of less w than this is not drawn.
    float facing;         ///< 1: clockwise triangles are not drawn; -1: counter-clockwise ones; 0: all are.
    std::uint32_t* out;
};

/// The functions of one instruction set.
struct TriangleFilterKernel {
    const char* name;
    void (*transform)(const ScreenTransform& job);
    /// Writes the indices of the triangles that may cover a sample, in their order. Returns how many indices
    /// those are.
    std::uint32_t (*filter)(const FilterTriangles& job);
};

/// One for each instruction set that this build has and this processor runs, widest first.
std::vector<const TriangleFilterKernel*> triangleFilterKernels();

}  // namespace candela
