// Lines over the image: visible lines of the wireframe are drawn whole, and nothing else is.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include <candela/color.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace candela::test {
namespace {

constexpr int width = 160, height = 120;

glm::mat4 at(const glm::vec3& position) {
    return glm::translate(glm::mat4(1.0f), position);
}

FrameRequest frameOf(const CameraView& view, const Overlays& overlays) {
    FrameRequest inputs{width, height, view, BrdfModel::course, Technique::volumes};
    inputs.overlays = overlays;
    return inputs;
}

/// The coordinates of a pixel, y from the top.
struct Pixel {
    int x, y;
    auto operator<=>(const Pixel&) const = default;
};
using Pixels = std::set<Pixel>;

/// The faces of a cube from -1 to 1, none of whose vertices they share.
Mesh makeCube() {
    Mesh mesh;
    const glm::mat3 rotations[] = {{1, 0, 0, 0, 1, 0, 0, 0, 1},  {-1, 0, 0, 0, 1, 0, 0, 0, -1},
                                   {0, 0, -1, 0, 1, 0, 1, 0, 0}, {0, 0, 1, 0, 1, 0, -1, 0, 0},
                                   {1, 0, 0, 0, 0, -1, 0, 1, 0}, {1, 0, 0, 0, 0, 1, 0, -1, 0}};
    const Mesh quad = makeQuad(1.0f);
    for (const glm::mat3& rotation : rotations) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec3& p : quad.positions)
            mesh.positions.push_back(rotation * (p + glm::vec3(0, 0, 1)));
        mesh.normals.insert(mesh.normals.end(), 4, rotation[2]);
        for (const std::uint32_t index : quad.indices) mesh.indices.push_back(first + index);
    }
    return mesh;
}

struct Edge {
    glm::vec3 from, to;
};

/// The edges of all triangles of a mesh that face the eye.
std::vector<Edge> frontEdges(const Mesh& mesh, const glm::vec3& eye) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::array corners{mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                                 mesh.positions[mesh.indices[i + 2]]};
        const glm::vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        if (glm::dot(normal, eye - corners[0]) <= 0.0f) continue;
        for (std::size_t c = 0; c < 3; ++c) edges.push_back({corners[c], corners[(c + 1) % 3]});
    }
    return edges;
}

class OverlayTest : public DrawingTest {
  protected:
    static std::vector<std::uint8_t> displayed(auto&& scene, const FrameRequest& inputs) {
        render(scene, inputs);
        return lastFrame().displayPicture(ColorConfig::builtIn().displayTransform({}));
    }

    /// The pixels that overlays change.
    static Pixels lines(auto&& scene, const CameraView& view, const Overlays& overlays,
                        DebugView debugView = DebugView::none) {
        FrameRequest inputs = frameOf(view, overlays);
        inputs.debugView = debugView;
        const std::vector<std::uint8_t> with = displayed(scene, inputs);
        inputs.overlays = {};
        const std::vector<std::uint8_t> without = displayed(scene, inputs);
        Pixels changed;
        for (int i = 0; i < width * height; ++i) {
            if (!std::equal(&with[std::size_t(4 * i)], &with[std::size_t(4 * i + 4)],
                            &without[std::size_t(4 * i)]))
                changed.insert({i % width, i / width});
        }
        return changed;
    }

    static constexpr Overlays wireframe{.wireframe = true};
};

/// The projection of an edge, in pixels from the upper left corner: points less than a tenth of a pixel
/// apart, of the part in front of the near plane.
std::vector<glm::vec2> project(const CameraView& view, const Edge& edge) {
    const glm::mat4 clipFromWorld =
        projection(view, float(width) / float(height)) * glm::inverse(view.worldFromCamera);
    const glm::vec4 from = clipFromWorld * glm::vec4(edge.from, 1),
                    to = clipFromWorld * glm::vec4(edge.to, 1);
    std::vector<glm::vec2> points;
    constexpr int steps = 20000;
    for (int i = 0; i <= steps; ++i) {
        const glm::vec4 clip = glm::mix(from, to, float(i) / steps);
        if (clip.w <= view.nearPlane) continue;
        const glm::vec2 point((0.5f + 0.5f * clip.x / clip.w) * width,
                              (0.5f - 0.5f * clip.y / clip.w) * height);
        if (points.empty() || glm::distance(points.back(), point) >= 0.1f) points.push_back(point);
    }
    return points;
}

