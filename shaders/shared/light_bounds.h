// Which tiles of the picture a light's sphere may reach, read by C++ and GLSL both: the tile kernels, the compute passes of the technique
// `tiles`, and the culling of light volumes. The includer defines Real and SHARED_FUNCTION as for shared/shading.h; Real is a number or a
// vector of them.

// The view frustum without a far plane, in camera space: x points right, y up, and depth forward.
struct ViewFrustum {
    float nearPlane;
    float halfWidth, halfHeight;   // of the picture at a depth of one metre; 0 in an orthographic view
    float edgeScaleX, edgeScaleY;  // see edgeScale
    float baseWidth, baseHeight;   // half of the picture's width and height in an orthographic view; 0 in a perspective one
    float shiftX, shiftY;          // CameraView::shift: of the picture's middle from the axis, in units of its width and height
};

// 1 / length of the normal of the side plane that is farther from the axis. With a shift the distance to the opposite plane is underestimated.
SHARED_FUNCTION float edgeScale(float halfExtent, float shift) {
    float slope = halfExtent * (1.0f + 2.0f * (shift < 0.0f ? -shift : shift));
    return 1.0f / sqrt(1.0f + slope * slope);
}

// How far a point lies outside of the planes of the frustum, or less than that; negative inside. A sphere whose radius is less lies wholly outside.
SHARED_FUNCTION Real distanceToFrustum(ViewFrustum frustum, Real x, Real y, Real depth) {
    Real halfWidth = frustum.baseWidth + depth * frustum.halfWidth, halfHeight = frustum.baseHeight + depth * frustum.halfHeight;
    Real beside = (abs(x - 2.0f * frustum.shiftX * halfWidth) - halfWidth) * frustum.edgeScaleX;
    Real above = (abs(y - 2.0f * frustum.shiftY * halfHeight) - halfHeight) * frustum.edgeScaleY;
    return max(max(beside, above), frustum.nearPlane - depth);
}

// The part of the picture's width or height that a sphere's projection covers: from 0 at the left or lower edge to 1, not clipped.
struct Span {
    float first, last;
};

// The sphere lies wholly in front of the near plane. Tangent lines from the eye, after Mara and McGuire, "2D polyhedral bounds of a
// clipped, perspective-projected 3D sphere", 2013. `side` is x or y, and `halfExtent`, `base` and `shift` belong to it.
SHARED_FUNCTION Span projectedSpan(float side, float depth, float radius, float halfExtent, float base, float shift) {
    Span span;
    float axis = 0.5f - shift;
    if (base > 0.0f) {
        span.first = axis + 0.5f * (side - radius) / base;
        span.last = axis + 0.5f * (side + radius) / base;
        return span;
    }
    float radius2 = radius * radius;
    float reach = radius * sqrt(max(side * side + depth * depth - radius2, 0.0f));
    float scale = 0.5f / (halfExtent * (depth * depth - radius2));
    span.first = axis + (side * depth - reach) * scale;
    span.last = axis + (side * depth + reach) * scale;
    return span;
}

// A picture of width × height pixels, cut into columns × rows tiles of tileSize × tileSize.
struct TileGrid {
    int width, height, tileSize, columns, rows;
};

// Both ends included.
struct TileRange {
    int left, bottom, right, top;
};

SHARED_FUNCTION int tileOf(float pixel, int tileSize, int tiles) {
    if (!(pixel > 0.0f)) return 0;
    return pixel < float(tiles * tileSize) ? int(pixel) / tileSize : tiles - 1;
}

// The tiles under the projection of a sphere that meets the frustum, one pixel wider for rounding; all of them where the sphere reaches the
// near plane.
SHARED_FUNCTION TileRange tilesUnder(TileGrid grid, ViewFrustum frustum, float x, float y, float depth, float radius) {
    TileRange tiles;
    tiles.left = 0;
    tiles.bottom = 0;
    tiles.right = grid.columns - 1;
    tiles.top = grid.rows - 1;
    if (depth - radius <= frustum.nearPlane) return tiles;
    Span across = projectedSpan(x, depth, radius, frustum.halfWidth, frustum.baseWidth, frustum.shiftX);
    Span along = projectedSpan(y, depth, radius, frustum.halfHeight, frustum.baseHeight, frustum.shiftY);
    tiles.left = tileOf(across.first * float(grid.width) - 1.0f, grid.tileSize, grid.columns);
    tiles.right = tileOf(across.last * float(grid.width) + 1.0f, grid.tileSize, grid.columns);
    tiles.bottom = tileOf(along.first * float(grid.height) - 1.0f, grid.tileSize, grid.rows);
    tiles.top = tileOf(along.last * float(grid.height) + 1.0f, grid.tileSize, grid.rows);
    return tiles;
}
