#pragma once

#include <map>

#include "materials.h"

namespace candela_gltf {

/// The materials of cages. A cage has one set of texture coordinates, which is set 0 to the host: a material
/// that reads set 1 gets a copy that reads set 0, pushed when a cage first needs it.
class CageMaterials {
  public:
    CageMaterials(const PushedMaterials& materials, const Host& host) : materials_(materials), host_(host) {}

    /// The host's index of a material of the file; -1 stays -1.
    std::int32_t find(std::int32_t material);

  private:
    const PushedMaterials& materials_;
    const Host& host_;
    std::map<std::int32_t, std::int32_t> copies_;
};

}  // namespace candela_gltf
