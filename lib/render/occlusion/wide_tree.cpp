#include "render/occlusion/wide_tree.h"

#include "base/thread_pool.h"

#include <candela/error.h>
#include <candela/threads.h>

#include <embree3/rtcore.h>

#include <algorithm>
#include <cassert>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>

namespace candela {

namespace {

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseBvh {
    void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
};
using Device = std::shared_ptr<std::remove_pointer_t<RTCDevice>>;
using Bvh = std::unique_ptr<std::remove_pointer_t<RTCBVH>, ReleaseBvh>;

/// The device that builds, with the threads of the library.
Device builder() {
    static std::mutex mutex;
    static Device device;
    static unsigned threads = 0;
    const std::lock_guard lock(mutex);
    if (device && threads == threadCount()) return device;
    threads = threadCount();
    device = Device(rtcNewDevice(("threads=" + std::to_string(threads)).c_str()), ReleaseDevice{});
    return device;
}

/// How much of a tree is below a node, itself included.
struct Content {
    std::size_t nodes = 0, leaves = 0, primitives = 0;
    unsigned depth = 0;  ///< In nodes.

    void add(const Content& child) {
        nodes += child.nodes;
        leaves += child.leaves;
        primitives += child.primitives;
        depth = std::max(depth, child.depth + 1);
    }
};

/// Nodes and leaves as Embree's builder makes them, in its own memory. Children are made before their node is
/// told of them.
struct BuiltNode {
    WideNode node;
    const void* children[WideNode::width];
    unsigned count;
    Content content;
};
struct BuiltLeaf {
    unsigned count;
    std::uint32_t primitives[WideNode::width];
};

/// Leaves have odd addresses, which tells them from nodes.
constexpr std::uintptr_t leafBit = 1;

bool isLeaf(const void* built) {
    return (reinterpret_cast<std::uintptr_t>(built) & leafBit) != 0;
}

const BuiltNode& nodeAt(const void* built) {
    return *static_cast<const BuiltNode*>(built);
}

const BuiltLeaf& leafAt(const void* built) {
    return *reinterpret_cast<const BuiltLeaf*>(reinterpret_cast<std::uintptr_t>(built) & ~leafBit);
}

Content contentOf(const void* built) {
    return isLeaf(built) ? Content{0, 1, leafAt(built).count, 0} : nodeAt(built).content;
}

void* createNode(RTCThreadLocalAllocator allocator, unsigned childCount, void*) {
    auto* built =
        static_cast<BuiltNode*>(rtcThreadLocalAlloc(allocator, sizeof(BuiltNode), alignof(BuiltNode)));
    built->count = childCount;
    for (unsigned lane = childCount; lane < WideNode::width; ++lane) setMissing(built->node, lane);
    return built;
}

void setNodeChildren(void* node, void** children, unsigned childCount, void*) {
    BuiltNode& built = *static_cast<BuiltNode*>(node);
    built.content = {1, 0, 0, 1};
    for (unsigned lane = 0; lane < childCount; ++lane) {
        built.children[lane] = children[lane];
        built.content.add(contentOf(children[lane]));
    }
}

void setNodeBounds(void* node, const RTCBounds** bounds, unsigned childCount, void*) {
    for (unsigned lane = 0; lane < childCount; ++lane) {
        const RTCBounds& box = *bounds[lane];
        setChildBounds(static_cast<BuiltNode*>(node)->node, lane,
                       {{box.lower_x, box.lower_y, box.lower_z}, {box.upper_x, box.upper_y, box.upper_z}});
    }
}

void* createLeaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count,
                 void*) {
    auto* leaf = static_cast<BuiltLeaf*>(rtcThreadLocalAlloc(allocator, sizeof(BuiltLeaf), 16));
    leaf->count = static_cast<unsigned>(count);
    for (std::size_t i = 0; i < count; ++i) leaf->primitives[i] = primitives[i].primID;
    return reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(leaf) | leafBit);
}

/// Copies what Embree has built into the arrays of a tree, depth first.
class Flattening {
  public:
    explicit Flattening(WideTree& tree) : tree_(tree) {}

    void addRoot(const void* root) {
        const Content content = contentOf(root);
        tree_.nodes.reserve(std::max<std::size_t>(content.nodes, 1));
        tree_.leaves.reserve(content.leaves);
        tree_.primitives.reserve(content.primitives);
        tree_.depth = std::max(content.depth, 1u);
        if (isLeaf(root)) {
            addNodeOfLeaf(root);
        } else {
            addNode(nodeAt(root));
        }
    }

