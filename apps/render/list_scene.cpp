#include "commands.h"

#include "common/count_text.h"
#include "common/light_file.h"
#include "common/scene_selection.h"
#include "scene_contents.h"

#include <candela/default_lights.h>
#include <candela/environment.h>
#include <candela/import.h>
#include <candela/plugin_registry.h>

#include <iostream>
#include <numbers>
#include <utility>

namespace {

void printAnimations(const candela::Scene& scene) {
    for (std::uint32_t i = 0; i < scene.animations.size(); ++i) {
        const candela::Animation& animation = scene.animations[i];
        const std::size_t channels = animation.channels.size() + animation.properties.size();
        std::cout << animationLabel(scene, i) << ": " << countText(channels, "channel") << ", to "
                  << lastKeyTime(animation) << " s" << (i == 0 ? "  (default)" : "") << "\n";
    }
    if (scene.frameCallback)
        std::cout << "frame callback of the plugin: to " << candela::frameCallbackSpan(scene).last << " s\n";
    if (!candela::isAnimated(scene)) std::cout << "no animations\n";
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

void printVariants(const candela::Scene& scene) {
    for (std::uint32_t i = 0; i < scene.variants.size(); ++i) std::cout << variantLabel(scene, i) << "\n";
    if (scene.variants.empty()) std::cout << "no variants\n";
}

void printContents(const candela::ImportedScene& imported) {
    const candela::Scene& scene = imported.scene;
    const auto print = [](const char* name, std::uint64_t count) {
        if (count > 0) std::cout << name << ": " << count << "\n";
    };
    print("triangles of meshes", candela::triangleCount(scene));
    for (const ContentCount& kind : contentCounts(scene)) print(kind.name, kind.count);
    print("lights", scene.lights.size());
    print("environments", scene.environment ? 1 : 0);
    print("materials", scene.materials.size());
    for (const ContentCount& kind : materialKinds(scene))
        print((std::string("materials with ") + kind.name).c_str(), kind.count);
    for (const candela::ImportNote& note : imported.report.notes)
        std::cout << toString(note.kind) << ": " << note.line() << "\n";
}

/// `scene` has one.
void printOwnEnvironment(candela::Environment environment) {
    const candela::Image& picture = environment.picture;
    if (!picture.name.empty()) std::cout << "\"" << picture.name << "\": ";
    std::cout << picture.width << "x" << picture.height << ", intensity " << environment.intensity << ", "
              << (environment.isBackground ? "seen" : "not seen") << " behind the scene";
    if (candela::takeSun(environment)) std::cout << ", with a sun";
    std::cout << "\n";
}

void printEnvironment(const candela::Scene& scene) {
    if (scene.environment)
        printOwnEnvironment(*scene.environment);
    else if (candela::hasLight(scene))
        std::cout << "no environment\n";
    else
        std::cout << "no environment, and no other light: a studio lights the scene\n";
}

}  // namespace

void printSceneList(const Options& options) {
    const candela::PluginRegistry plugins(options.pluginFolders);
    candela::ImportedScene imported = candela::importScene(plugins, options.scene, {options.strictness, {}});
    for (candela::ImportNote& note : takeLightFile(imported.scene, plugins, options))
        imported.report.notes.push_back(std::move(note));
    const candela::Scene& scene = imported.scene;
    switch (*options.list) {
        case ListKind::animations:
            return printAnimations(scene);
        case ListKind::cameras:
            return printCameras(scene);
        case ListKind::contents:
            return printContents(imported);
        case ListKind::variants:
            return printVariants(scene);
        case ListKind::environment:
            return printEnvironment(scene);
        default:
            return printMaterials(scene);
    }
}
