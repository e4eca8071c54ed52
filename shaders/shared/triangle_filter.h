// Which triangles surely leave no trace in a picture, because they face away, are behind the near plane, or cover no pixel's centre. Exact:
// what the device rounds is bounded, so that the picture stays the same bit for bit. After Wihlidal, "Optimizing the graphics pipeline with
// compute", GDC 2016. The kernels of the CPU compile this over vectors of floats, compute shaders over floats.
//
// The includer defines
//   Real, Mask       a number and a truth value, or vectors of them
//   SHARED_FUNCTION  what C++ puts before a function; nothing in GLSL
//   both, either, negated, select(mask, a, b), splat, reciprocal, wholeNumber
// besides the functions that GLSL has, and includes shared/triangle_filter_records.h. `splat` makes a Real of a float; `wholeNumber` rounds
// numbers from 0 to the size of a picture up.

SHARED_FUNCTION Real rowTimes(float row[4], Real x, Real y, Real z) {
    return row[0] * x + row[1] * y + row[2] * z + row[3];
}

SHARED_FUNCTION Real min3(Real a, Real b, Real c) {
    return min(min(a, b), c);
}
SHARED_FUNCTION Real max3(Real a, Real b, Real c) {
    return max(max(a, b), c);
}

// The least w at which a point has a place on the screen: the divisor is off by an eighth at most.
SHARED_FUNCTION float minDepth(FilterView view) {
    return 8.0f * view.depthError;
}

// Pixels by which a point may lie elsewhere. `extent` is the largest of its coordinates, `inverse` 1 / w.
SHARED_FUNCTION Real marginOf(FilterView view, Real extent, Real inverse) {
    // Quotient and viewport transform round 1e-6 of the coordinate at most.
    return 1.15f * (view.screenError + extent * view.depthError) * inverse + extent * 1.0e-6f + view.snapping;
}

// The centres of pixels, of `size` pixels, between two coordinates, which reach a margin beyond what is meant. Counted from 0.
struct CenterSpan {
    Real first;
    Real last;  // not whole; less than `first`: there are none
};

SHARED_FUNCTION CenterSpan centersBetween(Real low, Real high, float size) {
    CenterSpan span;
    span.first = wholeNumber(min(max(low - 0.5f, splat(0.0f)), splat(size)));
    span.last = min(high - 0.5f, splat(size - 1.0f));
    return span;
}

struct ScreenCorner {
    Real x, y;
    Real w;
    Real inverse;  // 1 / w; 1 where that has no place on the screen
};

SHARED_FUNCTION ScreenCorner cornerOf(FilterView view, Real x, Real y, Real z) {
    ScreenCorner corner;
    corner.w = rowTimes(view.rows[2], x, y, z);
    corner.inverse = reciprocal(select(corner.w > minDepth(view), corner.w, splat(1.0f)));
    corner.x = rowTimes(view.rows[0], x, y, z) * corner.inverse;
    corner.y = rowTimes(view.rows[1], x, y, z) * corner.inverse;
    return corner;
}

// A triangle on the screen, all of whose corners have a place there.
struct ScreenTriangle {
    Real x, y;                // first corner
    Real abx, aby, acx, acy;  // edges from there
    Real area;                // twice it
    Real areaError;
    Real orientation;  // 1: counter-clockwise where it is drawn, or -1
    Real edgeError;    // of the areas of a pixel's centre and an edge
};

// Is a point, relative to the first corner, surely outside?
SHARED_FUNCTION Mask isOutside(ScreenTriangle triangle, Real x, Real y) {
    Real ab = triangle.abx * y - triangle.aby * x;
    Real ca = triangle.acy * x - triangle.acx * y;
    Real bc = triangle.area - ab - ca;
    return min3(ab * triangle.orientation, bc * triangle.orientation, ca * triangle.orientation) < -triangle.edgeError;
}

SHARED_FUNCTION Mask missesCenters(ScreenTriangle triangle, CenterSpan columns, CenterSpan rows) {
    Real left = columns.first + 0.5f - triangle.x, bottom = rows.first + 0.5f - triangle.y;
    Real right = left + select(columns.first + 1.0f <= columns.last, splat(1.0f), splat(0.0f));
    Real top = bottom + select(rows.first + 1.0f <= rows.last, splat(1.0f), splat(0.0f));
    Mask few = both(columns.last < columns.first + 2.0f, rows.last < rows.first + 2.0f);
    Mask outside = both(both(isOutside(triangle, left, bottom), isOutside(triangle, right, bottom)),
                        both(isOutside(triangle, left, top), isOutside(triangle, right, top)));
    return both(few, outside);
}

