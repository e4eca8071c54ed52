// What the triangle filter reads, plain numbers only: std430, read by C++ and GLSL both. shared/triangle_filter.h has the tests.

// How an instance is seen. Screen coordinates are pixels from the lower left corner of the picture.
struct FilterView {
    float rows[3][4];   // from a position of the mesh to x and y on the screen, both times w, and to w
    float screenError;  // of x and y times w, at most: what the device and the filter round
    float depthError;   // of w
    float nearDepth;    // what has less w than this is not drawn
    float width, height;
    float snapping;  // pixels by which the rasteriser may place a vertex elsewhere, at most
    float facing;    // 1: clockwise triangles are not drawn; -1: counter-clockwise ones; 0: all are
    // The centre of projection in the mesh's coordinates, times the last component; that is 0 in an orthographic view.
    float eye[4];
    float eyeError;                // of differences of `eye` and positions of the mesh
    float xx, xy, xw, yy, yw, ww;  // dot products of the first three numbers of two rows
    float lengthW;                 // root of the last
    float reserved;
};

const int CLUSTER_TRIANGLES = 64;

// Consecutive triangles of a mesh, CLUSTER_TRIANGLES at most.
struct TriangleCluster {
    float center[3], radius;  // of a sphere around the triangles
    float axis[3], cosine;    // of a cone that holds their normals; cosine of half its angle, or less; 0: there is none
    float altitude;           // of the flattest triangle, over its longest edge, or less
    float reserved[3];
};

// A draw of one instance, for the compute shaders.
struct FilterDraw {
    FilterView view;
    uint firstCluster;  // in the scene
    uint firstGroup;    // of the groups of threads that take its clusters, one each
    uint groupEnd;
    uint firstIndex, indexCount;
    int baseVertex;
    uint command;  // its place
    uint reserved;
};

// What the compute shaders find of a cluster.
struct ClusterResult {
    uint kept[2];  // a bit a triangle
    uint tested;   // 1 where the cluster was not dropped as a whole
    uint start;    // triangles kept before it, from the first cluster of its block on
};

const uint BLOCK_CLUSTERS = 1024u;   // clusters whose sums are added in shared memory
const uint GROUPS_PER_ROW = 65535u;  // groups of threads along an axis, which every device takes