Pixel pixelAt(const glm::vec2& position) {
    return {int(std::floor(position.x)), int(std::floor(position.y))};
}

bool isInside(const Pixel& pixel) {
    return pixel.x > 1 && pixel.x < width - 2 && pixel.y > 1 && pixel.y < height - 2;
}

/// A line has one pixel in each column, or in each row if it is steep; the last one may be left out.
void expectWhole(const Pixels& lines, const std::vector<glm::vec2>& points) {
    const glm::vec2 direction = glm::abs(points.back() - points.front());
    const int acrossX = direction.y > direction.x, acrossY = 1 - acrossX;
    for (const glm::vec2& point : points) {
        if (glm::distance(point, points.front()) < 2.0f || glm::distance(point, points.back()) < 2.0f)
            continue;
        const Pixel p = pixelAt(point);
        if (!isInside(p)) continue;
        const bool drawn = lines.contains(p) || lines.contains({p.x + acrossX, p.y + acrossY}) ||
                           lines.contains({p.x - acrossX, p.y - acrossY});
        ASSERT_TRUE(drawn) << "no line at " << p.x << ", " << p.y;
    }
}

/// All edges are drawn whole, and no pixel more than one away from all edges is drawn.
void expectLines(const Pixels& lines, const CameraView& view, const std::vector<Edge>& edges) {
    Pixels near;
    for (const Edge& edge : edges) {
        const std::vector<glm::vec2> points = project(view, edge);
        if (points.size() < 2) continue;
        expectWhole(lines, points);
        for (const glm::vec2& point : points) {
            const Pixel p = pixelAt(point);
            for (int i = 0; i < 9; ++i) near.insert({p.x + i % 3 - 1, p.y + i / 3 - 1});
        }
    }
    for (const Pixel& pixel : lines)
        ASSERT_TRUE(near.contains(pixel)) << "a line at " << pixel.x << ", " << pixel.y;
}

TEST_F(OverlayTest, cubeHidesItsBackEdges) {
    const Mesh cube = makeCube();
    GpuScene scene = upload(sceneOf(cube, Material{}));
    for (const glm::vec3 eye : {glm::vec3(3, 2.5f, 5), glm::vec3(-4, 1.5f, -4), glm::vec3(0.3f, -5, 2.5f)}) {
        const CameraView view = lookAt(eye, {0, 0, 0}, 0.7f);
        const Pixels seen = lines(scene, view, wireframe);
        EXPECT_GT(seen.size(), 300u);
        expectLines(seen, view, frontEdges(cube, eye));
    }
}

TEST_F(OverlayTest, roomShowsItsEdgesFromInside) {
    // Inverted: its edges are concave.
    Mesh room = makeCube();
    for (std::size_t i = 0; i < room.indices.size(); i += 3) std::swap(room.indices[i], room.indices[i + 1]);
    for (glm::vec3& normal : room.normals) normal = -normal;
    GpuScene inside = upload(sceneOf(room, Material{}));
    const glm::vec3 eye(0.2f, 0.3f, 0.7f);
    const CameraView view = lookAt(eye, {-0.3f, -0.2f, -1}, 1.4f);
    expectLines(lines(inside, view, wireframe), view, frontEdges(room, eye));
}

TEST_F(OverlayTest, surfacesInFrontHideLines) {
    Scene description = sceneOf(makeCube(), Material{});
    place(description, makeQuad(3.0f), Material{}, at({0, 0, 2}));
    const CameraView view = lookAt({0, 0, 8}, {0, 0, 0}, 0.3f);
    EXPECT_GT(lines(upload(sceneOf(makeCube(), Material{})), view, wireframe).size(), 100u);
    // Only the diagonal of the quad in front is visible, from corner to corner of the image.
    const Pixels seen = lines(upload(description), view, wireframe);
    for (const Pixel& pixel : seen) {
        const float off = float(pixel.x - width / 2) + float(pixel.y - height / 2);
        EXPECT_LE(std::abs(off), 2.0f) << pixel.x << ", " << pixel.y;
    }
    EXPECT_GE(seen.size(), std::size_t(height - 2));
}

