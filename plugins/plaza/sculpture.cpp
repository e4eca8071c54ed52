#include <array>
#include <cstdint>
#include <vector>

#include "geometry.h"
#include "scene_builder.h"
#include "scenes.h"

namespace candela_plugins::plaza {
namespace {

constexpr std::uint32_t segments = 20;                     // around the ring
constexpr std::uint32_t sides = 4;                         // of its section
constexpr std::uint32_t halfTurns = 3;                     // of the section over the length of the ring
constexpr double ringRadius = 2.35, sectionRadius = 1.15;  // metres
constexpr double pi = 3.14159265358979323846;
constexpr float infinitelySharp = 10.0f;

struct Ring {
    std::vector<std::array<float, 3>> positions;
    std::vector<std::uint32_t> faceSizes, faceVertices, creaseEdges;
    std::vector<float> creaseSharpness;
};

// Corner `side` of section `segment`. After an odd number of half turns the ring is closed with an offset of
// two corners.
std::uint32_t corner(std::uint32_t segment, std::uint32_t side) {
    const std::uint32_t shift = segment < segments ? 0 : sides / 2;
    return segment % segments * sides + (side + shift) % sides;
}

std::array<float, 3> cornerPosition(std::uint32_t segment, std::uint32_t side) {
    const double around = 2.0 * pi * segment / segments;
    const double turned = 2.0 * pi * side / sides + halfTurns * pi * segment / segments;
    const double outwards = ringRadius + sectionRadius * gridCosine(turned);
    return {static_cast<float>(outwards * gridCosine(around)),
            static_cast<float>(sectionRadius * gridSine(turned)),
            static_cast<float>(-outwards * gridSine(around))};
}

Ring makeRing() {
    Ring ring;
    for (std::uint32_t segment = 0; segment < segments; ++segment) {
        for (std::uint32_t side = 0; side < sides; ++side) {
            ring.positions.push_back(cornerPosition(segment, side));
            ring.faceSizes.push_back(4);
            for (const std::uint32_t vertex : {corner(segment, side), corner(segment + 1, side),
                                               corner(segment + 1, side + 1), corner(segment, side + 1)})
                ring.faceVertices.push_back(vertex);
            if (side % 2 != 0) continue;
            ring.creaseEdges.push_back(corner(segment, side));
            ring.creaseEdges.push_back(corner(segment + 1, side));
            ring.creaseSharpness.push_back(infinitelySharp);
        }
    }
    return ring;
}

int32_t addClayMaterial(const Host& host) {
    const std::string name = "sculpture";
    candela_material material = plainMaterial(name);
    constexpr std::array<float, 3> darkClay{0.09f, 0.1f, 0.13f};
    for (std::uint32_t i = 0; i < 3; ++i) material.base_color[i] = darkClay[i];
    material.roughness = 0.3f;
    return host.add(material);
}

int32_t addRing(const Host& host) {
    const Ring ring = makeRing();
    const std::vector<int32_t> materials(ring.faceSizes.size(), addClayMaterial(host));
    candela_cage cage{};
    cage.struct_size = sizeof cage;
    cage.name = "sculpture";
    cage.scheme = CANDELA_SCHEME_CATMULL_CLARK;
    cage.vertex_count = static_cast<std::uint32_t>(ring.positions.size());
    cage.positions = ring.positions.front().data();
    cage.face_count = static_cast<std::uint32_t>(ring.faceSizes.size());
    cage.face_sizes = ring.faceSizes.data();
    cage.face_vertices = ring.faceVertices.data();
    cage.crease_count = static_cast<std::uint32_t>(ring.creaseSharpness.size());
    cage.crease_edges = ring.creaseEdges.data();
    cage.crease_sharpness = ring.creaseSharpness.data();
    cage.face_materials = materials.data();
    return host.add(cage);
}

}  // namespace

void makeSculpture(const Host& host, const std::string& arguments) {
    if (!host.takesCages())
        throw Failure{"sculpture", "the host has no subdivision cages: it is older than version 1.1"};
    makePlaza(host, arguments);
    const std::string name = "sculpture";
    candela_node node = plainNode(name, -1);
    node.translation[1] = static_cast<float>(sectionRadius);
    node.translation[2] = 25.0f;  // between two rows of spheres
    candela_cage_instance instance{};
    instance.struct_size = sizeof instance;
    instance.cage = addRing(host);
    instance.node = host.add(node);
    instance.skin = -1;
    host.add(instance);
}

}  // namespace candela_plugins::plaza
