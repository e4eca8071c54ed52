#include "scene/validate/limits.h"
#include "scene/validate/require_each.h"
#include "scene/validate/validate_parts.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

// How many joints a skin must have for the cage.
std::size_t jointsAskedFor(const Cage& cage) {
    const auto greatest = std::max_element(cage.joints.begin(), cage.joints.end());
    return greatest == cage.joints.end() ? 0 : std::size_t{*greatest} + 1;
}

void validateMorphWeights(const CageInstance& shown, const Cage& cage, const ErrorContext& element) {
    if (shown.morphWeights.empty()) return;
    if (shown.morphWeights.size() != cage.morphTargets.size()) {
        element.refuse("has " + std::to_string(shown.morphWeights.size()) +
                       " morph weights, but its cage has " + std::to_string(cage.morphTargets.size()) +
                       " morph targets");
    }
    requireEach(shown.morphWeights, "morph weight", "must be a finite number of at most 1e9", element,
                [](float weight) { return std::abs(weight) <= maxAnimated; });
}

}  // namespace

void validateSkin(const Skin& skin, const Scene& scene, const ErrorContext& element) {
    element.require(!skin.joints.empty(), "it must have at least one joint");
    for (const std::uint32_t joint : skin.joints) element.requireIndex("node", joint, scene.nodes.size());
    if (skin.inverseBindMatrices.size() != skin.joints.size()) {
        element.refuse("has " + std::to_string(skin.inverseBindMatrices.size()) +
                       " inverse bind matrices for " + std::to_string(skin.joints.size()) + " joints");
    }
    requireEach(skin.inverseBindMatrices, "inverse bind matrix", "must be finite numbers", element,
                [](const glm::mat4& matrix) { return allFinite(matrix); });
    requireEach(skin.inverseBindMatrices, "inverse bind matrix", "must be affine: a last row of 0, 0, 0, 1",
                element, isAffine);
}

void validateCageInstances(const Scene& scene) {
    std::vector<std::size_t> askedFor;
    askedFor.reserve(scene.cages.size());
    for (const Cage& cage : scene.cages) askedFor.push_back(jointsAskedFor(cage));
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        if (!scene.nodes[i].cage) continue;
        const CageInstance& shown = *scene.nodes[i].cage;
        const ErrorContext element("node", i, scene.nodes[i].name);
        element.requireIndex("cage", shown.cage, scene.cages.size());
        element.requireIndex("skin", shown.skin, scene.skins.size());
        const Cage& cage = scene.cages[shown.cage];
        validateMorphWeights(shown, cage, element);
        if (!shown.skin) continue;
        element.require(cage.influenceCount > 0, "has a skin, but no joint moves a vertex of its cage");
        const std::size_t joints = scene.skins[*shown.skin].joints.size();
        if (askedFor[shown.cage] <= joints) continue;
        element.refuse("its cage names joint " + std::to_string(askedFor[shown.cage] - 1) +
                       ", but its skin has " + std::to_string(joints));
    }
}

}  // namespace candela
