#include "render/frame_request.h"

#include <candela/error.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>

namespace candela {

void refuse(const std::string& text) {
    throw Error(ErrorKind::badInput, "", text);
}

namespace {

void checkRegion(const PictureRegion& region) {
    constexpr int maxSide = 1 << 20;
    if (region.width < 1 || region.height < 1 || region.width > maxSide || region.height > maxSide) {
        refuse("a part of a picture of " + std::to_string(region.width) + "x" +
               std::to_string(region.height) + " pixels is asked for; width and height have to be 1 to " +
               std::to_string(maxSide));
    }
    if (std::abs(region.x) <= maxSide && std::abs(region.y) <= maxSide) return;
    refuse("the part at (" + std::to_string(region.x) + ", " + std::to_string(region.y) +
           ") of a picture is asked for; both have to be within " + std::to_string(maxSide));
}

}  // namespace

void checkSettings(const FrameSettings& settings) {
    if (settings.width < 1 || settings.height < 1) {
        refuse("a picture of " + std::to_string(settings.width) + "x" + std::to_string(settings.height) +
               " pixels is asked for; width and height have to be 1 or more");
    }
    if (settings.layers > maxLayers) {
        refuse(std::to_string(settings.layers) +
               " layers of transparent surfaces are asked for; expected 0 to " + std::to_string(maxLayers));
    }
    constexpr std::uint32_t maxRays = 4096;
    const auto& [distance, rays] = settings.ambientOcclusion;
    if (!(distance > 0.0f && std::isfinite(distance))) {
        refuse("ambient occlusion within " + std::to_string(distance) +
               " m is asked for; the distance has to be finite and over 0");
    }
    if (rays < 1 || rays > maxRays) {
        refuse("ambient occlusion of " + std::to_string(rays) + " rays is asked for; expected 1 to " +
               std::to_string(maxRays));
    }
    if (settings.environmentOcclusion.rays < 1 || settings.environmentOcclusion.rays > maxRays) {
        refuse("occlusion of the environment by " + std::to_string(settings.environmentOcclusion.rays) +
               " rays is asked for; expected 1 to " + std::to_string(maxRays));
    }
    if (settings.region) checkRegion(*settings.region);
    if (settings.previousView) checkView(*settings.previousView);
    const auto requireSize = [](const char* what, float pixels) {
        if (pixels > 0.0f && std::isfinite(pixels)) return;
        refuse(std::string(what) + " of " + std::to_string(pixels) +
               " pixels are asked for; the number has to be finite and over 0");
    };
    requireSize("points", settings.pointSize);
    requireSize("lines", settings.lineWidth);
}

namespace {

/// Rotation and translation, right-handed. As in scenes, lengths may be 1 % off.
bool isRigid(const glm::mat4& matrix) {
    constexpr float tolerance = 0.01f;
    const glm::mat3 axes(matrix);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const float expected = i == j ? 1.0f : 0.0f;
            // Written so that a number that is not finite fails.
            if (!(std::abs(glm::dot(axes[i], axes[j]) - expected) <= 2.0f * tolerance)) return false;
            if (!std::isfinite(matrix[3][i])) return false;
        }
    }
    return glm::dot(glm::cross(axes[0], axes[1]), axes[2]) > 0.0f && matrix[0][3] == 0.0f &&
           matrix[1][3] == 0.0f && matrix[2][3] == 0.0f && matrix[3][3] == 1.0f;
}

}  // namespace

void checkView(const CameraView& view) {
    if (!isRigid(view.worldFromCamera)) {
        refuse("the view's worldFromCamera has to be a rotation and a translation of finite numbers");
    }
    if (!(view.verticalFov > 0.0f && view.verticalFov < std::numbers::pi_v<float>)) {
        refuse("the view's verticalFov is " + std::to_string(view.verticalFov) +
               " radians; it has to be over 0 and under pi");
    }
    if (!std::isfinite(view.shift.x) || !std::isfinite(view.shift.y)) {
        refuse("the view's shift is (" + std::to_string(view.shift.x) + ", " + std::to_string(view.shift.y) +
               "); it has to be finite");
    }
    if (view.aspect && !(*view.aspect > 0.0f && std::isfinite(*view.aspect))) {
        refuse("the view's aspect is " + std::to_string(*view.aspect) + "; it has to be finite and over 0");
    }
    const bool orthographic = view.orthographicHeight.has_value();
    const auto isPositive = [](float number) { return number > 0.0f && std::isfinite(number); };
    if (orthographic && !isPositive(*view.orthographicHeight)) {
        refuse("the view's orthographicHeight is " + std::to_string(*view.orthographicHeight) +
               " m; it has to be finite and over 0");
    }
    if (!isPositive(view.nearPlane) && !(orthographic && view.nearPlane == 0.0f)) {
        refuse("the view's nearPlane is " + std::to_string(view.nearPlane) +
               " m; it has to be finite and over 0" + (orthographic ? " or 0" : ""));
    }
    if (view.farPlane && !(*view.farPlane > view.nearPlane && std::isfinite(*view.farPlane))) {
        refuse("the view's farPlane is " + std::to_string(*view.farPlane) +
               " m; it has to be finite and over its nearPlane, " + std::to_string(view.nearPlane) + " m");
    }
}

}  // namespace candela
