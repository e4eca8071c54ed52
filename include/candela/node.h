#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace candela {

/// A transform that can be animated: translation × rotation × scale.
struct Transform {
    glm::vec3 translation{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< Unit length.
    glm::vec3 scale{1.0f};
};

/// A node of the hierarchy. Parents precede their children in `Scene::nodes`.
struct Node {
    std::string name = {};
    std::optional<std::uint32_t> parent = {};  ///< Index into `Scene::nodes`, less than this node's own.
    std::variant<Transform, glm::mat4> transform =
        Transform{};                         ///< Local; an affine matrix where the file gives one.
    std::optional<std::uint32_t> mesh = {};  ///< Index into `Scene::meshes`.
    std::optional<std::uint32_t> cage = {};  ///< Index into `Scene::cages`.
    /// Index into `Scene::skins`: moves the node's mesh and cage, where these have joints. What a skin moves
    /// is placed by the joints, not by the node.
    std::optional<std::uint32_t> skin = {};
    /// One per morph target of the node's mesh or cage (where both have targets, they have as many); empty:
    /// all 0.
    std::vector<float> morphWeights = {};
    /// Metres, added to the local translation in double precision: what a float can not hold of it.
    glm::dvec3 translationRemainder{0.0};
    /// Whether the node's own mesh and cage cast shadows; its children are not affected.
    bool castsShadow = true;
    /// False: what this node and all nodes below it show is not drawn and casts no shadow, and their lights
    /// do not light. Cameras see as before, and boxes around the scene hold it too.
    bool visible = true;
};

}  // namespace candela
