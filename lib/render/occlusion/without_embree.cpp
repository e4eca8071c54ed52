// What a library without shadows (CMake option CANDELA_SHADOWS) has in place of what needs Embree. Renderers
// refuse to draw shadows then, so that none of this is called.

#include "render/occlusion/embree_scene.h"
#include "render/occlusion/wide_tree.h"

#include <candela/error.h>

namespace candela {

namespace {

[[noreturn]] void refuse() {
    throw Error(ErrorKind::environment, "", "this candela was built without shadows");
}

}  // namespace

struct EmbreeScene::State {};

EmbreeScene::EmbreeScene() {
    refuse();
}
EmbreeScene::~EmbreeScene() = default;
void EmbreeScene::setMesh(std::uint32_t, std::shared_ptr<const OcclusionMesh>) {}
void EmbreeScene::setInstance(std::uint32_t, const OcclusionInstance&) {}
void EmbreeScene::disableInstance(std::uint32_t) {}
void EmbreeScene::commit() {}
std::uint64_t EmbreeScene::bytes() const {
    return 0;
}
std::uint32_t EmbreeScene::tracePacket(const void*, const RayPacket&, float*) {
    return 0;
}

std::size_t WideTree::bytes() const {
    return 0;
}
WideTree buildWideTree(std::span<const Bounds>, unsigned) {
    refuse();
}
WideTree buildWideTree(const TriangleSpan&) {
    refuse();
}
void refit(WideTree&, const TriangleSpan&) {}
void fillTriangleBlocks(const WideTree&, const TriangleSpan&, std::vector<TriangleBlock>&) {}

}  // namespace candela
