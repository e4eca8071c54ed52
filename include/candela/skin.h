#pragma once

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace candela {

/// The joints that move a cage (glTF 2.0, 3.7.3.3).
struct Skin {
    std::string name;
    std::vector<std::uint32_t> joints;           ///< Indices into `Scene::nodes`, one or more.
    std::vector<glm::mat4> inverseBindMatrices;  ///< Affine, one per joint.
};

}  // namespace candela
