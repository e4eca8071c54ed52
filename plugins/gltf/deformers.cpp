#include "deformers.h"

#include <algorithm>
#include <array>

#include "primitives.h"

namespace candela_plugins::gltf {

namespace {

constexpr std::array morphAttributes{"POSITION", "NORMAL", "TANGENT"};

void append(std::vector<float>& all, const std::vector<float>& more, std::size_t before, std::size_t count) {
    if (more.empty()) return;
    all.resize(3 * before);
    all.insert(all.end(), more.begin(), more.begin() + static_cast<std::ptrdiff_t>(3 * count));
}

}  // namespace

std::vector<int> deformerAccessors(const tinygltf::Primitive& primitive) {
    std::vector<int> accessors{accessorOf(primitive, "POSITION")};
    for (const auto& [name, accessor] : primitive.attributes) {
        if (name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_")) accessors.push_back(accessor);
    }
    for (const auto& target : primitive.targets) {
        for (const char* attribute : morphAttributes) {
            const auto accessor = target.find(attribute);
            accessors.push_back(accessor == target.end() ? -1 : accessor->second);
        }
    }
    return accessors;
}

DeformerReader::DeformerReader(const Document& document, std::size_t mesh, const Host& host)
    : document_(document), host_(host) {
    for (const tinygltf::Node& node : document.model.nodes) {
        if (node.mesh != static_cast<int>(mesh) || node.skin < 0) continue;
        const std::size_t joints = document.skins[static_cast<std::size_t>(node.skin)].joints.size();
        joints_ = std::min(joints_.value_or(joints), joints);
    }
}

const Deformers& DeformerReader::read(const tinygltf::Primitive& primitive, const std::string& element) {
    const auto [entry, isNew] = known_.try_emplace(deformerAccessors(primitive));
    Deformers& deformers = entry->second;
    if (!isNew || !host_.takesDeformations()) return deformers;
    const std::size_t vertices = elementCount(document_, accessorOf(primitive, "POSITION"));
    host_.leavesOut([&] {
        if (!joints_) return;
        const std::uint32_t sets = influenceSets(primitive, element);
        deformers.influences =
            readInfluences(document_, primitive, sets, {vertices, *joints_}, element, host_);
        deformers.influenceSets = sets;
    });
    for (std::size_t i = 0; i < primitive.targets.size(); ++i) {
        Deformers::Target& target = deformers.targets.emplace_back();
        host_.leavesOut([&] { target = readTarget(primitive, i, vertices, element); });
    }
    return deformers;
}

Deformers::Target DeformerReader::readTarget(const tinygltf::Primitive& primitive, std::size_t target,
                                             std::size_t vertices, const std::string& element) const {
    const auto offsets = [&](const char* attribute) {
        return readMorphOffsets(document_, primitive, target, attribute, vertices, element);
    };
    return {offsets("POSITION"), offsets("NORMAL"), offsets("TANGENT")};
}

void MorphTargets::add(const std::vector<Deformers::Target>& targets, std::size_t before, std::size_t count) {
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        append(targets_[i].positions, targets[i].positions, before, count);
        append(targets_[i].normals, targets[i].normals, before, count);
        append(targets_[i].tangents, targets[i].tangents, before, count);
    }
}

std::vector<float> MorphTargets::joined(std::vector<float> Deformers::Target::*kind,
                                        std::size_t vertices) const {
    const bool any = std::any_of(targets_.begin(), targets_.end(),
                                 [&](const Deformers::Target& target) { return !(target.*kind).empty(); });
    std::vector<float> all;
    if (!any) return all;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        const std::vector<float>& offsets = targets_[i].*kind;
        all.insert(all.end(), offsets.begin(), offsets.end());
        all.resize((i + 1) * vertices * 3);
    }
    return all;
}

}  // namespace candela_plugins::gltf
