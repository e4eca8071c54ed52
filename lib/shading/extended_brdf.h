#pragma once

#include <candela/brdf.h>

#include <functional>

namespace candela {

/// Throws `Error` (badInput) where a member is not in its range.
void requireExtendedLobes(const SurfacePoint& surface);

/// `evaluateReflection` of a surface with `extended`, for arguments that are checked.
glm::dvec3 extendedReflection(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& l,
                              const glm::dvec3& v);

/// The same as a function of `l`: what depends on the direction of view alone is evaluated once. `surface` is
/// kept by reference.
std::function<glm::dvec3(const glm::dvec3& l)> extendedReflectionTowards(BrdfModel model,
                                                                         const SurfacePoint& surface,
                                                                         const glm::dvec3& v);

}  // namespace candela
