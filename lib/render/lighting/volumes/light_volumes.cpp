#include "render/lighting/volumes/light_volumes.h"

#include "render/layout.h"
#include "render/lighting/pair_counter.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace candela {

namespace {

/// `position` is in units of the picture's width or height.
int cellOf(float position, int cells) {
    return std::clamp(static_cast<int>(position * static_cast<float>(cells)), 0, cells - 1);
}

/// The icosahedron in the unit sphere: 12 vertices, 20 triangles.
SphereProxy icosahedron() {
    // Half the sides of the golden rectangle whose corners lie on the unit sphere.
    constexpr float a = 0.525731f, b = 0.850651f;
    return {{{-a, b, 0},
             {a, b, 0},
             {-a, -b, 0},
             {a, -b, 0},
             {0, -a, b},
             {0, a, b},
             {0, -a, -b},
             {0, a, -b},
             {b, 0, -a},
             {b, 0, a},
             {-b, 0, -a},
             {-b, 0, a}},
            {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
             {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
             {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// The distance of the nearest face from the origin.
float innerRadius(const SphereProxy& proxy) {
    float nearest = 1.0f;
    for (const auto& [i, j, k] : proxy.triangles) {
        const glm::vec3 &p = proxy.vertices[i], &q = proxy.vertices[j], &r = proxy.vertices[k];
        nearest = std::min(nearest, glm::dot(glm::normalize(glm::cross(q - p, r - p)), p));
    }
    return nearest;
}

/// Software rasterisers pay more for a triangle than for the pixels that a rounder proxy would save.
SphereProxy makeSphereProxy() {
    SphereProxy proxy = icosahedron();
    // A margin for the rounding of vertices in the shader.
    const float scale = 1.0001f / innerRadius(proxy);
    for (glm::vec3& vertex : proxy.vertices) vertex *= scale;
    proxy.radius = scale;
    return proxy;
}

/// A far plane would cut off the back faces of volumes that reach beyond it.
class DepthClamp {
  public:
    explicit DepthClamp(bool needed) : needed_(needed) {
        if (needed_) glEnable(GL_DEPTH_CLAMP);
    }
    DepthClamp(const DepthClamp&) = delete;
    DepthClamp& operator=(const DepthClamp&) = delete;
    ~DepthClamp() {
        if (needed_) glDisable(GL_DEPTH_CLAMP);
    }

  private:
    bool needed_;
};

}  // namespace

std::uint32_t LightBatches::freeBatch(const Frustum::Rectangle& bounds) {
    const int left = cellOf(bounds.min.x, columns_), right = cellOf(bounds.max.x, columns_);
    const int bottom = cellOf(bounds.min.y, rows_), top = cellOf(bounds.max.y, rows_);
    std::array<std::uint64_t, batchWords> used{};
    const auto words = [&](int column, int row) {
        return taken_.data() + (static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                static_cast<std::size_t>(column)) *
                                   batchWords;
    };
    for (int row = bottom; row <= top; ++row) {
        for (int column = left; column <= right; ++column) {
            const std::uint64_t* cell = words(column, row);
            for (std::uint32_t w = 0; w < batchWords; ++w) used[w] |= cell[w];
        }
    }
    const auto word =
        std::ranges::find_if(used, [](std::uint64_t bits) { return bits != ~std::uint64_t{0}; });
    if (word == used.end()) return batchWords * 64;
    const auto w = static_cast<std::uint32_t>(word - used.begin());
    const auto bit = static_cast<std::uint32_t>(std::countr_one(*word));
    for (int row = bottom; row <= top; ++row) {
        for (int column = left; column <= right; ++column) words(column, row)[w] |= std::uint64_t{1} << bit;
    }
    return w * 64 + bit;
}

void LightBatches::assign(const Input& input) {
    columns_ = (input.width + cellSize - 1) / cellSize;
    rows_ = (input.height + cellSize - 1) / cellSize;
    taken_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) * batchWords, 0);
    for (auto& batch : batches_) batch.clear();
    unsorted_.clear();
    // Bounds are widened by one pixel for the rounding of the rasteriser.
    const glm::vec2 pixel = 1.0f / glm::vec2(input.width, input.height);
    for (std::size_t i = input.first; i < input.end; ++i) {
        const glm::vec3 center = input.reaches.position(i);
        const float range = input.reaches.range[i], radius = range * input.proxyRadius;
        if (!input.frustum.meets(center, range)) continue;
        const auto light = static_cast<std::uint32_t>(i);
        if (input.frustum.meetsNearPlane(center, radius)) {
            unsorted_.push_back(light);
            continue;
        }
        Frustum::Rectangle bounds = input.frustum.projectedBounds(center, radius);
        const std::uint32_t batch = freeBatch({bounds.min - pixel, bounds.max + pixel});
        if (batch == batchWords * 64) {
            unsorted_.push_back(light);
            continue;
        }
        if (batch >= batches_.size()) batches_.resize(batch + 1);
        batches_[batch].push_back(light);
    }
    lights_.clear();
    ends_.clear();
    for (const auto& batch : batches_) {
        if (batch.empty()) break;
        lights_.insert(lights_.end(), batch.begin(), batch.end());
        ends_.push_back(static_cast<std::uint32_t>(lights_.size()));
    }
    lights_.insert(lights_.end(), unsorted_.begin(), unsorted_.end());
}

LightVolumes::LightVolumes()
    : proxy_(makeSphereProxy()),
      mark_({{"light_volume.vert", {}, {}}, {"light_volume_mark.frag", {}, {}}}, "light volume mark"),
      vertices_(gl::Buffer::immutable("light volume vertices", std::span<const glm::vec3>(proxy_.vertices))),
      triangles_(gl::Buffer::immutable("light volume triangles",
                                       std::span<const std::array<std::uint32_t, 3>>(proxy_.triangles))),
      indexBuffer_("light volume lights", gl::BufferUsage::dynamic),
      vertexArray_("light volumes") {
    const GLuint name = vertexArray_.name();
    glVertexArrayElementBuffer(name, triangles_.name());
    glVertexArrayVertexBuffer(name, 0, vertices_.name(), 0, sizeof(glm::vec3));
    glEnableVertexArrayAttrib(name, layout::POSITION_ATTRIBUTE);
    glVertexArrayAttribFormat(name, layout::POSITION_ATTRIBUTE, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(name, layout::POSITION_ATTRIBUTE, 0);
    glVertexArrayVertexBuffer(name, 1, indexBuffer_.name(), 0, sizeof(std::uint32_t));
    glVertexArrayBindingDivisor(name, 1, 1);
    glEnableVertexArrayAttrib(name, layout::LIGHT_ATTRIBUTE);
    glVertexArrayAttribIFormat(name, layout::LIGHT_ATTRIBUTE, 1, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribBinding(name, layout::LIGHT_ATTRIBUTE, 1);
}

LightVolumes::Kind LightVolumes::append(const LightingInputs& inputs, std::uint32_t firstLight,
                                        std::uint32_t count) {
    batches_.assign({inputs.lights.reaches(), firstLight, firstLight + count, inputs.frustum, proxy_.radius,
                     inputs.targets.width, inputs.targets.height});
    const auto start = static_cast<std::uint32_t>(lightIndices_.size());
    lightIndices_.insert(lightIndices_.end(), batches_.lights().begin(), batches_.lights().end());
    Kind kind;
    std::uint32_t first = 0;
    for (const std::uint32_t end : batches_.batchEnds()) {
        kind.batches.push_back({start + first, end - first});
        first = end;
    }
    const auto total = static_cast<std::uint32_t>(batches_.lights().size());
    kind.unsorted = {start + first, total - first};
    kind.all = {start, total};
    return kind;
}

std::uint32_t LightVolumes::prepare(const LightingInputs& inputs) {
    hasFarPlane_ = inputs.uniforms.depthRange.x > 0.0f || inputs.uniforms.depthRange.w > 0.0f;
    const LightCounts& counts = inputs.lights.counts();
    lightIndices_.clear();
    points_ = append(inputs, 0, static_cast<std::uint32_t>(counts.points));
    spots_ =
        append(inputs, static_cast<std::uint32_t>(counts.points), static_cast<std::uint32_t>(counts.spots));
    indexBuffer_.upload(std::span<const std::uint32_t>(lightIndices_));
    return static_cast<std::uint32_t>(lightIndices_.size());
}

void LightVolumes::draw(const Run& run) const {
    glDrawElementsInstancedBaseInstance(GL_TRIANGLES, static_cast<GLsizei>(3 * proxy_.triangles.size()),
                                        GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(run.count), run.first);
}

void LightVolumes::drawInside(const gl::Program& pointProgram, const gl::Program& spotProgram) const {
    drawKind(points_, pointProgram);
    drawKind(spots_, spotProgram);
}

void LightVolumes::drawKind(const Kind& kind, const gl::Program& program) const {
    if (kind.all.count == 0) return;
    const DepthClamp clamp(hasFarPlane_);
    glBindVertexArray(vertexArray_.name());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_CULL_FACE);
    glEnable(GL_STENCIL_TEST);
    glBlendFunc(GL_ONE, GL_ONE);
    for (const Run& batch : kind.batches) {
        glUseProgram(mark_.name());
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDisable(GL_BLEND);
        glCullFace(GL_BACK);
        glDepthFunc(GL_GEQUAL);
        glStencilFunc(GL_ALWAYS, 1, 0xff);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        draw(batch);
        glUseProgram(program.name());
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glEnable(GL_BLEND);
        glCullFace(GL_FRONT);
        glDepthFunc(GL_LEQUAL);
        glStencilFunc(GL_EQUAL, 1, 0xff);
        glStencilOp(GL_KEEP, GL_ZERO, GL_ZERO);
        draw(batch);
    }
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_BLEND);
    glUseProgram(program.name());
    glCullFace(GL_FRONT);
    glDepthFunc(GL_LEQUAL);
    if (kind.unsorted.count > 0) draw(kind.unsorted);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

void LightVolumes::drawBackFaces(const gl::Program& pointProgram, const gl::Program& spotProgram) const {
    const DepthClamp clamp(hasFarPlane_);
    glBindVertexArray(vertexArray_.name());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glUseProgram(pointProgram.name());
    if (points_.all.count > 0) draw(points_.all);
    glUseProgram(spotProgram.name());
    if (spots_.all.count > 0) draw(spots_.all);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

StencilledDepth::StencilledDepth()
    : copy_({{"fullscreen_triangle.vert", {}, {}}, {"depth_copy.frag", {}, {}}}, "depth copy"),
      vertexArray_("depth copy") {}

void StencilledDepth::resize(const GBufferTargets& targets, const gl::Texture& color) {
    if (sized_ && sized_->width == targets.width && sized_->height == targets.height) {
        // The driver reuses the names of deleted textures: an equal name does not say that it is the same
        // texture, so that each frame attaches its own.
        glNamedFramebufferTexture(sized_->framebuffer.name(), GL_COLOR_ATTACHMENT0, color.name(), 0);
        return;
    }
    gl::Texture texture =
        gl::Texture::target2d(GL_DEPTH32F_STENCIL8, targets.width, targets.height, "depth and stencil");
    gl::Framebuffer framebuffer({&color}, &texture, "light volumes");
    sized_ = Sized{targets.width, targets.height, std::move(texture), std::move(framebuffer)};
}

void StencilledDepth::bind(const GBufferTargets& targets, const gl::Texture& color) {
    resize(targets, color);
    const GLuint name = sized_->framebuffer.name();
    glClearNamedFramebufferfi(name, GL_DEPTH_STENCIL, 0, 0.0f, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
    glViewport(0, 0, targets.width, targets.height);
    glUseProgram(copy_.name());
    glBindVertexArray(vertexArray_.name());
    glBindTextureUnit(layout::DEPTH_UNIT, targets.depth.name());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

VolumesTechnique::VolumesTechnique(const FullscreenPass& fullscreen)
    : fullscreen_(fullscreen),
      pointPrograms_("light_volume.vert", "light_volume.frag", {"SPOT 0"}),
      spotPrograms_("light_volume.vert", "light_volume.frag", {"SPOT 1"}) {}

void VolumesTechnique::render(const LightingInputs& inputs, gl::PassTimer& timer) {
    const gl::PassTimer::Scope pass(timer, "lighting");
    if (volumes_.prepare(inputs) > 0) {
        depth_.bind(inputs.targets, inputs.targets.radiance);
        volumes_.drawInside(pointPrograms_.get(inputs), spotPrograms_.get(inputs));
    }
    fullscreen_.addDirectionals(inputs);
}

std::uint64_t VolumesTechnique::countEvaluated(const LightingInputs& inputs, PairCounter& counter) {
    return counter.countInside(inputs);
}

}  // namespace candela
