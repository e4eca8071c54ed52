#pragma once

#include <candela/scene.h>

#include <cstdint>
#include <vector>

namespace candela {

/// Which sets of texture coordinates the surfaces have that wear each material of a scene.
class SurfaceUvs {
  public:
    explicit SurfaceUvs(const Scene& scene);

    /// Throws `Error` (badInput) when a surface that wears material `index` lacks coordinates that a texture
    /// of `material` reads.
    void check(std::uint32_t index, const Material& material) const;

  private:
    struct Sets {
        bool all0 = true, all1 = true;  ///< Do all surfaces have the set?
    };
    void add(std::uint32_t material, Sets sets);

    std::vector<Sets> sets_;  ///< One a material.
};

}  // namespace candela
