#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry.h"
#include "scene_builder.h"
#include "scenes.h"

namespace candela_plugins::plaza {
namespace {

using Vector = std::array<double, 3>;

constexpr double pi = 3.14159265358979323846;
constexpr std::uint32_t maxCharacters = 4096;
constexpr std::uint32_t around = 20;     // vertices of a ring
constexpr std::uint32_t influences = 4;  // joints of a vertex
constexpr std::uint32_t keys = 9;        // of each joint, over one second
constexpr double spacing = 1.5;          // metres between characters
constexpr double bodyHeight = 0.95;      // of the hips over the ground, metres

/// A limb, spine or head: joints along a line from one end to the other, and a tube around them.
struct Chain {
    const char* name;
    int parent;  // a chain, whose last joint carries this one; -1: the first joint of the body
    std::uint32_t joints, rings;
    Vector from, to;  // relative to the hips, metres
    double radius;
    double swing;  // of the whole chain when walking, radians
    double phase;  // of the walk, in turns
};

// 60 joints and 500 rings of 20 vertices.
constexpr std::array<Chain, 6> body{
    {{"spine", -1, 12, 140, {0, 0, 0}, {0, 0.52, 0}, 0.16, 0.1, 0.0},
     {"head", 0, 4, 60, {0, 0.52, 0}, {0, 0.82, 0}, 0.1, 0.1, 0.25},
     {"left arm", 0, 10, 70, {0.2, 0.48, 0}, {0.28, -0.15, 0}, 0.05, 0.7, 0.5},
     {"right arm", 0, 10, 70, {-0.2, 0.48, 0}, {-0.28, -0.15, 0}, 0.05, 0.7, 0.0},
     {"left leg", -1, 12, 80, {0.1, 0, 0}, {0.1, -0.93, 0}, 0.085, 0.9, 0.0},
     {"right leg", -1, 12, 80, {-0.1, 0, 0}, {-0.1, -0.93, 0}, 0.085, 0.9, 0.5}}};

constexpr std::uint32_t jointCount() {
    std::uint32_t count = 0;
    for (const Chain& chain : body) count += chain.joints;
    return count;
}

/// The first joint of each chain.
constexpr std::array<std::uint32_t, body.size()> firstJoints() {
    std::array<std::uint32_t, body.size()> first{};
    for (std::size_t i = 1; i < body.size(); ++i) first[i] = first[i - 1] + body[i - 1].joints;
    return first;
}

Vector pointOf(const Chain& chain, double along) {
    Vector point;
    for (std::size_t i = 0; i < 3; ++i) point[i] = between(chain.from[i], chain.to[i], along);
    return point;
}

double fractionOfJoint(const Chain& chain, std::uint32_t joint) {
    return static_cast<double>(joint) / chain.joints;
}

struct Character {
    Geometry geometry;
    std::vector<std::uint32_t> joints;
    std::vector<float> weights;
};

/// The uniform cubic B-spline weights of the four joints around a place.
void addInfluences(Character& character, const Chain& chain, std::uint32_t firstJoint, double along) {
    const double place = along * chain.joints;
    const double base = std::min(std::floor(place), chain.joints - 1.0), t = place - base, s = 1.0 - t;
    const std::array<double, influences> weights{s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
                                                 (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0,
                                                 t * t * t / 6.0};
    for (std::uint32_t i = 0; i < influences; ++i) {
        const double joint = std::clamp(base + i - 1.0, 0.0, chain.joints - 1.0);
        character.joints.push_back(firstJoint + static_cast<std::uint32_t>(joint));
        character.weights.push_back(static_cast<float>(weights[i]));
    }
}

/// A tube along the y axis whose ends are half ellipsoids.
void addTube(Character& character, const Chain& chain, std::uint32_t firstJoint, double girth) {
    const auto base = static_cast<std::uint32_t>(character.geometry.positions.size());
    const double radius = chain.radius * girth;
    for (std::uint32_t ring = 0; ring < chain.rings; ++ring) {
        const double along = static_cast<double>(ring) / (chain.rings - 1);
        const double side = 2.0 * along - 1.0, narrowing = side * side * side * side;
        const double width = radius * std::sqrt(std::max(1.0 - narrowing, 0.0));
        // The slope of the profile towards the ends of the chain.
        const double tilt =
            narrowing * (side < 0.0 ? -1.0 : 1.0) * (chain.to[1] > chain.from[1] ? 1.0 : -1.0);
        const double level = std::sqrt(1.0 - tilt * tilt);
        const Vector center = pointOf(chain, along);
        for (std::uint32_t i = 0; i < around; ++i) {
            const double angle = 2.0 * pi * i / around, c = gridCosine(angle), s = gridSine(angle);
            character.geometry.positions.push_back({static_cast<float>(center[0] + width * c),
                                                    static_cast<float>(center[1]),
                                                    static_cast<float>(center[2] + width * s)});
            character.geometry.normals.push_back(
                {static_cast<float>(level * c), static_cast<float>(tilt), static_cast<float>(level * s)});
            addInfluences(character, chain, firstJoint, along);
        }
    }
    const bool upwards = chain.to[1] > chain.from[1];
    for (std::uint32_t ring = 0; ring + 1 < chain.rings; ++ring) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = base + ring * around + i, b = base + ring * around + (i + 1) % around;
            const std::uint32_t low = upwards ? a : b, lowNext = upwards ? b : a;
            for (const std::uint32_t corner :
                 {low, low + around, lowNext, lowNext, low + around, lowNext + around})
                character.geometry.indices.push_back(corner);
        }
    }
}

Character makeCharacter(double girth) {
    Character character;
    for (std::size_t i = 0; i < body.size(); ++i) addTube(character, body[i], firstJoints()[i], girth);
    return character;
}

int32_t addCharacterMesh(const Host& host, const Character& character, int32_t material,
                         const std::string& name) {
    candela_submesh submesh{};
    submesh.index_count = static_cast<std::uint32_t>(character.geometry.indices.size());
    submesh.material = material;
    candela_mesh mesh{};
    mesh.struct_size = sizeof mesh;
    mesh.name = name.c_str();
    mesh.vertex_count = static_cast<std::uint32_t>(character.geometry.positions.size());
    mesh.positions = character.geometry.positions.front().data();
    mesh.normals = character.geometry.normals.front().data();
    mesh.index_count = submesh.index_count;
    mesh.indices = character.geometry.indices.data();
    mesh.submesh_count = 1;
    mesh.submeshes = &submesh;
    mesh.influence_count = influences;
    mesh.joints = character.joints.data();
    mesh.joint_weights = character.weights.data();
    return host.add(mesh);
}

/// The joints of one character, in the order of `body`, below the node `root`. Returns the first one's index.
int32_t addJoints(const Host& host, int32_t root) {
    std::array<int32_t, body.size()> lastJoints{};
    int32_t first = -1;
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Chain& chain = body[i];
        int32_t parent = root;
        Vector origin{0, 0, 0};
        if (chain.parent >= 0) {
            const Chain& carrier = body[static_cast<std::size_t>(chain.parent)];
            parent = lastJoints[static_cast<std::size_t>(chain.parent)];
            origin = pointOf(carrier, fractionOfJoint(carrier, carrier.joints - 1));
        }
        for (std::uint32_t joint = 0; joint < chain.joints; ++joint) {
            const std::string name = chain.name;
            candela_node node = plainNode(name, -1);
            const Vector place = pointOf(chain, fractionOfJoint(chain, joint));
            for (std::size_t axis = 0; axis < 3; ++axis)
                node.translation[axis] = static_cast<float>(place[axis] - origin[axis]);
            node.parent = parent;
            parent = host.add(node);
            origin = place;
            if (first < 0) first = parent;
        }
        lastJoints[i] = parent;
    }
    return first;
}

