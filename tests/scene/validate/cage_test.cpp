#include <candela/scene.h>

#include "sample_cage_scene.h"
#include "validate/broken_rule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace candela {
namespace {

const float nan_ = std::numeric_limits<float>::quiet_NaN();

void expectMessages(const std::vector<BrokenRule>& rules) {
    expectMessages(sampleCageScene(), rules);
}

TEST(ValidateCage, AcceptsValidCages) {
    EXPECT_NO_THROW(validate(sampleCageScene()));
    Scene scene = sampleCageScene();
    scene.cages.emplace_back();  // Without a face.
    scene.nodes[4].cage = 2;
    scene.cages[0].jointWeights[1] = 0.246f;  // As from 8-bit weights.
    scene.cages[0].creases[0].sharpness = 0.0f;
    scene.cages[0].holes = {0, 1, 2, 3, 4, 5};
    scene.nodes[0].skin.reset();  // The joints are not used then.
    EXPECT_NO_THROW(validate(scene));
}

TEST(ValidateCage, PolygonsMayHaveDifferentSizes) {
    Scene scene;
    Cage cage;
    cage.positions = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {-1, 0, 1}};
    cage.faceSizes = {5, 3};
    cage.faceVertices = {0, 1, 2, 3, 4, 0, 4, 5};
    cage.creases = {{0, 4, 1.0f}, {0, 5, 1.0f}};  // Including the last edge of a face.
    scene.cages.push_back(cage);
    EXPECT_NO_THROW(validate(scene));
}

TEST(ValidateCage, Rules) {
    expectMessages({
        {"cage 0 'hull': its scheme is unknown",
         [](Scene& s) { s.cages[0].scheme = unknown<SubdivisionScheme>(); }},
        {"cage 0 'hull': its boundary interpolation is unknown",
         [](Scene& s) { s.cages[0].boundaryInterpolation = unknown<BoundaryInterpolation>(); }},
        {"cage 0 'hull': its face-varying interpolation is unknown",
         [](Scene& s) { s.cages[0].faceVaryingInterpolation = unknown<FaceVaryingInterpolation>(); }},
        {"cage 0 'hull': its crease method is unknown",
         [](Scene& s) { s.cages[0].creaseMethod = unknown<CreaseMethod>(); }},
        {"cage 0 'hull': its triangle subdivision is unknown",
         [](Scene& s) { s.cages[0].triangleSubdivision = unknown<TriangleSubdivision>(); }},
        {"cage 0 'hull': its level is 0, but 1 to 8 was expected", [](Scene& s) { s.cages[0].level = 0; }},
        {"cage 0 'hull': its level is 9, but 1 to 8 was expected",
         [](Scene& s) { s.cages[0].level = maxSubdivisionLevel + 1; }},
    });
}

TEST(ValidateCage, Faces) {
    expectMessages({
        {"cage 0 'hull': face 2 has 2 corners, but 3 or more were expected",
         [](Scene& s) { s.cages[0].faceSizes[2] = 2; }},
        {"cage 0 'hull': face 0 has 4 corners, but a face of a Loop cage has 3",
         [](Scene& s) { s.cages[0].scheme = SubdivisionScheme::loop; }},
        {"cage 1 'tent': face 3 has 2 corners, but a face of a Loop cage has 3",
         [](Scene& s) { s.cages[1].faceSizes[3] = 2; }},
        {"cage 0 'hull': has 24 vertices of faces for 25 corners",
         [](Scene& s) { s.cages[0].faceSizes[2] = 5; }},
        {"cage 0 'hull': has 23 vertices of faces for 24 corners",
         [](Scene& s) { s.cages[0].faceVertices.pop_back(); }},
        {"cage 0 'hull': has more vertices, texture coordinates, faces or corners than 32 bits can count",
         [](Scene& s) { s.cages[0].faceSizes[0] = s.cages[0].faceSizes[1] = 0xffffffffu; }},
        {"cage 0 'hull': face 1 names vertex 8, but there are 8",
         [](Scene& s) { s.cages[0].faceVertices[5] = 8; }},
        {"cage 0 'hull': face 5 names vertex 3 twice", [](Scene& s) { s.cages[0].faceVertices[23] = 3; }},
        {"cage 0 'hull': position 3 is not a finite number",
         [](Scene& s) { s.cages[0].positions[3].y = nan_; }},
        {"cage 0 'hull': hole 0 names face 6, but there are 6", [](Scene& s) { s.cages[0].holes[0] = 6; }},
    });
}

TEST(ValidateCage, TextureCoordinates) {
    expectMessages({
        {"cage 0 'hull': texture coordinate 2 is not a finite number",
         [](Scene& s) { s.cages[0].uvs[2].x = INFINITY; }},
        {"cage 0 'hull': has 25 texture coordinates of faces for 24 corners",
         [](Scene& s) { s.cages[0].faceUvs.push_back(0); }},
        {"cage 0 'hull': has 24 texture coordinates of faces for 0 corners",
         [](Scene& s) { s.cages[0].uvs.clear(); }},
        {"cage 0 'hull': face 1 names texture coordinate 4, but there are 4",
         [](Scene& s) { s.cages[0].faceUvs[4] = 4; }},
    });
}

