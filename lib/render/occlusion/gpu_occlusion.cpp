#include "render/occlusion/gpu_occlusion.h"

#include "base/thread_pool.h"
#include "render/layout.h"

#include <candela/error.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace candela {

namespace {

constexpr std::uint32_t nodeTexels = layout::OCCLUSION_NODE_TEXELS;
constexpr std::uint32_t triangleTexels = layout::OCCLUSION_TRIANGLE_TEXELS;
constexpr std::uint32_t instanceTexels = layout::OCCLUSION_INSTANCE_TEXELS;
constexpr std::uint32_t cutoutTexels = layout::OCCLUSION_CUTOUT_TEXELS;
/// A stack entry of the shader has 24 bits for a node.
constexpr std::uint32_t maxNodes = 1u << 24;

std::uint32_t bits(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

glm::uvec4 corner(const glm::vec3& position, std::uint32_t w) {
    return {bits(position.x), bits(position.y), bits(position.z), w};
}

/// Calls `body(i)` for each i below `count` on all threads.
template <typename Body>
void forEach(std::size_t count, const Body& body) {
    constexpr std::size_t run = 1024;
    ThreadPool::shared()->run((count + run - 1) / run, [&](std::size_t part, unsigned) {
        for (std::size_t i = part * run; i < std::min(count, (part + 1) * run); ++i) body(i);
    });
}

/// The sides of eight boxes along an axis as multiples of a step above an origin. The shader's
/// `origin + number * step` has one rounding, as here, so that it is the same.
struct AxisCodes {
    float origin;
    std::uint32_t exponent;  ///< Of the step, biased by 127 as in a float.
    std::array<std::uint8_t, WideNode::width> lower{}, upper{};
};

float side(const AxisCodes& axis, int number) {
    return axis.origin + static_cast<float>(number) * std::bit_cast<float>(axis.exponent << 23);
}

AxisCodes encodeAxis(const float* low, const float* high, unsigned count) {
    const float lowest = *std::min_element(low, low + count), highest = *std::max_element(high, high + count);
    const double extent = double(highest) - lowest;
    const int exponent = extent > 0.0 ? std::ilogb(extent / 255.0) + 127 : 1;
    AxisCodes axis{lowest, static_cast<std::uint32_t>(std::clamp(exponent, 1, 254))};
    while (side(axis, 255) < highest && axis.exponent < 254) ++axis.exponent;
    const double step = std::bit_cast<float>(axis.exponent << 23);
    for (unsigned lane = 0; lane < count; ++lane) {
        int lower = static_cast<int>(std::min(std::floor((double(low[lane]) - lowest) / step), 255.0));
        while (lower > 0 && side(axis, lower) > low[lane]) --lower;
        int upper = static_cast<int>(std::min(std::ceil((double(high[lane]) - lowest) / step), 255.0));
        while (upper < 255 && side(axis, upper) < high[lane]) ++upper;
        axis.lower[lane] = static_cast<std::uint8_t>(lower);
        axis.upper[lane] = static_cast<std::uint8_t>(upper);
    }
    return axis;
}

glm::uvec4 wordsOf(const AxisCodes& axis) {
    const auto word = [](const std::uint8_t* codes) {
        return std::uint32_t{codes[0]} | std::uint32_t{codes[1]} << 8 | std::uint32_t{codes[2]} << 16 |
               std::uint32_t{codes[3]} << 24;
    };
    return {word(&axis.lower[0]), word(&axis.lower[4]), word(&axis.upper[0]), word(&axis.upper[4])};
}

/// `child[lane]` are the children as the shader reads them.
void encodeNode(const WideNode& node, unsigned count, const std::array<std::uint32_t, WideNode::width>& child,
                glm::uvec4* texels) {
    const AxisCodes x = encodeAxis(node.minX, node.maxX, count), y = encodeAxis(node.minY, node.maxY, count),
                    z = encodeAxis(node.minZ, node.maxZ, count);
    const std::uint32_t present = (1u << count) - 1;
    texels[0] = {bits(x.origin), bits(y.origin), bits(z.origin),
                 x.exponent | y.exponent << 8 | z.exponent << 16 | present << 24};
    texels[1] = wordsOf(x);
    texels[2] = wordsOf(y);
    texels[3] = wordsOf(z);
    texels[4] = {child[0], child[1], child[2], child[3]};
    texels[5] = {child[4], child[5], child[6], child[7]};
}

/// Nodes of a tree whose first one is node `firstNode` of the buffer; `leafCode(leaf)` is a leaf as the
/// shader reads it.
template <typename LeafCode>
std::vector<glm::uvec4> encodeNodes(std::span<const WideNode> nodes, std::uint32_t firstNode,
                                    const LeafCode& leafCode) {
    std::vector<glm::uvec4> texels(nodes.size() * nodeTexels);
    forEach(nodes.size(), [&](std::size_t i) {
        const WideNode& node = nodes[i];
        std::array<std::uint32_t, WideNode::width> child{};
        unsigned count = 0;
        for (; count < WideNode::width && node.child[count] != WideNode::noChild; ++count) {
            const std::uint32_t own = node.child[count];
            child[count] =
                (own & WideNode::leafFlag) != 0 ? leafCode(own & ~WideNode::leafFlag) : firstNode + own;
        }
        if (count > 0) encodeNode(node, count, child, &texels[i * nodeTexels]);
    });
    return texels;
}

/// A ray in the space of a mesh is rounded otherwise than in the world: the boxes of instances are wider by
/// four units in the last place of their largest coordinate.
void widen(WideNode& node) {
    constexpr float relative = 4.0f * std::numeric_limits<float>::epsilon();
    const auto widenAxis = [](float* low, float* high) {
        for (unsigned lane = 0; lane < WideNode::width; ++lane) {
            const float margin = relative * std::max(std::abs(low[lane]), std::abs(high[lane]));
            low[lane] -= margin;
            high[lane] += margin;
        }
    };
    widenAxis(node.minX, node.maxX);
    widenAxis(node.minY, node.maxY);
    widenAxis(node.minZ, node.maxZ);
}

/// The inverse of the linear part, by rows; none where it is singular or not finite.
std::optional<glm::mat3> inverseRows(const glm::mat4& worldFromLocal) {
    const glm::dvec3 x(worldFromLocal[0]), y(worldFromLocal[1]), z(worldFromLocal[2]);
    const glm::dvec3 cofactors[3] = {glm::cross(y, z), glm::cross(z, x), glm::cross(x, y)};
    const double determinant = glm::dot(x, cofactors[0]);
    if (determinant == 0.0) return std::nullopt;
    glm::mat3 rows;
    for (int row = 0; row < 3; ++row) {
        rows[row] = glm::vec3(cofactors[row] / determinant);
        for (int i = 0; i < 3; ++i) {
            if (!std::isfinite(rows[row][i]) || !std::isfinite(worldFromLocal[3][i])) return std::nullopt;
        }
    }
    return rows;
}

std::vector<std::uint32_t> packAlphas(const AlphaImage& image) {
    std::vector<std::uint32_t> words((image.alpha.size() + 3) / 4);
    for (std::size_t i = 0; i < image.alpha.size(); ++i)
        words[i / 4] |= std::uint32_t{image.alpha[i]} << 8 * (i % 4);
    return words;
}

void requireDepth(unsigned depth) {
    if (depth <= unsigned{layout::OCCLUSION_MAX_DEPTH}) return;
    throw Error(ErrorKind::limit, "",
                "a tree of occlusion rays is " + std::to_string(depth) + " nodes deep; shaders take " +
                    std::to_string(layout::OCCLUSION_MAX_DEPTH) + " at most");
}

void requireNodes(std::uint64_t nodes) {
    if (nodes <= maxNodes) return;
    throw Error(ErrorKind::limit, "",
                "the trees of occlusion rays have more than " + std::to_string(maxNodes) +
                    " nodes, as many as shaders take at most");
}

}  // namespace

GpuOcclusion::GpuOcclusion()
    : nodes_(GL_RGBA32UI, "occlusion nodes"),
      triangles_(GL_RGBA32UI, "occlusion triangles"),
      cutouts_(GL_RGBA32UI, "occlusion cut-outs"),
      alphas_(GL_R32UI, "occlusion alphas"),
      instances_(GL_RGBA32UI, instanceTexels, "occlusion instances") {
    setTree({}, 0, {});
}

void GpuOcclusion::release(Mesh& mesh) {
    nodes_.release(mesh.nodes);
    triangles_.release(mesh.triangles);
    cutouts_.release(mesh.cutouts);
    for (const auto& image : mesh.images) {
        const auto found = images_.find(image.get());
        if (--found->second.users > 0) continue;
        alphas_.release(found->second.words);
        images_.erase(found);
    }
    mesh = {};
}

void GpuOcclusion::addImage(const std::shared_ptr<const AlphaImage>& image) {
    Image& entry = images_[image.get()];
    if (++entry.users > 1) return;
    const std::vector<std::uint32_t> words = packAlphas(*image);
    entry.words = alphas_.allocate(static_cast<std::uint32_t>(words.size()));
    alphas_.write(entry.words, std::as_bytes(std::span(words)));
}

void GpuOcclusion::writeTriangles(const Mesh& mesh, const OcclusionMesh& from, const WideTree& tree) {
    const std::uint32_t firstCutout = mesh.cutouts.first / cutoutTexels;
    std::vector<glm::uvec4> texels(tree.primitives.size() * triangleTexels);
    forEach(tree.primitives.size(), [&](std::size_t i) {
        const std::uint32_t triangle = tree.primitives[i];
        const auto opaque = static_cast<std::uint32_t>(from.opaqueCount());
        const std::uint32_t cutout =
            triangle < opaque ? layout::OCCLUSION_NONE : firstCutout + (triangle - opaque);
        const glm::uvec3& corners = from.triangles[triangle];
        for (std::uint32_t k = 0; k < 3; ++k)
            texels[i * triangleTexels + k] = corner(from.positions[corners[static_cast<int>(k)]], cutout);
    });
    triangles_.write(mesh.triangles, std::as_bytes(std::span(texels)));
}

void GpuOcclusion::writeCutouts(const Mesh& mesh, const OcclusionMesh& from) {
    std::vector<glm::uvec4> texels(from.cutouts.size() * cutoutTexels);
    for (std::size_t i = 0; i < from.cutouts.size(); ++i) {
        const CutoutTriangle& cutout = from.cutouts[i];
        glm::uvec4* record = &texels[i * cutoutTexels];
        record[0] = {bits(cutout.uv[0].x), bits(cutout.uv[0].y), bits(cutout.uv[1].x), bits(cutout.uv[1].y)};
        record[1] = {bits(cutout.uv[2].x), bits(cutout.uv[2].y), bits(cutout.alpha[0]),
                     bits(cutout.alpha[1])};
        record[2] = {bits(cutout.alpha[2]), bits(cutout.cutoff), bits(cutout.transmitted), 0};
        const auto flags = static_cast<std::uint32_t>(cutout.wrapS) |
                           static_cast<std::uint32_t>(cutout.wrapT) << layout::OCCLUSION_WRAP_T_SHIFT |
                           (cutout.nearest ? layout::OCCLUSION_NEAREST : 0u) |
                           (cutout.blends ? layout::OCCLUSION_BLENDS : 0u);
        record[3] = {layout::OCCLUSION_NONE, 1, 1, flags};
        if (cutout.image == CutoutTriangle::noImage) continue;
        const AlphaImage& image = *from.images[cutout.image];
        record[3] = {images_.at(&image).words.first, image.width, image.height, flags};
    }
    cutouts_.write(mesh.cutouts, std::as_bytes(std::span(texels)));
}

void GpuOcclusion::setMesh(std::uint32_t index, const OcclusionMesh& from, const WideTree& tree) {
    if (index >= meshes_.size()) meshes_.resize(index + 1);
    Mesh& mesh = meshes_[index];
    release(mesh);
    if (tree.empty()) return;
    requireDepth(tree.depth);
    try {
        mesh.nodes = nodes_.allocate(static_cast<std::uint32_t>(tree.nodes.size()) * nodeTexels);
        mesh.triangles =
            triangles_.allocate(static_cast<std::uint32_t>(tree.primitives.size()) * triangleTexels);
        mesh.cutouts = cutouts_.allocate(static_cast<std::uint32_t>(from.cutouts.size()) * cutoutTexels);
        const std::uint32_t firstNode = mesh.nodes.first / nodeTexels;
        requireNodes(std::uint64_t{firstNode} + tree.nodes.size());
        for (const auto& image : from.images) {
            mesh.images.push_back(image);
            addImage(image);
        }
        const std::uint32_t firstTriangle = mesh.triangles.first / triangleTexels;
        const std::vector<glm::uvec4> nodes =
            encodeNodes(tree.nodes, firstNode, [&](std::uint32_t leafIndex) {
                const WideTree::Leaf& leaf = tree.leaves[leafIndex];
                return layout::OCCLUSION_LEAF | (leaf.count - 1) << layout::OCCLUSION_LEAF_COUNT_SHIFT |
                       (firstTriangle + leaf.first);
            });
        nodes_.write(mesh.nodes, std::as_bytes(std::span(nodes)));
        writeTriangles(mesh, from, tree);
        writeCutouts(mesh, from);
    } catch (...) {
        release(mesh);
        throw;
    }
}

void GpuOcclusion::setInstance(std::uint32_t index, const OcclusionInstance& instance) {
    if (index + 2 > instances_.size()) instances_.grow(index + 2);
    const std::span<glm::uvec4> record = instances_.edit(index + 1);
    const std::optional<glm::mat3> rows = inverseRows(instance.worldFromLocal);
    const bool isTraced = rows && instance.mesh < meshes_.size() && meshes_[instance.mesh].nodes.count > 0;
    record[3].x = isTraced ? meshes_[instance.mesh].nodes.first / nodeTexels : layout::OCCLUSION_NONE;
    if (!isTraced) return;
    for (int row = 0; row < 3; ++row) {
        record[static_cast<std::size_t>(row)] = corner((*rows)[row], bits(instance.worldFromLocal[3][row]));
    }
}

void GpuOcclusion::setRoot(std::uint32_t node) {
    if (instances_.size() == 0) instances_.grow(1);
    instances_.edit(0)[0].x = node;
    instances_.upload();
}

void GpuOcclusion::setTree(std::span<const WideNode> nodes, unsigned depth,
                           const InstanceTree::Changes& changes) {
    const auto needed = static_cast<std::uint32_t>(nodes.size()) * nodeTexels;
    const bool fits = needed <= upper_.count;
    if (!fits || nodes.empty()) nodes_.release(std::exchange(upper_, {}));
    if (nodes.empty()) return setRoot(layout::OCCLUSION_NONE);
    try {
        requireDepth(depth);
        // Room for the nodes that insertions add.
        if (!fits) upper_ = nodes_.allocate(needed + needed / (8 * nodeTexels) * nodeTexels);
        requireNodes(std::uint64_t{upper_.first / nodeTexels} + nodes.size());
    } catch (...) {
        setRoot(layout::OCCLUSION_NONE);
        throw;
    }
    if (!fits || changes.all) {
        writeNodes(nodes, 0);
    } else {
        // Nodes between two changed ones are sent along where that takes less than another call.
        constexpr std::uint32_t maxGap = 16;
        const std::vector<std::uint32_t>& changed = changes.nodes;
        for (std::size_t first = 0, last = 0; first < changed.size(); first = last + 1) {
            for (last = first; last + 1 < changed.size() && changed[last + 1] - changed[last] <= maxGap;)
                ++last;
            writeNodes(nodes.subspan(changed[first], changed[last] - changed[first] + 1), changed[first]);
        }
    }
    setRoot(upper_.first / nodeTexels);
}

/// `nodes` are those from `first` on of the tree over instances.
void GpuOcclusion::writeNodes(std::span<const WideNode> nodes, std::uint32_t first) {
    std::vector<WideNode> widened(nodes.begin(), nodes.end());
    for (WideNode& node : widened) widen(node);
    const std::vector<glm::uvec4> texels =
        encodeNodes(widened, upper_.first / nodeTexels,
                    [](std::uint32_t instance) { return layout::OCCLUSION_LEAF | instance; });
    nodes_.write({upper_.first + first * nodeTexels, static_cast<std::uint32_t>(texels.size())},
                 std::as_bytes(std::span(texels)));
}

void GpuOcclusion::bind() const {
    glBindTextureUnit(layout::OCCLUSION_NODES_UNIT, nodes_.texture());
    glBindTextureUnit(layout::OCCLUSION_TRIANGLES_UNIT, triangles_.texture());
    glBindTextureUnit(layout::OCCLUSION_INSTANCES_UNIT, instances_.texture().name());
    glBindTextureUnit(layout::OCCLUSION_CUTOUTS_UNIT, cutouts_.texture());
    glBindTextureUnit(layout::OCCLUSION_ALPHAS_UNIT, alphas_.texture());
}

std::uint64_t GpuOcclusion::bytes() const {
    return nodes_.bytes() + triangles_.bytes() + cutouts_.bytes() + alphas_.bytes() +
           instances_.texels().size_bytes();
}

}  // namespace candela
