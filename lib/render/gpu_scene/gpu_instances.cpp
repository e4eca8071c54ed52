#include "render/gpu_scene/gpu_instances.h"

#include "base/error_context.h"
#include "base/runs.h"
#include "render/layout.h"
#include "scene/geometry/topology.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace candela {

namespace {

struct NormalMatrix {
    glm::mat3 matrix;
    bool mirrored;  ///< The instance's matrix reverses the winding.
};

/// The matrix that takes normals to the world: the cofactors of the linear part, which are det(M) times the
/// inverse transpose and defined for singular matrices too. The sign is that of the inverse transpose, so
/// that normals of mirrored instances point outwards. The largest element is scaled to 1, so that the length
/// of a normal neither overflows nor vanishes at any size of the instance.
NormalMatrix normalMatrix(const glm::mat4& m) {
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    const bool mirrored = glm::dot(x, cofactors[0]) < 0.0;
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(cofactors[column][row]));
    }
    if (largest == 0.0) return {glm::mat3(0.0f), mirrored};
    return {glm::mat3(cofactors * ((mirrored ? -1.0 : 1.0) / largest)), mirrored};
}

/// An upper bound of how far the matrix stretches any direction: the Frobenius norm bounds the largest
/// singular value, sheared matrices included.
float maxScale(const glm::mat4& m) {
    const glm::vec3 x(m[0]), y(m[1]), z(m[2]);
    return std::sqrt(glm::dot(x, x) + glm::dot(y, y) + glm::dot(z, z));
}

/// None where it is not finite.
std::optional<Bounds> boxOf(const BoundingSphere& sphere) {
    const glm::vec3 reach(sphere.radius);
    const Bounds box{sphere.center - reach, sphere.center + reach};
    return allFinite(box.min) && allFinite(box.max) ? std::optional(box) : std::nullopt;
}

}  // namespace

BoundingSphere boundingSphere(std::span<const glm::vec3> points) {
    if (points.empty()) return {};
    struct Part {
        glm::vec3 low{std::numeric_limits<float>::max()}, high{-std::numeric_limits<float>::max()};
        float radius = 0.0f;
    };
    std::vector<Part> parts((points.size() + runLength - 1) / runLength);
    inRuns(points.size(), [&](std::size_t first, std::size_t end) {
        Part part;
        for (const glm::vec3& point : points.subspan(first, end - first)) {
            part.low = glm::min(part.low, point);
            part.high = glm::max(part.high, point);
        }
        parts[first / runLength] = part;
    });
    Part all;
    for (const Part& part : parts) {
        all.low = glm::min(all.low, part.low);
        all.high = glm::max(all.high, part.high);
    }
    BoundingSphere sphere{0.5f * all.low + 0.5f * all.high};
    inRuns(points.size(), [&](std::size_t first, std::size_t end) {
        float radius = 0.0f;
        for (const glm::vec3& point : points.subspan(first, end - first))
            radius = std::max(radius, glm::distance(point, sphere.center));
        parts[first / runLength].radius = radius;
    });
    for (const Part& part : parts) sphere.radius = std::max(sphere.radius, part.radius);
    return sphere;
}

BoundingSphere worldSphere(const glm::mat4& worldFromLocal, const BoundingSphere& local) {
    return {glm::vec3(worldFromLocal * glm::vec4(local.center, 1.0f)),
            local.radius * maxScale(worldFromLocal)};
}

GpuInstances::GpuInstances(const Scene& scene)
    : meshOfNode_(scene.nodes.size(), none),
      cageOfNode_(scene.nodes.size(), none),
      records_(GL_RGBA32F, layout::INSTANCE_TEXELS, "instances") {
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        if (!scene.nodes[i].mesh) continue;
        meshOfNode_[i] = static_cast<std::uint32_t>(instances_.size());
        instances_.push_back({i, scene.nodes[i].mesh});
        hasElements_.push_back(!hasOnlyTriangles(scene.meshes[*scene.nodes[i].mesh]));
    }
    std::uint32_t cageInstances = 0;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        if (!scene.nodes[i].cage) continue;
        cageOfNode_[i] = static_cast<std::uint32_t>(instances_.size());
        instances_.push_back({i, std::nullopt, cageInstances++});
    }
    hasElements_.resize(instances_.size());
    spheres_.resize(instances_.size());
    windings_.resize(instances_.size(), Winding::kept);
    hidden_.resize(instances_.size());
    isChanged_.resize(instances_.size());
    records_.reserve(instances_.size());
    records_.resize(instances_.size());
}

