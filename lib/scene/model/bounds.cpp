#include "scene/model/drawn_vertices.h"
#include "scene/validate/scene_rules.h"

#include <candela/scene.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <span>
#include <utility>

namespace candela {

namespace {

UsedVertices listed(const std::vector<bool>& isUsed) {
    UsedVertices used;
    used.count = static_cast<std::size_t>(std::ranges::count(isUsed, true));
    if (used.count == isUsed.size()) return used;
    used.indices.reserve(used.count);
    for (std::uint32_t i = 0; i < isUsed.size(); ++i) {
        if (isUsed[i]) used.indices.push_back(i);
    }
    return used;
}

// Refuses an index beyond the vertices: the scene may not have passed `validate`.
void markUsed(std::span<const std::uint32_t> vertices, const ErrorContext& element,
              std::vector<bool>& isUsed) {
    for (const std::uint32_t vertex : vertices) {
        element.requireIndex("vertex", vertex, isUsed.size());
        isUsed[vertex] = true;
    }
}

void enclose(const glm::vec3& point, Bounds& bounds) {
    bounds.min = glm::min(bounds.min, point);
    bounds.max = glm::max(bounds.max, point);
}

void requireNode(const Scene& scene, std::uint32_t node) {
    const ErrorContext element("node", node, scene.nodes[node].name);
    element.requireIndex("mesh", scene.nodes[node].mesh, scene.meshes.size());
    element.requireIndex("cage", scene.nodes[node].cage, scene.cages.size());
}

Bounds boundsOf(DrawnVertices& drawn, std::uint32_t node, const std::vector<glm::mat4>& world, double time) {
    Bounds bounds;
    drawn.forEach(node, world, time, [&](const glm::vec3& point) { enclose(point, bounds); });
    return bounds;
}

}  // namespace

const UsedVertices& DrawnVertices::ofMesh(std::uint32_t index) {
    std::optional<UsedVertices>& used = meshes_[index];
    if (used) return *used;
    const Mesh& mesh = scene_.meshes[index];
    const ErrorContext element("mesh", index, mesh.name);
    std::vector<bool> isUsed(mesh.positions.size(), false);
    const std::span<const std::uint32_t> indices(mesh.indices);
    if (mesh.submeshes.empty()) markUsed(indices, element, isUsed);
    for (const Submesh& submesh : mesh.submeshes) {
        element.require(std::uint64_t{submesh.firstIndex} + submesh.indexCount <= indices.size(),
                        "a submesh names indices that it does not have");
        markUsed(indices.subspan(submesh.firstIndex, submesh.indexCount), element, isUsed);
    }
    return used.emplace(listed(isUsed));
}

const UsedVertices& DrawnVertices::ofCage(std::uint32_t index) {
    std::optional<UsedVertices>& used = cages_[index];
    if (used) return *used;
    const Cage& cage = scene_.cages[index];
    std::vector<bool> isUsed(cage.positions.size(), false);
    markUsed(cage.faceVertices, ErrorContext("cage", index, cage.name), isUsed);
    return used.emplace(listed(isUsed));
}

std::size_t DrawnVertices::count(std::uint32_t node) {
    const Node& element = scene_.nodes[node];
    return (element.mesh ? ofMesh(*element.mesh).count : 0) +
           (element.cage ? ofCage(*element.cage).count : 0);
}

bool DrawnVertices::isDeformed(std::uint32_t node) const {
    const Node& element = scene_.nodes[node];
    if (element.mesh &&
        (movesMesh(scene_, *element.mesh) || candela::isDeformed(element, scene_.meshes[*element.mesh])))
        return true;
    return element.cage &&
           (movesCage(scene_, *element.cage) || candela::isDeformed(element, scene_.cages[*element.cage]));
}

bool DrawnVertices::spansAPlane(const glm::mat4& matrix) {
    const glm::dvec3 x(matrix[0]), y(matrix[1]), z(matrix[2]), none(0.0);
    return glm::cross(x, y) != none || glm::cross(y, z) != none || glm::cross(z, x) != none;
}

void Bounds::add(const Bounds& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
}

Bounds nodeBounds(const Scene& scene, std::uint32_t node, const std::vector<glm::mat4>& world, double time) {
    ErrorContext("scene").requireIndex("node", node, scene.nodes.size());
    requireWorldMatrices(scene, world);
    requireTime(time);
    requireNode(scene, node);
    DrawnVertices drawn(scene);
    return boundsOf(drawn, node, world, time);
}

Bounds worldBounds(const Scene& scene, const std::vector<glm::mat4>& world, double time) {
    requireWorldMatrices(scene, world);
    requireTime(time);
    DrawnVertices drawn(scene);
    Bounds bounds;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        requireNode(scene, i);
        bounds.add(boundsOf(drawn, i, world, time));
    }
    return bounds;
}

namespace {

constexpr std::size_t maxSamples = 65536;    // Vertices that outliers are told by.
constexpr std::size_t maxKeyTimes = 64;      // Poses at keys.
constexpr int timesBetween = 32;             // And evenly spaced ones.
constexpr std::size_t maxPosed = 4'000'000;  // Vertices that are posed again, of all poses but the last.
constexpr float outlierFactor = 100.0f;

bool holds(const Bounds& box, const glm::vec3& point) {
    return glm::all(glm::lessThanEqual(box.min, point)) && glm::all(glm::lessThanEqual(point, box.max));
}

// Coordinates along an axis in ascending order, and the part of them that is no outlier.
class Spread {
  public:
    explicit Spread(std::vector<float> values) : values_(std::move(values)) {
        std::ranges::sort(values_);
        // The shortest interval that holds more than half of the values.
        const std::size_t half = values_.size() / 2;
        for (std::size_t i = 0; i + half < values_.size(); ++i) {
            if (values_[i + half] - values_[i] < length() || i == 0) first_ = i, last_ = i + half;
        }
    }

