#pragma once

#include <glm/mat4x4.hpp>

#include <cmath>

namespace candela {

/// Whether every component of a GLM vector is a finite number.
template <typename Vector>
bool allFinite(const Vector& vector) {
    for (glm::length_t i = 0; i < vector.length(); ++i) {
        if (!std::isfinite(vector[i])) return false;
    }
    return true;
}

inline bool allFinite(const glm::mat4& matrix) {
    return allFinite(matrix[0]) && allFinite(matrix[1]) && allFinite(matrix[2]) && allFinite(matrix[3]);
}

}  // namespace candela
