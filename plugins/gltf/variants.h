#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../common/host.h"
#include "document.h"

namespace candela_plugins::gltf {

/// Adds the variants of the file in its order (KHR_materials_variants). Notes that they are left out where
/// the host has none.
void addVariants(const Document& document, const Host& host);

/// A material that a primitive has in a variant.
struct VariantMaterial {
    std::uint32_t variant;
    std::int32_t material;
};

/// Those of a primitive, at most one for each variant; empty where the host has no variants. `element` is the
/// primitive; mappings that cannot be used are noted.
std::vector<VariantMaterial> readVariantMaterials(const Document& document,
                                                  const tinygltf::Primitive& primitive,
                                                  const std::string& element, const Host& host);

/// The materials of a primitive, those in variants included, each a material of the file.
std::vector<std::size_t> materialsOf(const tinygltf::Primitive& primitive);

}  // namespace candela_plugins::gltf