    float length() const { return values_[last_] - values_[first_]; }
    float first() const { return values_[first_]; }
    float last() const { return values_[last_]; }

    /// Takes in the neighbours that are at most `reach` away. Returns whether there were any.
    bool grow(float reach) {
        const std::size_t first = first_, last = last_;
        while (first_ > 0 && values_[first_ - 1] >= values_[first_] - reach) --first_;
        while (last_ + 1 < values_.size() && values_[last_ + 1] <= values_[last_] + reach) ++last_;
        return first_ != first || last_ != last;
    }

  private:
    std::vector<float> values_;
    std::size_t first_ = 0, last_ = 0;
};

constexpr Bounds everywhere{glm::vec3(-std::numeric_limits<float>::max()),
                            glm::vec3(std::numeric_limits<float>::max())};

// The box beyond which vertices are outliers of `sample`.
Bounds reachOf(const std::vector<glm::vec3>& sample) {
    if (sample.empty()) return everywhere;
    std::vector<Spread> axes;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> values;
        values.reserve(sample.size());
        for (const glm::vec3& point : sample) values.push_back(point[axis]);
        axes.emplace_back(std::move(values));
    }
    const auto reach = [&] {
        return outlierFactor * std::max({axes[0].length(), axes[1].length(), axes[2].length()});
    };
    if (reach() == 0.0f) return everywhere;
    for (bool grown = true; grown;) {
        grown = false;
        for (Spread& axis : axes) grown = axis.grow(reach()) || grown;
    }
    const float margin = reach();
    return {glm::vec3(axes[0].first(), axes[1].first(), axes[2].first()) - margin,
            glm::vec3(axes[0].last(), axes[1].last(), axes[2].last()) + margin};
}

std::vector<glm::vec3> sampleVertices(const Scene& scene, DrawnVertices& drawn,
                                      const std::vector<glm::mat4>& world, double time) {
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) count += drawn.count(i);
    const std::size_t step = (count + maxSamples - 1) / maxSamples;
    std::vector<glm::vec3> sample;
    std::size_t visited = 0;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        drawn.forEach(i, world, time, [&](const glm::vec3& point) {
            if (visited++ % step == 0) sample.push_back(point);
        });
    }
    return sample;
}

// The order that halves gaps again and again, the last time right after the first one.
std::vector<double> coarseToFine(const std::vector<double>& times) {
    std::vector<double> ordered{times.front()};
    if (times.size() > 1) ordered.push_back(times.back());
    for (std::size_t step = std::bit_ceil(times.size()) / 2; step > 0; step /= 2) {
        for (std::size_t i = step; i + 1 < times.size(); i += 2 * step) ordered.push_back(times[i]);
    }
    return ordered;
}

// The times at which the motion is looked at, the first and the last key of the animations, and the span of a
// frame callback, before others.
std::vector<double> poseTimes(const Scene& scene) {
    std::vector<double> keys;
    for (const Animation& animation : scene.animations) {
        if (!animation.plays) continue;
        for (const AnimationChannel& channel : animation.channels)
            keys.insert(keys.end(), channel.times.begin(), channel.times.end());
    }
    if (scene.frameCallback) {
        const TimeSpan span = frameCallbackSpan(scene);
        keys.insert(keys.end(), {span.first, span.last});
    }
    if (keys.empty()) return {0.0};
    std::ranges::sort(keys);
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::vector<double> times;
    const double duration = keys.back() - keys.front();
    const std::size_t step = (keys.size() + maxKeyTimes - 1) / maxKeyTimes;
    for (std::size_t i = 0; i < keys.size(); i += step) times.push_back(keys[i]);
    for (int i = 1; i <= timesBetween; ++i) times.push_back(keys.front() + duration * i / timesBetween);
    std::ranges::sort(times);
    return coarseToFine(times);
}

}  // namespace

Bounds framingBounds(const Scene& scene) {
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) requireNode(scene, i);
    DrawnVertices drawn(scene);
    const std::vector<double> times = poseTimes(scene);
    const std::vector<glm::mat4> first = worldTransforms(scene, times.front());
    const Bounds reach = reachOf(sampleVertices(scene, drawn, first, times.front()));
    Bounds bounds;
    std::size_t posed = 0;
    const auto add = [&](std::uint32_t node, const std::vector<glm::mat4>& world, double time) {
        drawn.forEach(node, world, time, [&](const glm::vec3& point) {
            if (holds(reach, point)) enclose(point, bounds);
        });
    };
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) add(i, first, times.front());
    for (std::size_t t = 1; t < times.size() && posed < maxPosed; ++t) {
        const std::vector<glm::mat4> world = worldTransforms(scene, times[t]);
        for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
            if (world[i] == first[i] && !drawn.isDeformed(i)) continue;
            add(i, world, times[t]);
            posed += drawn.count(i);
        }
    }
    return bounds;
}

}  // namespace candela