TEST(ValidateCage, Sharpness) {
    expectMessages({
        {"cage 0 'hull': crease 1, edge 7-5: its sharpness is -1, but must be a finite number, 0 or more",
         [](Scene& s) { s.cages[0].creases[1].sharpness = -1.0f; }},
        {"cage 0 'hull': crease 0, edge 4-5: its sharpness is nan, but must be a finite number, 0 or more",
         [](Scene& s) { s.cages[0].creases[0].sharpness = nan_; }},
        {"cage 0 'hull': crease 0, edge 4-5: its sharpness is inf, but must be a finite number, 0 or more",
         [](Scene& s) { s.cages[0].creases[0].sharpness = INFINITY; }},
        {"cage 0 'hull': crease 0, edge 4-7: no face has this edge",  // A diagonal.
         [](Scene& s) { s.cages[0].creases[0].vertex1 = 7; }},
        {"cage 0 'hull': crease 0, edge 5-5: no face has this edge",
         [](Scene& s) { s.cages[0].creases[0].vertex0 = 5; }},
        {"cage 0 'hull': crease 0 names vertex 9, but there are 8",
         [](Scene& s) { s.cages[0].creases[0].vertex0 = 9; }},
        {"cage 0 'hull': crease 1 names vertex 4294967295, but there are 8",
         [](Scene& s) { s.cages[0].creases[1].vertex1 = 0xffffffffu; }},
        {"cage 0 'hull': corner 0 names vertex 8, but there are 8",
         [](Scene& s) { s.cages[0].corners[0].vertex = 8; }},
        {"cage 0 'hull': corner 0, vertex 0: its sharpness is -0.5, but must be a finite number, 0 or more",
         [](Scene& s) { s.cages[0].corners[0].sharpness = -0.5f; }},
    });
}

TEST(ValidateCage, Materials) {
    expectMessages({
        {"cage 0 'hull': has 5 materials for 6 faces", [](Scene& s) { s.cages[0].faceMaterials.pop_back(); }},
        {"cage 0 'hull': refers to material 1, but the scene has 1 (counted from 0)",
         [](Scene& s) { s.cages[0].faceMaterials[3] = 1; }},
        {"cage 0 'hull': has no texture coordinates 0, which a texture of material 0 'paint' reads",
         [](Scene& s) {
             s.cages[0].uvs.clear();
             s.cages[0].faceUvs.clear();
         }},
        {"cage 0 'hull': has no texture coordinates 1, which a texture of material 0 'paint' reads",
         [](Scene& s) { s.materials[0].baseColorTexture->uvSet = 1; }},
    });
}

TEST(ValidateCage, JointsAndMorphTargets) {
    expectMessages({
        {"cage 0 'hull': has 16 joints for 24 influences", [](Scene& s) { s.cages[0].influenceCount = 3; }},
        {"cage 0 'hull': has 16 joints for 0 influences", [](Scene& s) { s.cages[0].influenceCount = 0; }},
        {"cage 0 'hull': has 15 joint weights for 16 influences",
         [](Scene& s) { s.cages[0].jointWeights.pop_back(); }},
        {"cage 0 'hull': a joint weight of vertex 3 is not 0 or more",
         [](Scene& s) {
             s.cages[0].jointWeights[6] = -0.25f;
             s.cages[0].jointWeights[7] = 1.25f;
         }},
        {"cage 0 'hull': a joint weight of vertex 0 is not 0 or more",
         [](Scene& s) { s.cages[0].jointWeights[0] = nan_; }},
        {"cage 0 'hull': the joint weights of vertex 7 have the sum 0.75, but 1 was expected",
         [](Scene& s) { s.cages[0].jointWeights[15] = 0.0f; }},
        {"cage 0 'hull': the joint weights of vertex 0 have the sum inf, but 1 was expected",
         [](Scene& s) { s.cages[0].jointWeights[0] = INFINITY; }},
        {"cage 0 'hull': has 7 offsets in morph target 1 for 8 vertices",
         [](Scene& s) { s.cages[0].morphTargets[1].offsets.pop_back(); }},
        {"cage 0 'hull': morph target 0: offset 5 is not a finite number",
         [](Scene& s) { s.cages[0].morphTargets[0].offsets[5].z = nan_; }},
    });
}

