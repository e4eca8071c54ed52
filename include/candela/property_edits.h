#pragma once

#include <candela/animation.h>
#include <candela/export.h>
#include <candela/scene.h>

#include <cstdint>
#include <optional>

namespace candela {

/// From now on neither animations nor the frame callback change properties of element `index` of a kind; none:
/// of all of that kind. For elements that are replaced, whose indices then mean others. Matrices of nodes that
/// animations and the frame callback set are not properties: they stay.
CANDELA_API void endPropertyChanges(Scene& scene, AnimatedElement kind,
                                    std::optional<std::uint32_t> index = {});

}  // namespace candela
