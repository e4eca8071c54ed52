#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../common/host.h"
#include "deformation.h"
#include "document.h"

namespace candela_plugins::gltf {

/// What deforms the vertices of a primitive.
struct Deformers {
    /// The offsets of a morph target, 3 numbers a vertex; empty: none.
    struct Target {
        std::vector<float> positions, normals, tangents;
    };

    std::uint32_t influenceSets = 0;
    Influences influences;
    std::vector<Target> targets;
};

/// The accessors that deform the vertices of a primitive: joints and weights, then the morph targets' (-1 for
/// none).
std::vector<int> deformerAccessors(const tinygltf::Primitive& primitive);

/// Reads what deforms the primitives of a mesh. What cannot be read leaves the primitive undeformed, with a
/// note.
class DeformerReader {
  public:
    DeformerReader(const Document& document, std::size_t mesh, const Host& host);

    /// The same object for primitives with the same accessors.
    const Deformers& read(const tinygltf::Primitive& primitive, const std::string& element);

  private:
    Deformers::Target readTarget(const tinygltf::Primitive& primitive, std::size_t target,
                                 std::size_t vertices, const std::string& element) const;

    const Document& document_;
    const Host& host_;
    std::optional<std::size_t> joints_;  ///< The fewest of the skins with which nodes show the mesh.
    std::map<std::vector<int>, Deformers> known_;
};

/// The morph targets of a mesh, as they grow with its vertices.
class MorphTargets {
  public:
    explicit MorphTargets(std::size_t count) : targets_(count) {}

    std::uint32_t count() const { return static_cast<std::uint32_t>(targets_.size()); }

    /// Appends `count` vertices behind the `before` that there are.
    void add(const std::vector<Deformers::Target>& targets, std::size_t before, std::size_t count);

    /// The offsets of one kind, target after target; empty where no target has any.
    std::vector<float> joined(std::vector<float> Deformers::Target::*kind, std::size_t vertices) const;

  private:
    std::vector<Deformers::Target> targets_;
};

}  // namespace candela_plugins::gltf