  private:
    void addNodeOfLeaf(const void* leaf) {
        WideNode& node = tree_.nodes.emplace_back();
        for (unsigned lane = 1; lane < WideNode::width; ++lane) setMissing(node, lane);
        setChildBounds(node, 0, tree_.bounds);
        node.child[0] = addLeaf(leafAt(leaf));
    }

    std::uint32_t addNode(const BuiltNode& built) {
        const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.push_back(built.node);
        for (unsigned lane = 0; lane < built.count; ++lane) {
            const void* child = built.children[lane];
            const std::uint32_t added = isLeaf(child) ? addLeaf(leafAt(child)) : addNode(nodeAt(child));
            tree_.nodes[index].child[lane] = added;
        }
        return index;
    }

    std::uint32_t addLeaf(const BuiltLeaf& leaf) {
        tree_.leaves.push_back({static_cast<std::uint32_t>(tree_.primitives.size()), leaf.count});
        tree_.primitives.insert(tree_.primitives.end(), leaf.primitives, leaf.primitives + leaf.count);
        return WideNode::leafFlag | static_cast<std::uint32_t>(tree_.leaves.size() - 1);
    }

    WideTree& tree_;
};

[[noreturn]] void failToBuild(std::size_t primitives) {
    throw Error(ErrorKind::limit, "",
                "there is not enough memory for the tree of " + std::to_string(primitives) +
                    " primitives that rays are traced in");
}

/// From here on a tree by Morton order is built: it takes a fifth of the time.
constexpr std::size_t largeCount = std::size_t{1} << 17;

/// In a tree by surface areas rays, and blocks of rays, visit a quarter fewer nodes than in one by Morton
/// order.
RTCBuildArguments buildArguments(std::size_t count, unsigned maxLeaf) {
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = count < largeCount ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_LOW;
    arguments.maxBranchingFactor = WideNode::width;
    arguments.maxDepth = WideTree::maxDepth;
    arguments.minLeafSize = maxLeaf;
    arguments.maxLeafSize = maxLeaf;
    arguments.sahBlockSize = maxLeaf;
    arguments.createNode = createNode;
    arguments.setNodeChildren = setNodeChildren;
    arguments.setNodeBounds = setNodeBounds;
    arguments.createLeaf = createLeaf;
    return arguments;
}

/// What Embree builds from; it reorders the primitives.
struct BuildInput {
    std::unique_ptr<RTCBuildPrimitive[]> primitives;
    std::size_t count = 0;
    Bounds bounds = invertedBounds;
};

/// `boxOf(i)` is the box of primitive i.
template <typename BoxOf>
BuildInput buildInput(std::size_t count, const BoxOf& boxOf) {
    BuildInput input{std::make_unique_for_overwrite<RTCBuildPrimitive[]>(count)};
    constexpr std::size_t run = 8192;
    std::mutex mutex;
    bool anyLeftOut = false;
    ThreadPool::shared()->run((count + run - 1) / run, [&](std::size_t part, unsigned) {
        Bounds bounds = invertedBounds;
        bool leavesOut = false;
        for (std::size_t i = part * run; i < std::min(count, (part + 1) * run); ++i) {
            Bounds box = boxOf(i);
            if (isTraceable(box)) {
                enclose(bounds, box);
            } else {
                box = invertedBounds;
                leavesOut = true;
            }
            input.primitives[i] = {box.min.x, box.min.y, box.min.z, 0,
                                   box.max.x, box.max.y, box.max.z, static_cast<unsigned>(i)};
        }
        const std::lock_guard lock(mutex);
        enclose(input.bounds, bounds);
        anyLeftOut = anyLeftOut || leavesOut;
    });
    RTCBuildPrimitive* first = input.primitives.get();
    const auto isLeftOut = [](const RTCBuildPrimitive& primitive) {
        return primitive.lower_x > primitive.upper_x;
    };
    input.count = anyLeftOut
                      ? static_cast<std::size_t>(std::remove_if(first, first + count, isLeftOut) - first)
                      : count;
    return input;
}

