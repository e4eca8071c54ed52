// Very many triangles, none of them instanced: mounds, rocks and splinters, each mesh with vertices of its
// own.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "available_memory.h"
#include "geometry.h"
#include "scene_builder.h"
#include "scenes.h"

namespace candela_plugins::plaza {
namespace {

using Point = std::array<double, 3>;

constexpr std::uint32_t maxTriangles = 50'000'000;
constexpr const char* example = "triangles:1000000 or triangles:1000000,4096";
// Of the scene, of its copies on a software device, and of what is allocated for a moment on the way there.
constexpr std::uint64_t bytesPerTriangle = 120;

constexpr double side = 100.0;  // of the ground, metres
constexpr std::uint32_t patchesPerSide = 8, rocksPerSide = 16;
constexpr std::uint32_t patches = patchesPerSide * patchesPerSide, rocks = rocksPerSide * rocksPerSide;
constexpr double patchShare = 0.25;  // of all triangles; rocks have the rest
constexpr double moundHeight = 0.8;  // metres
constexpr float lightCandela = 2.5f, lightRange = 3.0f;
constexpr double pi = 3.14159265358979323846;

// Pseudo-random properties. The numbers are part of the scene: changing them changes it.
enum Property : std::uint32_t {
    patchFineness = 400,
    rockFineness,
    rockRadius,
    rockPhase,
    rockRed,
    rockGreen,
    rockBlue,
    splinterPlace,
    splinterAngles = splinterPlace + 3,
    splinterSize = splinterAngles + 2,
    lightPlace,
    lightHue = lightPlace + 3
};

/// How much finer than the coarsest mesh of its kind a mesh is, in triangles: 1 to 64, equally likely on a
/// logarithmic scale.
double fineness(std::uint32_t index, Property property) {
    double value = 1.0;
    // Products of roots are the same on every machine, where the power function may not be.
    const auto steps = static_cast<std::uint32_t>(hashedFraction(index, property) * 13.0);
    for (std::uint32_t i = 0; i < steps; ++i) value *= std::sqrt(2.0);
    return value;
}

/// How many of `triangles` each of `count` meshes may have.
std::vector<std::uint32_t> sharesOf(double triangles, std::uint32_t count, Property property) {
    double sum = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) sum += fineness(i, property);
    std::vector<std::uint32_t> shares;
    for (std::uint32_t i = 0; i < count; ++i)
        shares.push_back(static_cast<std::uint32_t>(triangles * fineness(i, property) / sum));
    return shares;
}

std::array<float, 3> rounded(const Point& point) {
    return {static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2])};
}

Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Sums of the areas of the triangles around each vertex; the host normalizes them.
void addNormals(Geometry& geometry) {
    geometry.normals.assign(geometry.positions.size(), {0.0f, 0.0f, 0.0f});
    for (std::size_t i = 0; i < geometry.indices.size(); i += 3) {
        const std::uint32_t* corners = geometry.indices.data() + i;
        Point u, v;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double origin = geometry.positions[corners[0]][axis];
            u[axis] = geometry.positions[corners[1]][axis] - origin;
            v[axis] = geometry.positions[corners[2]][axis] - origin;
        }
        const std::array<float, 3> normal = rounded(cross(u, v));
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (std::size_t axis = 0; axis < 3; ++axis)
                geometry.normals[corners[corner]][axis] += normal[axis];
    }
}

/// A square of the ground that is level at its border, so that neighbours of another fineness meet it, and a
/// mound in between. At most `triangles`; none where these are too few.
Geometry makePatch(std::uint32_t index, std::uint32_t triangles) {
    const auto quads = static_cast<std::uint32_t>(std::sqrt(triangles / 2.0));
    Geometry patch;
    if (quads == 0) return patch;
    constexpr double size = side / patchesPerSide;
    patch = makeGround(static_cast<float>(size), quads);
    for (std::array<float, 3>& position : patch.positions) {
        const double u = 2.0 * position[0] / size, v = 2.0 * position[2] / size;
        position[1] = static_cast<float>(moundHeight * (1.0 - u * u) * (1.0 - v * v));
        position[0] += static_cast<float>(size * (index % patchesPerSide + 0.5) - 0.5 * side);
        position[2] += static_cast<float>(size * (index / patchesPerSide + 0.5) - 0.5 * side);
    }
    addNormals(patch);
    return patch;
}

/// A bumpy ball around the origin. At most `triangles`; none where these are too few.
Geometry makeRock(std::uint32_t index, std::uint32_t triangles) {
    // `makeSphere` gives 2 around (down - 1) triangles, here with around = 2 down.
    const auto down = static_cast<std::uint32_t>((1.0 + std::sqrt(1.0 + triangles)) / 2.0);
    if (down < 2) return {};
    Geometry rock = makeSphere(1.0f, 2 * down, down);
    const double radius = between(0.6, 1.8, hashedFraction(index, rockRadius));
    const double phase = 2.0 * pi * hashedFraction(index, rockPhase);
    for (std::array<float, 3>& position : rock.positions) {
        const double x = position[0], y = position[1], z = position[2];
        const double bumps =
            gridSine(5.0 * x + phase) * gridSine(6.0 * y + phase) * gridSine(5.0 * z + phase);
        const double scale = radius * (1.0 + 0.25 * bumps);
        position = rounded({scale * x, scale * y, scale * z});
    }
    addNormals(rock);
    return rock;
}

