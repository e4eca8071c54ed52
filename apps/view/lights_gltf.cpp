#include "lights_gltf.h"

#include <candela/version.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace {

using Json = nlohmann::ordered_json;

/// The shortest decimals that are read as this float: 0.1 and not 0.10000000149.
double shortDecimals(float value) {
    std::array<char, 64> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    double number = 0.0;
    std::from_chars(text.data(), end, number);
    return static_cast<float>(number) == value ? number : static_cast<double>(value);
}

Json jsonOf(const glm::vec3& value) {
    return {shortDecimals(value.x), shortDecimals(value.y), shortDecimals(value.z)};
}

/// A place in the file of the scene. Sums with an origin need more digits than a float has.
Json placeOf(const glm::vec3& point, const glm::dvec3& origin) {
    Json place = Json::array();
    for (int axis = 0; axis < 3; ++axis)
        place.push_back(origin[axis] == 0.0 ? shortDecimals(point[axis]) : point[axis] + origin[axis]);
    return place;
}

/// A power of two, so that a colour of at most 1 times it is exactly the light's intensity.
float exactIntensity(const glm::vec3& intensity) {
    constexpr float maxIntensity = 1e20f;  // that an importer takes
    const float brightest = std::max({intensity.x, intensity.y, intensity.z});
    return brightest > 0.0f ? std::min(std::exp2(std::ceil(std::log2(brightest))), maxIntensity) : 0.0f;
}

const char* wordOf(candela::LightType type) {
    switch (type) {
        case candela::LightType::spot:
            return "spot";
        case candela::LightType::directional:
            return "directional";
        default:
            return "point";
    }
}

Json jsonOf(const candela::WorldLight& light) {
    const float intensity = exactIntensity(light.intensity);
    Json json{{"type", wordOf(light.type)},
              {"color", jsonOf(intensity > 0.0f ? light.intensity / intensity : glm::vec3(1.0f))},
              {"intensity", shortDecimals(intensity)}};
    if (light.range > 0.0f && light.type != candela::LightType::directional)
        json["range"] = shortDecimals(light.range);
    if (light.type == candela::LightType::spot)
        json["spot"] = {{"innerConeAngle", shortDecimals(light.innerConeAngle)},
                        {"outerConeAngle", shortDecimals(light.outerConeAngle)}};
    if (!light.castsShadow) json["extras"]["castsShadow"] = false;
    if (light.radius > 0.0f) json["extras"]["radius"] = shortDecimals(light.radius);
    return json;
}

/// A rotation as the first nine numbers of a matrix of 16.
Json matrixOf(const glm::mat3& rotation, const Json& place) {
    Json matrix = Json::array();
    for (int column = 0; column < 3; ++column) {
        for (const Json& number : jsonOf(rotation[column])) matrix.push_back(number);
        matrix.push_back(0);
    }
    for (const Json& number : place) matrix.push_back(number);
    matrix.push_back(1);
    return matrix;
}

/// Turns -Z, along which a light without a node shines, to `direction`.
glm::mat3 rotationTo(const glm::vec3& direction) {
    const glm::vec3 z = -direction;
    const glm::vec3 helper = std::abs(z.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 x = glm::normalize(glm::cross(helper, z));
    return {x, glm::cross(z, x), z};
}

Json nodeOf(const candela::WorldLight& light, std::size_t index, const glm::dvec3& origin) {
    Json node{{"name", "light " + std::to_string(index)}};
    const Json place = placeOf(light.position, origin);
    if (light.type == candela::LightType::point)
        node["translation"] = place;
    else
        node["matrix"] = matrixOf(rotationTo(light.direction), place);
    node["extensions"]["KHR_lights_punctual"]["light"] = index;
    return node;
}

Json jsonOf(const SavedCamera& camera) {
    const candela::CameraView& view = camera.view;
    Json lens{{"znear", shortDecimals(view.nearPlane)}};
    if (view.farPlane) lens["zfar"] = shortDecimals(*view.farPlane);
    if (!view.orthographicHeight) {
        lens["yfov"] = shortDecimals(view.verticalFov);
        return {{"name", camera.name}, {"type", "perspective"}, {"perspective", lens}};
    }
    lens["xmag"] = lens["ymag"] = shortDecimals(0.5f * *view.orthographicHeight);
    return {{"name", camera.name}, {"type", "orthographic"}, {"orthographic", lens}};
}

Json nodeOf(const SavedCamera& camera, std::size_t index, const glm::dvec3& origin) {
    return {{"name", camera.name},
            {"camera", index},
            {"matrix", matrixOf(glm::mat3(camera.view.worldFromCamera), placeOf(camera.view.eye(), origin))}};
}

void appendNumber(std::string& bytes, std::size_t number) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xffu);
}

}  // namespace

std::string lightsGltf(std::span<const candela::WorldLight> lights, std::span<const SavedCamera> cameras,
                       const glm::dvec3& origin) {
    Json nodes = Json::array(), roots = Json::array(), lightList = Json::array(), cameraList = Json::array();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        nodes.push_back(nodeOf(lights[i], i, origin));
        lightList.push_back(jsonOf(lights[i]));
    }
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        nodes.push_back(nodeOf(cameras[i], i, origin));
        cameraList.push_back(jsonOf(cameras[i]));
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) roots.push_back(i);
    Json file{{"asset", {{"version", "2.0"}, {"generator", "candela-view " CANDELA_VERSION}}},
              {"extensionsUsed", Json::array({"KHR_lights_punctual"})},
              {"scene", 0},
              {"scenes", Json::array({{{"nodes", std::move(roots)}}})},
              {"nodes", std::move(nodes)}};
    if (!cameras.empty()) file["cameras"] = std::move(cameraList);
    file["extensions"]["KHR_lights_punctual"]["lights"] = std::move(lightList);
    return file.dump() + "\n";
}

std::string glbOf(const std::string& gltf) {
    constexpr std::size_t header = 12, chunkHeader = 8, alignment = 4;
    std::string text = gltf;
    text.resize((text.size() + alignment - 1) / alignment * alignment, ' ');
    std::string bytes = "glTF";
    appendNumber(bytes, 2);
    appendNumber(bytes, header + chunkHeader + text.size());
    appendNumber(bytes, text.size());
    return bytes + "JSON" + text;
}