TEST_F(OverlayTest, linesOnGrazingAndDistantSurfacesAreWhole) {
    Mesh grid;
    for (int z = 0; z <= 20; ++z) {
        for (int x = 0; x <= 4; ++x) grid.positions.emplace_back(float(x) - 2.0f, 0.0f, -5.0f * float(z));
    }
    grid.normals.assign(grid.positions.size(), {0, 1, 0});
    for (std::uint32_t z = 0; z < 20; ++z) {
        for (std::uint32_t x = 0; x < 4; ++x) {
            const std::uint32_t a = 5 * z + x, b = a + 1, c = a + 5, d = a + 6;
            grid.indices.insert(grid.indices.end(), {a, b, d, a, d, c});
        }
    }
    GpuScene scene = upload(sceneOf(grid, Material{}));
    for (const float eyeHeight : {0.05f, 0.5f, 10.0f}) {
        const glm::vec3 eye(0.3f, eyeHeight, 3);
        const CameraView view = lookAt(eye, {0, 0, -30}, 0.6f);
        expectLines(lines(scene, view, wireframe), view, frontEdges(grid, eye));
    }
}

TEST_F(OverlayTest, imageBorderIsNoEdge) {
    // The image lies inside one triangle.
    Mesh triangle;
    triangle.positions = {{-50, -50, 0}, {50, -50, 0}, {0, 80, 0}};
    triangle.normals.assign(3, {0, 0, 1});
    triangle.indices = {0, 1, 2};
    GpuScene scene = upload(sceneOf(triangle, Material{}));
    EXPECT_EQ(lines(scene, lookAt({0, 0, 3}, {0, 0, 0}, 0.6f), wireframe), Pixels{});
}

TEST_F(OverlayTest, isDrawnOverDebugViewsToo) {
    GpuScene scene = upload(sceneOf(makeCube(), Material{}));
    const CameraView view = lookAt({3, 2.5f, 5}, {0, 0, 0}, 0.7f);
    const Pixels over = lines(scene, view, wireframe);
    for (const DebugView debugView : {DebugView::normals, DebugView::depth, DebugView::lightCount})
        EXPECT_EQ(lines(scene, view, wireframe, debugView), over) << toString(debugView);
}

TEST_F(OverlayTest, doesNotAffectRadianceAndAovs) {
    GpuScene scene = upload(sceneOf(makeCube(), Material{}));
    const CameraView view = lookAt({3, 2.5f, 5}, {0, 0, 0}, 0.7f);
    const HdrImage without = drawn(scene, frameOf(view, {}));
    const auto normals = lastFrame().aovs({"N"})[0].values;
    EXPECT_EQ(drawn(scene, frameOf(view, {.wireframe = true, .cage = true})).rgba, without.rgba);
    EXPECT_EQ(lastFrame().aovs({"N"})[0].values, normals);
}

TEST_F(OverlayTest, frameIsDisplayedAfterItsSceneIsDestroyed) {
    const CameraView view = lookAt({3, 2.5f, 5}, {0, 0, 0}, 0.7f);
    std::vector<std::uint8_t> expected;
    {
        GpuScene scene = upload(sceneOf(makeCube(), Material{}));
        expected = displayed(scene, frameOf(view, wireframe));
        render(scene, frameOf(view, wireframe));
    }
    EXPECT_EQ(lastFrame().displayPicture(ColorConfig::builtIn().displayTransform({})), expected);
}

/// The lines that divide each face that faces the eye, of a cage of squares, into `cells` × `cells`, with the
/// face's own edges.
std::vector<Edge> frontGrid(const Cage& cage, int cells, const glm::vec3& eye) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < cage.faceVertices.size(); i += 4) {
        const auto corner = [&](std::size_t c) { return cage.positions[cage.faceVertices[i + c]]; };
        const glm::vec3 along = corner(1) - corner(0), up = corner(3) - corner(0);
        if (glm::dot(glm::cross(along, up), eye - corner(0)) <= 0.0f) continue;
        for (int line = 0; line <= cells; ++line) {
            const float share = float(line) / float(cells);
            edges.push_back({corner(0) + share * along, corner(3) + share * along});
            edges.push_back({corner(0) + share * up, corner(1) + share * up});
        }
    }
    return edges;
}

