#pragma once

#include <candela/brdf.h>

#include <candela/error.h>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>
#include <string>

/// What the functions of brdf.h ask of their arguments. Each throws `Error` (badInput) with the name of the
/// argument and what it has to be.
namespace candela::arguments {

/// Unit vectors and cosines are off by rounding, also of single precision.
constexpr double unitTolerance = 1.0e-3;

inline void require(bool holds, const char* name, const char* expected) {
    if (holds) return;
    throw Error(ErrorKind::badInput, "", std::string(name) + " has to be " + expected);
}

inline bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool isUnit(const glm::dvec3& v) {
    return isFinite(v) && std::abs(glm::length(v) - 1.0) <= unitTolerance;
}

inline bool isNonNegative(const glm::dvec3& v) {
    return isFinite(v) && glm::all(glm::greaterThanEqual(v, glm::dvec3(0.0)));
}

inline void requireCosine(double value, const char* name) {
    require(std::abs(value) <= 1.0 + unitTolerance, name, "a cosine, -1 to 1");
}

inline void requireUnitRange(double value, const char* name) {
    require(value >= 0.0 && value <= 1.0, name, "0 to 1");
}

inline void requireUnitRange(const glm::dvec3& value, const char* name) {
    require(isNonNegative(value) && glm::all(glm::lessThanEqual(value, glm::dvec3(1.0))), name, "0 to 1");
}

}  // namespace candela::arguments
