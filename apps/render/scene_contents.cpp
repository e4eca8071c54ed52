#include "scene_contents.h"

#include <algorithm>

namespace {

using candela::Material;

struct MaterialKind {
    const char* name;
    bool (*has)(const Material&);
};

constexpr MaterialKind kinds[] = {
    {"mask", [](const Material& m) { return m.alphaMode == candela::AlphaMode::mask; }},
    {"blend", [](const Material& m) { return m.alphaMode == candela::AlphaMode::blend; }},
    {"unlit", [](const Material& m) { return m.unlit; }},
    {"ior", [](const Material& m) { return m.ior != Material{}.ior; }},
    {"specular", [](const Material& m) { return m.specular != candela::Specular{}; }},
    {"clearcoat", [](const Material& m) { return m.clearcoat.factor > 0.0f; }},
    {"sheen", [](const Material& m) { return m.sheen.color != glm::vec3(0.0f); }},
    {"anisotropy", [](const Material& m) { return m.anisotropy.strength > 0.0f; }},
    {"iridescence", [](const Material& m) { return m.iridescence.factor > 0.0f; }},
    {"transmission", [](const Material& m) { return m.transmission.factor > 0.0f; }},
    {"volume", [](const Material& m) { return m.volume.thickness > 0.0f; }},
    {"dispersion", [](const Material& m) { return m.volume.dispersion > 0.0f; }},
    {"diffuse_transmission", [](const Material& m) { return m.diffuseTransmission.factor > 0.0f; }},
};

}  // namespace

std::vector<ContentCount> contentCounts(const candela::Scene& scene) {
    return {{"meshes", scene.meshes.size()},    {"cages", scene.cages.size()},
            {"nodes", scene.nodes.size()},      {"images", scene.images.size()},
            {"cameras", scene.cameras.size()},  {"animations", scene.animations.size()},
            {"variants", scene.variants.size()}};
}

std::vector<ContentCount> materialKinds(const candela::Scene& scene) {
    std::vector<ContentCount> counts;
    for (const MaterialKind& kind : kinds) {
        const auto count = std::ranges::count_if(scene.materials, kind.has);
        if (count > 0) counts.push_back({kind.name, static_cast<std::uint64_t>(count)});
    }
    return counts;
}

const char* toString(candela::NoteKind kind) {
    switch (kind) {
        case candela::NoteKind::missing:
            return "missing";
        case candela::NoteKind::repaired:
            return "repaired";
        default:
            return "information";
    }
}