TEST_F(OverlayTest, refinedCagesShowTheEdgesOfTheirFaces) {
    const Cage cube = makeSharpCubeCage(1.0f);
    const Scene description = sceneOfCage(cube, Material{});
    const glm::vec3 eye(3, 2.5f, 5);
    const CameraView view = lookAt(eye, {0, 0, 0}, 0.7f);
    for (const std::uint32_t level : {1u, 2u, 3u}) {
        GpuScene scene(context(), description, subdividing(level));
        expectLines(lines(scene, view, wireframe), view, frontGrid(cube, 1 << level, eye));
    }
}

TEST_F(OverlayTest, controlPolyhedronHidesItsBackEdges) {
    const Cage cube = makeSharpCubeCage(1.0f);
    const glm::mat4 rotated = glm::rotate(at({0.2f, 0, 0}), 0.4f, glm::vec3(0, 1, 0));
    const glm::vec3 eye(3, 2.5f, 5);
    const CameraView view = lookAt(eye, {0, 0, 0}, 0.7f);
    std::vector<Edge> edges = frontGrid(cube, 1, glm::vec3(glm::inverse(rotated) * glm::vec4(eye, 1)));
    for (Edge& edge : edges) {
        edge.from = glm::vec3(rotated * glm::vec4(edge.from, 1));
        edge.to = glm::vec3(rotated * glm::vec4(edge.to, 1));
    }
    GpuScene scene(context(), sceneOfCage(cube, Material{}, rotated), subdividing(2));
    expectLines(lines(scene, view, {.cage = true}), view, edges);
}

TEST_F(OverlayTest, controlPolyhedronLiesInFrontOfASmoothSurface) {
    const Cage cube = makeCubeCage(1.0f);
    GpuScene scene(context(), sceneOfCage(cube, Material{}), subdividing(4));
    const glm::vec3 eye(3, 2.5f, 5);
    const CameraView view = lookAt(eye, {0, 0, 0}, 0.7f);
    const Pixels seen = lines(scene, view, {.cage = true});
    for (const Edge& edge : frontGrid(cube, 1, eye)) expectWhole(seen, project(view, edge));
}

TEST_F(OverlayTest, meshesHaveNoCageAndEmptyScenesNoLines) {
    const CameraView view = lookAt({3, 2.5f, 5}, {0, 0, 0}, 0.7f);
    EXPECT_EQ(lines(upload(sceneOf(makeCube(), Material{})), view, {.cage = true}), Pixels{});
    EXPECT_EQ(lines(upload(Scene{}), view, {.wireframe = true, .cage = true}), Pixels{});
}

TEST_F(OverlayTest, isASeparatePass) {
    GpuScene scene = upload(sceneOf(makeCube(), Material{}));
    FrameRequest inputs = frameOf(lookAt({3, 2.5f, 5}, {0, 0, 0}, 0.7f), wireframe);
    inputs.technique = Technique::fullscreen;
    displayed(scene, inputs);
    std::vector<std::string> names;
    for (const PassTime& pass : lastFrame().passTimes()) names.push_back(pass.name);
    EXPECT_EQ(names, (std::vector<std::string>{"geometry", "lighting", "overlays", "display"}));
}

TEST_F(OverlayTest, sizesMayChangeBetweenFrames) {
    GpuScene scene = upload(sceneOf(makeCube(), Material{}));
    for (const auto& [w, h] : {std::pair{7, 5}, {1, 1}, {130, 3}, {7, 5}}) {
        FrameRequest inputs = frameOf(lookAt({3, 2.5f, 5}, {0, 0, 0}, 0.7f), wireframe);
        inputs.width = w;
        inputs.height = h;
        EXPECT_EQ(displayed(scene, inputs).size(), std::size_t(4 * w * h));
    }
}

}  // namespace
}  // namespace candela::test
