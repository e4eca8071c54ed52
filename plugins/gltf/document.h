#pragma once

// candela's rule: tinygltf is a shared library, so its implementation macros are never defined.
#include <tiny_gltf.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../common/failure.h"
#include "../common/host.h"
#include "animation_pointer.h"
#include "cage_settings.h"
#include "image_based_light.h"
#include "schema.h"
#include "shadow_extras.h"

namespace candela_plugins::gltf {

/// Where the bytes of a buffer or an image are. They are hidden from tinygltf, which would open files itself.
struct Source {
    std::string name;
    std::optional<std::string> uri;
    std::optional<std::size_t> bufferView;
    std::optional<std::uint64_t> byteLength;  ///< Buffers only.
};

/// What EXT_meshopt_compression or KHR_meshopt_compression says of a buffer view.
struct CompressedData {
    enum class Mode { attributes, triangles, indices };
    enum class Filter { none, octahedral, quaternion, exponential, color };

    std::string extension;
    std::size_t buffer = 0;
    std::uint64_t byteOffset = 0, byteLength = 0;  ///< Of the compressed data.
    std::uint64_t byteStride = 0, count = 0;       ///< Of the elements.
    Mode mode = Mode::attributes;
    Filter filter = Filter::none;
};

/// A part of a buffer. Hidden from tinygltf, which refuses strides that can be read.
struct BufferView {
    std::string name;
    std::size_t buffer = 0;
    std::uint64_t byteOffset = 0, byteLength = 0;
    std::uint64_t byteStride = 0;  ///< 0: the elements are tightly packed.
    std::optional<CompressedData> compressed = {};
    std::optional<Bytes> decoded = {};  ///< In place of a part of the buffer.
};

/// What KHR_draco_mesh_compression says of a primitive.
struct CompressedPrimitive {
    std::size_t bufferView = 0;
    std::map<std::string, std::uint32_t> attributes;  ///< The unique ids in the compressed data.
};

/// The joints of a skin. They are hidden from tinygltf, which refuses skins without inverseBindMatrices.
struct SkinSource {
    std::string name;
    std::vector<std::size_t> joints;                 ///< Nodes.
    std::optional<std::size_t> inverseBindMatrices;  ///< An accessor.
};

/// A document whose JSON has been checked: every index is in range, every number finite in single precision.
struct Document {
    tinygltf::Model model;  ///< Without buffers, buffer views, images and skins.
    Faults faults;
    std::optional<Failure> lostGeometry;  ///< Why the first mesh or primitive that is not drawn was left out.
    std::vector<Source> bufferSources, imageSources;
    std::vector<BufferView> bufferViews;
    std::vector<std::string> imageExtensions;  ///< By texture: that of an image of another format, or empty.
    std::vector<SkinSource> skins;
    std::map<std::pair<std::size_t, std::size_t>, CompressedPrimitive>
        compressedPrimitives;                   ///< By mesh and primitive.
    std::map<std::size_t, CageSettings> cages;  ///< By mesh: those that are subdivision cages.
    ShadowExtras shadows;
    AnimationPointers animationPointers;
    std::optional<ImageBasedLight> imageBasedLight;  ///< Of the scene that is drawn.
    std::vector<Bytes> buffers;                      ///< Filled by `loadBuffers`; empty where it has a fault.
    bool quantized = false;                          ///< KHR_mesh_quantization is in use.
};

/// The attribute name under which `readDocument` keeps a primitive's index accessor.
inline constexpr const char* indicesAttribute = "_INDICES";

/// Reads the JSON text. Throws `Failure` when it is no glTF 2.0 document; notes what is repaired or left out.
Document readDocument(const Bytes& json, const Host& host);

/// Notes that a mesh or primitive is left out, and keeps the first reason.
void loseGeometry(Document& document, const Failure& failure, const Host& host);

/// Throws the fault of an element of the document, if it has one.
void requireUsable(const Document& document, const std::string& element);

/// The same for an element that another one, `user`, reads: the `Failure` is of that one.
void requireUsable(const Document& document, const std::string& element, const std::string& user);

}  // namespace candela_plugins::gltf
