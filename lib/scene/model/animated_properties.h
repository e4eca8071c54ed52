#pragma once

#include <candela/scene.h>

#include <cstddef>
#include <optional>
#include <variant>

namespace candela {

// Where an element keeps the numbers of a property: a pointer to the first of them; null where the element
// does not have the property.
using NodeFlag = bool* (*)(Node&);
using MaterialNumbers = float* (*)(Material&);
using TextureNumbers = float* (*)(Texture&);
using LightNumbers = float* (*)(Light&);
using CameraNumbers = float* (*)(Camera&);

/// What an animation needs to know of a property.
struct AnimatedPropertyRow {
    AnimatedProperty property;
    const char* name;     ///< As messages call it: "base colour".
    std::size_t numbers;  ///< Of a value, at most 4.
    float min, max;       ///< Included.
    std::variant<NodeFlag, MaterialNumbers, TextureNumbers, LightNumbers, CameraNumbers> place;
};

/// The row of a property; null where there is no such property.
const AnimatedPropertyRow* findRow(AnimatedProperty property);
/// The same of one that there is.
const AnimatedPropertyRow& rowOf(AnimatedProperty property);

}  // namespace candela
