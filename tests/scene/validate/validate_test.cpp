#include <candela/error.h>
#include <candela/scene.h>

#include "sample_scene.h"
#include "validate/broken_rule.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace candela {
namespace {

const float nan_ = std::numeric_limits<float>::quiet_NaN();
constexpr float pi = std::numbers::pi_v<float>;

void expectMessages(const std::vector<BrokenRule>& rules) {
    expectMessages(sampleScene(), rules);
}

TEST(Validate, AcceptsValidScenes) {
    EXPECT_NO_THROW(validate({}));
    EXPECT_NO_THROW(validate(sampleScene()));
}

TEST(Validate, Images) {
    const char* size = "image 0 'bricks': its width and height must lie between 1 and 32768";
    expectMessages({
        {size, [](Scene& s) { s.images[0].width = 0; }},
        {size, [](Scene& s) { s.images[0].height = 32769; }},
        {"image 0 'bricks': holds 8 bytes of pixels, but its size requires 16",
         [](Scene& s) { s.images[0].height = 2; }},
        {"image 0 'bricks': its pixel format is unknown",
         [](Scene& s) { s.images[0].format = unknown<PixelFormat>(); }},
        {"image 0 'bricks': its pixels must be finite numbers",
         [](Scene& s) {
             s.images[0].format = PixelFormat::rgba32f;
             s.images[0].pixels.assign(32, std::byte{0xff});  // All bits set is a NaN.
         }},
    });
}

TEST(Validate, LinesAndPoints) {
    Scene scene = sampleScene();
    const auto add = [&](Topology topology, std::uint32_t count) {
        Mesh& mesh = scene.meshes[0];
        mesh.submeshes.push_back({static_cast<std::uint32_t>(mesh.indices.size()), count, {}, topology});
        for (std::uint32_t i = 0; i < count; ++i) mesh.indices.push_back(i % 2);
    };
    add(Topology::points, 1);
    add(Topology::lines, 2);
    EXPECT_NO_THROW(validate(scene));
    const auto last = [](Scene& s) -> Submesh& { return s.meshes[0].submeshes.back(); };
    expectMessages(scene, {{"mesh 0 'wheel': a submesh of lines must have an even number of indices",
                            [&](Scene& s) { last(s).indexCount = 1; }},
                           {"mesh 0 'wheel': a submesh of triangles must have a multiple of 3 indices",
                            [&](Scene& s) { last(s).topology = Topology::triangles; }},
                           {"mesh 0 'wheel': a submesh's topology is none of the enumeration",
                            [&](Scene& s) { last(s).topology = unknown<Topology>(); }},
                           {"mesh 0 'wheel': vertex 0 of a triangle must have a normal",
                            [](Scene& s) { s.meshes[0].normals[0] = glm::vec3(0.0f); }}});
    const std::vector<glm::vec3> normals(scene.meshes[0].normals.size(), glm::vec3(0.0f));
    std::erase_if(scene.meshes[0].submeshes,
                  [](const Submesh& s) { return s.topology == Topology::triangles; });
    scene.meshes[0].normals = normals;
    EXPECT_NO_THROW(validate(scene)) << "none of its lines and points have normals";
    expectMessages(scene, {{"mesh 0 'wheel': a submesh of lines or points must have normals at all of its "
                            "vertices or at none, but vertex 1 differs from the first",
                            [](Scene& s) {
                                s.meshes[0].normals[1] = {0, 0, 1};
                            }}});
}

TEST(Validate, Materials) {
    expectMessages({
        {"material 0 'wall': its base colour is 1.5, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].baseColor.y = 1.5f; }},
        {"material 0 'wall': its base colour is nan, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].baseColor.w = nan_; }},
        {"material 0 'wall': its metallic factor is -1, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].metallic = -1.0f; }},
        {"material 0 'wall': its roughness is 2, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].roughness = 2.0f; }},
        {"material 0 'wall': its emission is -1, but 0 to 1e+20 was expected",
         [](Scene& s) { s.materials[0].emission.z = -1.0f; }},
        {"material 0 'wall': its emission strength is -1, but 0 to 1e+20 was expected",
         [](Scene& s) { s.materials[0].emissionStrength = -1.0f; }},
        {"material 0 'wall': its emission times its strength must be at most 1e20",
         [](Scene& s) { s.materials[0].emissionStrength = 5e19f; }},
        {"material 0 'wall': its normal scale must be a finite number",
         [](Scene& s) { s.materials[0].normalScale = INFINITY; }},
        {"material 0 'wall': its occlusion strength is 1.1, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].occlusionStrength = 1.1f; }},
        {"material 0 'wall': its alpha mode must be opaque, mask or blend",
         [](Scene& s) { s.materials[0].alphaMode = unknown<AlphaMode>(); }},
        {"material 0 'wall': its alpha cutoff must be a finite number, 0 or more",
         [](Scene& s) { s.materials[0].alphaCutoff = -0.1f; }},
    });
}

TEST(Validate, Lobes) {
    expectMessages({
        {"material 0 'wall': its index of refraction is 0.5, but 1 or more was expected",
         [](Scene& s) { s.materials[0].ior = 0.5f; }},
        {"material 0 'wall': its specular factor is 2, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].specular.factor = 2.0f; }},
        {"material 0 'wall': its specular colour is -1, but 0 or more was expected",
         [](Scene& s) { s.materials[0].specular.color.z = -1.0f; }},
        {"material 0 'wall': its clearcoat factor is 2, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].clearcoat.factor = 2.0f; }},
        {"material 0 'wall': its clearcoat roughness is nan, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].clearcoat.roughness = nan_; }},
        {"material 0 'wall': its clearcoat normal scale must be a finite number",
         [](Scene& s) { s.materials[0].clearcoat.normalScale = INFINITY; }},
        {"material 0 'wall': its sheen colour is 2, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].sheen.color.y = 2.0f; }},
        {"material 0 'wall': its sheen roughness is -1, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].sheen.roughness = -1.0f; }},
        {"material 0 'wall': its anisotropy strength is 2, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].anisotropy.strength = 2.0f; }},
        {"material 0 'wall': its anisotropy rotation must be a finite number",
         [](Scene& s) { s.materials[0].anisotropy.rotation = nan_; }},
        {"material 0 'wall': its iridescence factor is 2, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].iridescence.factor = 2.0f; }},
        {"material 0 'wall': its iridescence index of refraction is inf, but 1 or more was expected",
         [](Scene& s) { s.materials[0].iridescence.ior = INFINITY; }},
        {"material 0 'wall': its least iridescence thickness is -1, but 0 or more was expected",
         [](Scene& s) { s.materials[0].iridescence.minThickness = -1.0f; }},
        {"material 0 'wall': its largest iridescence thickness is inf, but a finite number was expected",
         [](Scene& s) { s.materials[0].iridescence.maxThickness = INFINITY; }},
        {"material 0 'wall': its transmission factor is 2, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].transmission.factor = 2.0f; }},
        {"material 0 'wall': its thickness is -1, but 0 or more was expected",
         [](Scene& s) { s.materials[0].volume.thickness = -1.0f; }},
        {"material 0 'wall': its attenuation distance must be over 0 metres",
         [](Scene& s) { s.materials[0].volume.attenuationDistance = 0.0f; }},
        {"material 0 'wall': its attenuation colour is 2, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].volume.attenuationColor.x = 2.0f; }},
        {"material 0 'wall': its dispersion is -1, but 0 or more was expected",
         [](Scene& s) { s.materials[0].volume.dispersion = -1.0f; }},
        {"material 0 'wall': its diffuse transmission factor is 2, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].diffuseTransmission.factor = 2.0f; }},
        {"material 0 'wall': its diffuse transmission colour is 2, but 0 to 1 was expected",
         [](Scene& s) { s.materials[0].diffuseTransmission.color.z = 2.0f; }},
        {"material 0 'wall': clearcoat normal texture: the set of texture coordinates must be 0 to 17",
         [](Scene& s) {
             s.materials[0].clearcoat.normalTexture = Texture{};
             s.materials[0].clearcoat.normalTexture->uvSet = 18;
         }},
    });
    Scene scene = sampleScene();
    scene.materials[0].ior = INFINITY;
    EXPECT_NO_THROW(validate(scene));
}

TEST(Validate, Textures) {
    expectMessages({
        {"material 0 'wall': refers to image 1, but the scene has 1 (counted from 0)",
         [](Scene& s) { s.materials[0].baseColorTexture->image = 1; }},
        {"material 0 'wall': base colour texture: the set of texture coordinates must be 0 to 17",
         [](Scene& s) { s.materials[0].baseColorTexture->uvSet = 18; }},
        {"material 0 'wall': normal texture: a wrap mode is unknown",
         [](Scene& s) {
             s.materials[0].normalTexture = Texture{};
             s.materials[0].normalTexture->wrapT = unknown<Wrap>();
         }},
        {"material 0 'wall': metallic-roughness texture: the minification filter is unknown",
         [](Scene& s) {
             s.materials[0].metallicRoughnessTexture = Texture{};
             s.materials[0].metallicRoughnessTexture->minFilter = unknown<Filter>();
         }},
        {"material 0 'wall': occlusion texture: the magnification filter must be nearest or linear",
         [](Scene& s) {
             s.materials[0].occlusionTexture = Texture{};
             s.materials[0].occlusionTexture->magFilter = Filter::linearMipmapLinear;
         }},
        {"material 0 'wall': emission texture: offset, rotation and scale must be finite numbers",
         [](Scene& s) {
             s.materials[0].emissionTexture = Texture{};
             s.materials[0].emissionTexture->rotation = nan_;
         }},
    });
}

TEST(Validate, MeshArrays) {
    expectMessages({
        {"mesh 0 'wheel': has 3 normals for 4 vertices", [](Scene& s) { s.meshes[0].normals.pop_back(); }},
        {"mesh 0 'wheel': has 0 normals for 4 vertices", [](Scene& s) { s.meshes[0].normals.clear(); }},
        {"mesh 0 'wheel': has 5 tangents for 4 vertices",
         [](Scene& s) { s.meshes[0].tangents.emplace_back(1, 0, 0, 1); }},
        {"mesh 0 'wheel': has 1 texture coordinates 0 for 4 vertices",
         [](Scene& s) { s.meshes[0].uv0.resize(1); }},
        {"mesh 0 'wheel': has 1 texture coordinates 1 for 4 vertices",
         [](Scene& s) { s.meshes[0].uv1.resize(1); }},
        {"mesh 0 'wheel': has 6 colours for 4 vertices", [](Scene& s) { s.meshes[0].colors.resize(6); }},
        {"mesh 0 'wheel': position 2 is not a finite number",
         [](Scene& s) { s.meshes[0].positions[2].y = nan_; }},
        {"mesh 0 'wheel': texture coordinate 0 of vertex 1 is not a finite number",
         [](Scene& s) { s.meshes[0].uv0[1].y = INFINITY; }},
        {"mesh 0 'wheel': texture coordinate 1 of vertex 0 is not a finite number",
         [](Scene& s) { s.meshes[0].uv1.assign(4, glm::vec2(nan_)); }},
        {"mesh 0 'wheel': colour 3 is not a finite number", [](Scene& s) { s.meshes[0].colors[3].w = nan_; }},
        {"mesh 0 'wheel': normal 1 does not have unit length",
         [](Scene& s) {
             s.meshes[0].normals[1] = {0.0f, 0.0f, 1.02f};
         }},
        {"mesh 0 'wheel': normal 0 does not have unit length",
         [](Scene& s) { s.meshes[0].normals[0].x = nan_; }},
        {"mesh 0 'wheel': tangent 2 must have unit length and -1 or 1 in w",
         [](Scene& s) { s.meshes[0].tangents[2].w = 0.5f; }},
        {"mesh 0 'wheel': tangent 3 must have unit length and -1 or 1 in w",
         [](Scene& s) { s.meshes[0].tangents[3].x = 0.0f; }},
    });
}

TEST(Validate, MeshIndicesAndSubmeshes) {
    expectMessages({
        {"mesh 0 'wheel': index 4 names vertex 4, but there are 4",
         [](Scene& s) { s.meshes[0].indices[4] = 4; }},
        {"mesh 0 'wheel': the number of its indices must be a multiple of 3",
         [](Scene& s) { s.meshes[0].indices.pop_back(); }},
        {"mesh 0 'wheel': a submesh's first index and index count must be multiples of 3",
         [](Scene& s) { s.meshes[0].submeshes[1].firstIndex = 1; }},
        {"mesh 0 'wheel': a submesh's first index and index count must be multiples of 3",
         [](Scene& s) { s.meshes[0].submeshes[0].indexCount = 2; }},
        {"mesh 0 'wheel': a submesh ends at index 9, but there are 6",
         [](Scene& s) { s.meshes[0].submeshes[1].indexCount = 6; }},
        // 2^32 - 1 is a multiple of 3: the sum must not overflow.
        {"mesh 0 'wheel': a submesh ends at index 4294967298, but there are 6",
         [](Scene& s) { s.meshes[0].submeshes[1].indexCount = 4294967295u; }},
        {"mesh 0 'wheel': refers to material 1, but the scene has 1 (counted from 0)",
         [](Scene& s) { s.meshes[0].submeshes[1].material = 1; }},
        {"mesh 0 'wheel': has no texture coordinates 0, which a texture of material 0 'wall' reads",
         [](Scene& s) { s.meshes[0].uv0.clear(); }},
        {"mesh 0 'wheel': has no texture coordinates 1, which a texture of material 0 'wall' reads",
         [](Scene& s) { s.materials[0].baseColorTexture->uvSet = 1; }},
    });
}

TEST(Validate, Nodes) {
    expectMessages({
        {"node 0 'root': refers to node 9, but the scene has 3 (counted from 0)",
         [](Scene& s) { s.nodes[0].parent = 9; }},
        {"node 1 'arm': its parent must precede it", [](Scene& s) { s.nodes[1].parent = 2; }},
        {"node 1 'arm': its parent must precede it", [](Scene& s) { s.nodes[1].parent = 1; }},
        {"node 1 'arm': refers to mesh 1, but the scene has 1 (counted from 0)",
         [](Scene& s) { s.nodes[1].mesh = 1; }},
        {"node 1 'arm': its translation must be finite numbers",
         [](Scene& s) { std::get<Transform>(s.nodes[1].transform).translation.z = INFINITY; }},
        {"node 1 'arm': its scale must be finite numbers",
         [](Scene& s) { std::get<Transform>(s.nodes[1].transform).scale.x = nan_; }},
        {"node 1 'arm': its rotation must be a quaternion of unit length",
         [](Scene& s) {
             std::get<Transform>(s.nodes[1].transform).rotation = {0.0f, 0.0f, 0.0f, 0.0f};
         }},
        {"node 2 'hand': its matrix must be finite numbers",
         [](Scene& s) { std::get<glm::mat4>(s.nodes[2].transform)[1][1] = nan_; }},
        {"node 2 'hand': its matrix must be affine: a last row of 0, 0, 0, 1",
         [](Scene& s) { std::get<glm::mat4>(s.nodes[2].transform)[1][3] = 0.1f; }},
    });
}

TEST(Validate, Cameras) {
    const char* fov = "camera 0 'main': its vertical field of view must lie between 0 and pi";
    const char* near = "camera 0 'main': its near plane must be over 0 metres";
    expectMessages({
        {"camera 0 'main': refers to node 3, but the scene has 3 (counted from 0)",
         [](Scene& s) { s.cameras[0].node = 3; }},
        {fov, [](Scene& s) { s.cameras[0].verticalFov = 0.0f; }},
        {fov, [](Scene& s) { s.cameras[0].verticalFov = pi; }},
        {fov, [](Scene& s) { s.cameras[0].verticalFov = nan_; }},
        {near, [](Scene& s) { s.cameras[0].nearPlane = 0.0f; }},
        {near, [](Scene& s) { s.cameras[0].nearPlane = INFINITY; }},
    });
}

TEST(Validate, Lights) {
    const char* range = "light 0 'bulb': its range must be over 0 metres";
    const char* radius = "light 0 'bulb': its radius must be 0 or more metres";
    const char* color = "light 0 'bulb': its colour must be finite numbers, 0 or more";
    const char* inner = "light 1 'torch': its inner cone angle must be 0 or more and less than the outer one";
    expectMessages({
        {"light 2 'sun': refers to node 3, but the scene has 3 (counted from 0)",
         [](Scene& s) { s.lights[2].node = 3; }},
        {"light 0 'bulb': its type must be point, spot or directional",
         [](Scene& s) { s.lights[0].type = unknown<LightType>(); }},
        {color, [](Scene& s) { s.lights[0].color.x = -1.0f; }},
        {color, [](Scene& s) { s.lights[0].color.x = nan_; }},
        {"light 0 'bulb': its intensity is -1, but 0 to 1e+20 was expected",
         [](Scene& s) { s.lights[0].intensity = -1.0f; }},
        {"light 0 'bulb': its intensity is 2e+20, but 0 to 1e+20 was expected",
         [](Scene& s) { s.lights[0].intensity = 2e20f; }},
        {"light 0 'bulb': its intensity is nan, but 0 to 1e+20 was expected",
         [](Scene& s) { s.lights[0].intensity = nan_; }},
        {"light 0 'bulb': its intensity times its colour must be at most 1e20",
         [](Scene& s) {
             s.lights[0].color.y = 1e10f;
             s.lights[0].intensity = 1e11f;
         }},
        {range, [](Scene& s) { s.lights[0].range = 0.0f; }},
        {range, [](Scene& s) { s.lights[0].range = INFINITY; }},
        {range, [](Scene& s) { s.lights[0].range = nan_; }},
        {radius, [](Scene& s) { s.lights[0].radius = -0.1f; }},
        {radius, [](Scene& s) { s.lights[0].radius = INFINITY; }},
        {radius, [](Scene& s) { s.lights[0].radius = nan_; }},
        {"light 0 'bulb': its position must be finite numbers",
         [](Scene& s) { s.lights[0].position.x = nan_; }},
        {"light 2 'sun': its direction must have unit length",
         [](Scene& s) { s.lights[2].direction = glm::vec3(0.0f); }},
        {"light 1 'torch': its outer cone angle is 1.6, but 0 to 1.5708 was expected",
         [](Scene& s) { s.lights[1].outerConeAngle = 1.6f; }},
        {inner, [](Scene& s) { s.lights[1].innerConeAngle = s.lights[1].outerConeAngle; }},
        {inner, [](Scene& s) { s.lights[1].innerConeAngle = -0.1f; }},
        {inner, [](Scene& s) { s.lights[1].innerConeAngle = nan_; }},
    });
}

TEST(Validate, WorldPositions) {
    expectMessages({
        {"node 0 'root': mesh 0 'wheel' is farther than 1e9 metres from the world's origin, or its position "
         "is not finite",
         [](Scene& s) { std::get<Transform>(s.nodes[0].transform).translation.x = 1.1e9f; }},
        {"light 0 'bulb': is farther than 1e9 metres from the world's origin, or its position is not finite",
         [](Scene& s) { s.lights[0].position.y = -2e9f; }},
        {"camera 0 'main': is farther than 1e9 metres from the world's origin, or its position is not finite",
         [](Scene& s) {
             s.lights[1].node.reset();
             std::get<glm::mat4>(s.nodes[2].transform)[3][2] = 3e9f;
         }},
        {"node 1 'arm': its matrix in the world is not finite",
         [](Scene& s) {
             s.animations.clear();
             for (const int i : {0, 1}) std::get<Transform>(s.nodes[i].transform).scale = glm::vec3(1e20f);
         }},
    });
}

// The limit applies to the vertices, not to their bounding box.
TEST(Validate, WorldPositionsAreThoseOfTheVertices) {
    Scene scene = sampleScene();
    scene.nodes.resize(1);
    scene.cameras.clear();
    scene.lights.clear();
    scene.animations.clear();
    scene.meshes[0].positions = {{0, 0, 0}, {1.2e9f, 0, 0}, {0, 1.2e9f, 0}, {0, 0, 0}};
    Transform rotated;
    rotated.rotation = glm::angleAxis(pi / 4.0f, glm::vec3(0.0f, 0.0f, 1.0f));
    scene.nodes[0].transform = rotated;  // The vertices move to 0.85e9, the corner of the box to 1.7e9.
    EXPECT_NO_THROW(validate(scene));
}

TEST(Validate, AcceptsUnusualValidScenes) {
    Scene scene = sampleScene();
    scene.nodes[2].transform = glm::scale(glm::mat4(1.0f), glm::vec3(0.0f));  // Singular.
    scene.meshes.emplace_back();                                              // Without a vertex.
    scene.nodes[1].mesh = 1;
    scene.meshes[0].normals[0] = {0.0f, 0.0f, 0.994f};  // As from 8-bit normals.
    scene.lights[1].outerConeAngle = pi / 2.0f;
    scene.lights[0].range.reset();
    scene.lights[0].direction = glm::vec3(0.0f);  // A point light does not use it.
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].baseColorTexture->uvSet = 1;  // Not used by a mesh.
    EXPECT_NO_THROW(validate(scene));
}

TEST(Validate, NamesKeepTheErrorOnOneLine) {
    Scene scene = sampleScene();
    scene.nodes[1].name = "two\nlines" + std::string(100, 'x');
    scene.nodes[1].mesh = 7;
    try {
        validate(scene);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  "node 1 'two?lines" + std::string(55, 'x') +
                      "...': refers to mesh 7, but the scene has 1 (counted from 0)");
    }
    scene.nodes[1].name.clear();
    try {
        validate(scene);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "node 1: refers to mesh 7, but the scene has 1 (counted from 0)");
    }
}

}  // namespace
}  // namespace candela
