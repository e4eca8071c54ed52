#pragma once

#include <glm/vec3.hpp>

/// The sRGB code values (0 to 1) of linear Rec.709, held within 0 to 1. Source: IEC 61966-2-1, 5.2.
glm::vec3 srgbFromLinear(const glm::vec3& linear);

/// Linear Rec.709 from sRGB code values of 0 to 1.
glm::vec3 linearFromSrgb(const glm::vec3& codes);
