#include "commands.h"

#include "common/scene_selection.h"

#include <candela/import.h>
#include <candela/plugin_registry.h>

#include <algorithm>
#include <iostream>
#include <numbers>

namespace {

void printAnimations(const candela::Scene& scene) {
    for (std::uint32_t i = 0; i < scene.animations.size(); ++i) {
        const auto& channels = scene.animations[i].channels;
        float last = 0.0f;
        for (const candela::AnimationChannel& channel : channels) last = std::max(last, channel.times.back());
        std::cout << animationLabel(scene, i) << ": " << channels.size()
                  << (channels.size() == 1 ? " channel" : " channels") << ", to " << last << " s"
                  << (i == 0 ? "  (default)" : "") << "\n";
    }
    if (scene.animations.empty()) std::cout << "no animations\n";
}

void printCameras(const candela::Scene& scene) {
    for (std::uint32_t i = 0; i < scene.cameras.size(); ++i) {
        const candela::Camera& camera = scene.cameras[i];
        std::cout << cameraLabel(scene, i) << ": ";
        if (camera.orthographicHeight)
            std::cout << "orthographic, " << *camera.orthographicHeight << " m high";
        else
            std::cout << "perspective, " << camera.verticalFov * 180.0 / std::numbers::pi << " degrees";
        std::cout << (i == 0 ? "  (default)" : "") << "\n";
    }
    if (scene.cameras.empty()) std::cout << "no cameras\n";
}

void printMaterials(const candela::Scene& scene) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        std::cout << i;
        if (!scene.materials[i].name.empty()) std::cout << " \"" << scene.materials[i].name << "\"";
        std::cout << "\n";
    }
    if (scene.materials.empty()) std::cout << "no materials\n";
}

}  // namespace

void printSceneList(const Options& options) {
    const candela::PluginRegistry plugins(options.pluginFolders);
    const candela::Scene scene = candela::importScene(plugins, options.scene, {options.strictness, {}}).scene;
    switch (*options.list) {
        case ListKind::animations:
            return printAnimations(scene);
        case ListKind::cameras:
            return printCameras(scene);
        default:
            return printMaterials(scene);
    }
}