// What a triangle covers of the picture's columns and rows at most.
struct ScreenBox {
    CenterSpan columns, rows;
    Real margin;
    Real size;  // half of what is around it, the margins of corners included twice
};

SHARED_FUNCTION Mask holdsCenter(CenterSpan columns, CenterSpan rows) {
    return both(columns.first <= columns.last, rows.first <= rows.last);
}

// All that the minima and maxima of the corners tell.
SHARED_FUNCTION ScreenBox boxOf(FilterView view, ScreenCorner a, ScreenCorner b, ScreenCorner c) {
    Real left = min3(a.x, b.x, c.x), right = max3(a.x, b.x, c.x);
    Real bottom = min3(a.y, b.y, c.y), top = max3(a.y, b.y, c.y);
    Real extent = max(max(abs(left), abs(right)), max(abs(bottom), abs(top)));
    ScreenBox box;
    box.margin = marginOf(view, extent, max3(a.inverse, b.inverse, c.inverse));
    box.columns = centersBetween(left - box.margin, right + box.margin, view.width);
    box.rows = centersBetween(bottom - box.margin, top + box.margin, view.height);
    box.size = (right - left) + (top - bottom) + 4.0f * box.margin;
    return box;
}

SHARED_FUNCTION ScreenTriangle triangleOf(FilterView view, ScreenBox box, ScreenCorner a, ScreenCorner b, ScreenCorner c) {
    ScreenTriangle triangle;
    triangle.x = a.x;
    triangle.y = a.y;
    triangle.abx = b.x - a.x;
    triangle.aby = b.y - a.y;
    triangle.acx = c.x - a.x;
    triangle.acy = c.y - a.y;
    triangle.area = triangle.abx * triangle.acy - triangle.acx * triangle.aby;
    // Each difference is off by two margins; and what the products round.
    Real reach = abs(triangle.abx) + abs(triangle.aby) + abs(triangle.acx) + abs(triangle.acy);
    triangle.areaError = box.margin * (2.0f * reach + 8.0f * box.margin) + 1.0e-6f * reach * reach;
    triangle.orientation = view.facing != 0.0f ? splat(view.facing) : select(triangle.area < 0.0f, splat(-1.0f), splat(1.0f));
    // A centre in the box is off by a margin from a corner, and an edge by two.
    triangle.edgeError = box.margin * (3.0f * box.size + 4.0f * box.margin) + 4.0e-6f * box.size * box.size;
    return triangle;
}

// May a triangle leave a trace? False only where it surely does not.
SHARED_FUNCTION Mask mayShow(FilterView view, ScreenCorner a, ScreenCorner b, ScreenCorner c) {
    ScreenBox box = boxOf(view, a, b, c);
    ScreenTriangle triangle = triangleOf(view, box, a, b, c);
    Mask kept = holdsCenter(box.columns, box.rows);
    Mask misses = missesCenters(triangle, box.columns, box.rows);
    if (view.facing != 0.0f) {
        kept = both(kept, both(triangle.area * view.facing >= -triangle.areaError, negated(misses)));
    } else {
        // Where a triangle may face either way, its edges tell nothing.
        kept = both(kept, negated(both(misses, abs(triangle.area) > triangle.areaError)));
    }
    Mask placed = min3(a.w, b.w, c.w) > minDepth(view);
    Mask inFront = max3(a.w, b.w, c.w) + view.depthError >= view.nearDepth;
    return both(inFront, either(kept, negated(placed)));
}

// A vector of clusters, see TriangleCluster.
struct ClusterBounds {
    Real x, y, z, radius;
    Real axisX, axisY, axisZ, cosine;
    Real altitude;
};

// A screen coordinate of a cluster's points.
struct ClusterReach {
    Real center;
    Real slope2;  // squared length of (row - coordinate × row of w): a way d from the centre changes the coordinate by its product with d,
                  // over w
    Real rounding;  // of that, at most; included
    Real points;    // how far from that of the centre those of the points lie, at most
};

