#include "support/random_rig.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <random>

namespace candela::test {

namespace {

class Numbers {
  public:
    explicit Numbers(std::uint32_t seed) : engine_(seed) {}

    float between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
    std::uint32_t below(std::uint32_t end) { return std::uniform_int_distribution(0u, end - 1)(engine_); }
    glm::vec3 vector(float reach) {
        return {between(-reach, reach), between(-reach, reach), between(-reach, reach)};
    }
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 v = vector(1.0f);
            if (glm::length(v) > 0.1f) return glm::normalize(v);
        }
    }
    Transform transform() {
        Transform transform;
        transform.translation = vector(0.4f);
        const float angle = between(-3.0f, 3.0f);
        transform.rotation = glm::angleAxis(angle, direction());
        for (int i = 0; i < 3; ++i) transform.scale[i] = between(0.7f, 1.3f);
        // Some joints mirror.
        if (below(8) == 0) transform.scale.x = -transform.scale.x;
        return transform;
    }

  private:
    std::mt19937 engine_;
};

void addVertices(Mesh& mesh, const RigSize& size, Numbers& numbers) {
    for (std::uint32_t i = 0; i < size.vertices; ++i) {
        mesh.positions.push_back(numbers.vector(1.0f));
        mesh.normals.push_back(numbers.direction());
        if (!size.tangents) continue;
        mesh.tangents.emplace_back(numbers.direction(), numbers.below(2) == 0 ? -1.0f : 1.0f);
        mesh.uv0.emplace_back(0.5f, 0.5f);
    }
    for (std::uint32_t i = 0; i < 3 * size.vertices; ++i)
        mesh.indices.push_back(numbers.below(size.vertices));
}

void addInfluences(Mesh& mesh, const RigSize& size, Numbers& numbers) {
    mesh.influenceCount = size.influences;
    for (std::uint32_t vertex = 0; vertex < size.vertices; ++vertex) {
        std::vector<float> weights(size.influences);
        weights[0] = numbers.between(0.1f, 1.0f);
        float sum = weights[0];
        // Vertices differ in how many joints move them.
        const std::uint32_t used = 1 + numbers.below(size.influences);
        for (std::uint32_t i = 1; i < used; ++i) sum += weights[i] = numbers.between(0.0f, 1.0f);
        for (const float weight : weights) {
            mesh.joints.push_back(numbers.below(size.joints));
            mesh.jointWeights.push_back(weight / sum);
        }
    }
}

void addTargets(Mesh& mesh, const RigSize& size, Numbers& numbers) {
    for (std::uint32_t i = 0; i < size.targets; ++i) {
        MorphTarget& target = mesh.morphTargets.emplace_back();
        for (std::uint32_t vertex = 0; vertex < size.vertices; ++vertex) {
            const bool moves = numbers.below(3) > 0;
            const auto offset = [&](float reach) { return moves ? numbers.vector(reach) : glm::vec3(0.0f); };
            target.offsets.push_back(offset(0.2f));
            // Targets may leave normals and tangents out.
            if (i % 2 == 0) target.normalOffsets.push_back(offset(0.3f));
            if (i % 2 == 0 && size.tangents) target.tangentOffsets.push_back(offset(0.3f));
        }
    }
}

void setWeights(Node& node, std::size_t targets, Numbers& numbers) {
    node.morphWeights.clear();
    for (std::size_t i = 0; i < targets; ++i) node.morphWeights.push_back(numbers.between(-1.0f, 1.0f));
}

}  // namespace

Scene randomRig(std::uint32_t seed, const RigSize& size, const glm::vec3& center) {
    Numbers numbers(seed);
    Scene scene;
    // A normal texture, so that tangents are read.
    scene.images.push_back(
        {"flat", 1, 1, PixelFormat::rgba8, {std::byte{128}, std::byte{128}, std::byte{255}, std::byte{255}}});
    scene.materials.emplace_back().doubleSided = true;
    if (size.tangents) scene.materials[0].normalTexture.emplace();
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.name = "rig";
    addVertices(mesh, size, numbers);
    addInfluences(mesh, size, numbers);
    addTargets(mesh, size, numbers);
    mesh.submeshes.push_back({0, static_cast<std::uint32_t>(mesh.indices.size()), 0u});

    Node& shown = scene.nodes.emplace_back();
    shown.name = "body";
    shown.mesh = 0;
    shown.skin = 0;
    Transform ignored = numbers.transform();
    ignored.translation += glm::vec3(50.0f);
    shown.transform = ignored;
    Skin& skin = scene.skins.emplace_back();
    for (std::uint32_t i = 0; i < size.joints; ++i) {
        Node& joint = scene.nodes.emplace_back();
        // Not too deep: products of many scales leave the range in which the tolerances hold.
        if (i > 0) joint.parent = 1 + numbers.below(std::min(i, 12u));
        joint.transform = numbers.transform();
        skin.joints.push_back(1 + i);
    }
    std::get<Transform>(scene.nodes[1].transform).translation += center;
    setWeights(scene.nodes[0], size.targets, numbers);
    const std::vector<glm::mat4> world = worldTransforms(scene);
    for (std::uint32_t i = 0; i < size.joints; ++i) {
        glm::mat4 bind = glm::inverse(world[1 + i]);
        for (int column = 0; column < 4; ++column) bind[column][3] = column == 3 ? 1.0f : 0.0f;
        skin.inverseBindMatrices.push_back(bind * glm::translate(glm::mat4(1.0f), center));
    }
    return scene;
}

void poseRandomly(Scene& scene, std::uint32_t seed, const glm::vec3& center) {
    Numbers numbers(seed);
    for (std::size_t i = 1; i < scene.nodes.size(); ++i) scene.nodes[i].transform = numbers.transform();
    std::get<Transform>(scene.nodes[1].transform).translation += center;
    setWeights(scene.nodes[0], scene.meshes[0].morphTargets.size(), numbers);
}

}  // namespace candela::test
