#include "render/deformation/mesh_deformation.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>

namespace candela {

namespace {

/// How far the linear part of a matrix moves the corners of a box along each axis.
glm::dvec3 extentOf(const glm::dmat4x3& m, const glm::dvec3& halfSize) {
    return glm::abs(m[0]) * halfSize.x + glm::abs(m[1]) * halfSize.y + glm::abs(m[2]) * halfSize.z;
}

glm::vec3 offsetAt(const std::vector<glm::vec3>& offsets, std::size_t vertex) {
    return offsets.empty() ? glm::vec3(0.0f) : offsets[vertex];
}

void copyTo(float (&to)[3], const glm::vec3& from) {
    for (int i = 0; i < 3; ++i) to[i] = from[i];
}

}  // namespace

PosedJoints posedJoints(std::span<const glm::dmat4x3> matrices) {
    PosedJoints posed;
    posed.rows.reserve(12 * matrices.size());
    double largest = 0.0;
    std::size_t mirrored = 0;
    for (const glm::dmat4x3& m : matrices) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) {
                posed.rows.push_back(static_cast<float>(m[column][row]));
                if (column < 3) largest = std::max(largest, std::abs(m[column][row]));
            }
        }
        mirrored += glm::determinant(glm::dmat3(m)) < 0.0;
    }
    // Outside of these limits the products of two elements are no floats any more.
    if (largest > 0.0) posed.directionScale = static_cast<float>(1.0 / std::clamp(largest, 1e-18, 1e18));
    if (2 * mirrored > matrices.size()) posed.winding = Winding::reversed;
    return posed;
}

MeshDeformation::MeshDeformation(const Mesh& mesh, GpuMeshes::Detail detail)
    : vertices_(static_cast<std::uint32_t>(mesh.positions.size())),
      hasTangents_(detail == GpuMeshes::Detail::everything && !mesh.tangents.empty()),
      sphere_(boundingSphere(mesh.positions)) {
    packRest(mesh);
    packInfluences(mesh);
    packMorphTargets(mesh);
    boundJoints(mesh);
}

void MeshDeformation::packRest(const Mesh& mesh) {
    const std::size_t width = hasTangents_ ? restColumnsWithTangents : restColumns;
    rest_.resize(blockCount() * width * deformBlockSize);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        float* first = rest_.data() + i / deformBlockSize * width * deformBlockSize + i % deformBlockSize;
        const auto put = [&](std::size_t column, float value) { first[column * deformBlockSize] = value; };
        for (int c = 0; c < 3; ++c) {
            put(static_cast<std::size_t>(c), mesh.positions[i][c]);
            put(static_cast<std::size_t>(3 + c), mesh.normals[i][c]);
        }
        for (int c = 0; c < 4 && hasTangents_; ++c) put(static_cast<std::size_t>(6 + c), mesh.tangents[i][c]);
    }
}

/// Influences of weight 0 are left out; what is left of each vertex has the sum 1. Blocks have all their
/// runs.
void MeshDeformation::packInfluences(const Mesh& mesh) {
    if (mesh.influenceCount == 0) return;
    const std::size_t count = blockCount() * std::size_t{deformBlockSize} / deformRunSize;
    runs_.reserve(count + 1);
    for (std::size_t run = 0; run < count; ++run) {
        runs_.push_back(static_cast<std::uint32_t>(influences_.size()));
        for (std::size_t lane = 0; lane < deformRunSize; ++lane) {
            const std::size_t vertex = run * deformRunSize + lane;
            if (vertex < vertices_) addInfluences(mesh, vertex, lane);
        }
    }
    runs_.push_back(static_cast<std::uint32_t>(influences_.size()));
}

/// Adds the influences of a vertex to those of the last run.
void MeshDeformation::addInfluences(const Mesh& mesh, std::size_t vertex, std::size_t lane) {
    const std::size_t first = vertex * mesh.influenceCount, end = first + mesh.influenceCount;
    double sum = 0.0;
    for (std::size_t i = first; i < end; ++i) sum += double{mesh.jointWeights[i]};
    for (std::size_t i = first; i < end; ++i) {
        if (mesh.jointWeights[i] == 0.0f) continue;
        const auto run = std::ranges::subrange(influences_.begin() + runs_.back(), influences_.end());
        const auto known = std::ranges::find(run, mesh.joints[i], &RunInfluence::joint);
        RunInfluence& influence = known == run.end() ? influences_.emplace_back() : *known;
        influence.joint = mesh.joints[i];
        influence.weight[lane] += static_cast<float>(double{mesh.jointWeights[i]} / sum);
    }
}

