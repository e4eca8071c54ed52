#pragma once

#include <vector>

#include "document.h"

namespace candela_obj {

/// A material of the document as the host has it.
struct PushedMaterial {
    std::int32_t index = -1;  ///< -1: the default one, for no material file has this.
    bool readsUvs = false;    ///< It has a texture.
};

/// Pushes the materials that faces use, with their textures. Returns one for each material of the document.
/// Progress goes from `from` to `to`.
///
/// What an .mtl file says becomes a metallic-roughness material:
///  - Kd, Ke, Pr, Pm are base colour, emission, roughness and metal; colours are linear. Their maps multiply
///    them, and a value that a map comes without is 1; so is a Ke of 0 with a map, as exporters write it.
///  - Without Pr, roughness follows from Ns: a Blinn-Phong lobe of exponent n is like one of GGX with
///    alpha² = 2 / (n + 2) (Karis, "Specular BRDF Reference", 2013), and roughness is the root of alpha.
///  - d, Tr and map_d are the opacity. They are drawn as a mask with a cutoff of 0.5.
///  - norm is the normal map. Faces are seen from both sides, for the format has no word on it.
std::vector<PushedMaterial> pushMaterials(const Document& document, const Host& host, double from, double to);

/// The material of a face.
PushedMaterial materialOf(const Document& document, const std::vector<PushedMaterial>& materials,
                          std::size_t face);

}  // namespace candela_obj
