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

/// An instance of a cage at a node. A skinned cage is placed by its joints, not by its node.
struct CageInstance {
    std::uint32_t cage = 0;             ///< Index into `Scene::cages`.
    std::optional<std::uint32_t> skin;  ///< Index into `Scene::skins`.
    std::vector<float> morphWeights;    ///< One per morph target of the cage; empty: all 0.
};

/// A node of the hierarchy. Parents precede their children in `Scene::nodes`.
struct Node {
    std::string name;
    std::optional<std::uint32_t> parent;  ///< Index into `Scene::nodes`, less than this node's own.
    std::variant<Transform, glm::mat4> transform =
        Transform{};                    ///< Local; an affine matrix where the file gives one.
    std::optional<std::uint32_t> mesh;  ///< Index into `Scene::meshes`.
    std::optional<CageInstance> cage;
    /// Metres, added to the local translation in double precision: what a float can not hold of it.
    glm::dvec3 translationRemainder{0.0};
};

}  // namespace candela