void MeshDeformation::packMorphTargets(const Mesh& mesh) {
    if (mesh.morphTargets.empty()) return;
    rows_.reserve(mesh.positions.size() + 1);
    targetReach_.resize(mesh.morphTargets.size());
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        rows_.push_back(static_cast<std::uint32_t>(entries_.size()));
        for (std::size_t i = 0; i < mesh.morphTargets.size(); ++i) {
            const MorphTarget& target = mesh.morphTargets[i];
            const glm::vec3 position = target.offsets[vertex];
            const glm::vec3 normal = offsetAt(target.normalOffsets, vertex);
            const glm::vec3 tangent = offsetAt(target.tangentOffsets, vertex);
            constexpr glm::vec3 zero(0.0f);
            if (position == zero && normal == zero && tangent == zero) continue;
            MorphEntry& entry = entries_.emplace_back();
            entry.target = static_cast<std::uint32_t>(i);
            copyTo(entry.position, position);
            copyTo(entry.normal, normal);
            copyTo(entry.tangent, tangent);
            targetReach_[i] = std::max(targetReach_[i], glm::length(position));
        }
    }
    rows_.push_back(static_cast<std::uint32_t>(entries_.size()));
}

void MeshDeformation::boundJoints(const Mesh& mesh) {
    constexpr float far = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < mesh.joints.size(); ++i) {
        if (mesh.jointWeights[i] == 0.0f) continue;
        if (mesh.joints[i] >= jointBoxes_.size())
            jointBoxes_.resize(mesh.joints[i] + 1, {glm::vec3(far), glm::vec3(-far)});
        Box& box = jointBoxes_[mesh.joints[i]];
        const glm::vec3& position = mesh.positions[i / mesh.influenceCount];
        box.low = glm::min(box.low, position);
        box.high = glm::max(box.high, position);
    }
}

DeformJob MeshDeformation::job() const {
    DeformJob job{};
    job.vertices = vertices_;
    job.rest = rest_.data();
    job.runs = runs_.data();
    job.influences = influences_.data();
    job.directionScale = 1.0f;
    job.rows = rows_.data();
    job.entries = entries_.data();
    return job;
}

float MeshDeformation::morphReach(std::span<const float> weights) const {
    float reach = 0.0f;
    for (std::size_t i = 0; i < weights.size(); ++i) reach += std::abs(weights[i]) * targetReach_[i];
    return reach;
}

BoundingSphere MeshDeformation::bounds(std::span<const float> morphWeights) const {
    return {sphere_.center, sphere_.radius + morphReach(morphWeights)};
}

BoundingSphere MeshDeformation::bounds(std::span<const glm::dmat4x3> matrices,
                                       std::span<const float> morphWeights) const {
    // A blended position lies between those to which the joints take the vertex.
    const double reach = morphReach(morphWeights);
    glm::dvec3 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    for (std::size_t i = 0; i < jointBoxes_.size(); ++i) {
        const Box& box = jointBoxes_[i];
        if (box.low.x > box.high.x) continue;
        const glm::dvec3 center =
            matrices[i] * glm::dvec4(0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high)), 1.0);
        const glm::dvec3 halfSize = 0.5 * (glm::dvec3(box.high) - glm::dvec3(box.low)) + reach;
        const glm::dvec3 extent = extentOf(matrices[i], halfSize);
        low = glm::min(low, center - extent);
        high = glm::max(high, center + extent);
    }
    if (low.x > high.x) return {};
    return {glm::vec3(0.5 * (low + high)), static_cast<float>(0.5 * glm::distance(low, high))};
}

const MeshDeformation::Storage& MeshDeformation::storage() {
    if (!storage_) {
        storage_.emplace(
            Storage{gl::Buffer::immutable("vertices at rest", std::span<const float>(rest_)),
                    gl::Buffer::immutable("runs of influences", std::span<const std::uint32_t>(runs_)),
                    gl::Buffer::immutable("influences", std::span<const RunInfluence>(influences_)),
                    gl::Buffer::immutable("rows of morph targets", std::span<const std::uint32_t>(rows_)),
                    gl::Buffer::immutable("morph targets", std::span<const MorphEntry>(entries_))});
    }
    return *storage_;
}

std::size_t MeshDeformation::largestBuffer() const {
    return std::max({rest_.size() * sizeof(float), influences_.size() * sizeof(RunInfluence),
                     entries_.size() * sizeof(MorphEntry), rows_.size() * sizeof(std::uint32_t),
                     surfaceBytes()});
}

}  // namespace candela
