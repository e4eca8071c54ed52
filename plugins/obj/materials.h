#pragma once

#include <string>
#include <vector>

#include "document.h"

namespace candela_plugins::obj {

/// An added material of the document.
struct AddedMaterial {
    std::int32_t index = -1;  ///< Of the host; -1: no face uses it.
    bool readsUvs = false;    ///< Whether it has a texture.
};

/// Adds the materials that faces use, with their textures. Returns one for each material of the document, and
/// the default one for faces without a material behind them. `sceneFile` is the name of the OBJ file.
/// Progress goes from `from` to `to`.
///
/// Converts the statements of an .mtl file to a metallic-roughness material:
///  - Kd, Ke, Pr, Pm are base colour, emission, roughness and metallic; colours are linear. Their maps
///    multiply them, and a factor that is not given with a map is 1; so is a Kd or Ke of 0 with a map, as
///    exporters write it.
///  - Without Pr, roughness follows from Ns: a Blinn-Phong lobe of exponent n is like one of GGX with
///    alpha² = 2 / (n + 2) (Karis, "Specular BRDF Reference", 2013), and roughness is the root of alpha.
///  - d, Tr and map_d are the opacity. They are drawn as a mask with a cutoff of 0.5.
///  - norm is the normal map; so is a bump map that holds normals.
///  - Materials are double-sided, since the format does not define it; the default one is white and rough.
std::vector<AddedMaterial> addMaterials(const Document& document, const std::string& sceneFile,
                                        const Host& host, double from, double to);

/// The material of a face.
AddedMaterial materialOf(const Document& document, const std::vector<AddedMaterial>& materials,
                         std::size_t face);

}  // namespace candela_plugins::obj
