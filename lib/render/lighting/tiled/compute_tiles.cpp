#include "render/lighting/tiled/compute_tiles.h"

#include "render/gbuffer/readback.h"
#include "render/layout.h"

#include <candela/error.h>

#include <algorithm>
#include <vector>

namespace candela {

namespace {

constexpr int tilePixels = 8;     // TILE of shaders/lib/tiles.glsl
constexpr int scatterGroup = 64;  // lights a group of tile_fill.comp
constexpr std::size_t boxBytes = 32;
constexpr std::size_t totalBytes = 16;
constexpr std::size_t groupBytes = 12;  // of an indirect dispatch
constexpr std::size_t entryBytes = sizeof(std::uint32_t);
constexpr std::size_t initialListBytes = entryBytes << 20;

int localLights(const LightCounts& counts) {
    return counts.points + counts.spots;
}

/// The maximum number of parts into which a list of `lights` falls; the directional lights fall into as many.
std::size_t partsOf(int lights, const LightCounts& counts, int partLights) {
    return static_cast<std::size_t>((std::max({lights, counts.directionals, 1}) - 1) / partLights + 1);
}

void storageBarrier() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

/// Also after shaders have written to the buffer.
void clear(const gl::Buffer& buffer, std::size_t bytes) {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glClearNamedBufferSubData(buffer.name(), GL_R32UI, 0, static_cast<GLsizeiptr>(bytes), GL_RED_INTEGER,
                              GL_UNSIGNED_INT, nullptr);
}

std::size_t maxStorageBlock() {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return static_cast<std::size_t>(bytes);
}

}  // namespace

ComputeTiles::ComputeTiles(std::size_t maxListBytes, LightsPerInvocation limit)
    : boxes_({{"tile_boxes.comp", {}, {}}}, "tile boxes"),
      count_({{"tile_fill.comp", {"FILL 0"}, {}}}, "tile count"),
      prefix_({{"tile_prefix.comp", {}, {}}}, "tile prefix sum"),
      fill_({{"tile_fill.comp", {"FILL 1"}, {}}}, "tile fill"),
      shade_("", "tile_shade.comp", {"LOAD_RADIANCE 0"}),
      addLight_("", "tile_shade.comp", {"LOAD_RADIANCE 1"}),
      boxBuffer_("tile boxes", gl::BufferUsage::device),
      countBuffer_("tile counts", gl::BufferUsage::device),
      startBuffer_("tile starts", gl::BufferUsage::device),
      listBuffer_("tile lists", gl::BufferUsage::device),
      totalBuffer_("tile total", gl::BufferUsage::device),
      groupBuffer_("tile groups", gl::BufferUsage::device),
      readbackBuffer_("tile total, read back", gl::BufferUsage::readback),
      maxListBytes_(std::min(maxListBytes, maxStorageBlock())),
      limit_(limit) {
    listBuffer_.reserve(std::min(initialListBytes, maxListBytes_));
    totalBuffer_.reserve(totalBytes);
    readbackBuffer_.reserve(totalBytes);
}

ComputeTiles::~ComputeTiles() {
    if (totalCopied_ != nullptr) glDeleteSync(totalCopied_);
}

ComputeTiles::Grid ComputeTiles::gridOf(const LightingInputs& inputs) {
    return {static_cast<GLuint>((inputs.targets.width + tilePixels - 1) / tilePixels),
            static_cast<GLuint>((inputs.targets.height + tilePixels - 1) / tilePixels)};
}

ComputeTiles::LightSpan ComputeTiles::spanOf(std::uint32_t index, const LightCounts& counts) const {
    const std::int64_t lights = localLights(counts);
    return {static_cast<int>(lights * index / spans_), static_cast<int>(lights * (index + 1) / spans_)};
}

void ComputeTiles::growLists(std::size_t bytes) {
    const std::size_t before = listBuffer_.capacity();
    try {
        listBuffer_.reserve(bytes);
    } catch (const Error&) {
        // The device has no memory for more: the previous size is the maximum from now on. OpenGL leaves the
        // buffer undefined after such an error.
        maxListBytes_ = before;
        listBuffer_ = gl::Buffer("tile lists", gl::BufferUsage::device);
        listBuffer_.reserve(before);
    }
}

void ComputeTiles::adaptLists() {
    if (totalCopied_ == nullptr ||
        glClientWaitSync(totalCopied_, GL_SYNC_FLUSH_COMMANDS_BIT, 0) == GL_TIMEOUT_EXPIRED)
        return;
    glDeleteSync(totalCopied_);
    totalCopied_ = nullptr;
    std::uint32_t entries = 0;
    glGetNamedBufferSubData(readbackBuffer_.name(), 0, sizeof entries, &entries);
    const std::size_t needed = std::size_t{entries} * entryBytes;
    // A quarter more, so that a scene that grows slowly does not outgrow its lists every frame.
    if (needed > listBuffer_.capacity()) growLists(std::min(needed + needed / 4, maxListBytes_));
    if (needed > listBuffer_.capacity()) {
        const std::size_t factor = needed / std::max<std::size_t>(listBuffer_.capacity(), 1) + 1;
        spans_ = static_cast<std::uint32_t>(std::min<std::size_t>(spans_ * factor, 1u << 20));
    } else if (spans_ > 1 && needed < listBuffer_.capacity() / 4) {
        spans_ = (spans_ + 1) / 2;
    }
}

void ComputeTiles::bindStorage(const Grid& grid, const LightingInputs& inputs) {
    const LightCounts& counts = inputs.lights.counts();
    groupBuffer_.reserve(partsOf(localLights(counts), counts, limit_.of(inputs)) * groupBytes);
    boxBuffer_.reserve(grid.tiles() * boxBytes);
    countBuffer_.reserve(grid.tiles() * entryBytes);
    startBuffer_.reserve(grid.tiles() * entryBytes);
    const auto bind = [](int binding, const gl::Buffer& buffer) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), buffer.name());
    };
    bind(layout::TILE_BOXES_STORAGE, boxBuffer_);
    bind(layout::TILE_COUNTS_STORAGE, countBuffer_);
    bind(layout::TILE_STARTS_STORAGE, startBuffer_);
    bind(layout::TILE_LISTS_STORAGE, listBuffer_);
    bind(layout::TILE_TOTAL_STORAGE, totalBuffer_);
    bind(layout::TILE_GROUPS_STORAGE, groupBuffer_);
}

