#include "light_file.h"

#include "scene_environment.h"
#include "scene_selection.h"

#include <candela/animation.h>
#include <candela/default_lights.h>
#include <candela/error.h>
#include <candela/property_edits.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace {

using candela::ImportNote;
using candela::NoteKind;

ImportNote information(std::string text) {
    return {NoteKind::information, std::move(text), {}, 1};
}

/// The studio that lights a scene without any light would not be added to one that has some.
void keepAddedStudio(candela::Scene& scene, const SceneOptions& options, std::vector<ImportNote>& notes) {
    if (options.environment.source != EnvironmentOption::Source::own || candela::hasLight(scene)) return;
    EnvironmentLight light = loadEnvironment(scene, options);
    for (std::string& note : light.notes) notes.push_back(information(std::move(note)));
    scene.environment = std::move(light.environment);
}

/// A node that stands at `place` of its file.
candela::Node nodeAt(const glm::dvec3& place, glm::mat4 matrix = glm::mat4(1.0f)) {
    matrix[3] = glm::vec4(glm::vec3(place), 1.0f);
    candela::Node node;
    node.transform = matrix;
    node.translationRemainder = place - glm::dvec3(glm::vec3(place));
    return node;
}

/// Gives the file the world space of the scene: far from the origin of both, a float has too few digits.
void useOrigin(candela::Scene& file, const glm::dvec3& origin) {
    for (candela::Light& light : file.lights)
        if (!light.node) light.position = glm::vec3(glm::dvec3(light.position) + file.origin - origin);
    for (candela::Camera& camera : file.cameras) {
        if (camera.node) continue;
        camera.node = static_cast<std::uint32_t>(file.nodes.size());
        file.nodes.push_back(nodeAt(file.origin));
    }
    file.origin = origin;
}

candela::Light lightOf(const candela::WorldLight& from, const std::string& name) {
    candela::Light light;
    light.name = name;
    light.type = from.type;
    light.color = from.intensity;
    if (from.range > 0.0f) light.range = from.range;
    light.innerConeAngle = from.innerConeAngle;
    light.outerConeAngle = from.outerConeAngle;
    light.position = from.position;
    light.direction = from.direction;
    light.castsShadow = from.castsShadow;
    light.radius = from.radius;
    return light;
}

void takeLights(candela::Scene& scene, const candela::Scene& file, const std::vector<glm::mat4>& world) {
    candela::endPropertyChanges(scene, candela::AnimatedElement::light);
    const std::vector<candela::WorldLight> lights = candela::worldLights(file, world);
    scene.lights.clear();
    scene.lights.reserve(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i)
        scene.lights.push_back(lightOf(lights[i], file.lights[i].name));
}

std::uint32_t nextNumber(const candela::Scene& scene) {
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
        next = std::max(next, scene.cameras[i].number.value_or(i) + 1);
    return next;
}

/// The camera of the scene that one of the file replaces.
std::optional<std::uint32_t> replacedBy(const candela::Scene& scene, const candela::Scene& file,
                                        std::uint32_t camera) {
    const candela::Camera& from = file.cameras[camera];
    const bool named = !from.name.empty() || (from.node && !file.nodes[*from.node].name.empty());
    return named ? findCamera(scene, cameraName(file, camera)) : std::nullopt;
}

void takeCamera(candela::Scene& scene, const candela::Scene& file, std::uint32_t index,
                const candela::CameraView& view) {
    const candela::Camera& from = file.cameras[index];
    std::optional<std::uint32_t> place = replacedBy(scene, file, index);
    const std::uint32_t number = place ? scene.cameras[*place].number.value_or(*place) : nextNumber(scene);
    if (!place) {
        place = static_cast<std::uint32_t>(scene.cameras.size());
        scene.cameras.emplace_back();
    }
    candela::endPropertyChanges(scene, candela::AnimatedElement::camera, *place);
    candela::Camera& taken = scene.cameras[*place];
    taken = from;
    taken.number = number;
    taken.node = static_cast<std::uint32_t>(scene.nodes.size());
    candela::Node node = nodeAt(glm::dvec3(view.eye()) + scene.origin, view.worldFromCamera);
    if (from.node) node.name = file.nodes[*from.node].name;
    scene.nodes.push_back(std::move(node));
}

}  // namespace

std::vector<ImportNote> takeLightFile(candela::Scene& scene, const candela::PluginRegistry& plugins,
                                      const SceneOptions& options) {
    if (!options.lights) return {};
    candela::ImportedScene imported =
        candela::importScene(plugins, *options.lights, {options.strictness, {}});
    candela::Scene& file = imported.scene;
    if (file.lights.empty())
        throw candela::Error(candela::ErrorKind::badInput, *options.lights, "has no light");
    std::vector<ImportNote> notes;
    for (ImportNote& note : imported.report.notes)
        notes.push_back(
            {note.kind, *options.lights + ": " + note.text, std::move(note.elements), note.count});
    if (!file.animations.empty())
        notes.push_back(information(*options.lights + ": its animations do not play"));
    playOnly(file, {});
    keepAddedStudio(scene, options, notes);
    useOrigin(file, scene.origin);
    const std::vector<glm::mat4> world = candela::worldTransforms(file);
    takeLights(scene, file, world);
    for (std::uint32_t i = 0; i < file.cameras.size(); ++i)
        takeCamera(scene, file, i, candela::cameraView(file, i, world));
    return notes;
}
