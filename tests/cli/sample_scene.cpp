#include "sample_scene.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstring>
#include <vector>

namespace {

using Json = nlohmann::json;

std::string base64(const std::vector<unsigned char>& bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t j = 0; j < 3; ++j) group = group << 8 | (i + j < bytes.size() ? bytes[i + j] : 0u);
        for (std::size_t j = 0; j < 4; ++j)
            text += i + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63u] : '=';
    }
    return text;
}

/// Positions (4 × 3), light times (2), light positions (2 × 3), then 6 indices of 16 bits.
std::vector<unsigned char> sceneBytes() {
    constexpr std::array<float, 20> floats{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0, 1, 0, 0, 1, 0, 0, 9};
    constexpr std::array<std::uint16_t, 6> indices{0, 1, 2, 0, 2, 3};
    std::vector<unsigned char> bytes(sizeof floats + sizeof indices);
    std::memcpy(bytes.data(), floats.data(), sizeof floats);
    std::memcpy(bytes.data() + sizeof floats, indices.data(), sizeof indices);
    return bytes;
}

Json makeScene() {
    const std::vector<unsigned char> bytes = sceneBytes();
    Json scene = Json::parse(R"({
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_lights_punctual", "VENDOR_unknown"],
        "extensions": {"KHR_lights_punctual": {"lights": [
            {"type": "point", "color": [1, 1, 1], "intensity": 10, "range": 20}]}},
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 8},
            {"buffer": 0, "byteOffset": 56, "byteLength": 24},
            {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
            {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"},
            {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "materials": [{"pbrMetallicRoughness": {
            "baseColorFactor": [0.5, 0.25, 0.125, 1], "metallicFactor": 0, "roughnessFactor": 0.5}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 3, "material": 0}]}],
        "cameras": [
            {"name": "front", "type": "perspective", "perspective": {"yfov": 1.5707963, "znear": 0.1}},
            {"name": "far", "type": "perspective", "perspective": {"yfov": 1.5707963, "znear": 0.1}}],
        "nodes": [
            {"mesh": 0, "extensions": {"VENDOR_unknown": {}}},
            {"translation": [0, 0, 1], "extensions": {"KHR_lights_punctual": {"light": 0}}},
            {"camera": 0, "translation": [0, 0, 3]},
            {"camera": 1, "translation": [0, 0, 6]}],
        "animations": [{
            "samplers": [{"input": 1, "output": 2}],
            "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}]}],
        "scenes": [{"nodes": [0, 1, 2, 3]}],
        "scene": 0
    })");
    scene["buffers"] = Json::array();
    scene["buffers"].push_back(
        Json{{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}});
    return scene;
}

}  // namespace

std::string sampleScene() {
    return makeScene().dump();
}

std::string sampleSceneWithoutCameras() {
    Json scene = makeScene();
    scene.erase("cameras");
    scene["nodes"].erase(3);
    scene["nodes"].erase(2);
    scene["scenes"][0]["nodes"] = {0, 1};
    return scene.dump();
}