/// Also sets the counts to 0.
void ComputeTiles::findBoxes(const Grid& grid) const {
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glUseProgram(boxes_.name());
    glDispatchCompute(grid.columns, grid.rows, 1);
    storageBarrier();
}

void ComputeTiles::scatter(const gl::Program& program, const LightSpan& span) const {
    glUseProgram(program.name());
    glUniform2i(layout::LIGHT_SPAN_LOCATION, span.first, span.end);
    // Every device takes 65,535 groups in one dispatch.
    constexpr int maxLights = 65535 * scatterGroup;
    for (int first = span.first; first < span.end; first += maxLights) {
        const int lights = std::min(maxLights, span.end - first);
        glUniform1i(layout::FIRST_LIGHT_LOCATION, first);
        glDispatchCompute(static_cast<GLuint>((lights + scatterGroup - 1) / scatterGroup), 1, 1);
    }
    storageBarrier();
}

void ComputeTiles::fillLists(const LightSpan& span, int partLights) const {
    scatter(count_, span);
    glUseProgram(prefix_.name());
    glUniform2i(layout::LIGHT_SPAN_LOCATION, span.first, span.end);
    glUniform1i(layout::LIST_PART_LOCATION, partLights);
    glDispatchCompute(1, 1, 1);
    storageBarrier();
    scatter(fill_, span);
}

void ComputeTiles::shade(const LightingInputs& inputs, const LightSpan& span) const {
    glBindImageTexture(layout::RADIANCE_IMAGE, inputs.targets.radiance.name(), 0, GL_FALSE, 0, GL_READ_WRITE,
                       GL_RGBA32F);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groupBuffer_.name());
    // The geometry pass has written emission as a framebuffer; it is loaded as an image.
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    const int partLights = limit_.of(inputs);
    const std::size_t parts = partsOf(span.count(), inputs.lights.counts(), partLights);
    for (std::size_t part = 0; part < parts; ++part) {
        const bool loadRadiance = inputs.emissionDrawn || part > 0 || span.first > 0;
        glUseProgram((loadRadiance ? addLight_ : shade_).get(inputs).name());
        glUniform2i(layout::LIGHT_SPAN_LOCATION, span.first, span.end);
        glUniform2i(layout::LIST_PART_LOCATION, static_cast<GLint>(part), partLights);
        glDispatchComputeIndirect(static_cast<GLintptr>(part * groupBytes));
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    }
}

void ComputeTiles::copyTotal() {
    if (totalCopied_ != nullptr) return;
    glCopyNamedBufferSubData(totalBuffer_.name(), readbackBuffer_.name(), 0, 0, totalBytes);
    totalCopied_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

void ComputeTiles::render(const LightingInputs& inputs, gl::PassTimer& timer) {
    const gl::PassTimer::Scope pass(timer, "lighting");
    const Grid grid = gridOf(inputs);
    const LightCounts& counts = inputs.lights.counts();
    adaptLists();
    bindStorage(grid, inputs);
    clear(totalBuffer_, totalBytes);
    findBoxes(grid);
    for (std::uint32_t i = 0; i < spans_; ++i) {
        const LightSpan span = spanOf(i, counts);
        if (i > 0 && span.count() == 0) continue;
        if (span.first > 0) clear(countBuffer_, grid.tiles() * entryBytes);
        fillLists(span, limit_.of(inputs));
        shade(inputs, span);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
    copyTotal();
}

std::uint64_t ComputeTiles::countEvaluated(const LightingInputs& inputs, PairCounter&) {
    const Grid grid = gridOf(inputs);
    if (spans_ > 1) {
        // The counts are those of the last span only.
        bindStorage(grid, inputs);
        findBoxes(grid);
        scatter(count_, {0, localLights(inputs.lights.counts())});
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    }
    std::vector<std::uint32_t> counts(grid.tiles());
    glGetNamedBufferSubData(countBuffer_.name(), 0, static_cast<GLsizeiptr>(counts.size() * entryBytes),
                            counts.data());
    const std::vector<GBufferTexel> surfaces = readSurfaces(inputs.targets);
    const auto width = static_cast<std::size_t>(inputs.targets.width);
    std::uint64_t pairs = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const std::size_t tile = i / width / tilePixels * grid.columns + i % width / tilePixels;
        if (surfaces[i].y != 0) pairs += counts[tile];
    }
    return pairs;
}

std::uint64_t ComputeTiles::lightListBytes() const {
    std::uint32_t entries = 0;
    glGetNamedBufferSubData(totalBuffer_.name(), 0, sizeof entries, &entries);
    return std::min(std::uint64_t{entries} * entryBytes, std::uint64_t{listBuffer_.capacity()}) +
           startBuffer_.capacity() + countBuffer_.capacity();
}

}  // namespace candela
