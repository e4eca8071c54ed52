#pragma once

#include <candela/scene.h>

namespace candela {

/// A small valid scene with every kind of element: two triangles, two instances, a texture, a camera,
/// three lights, an animation.
inline Scene sampleScene() {
    Scene scene;
    scene.images.push_back({"bricks", 2, 1, PixelFormat::rgba8, std::vector<std::byte>(8)});
    Material material;
    material.name = "wall";
    material.baseColorTexture = Texture{};
    material.emission = {1.0f, 2.0f, 3.0f};
    scene.materials.push_back(material);

    Mesh mesh;
    mesh.name = "wheel";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.colors.assign(4, glm::vec4(1));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.submeshes = {{0, 3, 0}, {3, 3, {}}};
    scene.meshes.push_back(mesh);

    scene.nodes.resize(3);
    scene.nodes[0].name = "root";
    scene.nodes[0].mesh = 0;
    scene.nodes[1].name = "arm";
    scene.nodes[1].parent = 0;
    scene.nodes[1].mesh = 0;
    scene.nodes[2].name = "hand";
    scene.nodes[2].parent = 1;
    scene.nodes[2].transform = glm::mat4(1.0f);

    scene.cameras.push_back({.name = "main", .node = 2});
    scene.lights.resize(3);
    scene.lights[0].name = "bulb";
    scene.lights[0].range = 3.0f;
    scene.lights[0].node = 1;
    scene.lights[1].name = "torch";
    scene.lights[1].type = LightType::spot;
    scene.lights[1].node = 2;
    scene.lights[2].name = "sun";
    scene.lights[2].type = LightType::directional;

    AnimationChannel translation{
        1, AnimationPath::translation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 2, 3}};
    AnimationChannel rotation{
        1, AnimationPath::rotation, Interpolation::step, {0, 1}, {0, 0, 0, 1, 0, 0, 1, 0}};
    AnimationChannel scale{
        0, AnimationPath::scale, Interpolation::cubicSpline, {2}, {0, 0, 0, 1, 1, 1, 0, 0, 0}};
    scene.animations.push_back({"walk", {translation, rotation, scale}});
    return scene;
}

}  // namespace candela