TEST(ValidateCage, Skins) {
    expectMessages({
        {"skin 0 'bones': it must have at least one joint", [](Scene& s) { s.skins[0].joints.clear(); }},
        {"skin 0 'bones': refers to node 5, but the scene has 5 (counted from 0)",
         [](Scene& s) { s.skins[0].joints[1] = 5; }},
        {"skin 0 'bones': has 1 inverse bind matrices for 2 joints",
         [](Scene& s) { s.skins[0].inverseBindMatrices.pop_back(); }},
        {"skin 0 'bones': inverse bind matrix 1 must be finite numbers",
         [](Scene& s) { s.skins[0].inverseBindMatrices[1][2][0] = nan_; }},
        {"skin 0 'bones': inverse bind matrix 0 must be affine: a last row of 0, 0, 0, 1",
         [](Scene& s) { s.skins[0].inverseBindMatrices[0][2][3] = 1.0f; }},
    });
}

TEST(ValidateCage, CageInstances) {
    expectMessages({
        {"node 4 'camp': refers to cage 2, but the scene has 2 (counted from 0)",
         [](Scene& s) { s.nodes[4].cage = 2; }},
        {"node 0 'body': refers to skin 1, but the scene has 1 (counted from 0)",
         [](Scene& s) { s.nodes[0].skin = 1; }},
        {"node 4 'camp': has a skin, but no joint moves a vertex of its mesh or its cage",
         [](Scene& s) { s.nodes[4].skin = 0; }},
        {"node 0 'body': its cage names joint 2, but its skin has 2",
         [](Scene& s) { s.cages[0].joints[5] = 2; }},
        {"node 0 'body': has 1 morph weights, but its cage has 2 morph targets",
         [](Scene& s) { s.nodes[0].morphWeights.pop_back(); }},
        {"node 0 'body': morph weight 1 must be a finite number of at most 1e9",
         [](Scene& s) { s.nodes[0].morphWeights[1] = nan_; }},
        {"node 0 'body': morph weight 0 must be a finite number of at most 1e9",
         [](Scene& s) { s.nodes[0].morphWeights[0] = -2e9f; }},
    });
}

TEST(ValidateCage, AnimatedMorphWeights) {
    expectMessages({
        {"animation 0 'motion': channel 1: its node has no mesh and no cage with morph targets",
         [](Scene& s) { s.animations[0].channels[1].node = 1; }},
        {"animation 0 'motion': channel 1: its node has no mesh and no cage with morph targets",
         [](Scene& s) { s.animations[0].channels[1].node = 4; }},
        {"animation 0 'motion': channel 1: its node has a matrix, which cannot be animated",
         [](Scene& s) { s.animations[0].channels[1].path = AnimationPath::scale; }},
        {"animation 0 'motion': channel 1: the number of its values does not fit the number of its keys",
         [](Scene& s) { s.animations[0].channels[1].values.pop_back(); }},
        {"animation 0 'motion': channel 2: the number of its values does not fit the number of its keys",
         [](Scene& s) { s.animations[0].channels[2].interpolation = Interpolation::step; }},
        {"animation 0 'motion': channel 1: its values must be finite numbers of at most 1e9",
         [](Scene& s) { s.animations[0].channels[1].values[3] = 2e9f; }},
        {"animation 0 'motion': channel 1: its times must be strictly increasing",
         [](Scene& s) {
             s.animations[0].channels[1].times = {1.0f, 0.0f};
         }},
    });
}

TEST(ValidateCage, WorldPositions) {
    const char* statue =
        "node 3 'statue': cage 0 'hull' is farther than 1e9 metres from the world's origin, or its position "
        "is not finite";
    const char* body =
        "node 0 'body': cage 0 'hull' is farther than 1e9 metres from the world's origin, or its position is "
        "not finite";
    expectMessages({
        {"node 4 'camp': cage 1 'tent' is farther than 1e9 metres from the world's origin, or its position "
         "is not finite",
         [](Scene& s) { std::get<Transform>(s.nodes[4].transform).translation.z = 2e9f; }},
        {statue, [](Scene& s) { std::get<glm::mat4>(s.nodes[3].transform)[3][0] = 1.1e9f; }},
        // By its morph targets, as animated at time 0.
        {statue,
         [](Scene& s) {
             s.cages[0].morphTargets[1].offsets[2].y = 1.1e9f;
             s.animations[0].channels[1].values[1] = 1.0f;
             s.animations[0].channels[2].values[3] = 0.0f;
         }},
        // By its joints, independent of its node.
        {body, [](Scene& s) { std::get<Transform>(s.nodes[1].transform).translation.x = 2e9f; }},
        {body, [](Scene& s) { s.skins[0].inverseBindMatrices[0][3].y = 3e38f; }},
        {body,
         [](Scene& s) {
             s.animations.clear();
             s.cages[0].morphTargets.clear();
             s.nodes[0].morphWeights.clear();
             std::get<Transform>(s.nodes[1].transform).translation.x = 2e9f;
         }},
    });
    Scene scene = sampleCageScene();
    std::get<Transform>(scene.nodes[0].transform).translation.x = 1e12f;
    EXPECT_NO_THROW(validate(scene)) << "the node's transform does not apply to a skinned cage";
}

}  // namespace
}  // namespace candela
