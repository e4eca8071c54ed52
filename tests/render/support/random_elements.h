#pragma once

#include <candela/scene.h>

#include <cstdint>
#include <optional>
#include <random>

namespace candela::test {

/// The same numbers on every machine.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    std::uint32_t operator()() { return static_cast<std::uint32_t>(engine_()); }
    /// From 0 on, less than 1.
    float unit() { return static_cast<float>((*this)() % 10007u) / 10007.0f; }

  private:
    std::mt19937 engine_;
};

// Random elements of scenes, small ones.

/// Shapes of few triangles, of which no two lie in the same place.
Mesh randomMesh(Random& random);
glm::mat4 randomPlace(Random& random);
Image randomImage(Random& random);
/// With textures of `image` at times.
Material randomMaterial(Random& random, std::optional<std::uint32_t> image);
Light randomLight(Random& random, std::optional<std::uint32_t> node);

}  // namespace candela::test
