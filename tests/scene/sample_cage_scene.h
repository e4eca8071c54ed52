#pragma once

#include <candela/scene.h>

#include <glm/gtc/matrix_transform.hpp>

namespace candela {

/// The cube from (-1, -1, -1) to (1, 1, 1) with all members of a cage.
inline Cage sampleHull() {
    Cage cage;
    cage.name = "hull";
    for (int i = 0; i < 8; ++i) {
        cage.positions.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    }
    cage.faceSizes.assign(6, 4);
    cage.faceVertices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    cage.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int face = 0; face < 6; ++face) cage.faceUvs.insert(cage.faceUvs.end(), {0, 1, 2, 3});
    cage.creases = {{4, 5, 2.5f}, {7, 5, infiniteSharpness}};
    cage.corners = {{0, 3.0f}};
    cage.holes = {1};
    cage.faceMaterials = {0, 0, {}, 0, {}, 0};
    cage.level = 2;
    cage.influenceCount = 2;
    for (int vertex = 0; vertex < 8; ++vertex) {
        cage.joints.insert(cage.joints.end(), {0, 1});
        cage.jointWeights.insert(cage.jointWeights.end(), {0.75f, 0.25f});
    }
    cage.morphTargets.resize(2);
    cage.morphTargets[0].offsets.assign(8, {1, 0, 0});
    cage.morphTargets[1].offsets.assign(8, {0, 2, 0});
    return cage;
}

/// A tetrahedron for Loop's scheme with required members only.
inline Cage sampleTent() {
    Cage cage;
    cage.name = "tent";
    cage.scheme = SubdivisionScheme::loop;
    cage.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    cage.faceSizes.assign(4, 3);
    cage.faceVertices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    return cage;
}

/// A small valid scene with cages: one skinned, one morphed on a node with a matrix, and one plain.
inline Scene sampleCageScene() {
    Scene scene;
    scene.images.push_back({"scales", 1, 1, PixelFormat::rgba8, std::vector<std::byte>(4)});
    Material material;
    material.name = "paint";
    material.baseColorTexture = Texture{};
    scene.materials.push_back(material);
    scene.cages = {sampleHull(), sampleTent()};
    scene.skins.push_back({"bones", {1, 2}, {2, glm::mat4(1.0f)}});

    scene.nodes.resize(5);
    scene.nodes[0].name = "body";
    scene.nodes[0].cage = 0;
    scene.nodes[0].skin = 0;
    scene.nodes[0].morphWeights = {0.5f, 0.0f};
    scene.nodes[1].name = "hip";
    scene.nodes[2].name = "knee";
    scene.nodes[2].parent = 1;
    scene.nodes[3].name = "statue";
    scene.nodes[3].transform = glm::translate(glm::mat4(1.0f), glm::vec3(10.0f, 0.0f, 0.0f));
    scene.nodes[3].cage = 0;
    scene.nodes[4].name = "camp";
    scene.nodes[4].cage = 1;

    AnimationChannel rotation{
        2, AnimationPath::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, 1, 0}};
    AnimationChannel linearWeights{
        3, AnimationPath::morphWeights, Interpolation::linear, {0, 1}, {0, 0, 1, 2}};
    AnimationChannel cubicWeights{
        0, AnimationPath::morphWeights, Interpolation::cubicSpline, {0}, {0, 0, 0.5f, 0.25f, 0, 0}};
    scene.animations.push_back({"motion", {rotation, linearWeights, cubicWeights}});
    return scene;
}

}  // namespace candela
