#pragma once

// candela's rule: tinygltf is a shared library, so its implementation macros are never defined.
#include <tiny_gltf.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../common/failure.h"
#include "../common/host.h"
#include "cage_settings.h"

namespace candela_plugins::gltf {

/// Where the bytes of a buffer or an image are. They are hidden from tinygltf, which would open files itself.
struct Source {
    std::string name;
    std::optional<std::string> uri;
    std::optional<std::size_t> bufferView;
    std::uint64_t byteLength = 0;  ///< Buffers only.
};

/// The joints of a skin. They are hidden from tinygltf, which refuses skins without inverseBindMatrices.
struct SkinSource {
    std::string name;
    std::vector<std::size_t> joints;                 ///< Nodes.
    std::optional<std::size_t> inverseBindMatrices;  ///< An accessor.
};

/// A document whose JSON has been checked: every index is in range, every number finite in single precision.
struct Document {
    tinygltf::Model model;  ///< Without buffers, images and skins.
    std::vector<Source> bufferSources, imageSources;
    std::vector<SkinSource> skins;
    std::map<std::size_t, CageSettings> cages;  ///< By mesh: those that are subdivision cages.
    std::vector<Bytes> buffers;                 ///< Filled by `loadBuffers`.
    bool quantized = false;                     ///< KHR_mesh_quantization is in use.
};

/// The attribute name under which `readDocument` keeps a primitive's index accessor.
inline constexpr const char* indicesAttribute = "_INDICES";

/// Reads the JSON text. Throws `Failure`; adds notes for unsupported content.
Document readDocument(const Bytes& json, const Host& host);

}  // namespace candela_plugins::gltf