// `rowRow` and `rowW` are the dot products of the view; `inverse` is 1 / the least w of the cluster.
SHARED_FUNCTION ClusterReach reachAlong(FilterView view, float rowRow, float rowW, Real center, Real radius, Real inverse) {
    ClusterReach reach;
    reach.center = center;
    reach.rounding = 1.0e-6f * (rowRow + center * center * view.ww) + 1.0e-20f;
    reach.slope2 = max(rowRow - 2.0f * center * rowW + center * center * view.ww, splat(0.0f)) + reach.rounding;
    reach.points = radius * sqrt(reach.slope2) * inverse;
    return reach;
}

// Pixels that an edge of unit length spans, at most: the norm of the two slopes, and by how much it may differ at other points.
SHARED_FUNCTION Real edgeReach(FilterView view, ClusterReach x, ClusterReach y, Real inverse) {
    Real product = view.xy - x.center * view.yw - y.center * view.xw + x.center * y.center * view.ww;
    Real mean = 0.5f * (x.slope2 + y.slope2), difference = 0.5f * (x.slope2 - y.slope2);
    Real mixed = abs(product) + x.rounding + y.rounding;
    return (sqrt(mean + sqrt(difference * difference + mixed * mixed)) + (x.points + y.points) * view.lengthW) * inverse;
}

// Do all triangles surely face away, with areas on the screen that the device cannot round to another sign? `edges` is `edgeReach`,
// `margin` that of a point, `farthest` the largest w.
SHARED_FUNCTION Mask facesAway(FilterView view, ClusterBounds cluster, Real edges, Real margin, Real farthest) {
    Real toX = view.eye[3] * cluster.x - view.eye[0], toY = view.eye[3] * cluster.y - view.eye[1],
         toZ = view.eye[3] * cluster.z - view.eye[2];
    Real along = (toX * cluster.axisX + toY * cluster.axisY + toZ * cluster.axisZ) * view.facing;
    Real across = sqrt(max(toX * toX + toY * toY + toZ * toZ - along * along, splat(0.0f)) + 1.0e-6f * along * along);
    Real sine = sqrt(max(1.0f - cluster.cosine * cluster.cosine, splat(0.0f))) * 1.00001f;
    // The product of any normal of the cone and the way from the eye to any point of the sphere is this or less. Times the doubled area of
    // a triangle and over the product of the corners' w it is the doubled area on the screen.
    Real maxProduct = along * cluster.cosine + across * sine + abs(splat(view.eye[3])) * cluster.radius + view.eyeError;
    // The doubled area is the longest edge times the altitude. `areaError` of `triangleOf` is less than 2.8 margins times the sum of two
    // edges along x and y where the area is more than that, and the sum is 2.83 longest edges or less.
    Real areaPerEdge = -maxProduct * cluster.altitude;
    Mask away = along < 0.0f, large = areaPerEdge > 8.0f * margin * edges * farthest * farthest * farthest;
    return both(away, large);
}

// May a triangle of a cluster leave a trace? False only where none does.
SHARED_FUNCTION Mask mayShowAny(FilterView view, ClusterBounds cluster) {
    Real w = rowTimes(view.rows[2], cluster.x, cluster.y, cluster.z);
    Real reachW = cluster.radius * view.lengthW + view.depthError;
    Mask placed = w - reachW > minDepth(view);
    Real overW = reciprocal(select(placed, w, splat(1.0f))), overNearest = reciprocal(select(placed, w - reachW, splat(1.0f)));
    ClusterReach x =
        reachAlong(view, view.xx, view.xw, rowTimes(view.rows[0], cluster.x, cluster.y, cluster.z) * overW, cluster.radius, overNearest);
    ClusterReach y =
        reachAlong(view, view.yy, view.yw, rowTimes(view.rows[1], cluster.x, cluster.y, cluster.z) * overW, cluster.radius, overNearest);
    Real margin = marginOf(view, max(abs(x.center) + x.points, abs(y.center) + y.points), overNearest);
    CenterSpan columns = centersBetween(x.center - x.points - margin, x.center + x.points + margin, view.width);
    CenterSpan rows = centersBetween(y.center - y.points - margin, y.center + y.points + margin, view.height);
    Mask kept = holdsCenter(columns, rows);
    if (view.facing != 0.0f) kept = both(kept, negated(facesAway(view, cluster, edgeReach(view, x, y, overNearest), margin, w + reachW)));
    return both(w + reachW >= view.nearDepth, either(kept, negated(placed)));
}