/// Triangles that touch no other, near the ground, turned in all directions.
Geometry makeSplinters(std::uint32_t count) {
    Geometry splinters;
    splinters.positions.reserve(3 * std::size_t{count});
    splinters.indices.reserve(3 * std::size_t{count});
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto drawn = [&](std::uint32_t property, double low, double high) {
            return between(low, high, hashedFraction(i, property));
        };
        const Point middle{drawn(splinterPlace, -0.48, 0.48) * side, drawn(splinterPlace + 1, 1.0, 3.0),
                           drawn(splinterPlace + 2, -0.48, 0.48) * side};
        const double heading = drawn(splinterAngles, 0.0, 2.0 * pi),
                     pitch = drawn(splinterAngles + 1, 0.0, 2.0 * pi);
        const double size = drawn(splinterSize, 0.02, 0.2);
        const Point u{gridCosine(heading), 0.0, gridSine(heading)};
        const Point v{-gridSine(heading) * gridSine(pitch), gridCosine(pitch),
                      gridCosine(heading) * gridSine(pitch)};
        constexpr std::array<std::array<double, 2>, 3> corners{{{-1.0, -0.5}, {1.0, -0.5}, {0.0, 1.0}}};
        for (const auto& [a, b] : corners) {
            Point corner;
            for (std::size_t axis = 0; axis < 3; ++axis)
                corner[axis] = middle[axis] + size * (a * u[axis] + b * v[axis]);
            splinters.indices.push_back(static_cast<std::uint32_t>(splinters.positions.size()));
            splinters.positions.push_back(rounded(corner));
        }
    }
    addNormals(splinters);
    return splinters;
}

/// Adds the meshes one after the other, so that no two are in the memory of the plugin at the same time.
class Builder {
  public:
    Builder(const Host& host, std::uint32_t triangles) : host_(host), left_(triangles), all_(triangles) {}

    void add(const Geometry& geometry, int32_t material, const std::string& name,
             const std::array<float, 3>& place = {}) {
        if (geometry.indices.empty()) return;
        candela_node node = plainNode(name, addMesh(host_, geometry, material, name));
        std::copy(place.begin(), place.end(), node.translation);
        host_.add(node);
        left_ -= static_cast<std::uint32_t>(geometry.indices.size() / 3);
        host_.progress(1.0 - static_cast<double>(left_) / all_);
    }
    std::uint32_t left() const { return left_; }

  private:
    const Host& host_;
    std::uint32_t left_, all_;
};

void addPatches(const Host& host, std::uint32_t triangles, Builder& builder) {
    const int32_t material = addGreyMaterial(host, "ground", 0.7f, 0.8f);
    const std::vector<std::uint32_t> shares = sharesOf(patchShare * triangles, patches, patchFineness);
    for (std::uint32_t i = 0; i < patches; ++i)
        builder.add(makePatch(i, shares[i]), material, "patch " + std::to_string(i));
}

int32_t addRockMaterial(const Host& host, std::uint32_t index, const std::string& name) {
    candela_material material = plainMaterial(name);
    for (std::uint32_t i = 0; i < 3; ++i)
        material.base_color[i] = static_cast<float>(between(0.3, 0.9, hashedFraction(index, rockRed + i)));
    material.roughness =
        static_cast<float>(between(0.2, 1.0, static_cast<double>(index % rocksPerSide) / (rocksPerSide - 1)));
    return host.add(material);
}

void addRocks(const Host& host, std::uint32_t triangles, Builder& builder) {
    const std::vector<std::uint32_t> shares = sharesOf((1.0 - patchShare) * triangles, rocks, rockFineness);
    const auto center = [](std::uint32_t i) {
        return static_cast<float>(side * ((i + 0.5) / rocksPerSide - 0.5));
    };
    for (std::uint32_t i = 0; i < rocks; ++i) {
        const std::string name = "rock " + std::to_string(i);
        const Geometry rock = makeRock(i, shares[i]);
        if (rock.indices.empty()) continue;
        builder.add(rock, addRockMaterial(host, i, name), name,
                    {center(i % rocksPerSide), 1.2f, center(i / rocksPerSide)});
    }
}

candela_light lightAt(std::uint32_t index) {
    const auto drawn = [&](std::uint32_t property, double low, double high) {
        return static_cast<float>(between(low, high, hashedFraction(index, property)));
    };
    candela_light light = plainLight(lightCandela, lightRange);
    light.position[0] = drawn(lightPlace, -48.0, 48.0);
    light.position[1] = drawn(lightPlace + 1, 1.0, 4.0);
    light.position[2] = drawn(lightPlace + 2, -48.0, 48.0);
    const std::array<float, 3> color = hueColor(hashedFraction(index, lightHue));
    std::copy(color.begin(), color.end(), light.color);
    return light;
}

std::string gigabytes(std::uint64_t bytes) {
    const std::uint64_t tenths = (bytes + 50'000'000) / 100'000'000;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GB";
}

void requireMemory(std::uint32_t triangles) {
    const std::uint64_t needed = triangles * bytesPerTriangle, free = availableMemory();
    if (needed <= free) return;
    throw Failure{"number of triangles", std::to_string(triangles) + " triangles take up to " +
                                             gigabytes(needed) + " of memory, but " + gigabytes(free) +
                                             " are free"};
}

}  // namespace

void makeTriangles(const Host& host, const std::string& arguments) {
    const std::size_t comma = arguments.find(',');
    const std::uint32_t triangles =
        parseCount(arguments.substr(0, comma), "number of triangles", example, {1, maxTriangles});
    const std::uint32_t lights = comma == std::string::npos
                                     ? 4096
                                     : parseCount(arguments.substr(comma + 1), "number of lights", example);
    requireMemory(triangles);
    Builder builder(host, triangles);
    addPatches(host, triangles, builder);
    addRocks(host, triangles, builder);
    builder.add(makeSplinters(builder.left()), addGreyMaterial(host, "splinters", 0.6f, 0.5f), "splinters");
    addCameraAt(host, 20.0, 75.0);
    addLights(host, lights, lightAt);
}

}  // namespace candela_plugins::plaza
