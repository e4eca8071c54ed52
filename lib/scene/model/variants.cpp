#include "base/error_context.h"

#include <candela/scene.h>

namespace candela {

namespace {

void selectVariant(Mesh& mesh, std::optional<std::uint32_t> variant, const ErrorContext& element) {
    for (const VariantMaterial& entry : mesh.variantMaterials) {
        if (entry.submesh >= mesh.submeshes.size())
            element.refuse("a variant names submesh " + std::to_string(entry.submesh) + ", but there are " +
                           std::to_string(mesh.submeshes.size()));
        if (!entry.variant) mesh.submeshes[entry.submesh].material = entry.material;
    }
    if (!variant) return;
    for (const VariantMaterial& entry : mesh.variantMaterials) {
        if (entry.variant == variant) mesh.submeshes[entry.submesh].material = entry.material;
    }
}

void selectVariant(Cage& cage, std::optional<std::uint32_t> variant) {
    for (const std::optional<std::uint32_t> selected : {std::optional<std::uint32_t>(), variant}) {
        for (const CageVariant& entry : cage.variants) {
            if (entry.variant == selected) cage.faceMaterials = entry.faceMaterials;
        }
    }
}

}  // namespace

void selectVariant(Scene& scene, std::optional<std::uint32_t> variant) {
    ErrorContext("scene").requireIndex("variant", variant, scene.variants.size());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        selectVariant(scene.meshes[i], variant, ErrorContext("mesh", i, scene.meshes[i].name));
    for (Cage& cage : scene.cages) selectVariant(cage, variant);
}

}  // namespace candela