int32_t addCharacterSkin(const Host& host, int32_t firstJoint) {
    std::vector<int32_t> joints;
    std::vector<float> matrices;
    for (const Chain& chain : body) {
        for (std::uint32_t joint = 0; joint < chain.joints; ++joint) {
            joints.push_back(firstJoint + static_cast<int32_t>(joints.size()));
            const Vector place = pointOf(chain, fractionOfJoint(chain, joint));
            for (int column = 0; column < 3; ++column) {
                for (int row = 0; row < 4; ++row) matrices.push_back(row == column ? 1.0f : 0.0f);
            }
            for (const double coordinate : place) matrices.push_back(static_cast<float>(-coordinate));
            matrices.push_back(1.0f);
        }
    }
    candela_skin skin{};
    skin.struct_size = sizeof skin;
    skin.name = "body";
    skin.joint_count = jointCount();
    skin.joints = joints.data();
    skin.inverse_bind_matrices = matrices.data();
    return host.add(skin);
}

/// The rotations of all joints about their x axes over a stride of one second.
class Walk {
  public:
    explicit Walk(double startPhase) {
        for (std::uint32_t key = 0; key < keys; ++key)
            times_[key] = static_cast<float>(key) / static_cast<float>(keys - 1);
        for (const Chain& chain : body) {
            for (std::uint32_t joint = 0; joint < chain.joints; ++joint) addJoint(chain, joint, startPhase);
        }
    }

    /// The channels refer to this object.
    void addChannels(int32_t firstJoint, std::vector<candela_animation_channel>& channels) const {
        for (std::uint32_t joint = 0; joint < jointCount(); ++joint) {
            candela_animation_channel channel{};
            channel.node = firstJoint + static_cast<int32_t>(joint);
            channel.path = CANDELA_ANIMATE_ROTATION;
            channel.interpolation = CANDELA_INTERPOLATE_LINEAR;
            channel.key_count = keys;
            channel.times = times_.data();
            channel.values = values_.data() + joint * keys * 4u;
            channels.push_back(channel);
        }
    }