std::uint32_t GpuInstances::addMesh(std::uint32_t node, std::uint32_t mesh, Elements elements) {
    const std::uint32_t index = take({node, mesh});
    setElements(index, elements);
    return meshOfNode_[node] = index;
}

std::uint32_t GpuInstances::addCage(std::uint32_t node, std::uint32_t cageInstance) {
    return cageOfNode_[node] = take({node, std::nullopt, cageInstance});
}

std::uint32_t GpuInstances::take(const Instance& instance) {
    std::uint32_t index = 0;
    if (!free_.empty()) {
        index = free_.back();
        free_.pop_back();
    } else {
        index = static_cast<std::uint32_t>(instances_.size());
        records_.grow(instances_.size() + 1);
        instances_.emplace_back();
        hasElements_.push_back(false);
        spheres_.emplace_back();
        windings_.push_back(Winding::kept);
        hidden_.push_back(false);
        isChanged_.push_back(false);
    }
    instances_[index] = instance;
    isNew_.resize(instances_.size());
    isNew_[index] = true;
    hasElements_[index] = false;
    windings_[index] = Winding::kept;
    hidden_[index] = false;
    markChanged(index);
    return index;
}

void GpuInstances::remove(std::uint32_t& ofNode) {
    const std::uint32_t index = std::exchange(ofNode, none);
    leaveBounds(index);
    instances_[index].isRemoved = true;
    hidden_[index] = true;
    markChanged(index);
    free_.push_back(index);
}

std::vector<std::uint32_t> GpuInstances::inNodeOrder() const {
    std::vector<std::uint32_t> order;
    order.reserve(instances_.size());
    for (const std::vector<std::uint32_t>* ofNode : {&meshOfNode_, &cageOfNode_}) {
        for (const std::uint32_t index : *ofNode) {
            if (index != none) order.push_back(index);
        }
    }
    return order;
}

void GpuInstances::place(std::uint32_t index, const glm::mat4& worldFromLocal, const BoundingSphere& local,
                         std::optional<Winding> winding) {
    leaveBounds(index);
    spheres_[index] = worldSphere(worldFromLocal, local);
    joinBounds(index);
    markChanged(index);
    const std::span<glm::vec4> record = records_.edit(index);
    const glm::mat4 rows = glm::transpose(worldFromLocal);
    const NormalMatrix normals = normalMatrix(worldFromLocal);
    const glm::mat3 normalRows = glm::transpose(normals.matrix);
    const float handedness = normals.mirrored ? -1.0f : 1.0f;
    for (int row = 0; row < 3; ++row) {
        record[static_cast<std::size_t>(row)] = rows[row];
        record[static_cast<std::size_t>(3 + row)] = glm::vec4(normalRows[row], handedness);
    }
    windings_[index] = winding.value_or(normals.mirrored ? Winding::reversed : Winding::kept);
}

std::vector<std::uint32_t> GpuInstances::takeChanged() {
    for (const std::uint32_t index : changed_) isChanged_[index] = false;
    return std::exchange(changed_, {});
}

/// Without what it touches, a box of others may be smaller.
void GpuInstances::leaveBounds(std::uint32_t index) {
    const std::optional<Bounds> own = boxOf(spheres_[index]);
    if (!own || boundsAreStale_) return;
    for (int axis = 0; axis < 3; ++axis) {
        if (own->min[axis] <= bounds_.min[axis] || own->max[axis] >= bounds_.max[axis])
            boundsAreStale_ = true;
    }
}

void GpuInstances::joinBounds(std::uint32_t index) {
    const std::optional<Bounds> own = boxOf(spheres_[index]);
    if (own && !boundsAreStale_) bounds_.add(*own);
}

const Bounds& GpuInstances::bounds() {
    if (!boundsAreStale_) return bounds_;
    bounds_ = {};
    boundsAreStale_ = false;
    for (std::uint32_t i = 0; i < spheres_.size(); ++i) {
        if (!instances_[i].isRemoved) joinBounds(i);
    }
    return bounds_;
}

float GpuInstances::farthestDepth(const Frustum& frustum) const {
    float farthest = 0.0f;
    for (std::uint32_t i = 0; i < spheres_.size(); ++i) {
        if (isVisible(i, frustum)) farthest = std::max(farthest, farthestDepth(i, frustum));
    }
    return farthest;
}

}  // namespace candela