template <typename BoxOf>
WideTree build(std::size_t count, unsigned maxLeaf, const BoxOf& boxOf) {
    assert(maxLeaf >= 1 && maxLeaf <= WideNode::width);
    assert(count < WideNode::leafFlag);
    const BuildInput input = buildInput(count, boxOf);
    WideTree tree;
    if (input.count == 0) return tree;
    const Device device = builder();
    const Bvh bvh(device ? rtcNewBVH(device.get()) : nullptr);
    if (!bvh) failToBuild(count);
    RTCBuildArguments arguments = buildArguments(input.count, maxLeaf);
    arguments.bvh = bvh.get();
    arguments.primitives = input.primitives.get();
    arguments.primitiveCount = input.count;
    arguments.primitiveArrayCapacity = input.count;
    const void* root = rtcBuildBVH(&arguments);
    if (root == nullptr) failToBuild(count);
    tree.bounds = input.bounds;
    Flattening(tree).addRoot(root);
    return tree;
}

/// Children follow their parents, so that one pass backwards reads finished boxes only.
template <typename BoxOf>
void refitTree(WideTree& tree, const BoxOf& boxOf) {
    const auto leafBounds = [&](const WideTree::Leaf& leaf) {
        Bounds bounds = invertedBounds;
        for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
            const Bounds box = boxOf(tree.primitives[i]);
            if (isTraceable(box)) enclose(bounds, box);
        }
        return bounds;
    };
    for (auto node = tree.nodes.rbegin(); node != tree.nodes.rend(); ++node) {
        for (unsigned lane = 0; lane < WideNode::width && node->child[lane] != WideNode::noChild; ++lane) {
            const std::uint32_t child = node->child[lane];
            setChildBounds(*node, lane,
                           candela::isLeaf(child) ? leafBounds(tree.leaves[child & ~WideNode::leafFlag])
                                                  : boundsOf(tree.nodes[child]));
        }
    }
    if (!tree.empty()) tree.bounds = boundsOf(tree.nodes.front());
}

void fillBlock(const WideTree& tree, const WideTree::Leaf& leaf, const TriangleSpan& mesh,
               TriangleBlock& block) {
    for (std::uint32_t lane = 0; lane < TriangleBlock::width; ++lane) {
        const std::uint32_t triangle = tree.primitives[leaf.first + (lane < leaf.count ? lane : 0)];
        block.triangle[lane] = triangle;
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3& position = mesh.positions[mesh.triangles[triangle][corner]];
            block.x[corner][lane] = position.x;
            block.y[corner][lane] = position.y;
            block.z[corner][lane] = position.z;
        }
    }
}

}  // namespace

std::size_t WideTree::bytes() const {
    return nodes.size() * sizeof(WideNode) + leaves.size() * sizeof(Leaf) +
           primitives.size() * sizeof(std::uint32_t);
}

Bounds TriangleSpan::bounds(std::size_t triangle) const {
    const glm::uvec3& corners = triangles[triangle];
    const glm::vec3 &a = positions[corners.x], &b = positions[corners.y], &c = positions[corners.z];
    // glm::min would drop a NaN.
    if (!(a + b + c == a + b + c)) return invertedBounds;
    return {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
}

WideTree buildWideTree(std::span<const Bounds> boxes, unsigned maxLeaf) {
    return build(boxes.size(), maxLeaf, [&](std::size_t i) { return boxes[i]; });
}

WideTree buildWideTree(const TriangleSpan& triangles) {
    return build(triangles.triangles.size(), TriangleBlock::width,
                 [&](std::size_t i) { return triangles.bounds(i); });
}

void refit(WideTree& tree, std::span<const Bounds> boxes) {
    refitTree(tree, [&](std::size_t i) { return boxes[i]; });
}

void refit(WideTree& tree, const TriangleSpan& triangles) {
    refitTree(tree, [&](std::size_t i) { return triangles.bounds(i); });
}

void fillTriangleBlocks(const WideTree& tree, const TriangleSpan& triangles,
                        std::vector<TriangleBlock>& blocks) {
    blocks.resize(tree.leaves.size());
    constexpr std::size_t run = 1024;
    ThreadPool::shared()->run((blocks.size() + run - 1) / run, [&](std::size_t part, unsigned) {
        const std::size_t end = std::min(blocks.size(), (part + 1) * run);
        for (std::size_t i = part * run; i < end; ++i) fillBlock(tree, tree.leaves[i], triangles, blocks[i]);
    });
}

}  // namespace candela