  private:
    void addJoint(const Chain& chain, std::uint32_t joint, double startPhase) {
        for (std::uint32_t key = 0; key < keys; ++key) {
            const double turn =
                startPhase + chain.phase + static_cast<double>(key) / (keys - 1) - 0.02 * joint;
            const double half = 0.5 * chain.swing / chain.joints * gridSine(2.0 * pi * turn);
            for (const double number : {gridSine(half), 0.0, 0.0, gridCosine(half)})
                values_.push_back(static_cast<float>(number));
        }
    }

    std::array<float, keys> times_;
    std::vector<float> values_;
};

/// Returns the first of its joints.
int32_t addCharacter(const Host& host, std::uint32_t index, std::uint32_t perRow, int32_t material) {
    const std::string name = "character " + std::to_string(index);
    const Character character = makeCharacter(between(0.8, 1.2, hashedFraction(index, 0)));
    candela_node root = plainNode(name, -1);
    const double middle = 0.5 * (perRow - 1);
    root.translation[0] = static_cast<float>((index % perRow - middle) * spacing);
    root.translation[1] = static_cast<float>(bodyHeight);
    root.translation[2] = static_cast<float>((index / perRow - middle) * spacing);
    const double heading = pi * hashedFraction(index, 1);
    root.rotation[1] = static_cast<float>(gridSine(heading));
    root.rotation[3] = static_cast<float>(gridCosine(heading));
    const int32_t rootIndex = host.add(root);
    const int32_t firstJoint = addJoints(host, rootIndex);
    candela_deformation deformation{};
    deformation.struct_size = sizeof deformation;
    deformation.node = host.add(plainNode(name, addCharacterMesh(host, character, material, name)));
    deformation.skin = addCharacterSkin(host, firstJoint);
    host.add(deformation);
    return firstJoint;
}

/// All walk in one animation, each with a phase of its own.
void addWalk(const Host& host, const std::vector<int32_t>& firstJoints) {
    std::vector<Walk> walks;
    for (std::uint32_t i = 0; i < firstJoints.size(); ++i) walks.emplace_back(hashedFraction(i, 2));
    std::vector<candela_animation_channel> channels;
    for (std::size_t i = 0; i < walks.size(); ++i) walks[i].addChannels(firstJoints[i], channels);
    candela_animation animation{};
    animation.struct_size = sizeof animation;
    animation.name = "walk";
    animation.channel_count = static_cast<std::uint32_t>(channels.size());
    animation.channels = channels.data();
    host.add(animation);
}

/// A light over every fourth character or so.
void addCrowdLights(const Host& host, double side) {
    const auto perRow = static_cast<std::uint32_t>(std::ceil(side / (2.0 * spacing)));
    addLights(host, perRow * perRow, [&](std::uint32_t i) {
        candela_light light = plainLight(5.0f, 8.0f);
        const std::array<float, 3> color = hueColor(hashedFraction(i, 3));
        for (std::size_t c = 0; c < 3; ++c) light.color[c] = 0.5f + 0.5f * color[c];
        light.position[0] = static_cast<float>((i % perRow + 0.5) * side / perRow - 0.5 * side);
        light.position[1] = 3.0f;
        light.position[2] = static_cast<float>((i / perRow + 0.5) * side / perRow - 0.5 * side);
        return light;
    });
}

}  // namespace

void makeCrowd(const Host& host, const std::string& arguments) {
    if (!host.takesDeformations())
        throw Failure{"crowd", "the host does not deform meshes: it is older than version 1.3"};
    const std::uint32_t count = parseCount(arguments, "crowd", "crowd:100");
    if (count > maxCharacters)
        throw Failure{"crowd",
                      std::to_string(count) + " characters: at most " + std::to_string(maxCharacters)};
    const auto perRow = static_cast<std::uint32_t>(std::ceil(std::sqrt(std::max(count, 1u))));
    const double side = (perRow + 1) * spacing;
    addGeometry(host, makeGround(static_cast<float>(side), 8), addGreyMaterial(host, "ground", 0.5f, 0.8f),
                "ground");
    const int32_t material = addGreyMaterial(host, "clothes", 0.6f, 0.6f);
    std::vector<int32_t> firstJoints;
    for (std::uint32_t i = 0; i < count; ++i) firstJoints.push_back(addCharacter(host, i, perRow, material));
    if (count > 0) addWalk(host, firstJoints);
    const std::string name = "overview";
    candela_node camera = plainNode(name, -1);
    // 35 degrees downwards.
    constexpr double tilt = -0.5 * 35.0 / 180.0 * pi;
    camera.translation[1] = static_cast<float>(0.75 * side + 1.0);
    camera.translation[2] = static_cast<float>(1.1 * side + 1.5);
    camera.rotation[0] = static_cast<float>(gridSine(tilt));
    camera.rotation[3] = static_cast<float>(gridCosine(tilt));
    addCamera(host, camera);
    addCrowdLights(host, side);
}

}  // namespace candela_plugins::plaza
