#include "variants.h"

#include <algorithm>

#include "texture_uses.h"

namespace candela_plugins::gltf {
namespace {

constexpr const char* extensionName = "KHR_materials_variants";

/// Calls `use` for each element of an array member of an extension, which may be null or without it.
template <typename Use>
void forEach(const tinygltf::Value* extension, const char* member, const Use& use) {
    if (!extension || !extension->Has(member)) return;
    const tinygltf::Value& array = extension->Get(member);
    for (std::size_t i = 0; i < array.ArrayLen(); ++i) use(i, array.Get(static_cast<int>(i)));
}

/// Calls `use` for each variant of a mapping of a primitive.
template <typename Use>
void forEachVariant(const tinygltf::Value& mapping, const Use& use) {
    forEach(&mapping, "variants", [&](std::size_t, const tinygltf::Value& variant) {
        use(VariantMaterial{static_cast<std::uint32_t>(variant.GetNumberAsInt()),
                            mapping.Get("material").GetNumberAsInt()});
    });
}

}  // namespace

void addVariants(const Document& document, const Host& host) {
    const tinygltf::Value* extension = findExtension(document.model.extensions, extensionName);
    if (extension && !host.takesVariants()) {
        host.note(CANDELA_NOTE_MISSING, "",
                  "variants, for which the host is too old: the materials without a variant are drawn");
        return;
    }
    forEach(extension, "variants", [&](std::size_t, const tinygltf::Value& variant) {
        host.addVariant(variant.Has("name") ? variant.Get("name").Get<std::string>() : std::string());
    });
}

std::vector<VariantMaterial> readVariantMaterials(const Document& document,
                                                  const tinygltf::Primitive& primitive,
                                                  const std::string& element, const Host& host) {
    std::vector<VariantMaterial> materials;
    if (!host.takesVariants()) return materials;
    const auto add = [&](const VariantMaterial& added) {
        const bool isKnown =
            std::any_of(materials.begin(), materials.end(),
                        [&](const VariantMaterial& material) { return material.variant == added.variant; });
        if (!isKnown) return materials.push_back(added);
        host.note(CANDELA_NOTE_REPAIRED, element, "two materials for a variant: the first one is used");
    };
    forEach(findExtension(primitive.extensions, extensionName), "mappings",
            [&](std::size_t i, const tinygltf::Value& mapping) {
                const std::string name =
                    element + ", " + extensionName + ", " + elementName("mapping", i, "");
                const bool isLeftOut = host.leavesOut([&] { requireUsable(document, name); });
                if (!isLeftOut) forEachVariant(mapping, add);
            });
    return materials;
}

std::vector<std::size_t> materialsOf(const tinygltf::Primitive& primitive) {
    std::vector<std::size_t> materials;
    if (primitive.material >= 0) materials.push_back(static_cast<std::size_t>(primitive.material));
    forEach(findExtension(primitive.extensions, extensionName), "mappings",
            [&](std::size_t, const tinygltf::Value& mapping) {
                forEachVariant(mapping, [&](const VariantMaterial& material) {
                    materials.push_back(static_cast<std::size_t>(material.material));
                });
            });
    return materials;
}

}  // namespace candela_plugins::gltf
