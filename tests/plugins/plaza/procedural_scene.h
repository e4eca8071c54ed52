#pragma once

#include <candela/import.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <variant>
#include <vector>

namespace candela {

/// Imports a scene of the plugin under test.
inline ImportedScene importProcedural(const std::string& uri, const ImportProgress& progress = {}) {
    static const PluginRegistry plugins({CANDELA_TEST_PLUGINS});
    return importScene(plugins, uri, {.progress = progress});
}

// FNV-1a, 64 bits, over little-endian 32-bit words (Fowler, Noll, Vo).
class Fnv {
  public:
    void add(std::uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8)
            hash_ = (hash_ ^ ((word >> shift) & 0xFFu)) * 0x100000001B3ull;
    }
    void add(float number) {
        std::uint32_t word = 0;
        std::memcpy(&word, &number, sizeof word);
        add(word);
    }
    void add(const glm::vec3& vector) {
        for (int i = 0; i < 3; ++i) add(vector[i]);
    }
    std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = 0xCBF29CE484222325ull;
};

// Without the normals: the host normalizes them, which may round differently on another processor.
inline std::uint64_t geometryHash(const Scene& scene) {
    Fnv hash;
    for (const Mesh& mesh : scene.meshes) {
        for (const glm::vec3& position : mesh.positions) hash.add(position);
        for (const std::uint32_t index : mesh.indices) hash.add(index);
    }
    for (const Material& material : scene.materials) {
        hash.add(glm::vec3(material.baseColor));
        hash.add(material.metallic);
        hash.add(material.roughness);
    }
    for (const Node& node : scene.nodes) hash.add(std::get<Transform>(node.transform).translation);
    return hash.value();
}

inline std::uint64_t lightHash(const std::vector<Light>& lights) {
    Fnv hash;
    for (const Light& light : lights) {
        hash.add(light.position);
        hash.add(light.color);
    }
    return hash.value();
}

}  // namespace candela
