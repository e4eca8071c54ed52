#include "render/lighting/tiled/compute_tiles.h"

#include "render/gbuffer/readback.h"
#include "render/layout.h"

#include <algorithm>
#include <vector>

namespace candela {

namespace {

constexpr int tilePixels = 8;     // TILE of shaders/lib/tiles.glsl
constexpr int scatterGroup = 64;  // lights a group of tile_scatter.comp
constexpr std::size_t boxBytes = 32;
constexpr std::size_t totalBytes = 16;
constexpr std::size_t groupBytes = 12;  // of an indirect dispatch
constexpr std::size_t firstListEntries = std::size_t{1} << 20;

/// Into how many parts the longest list that there may be falls.
std::size_t partsOf(const LightCounts& counts) {
    return static_cast<std::size_t>(std::max(counts.points + counts.spots, 1) - 1) / layout::LIST_PART + 1;
}

void storageBarrier() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace

ComputeTiles::ComputeTiles()
    : boxes_({{"tile_boxes.comp", {}, {}}}, "tile boxes"),
      count_({{"tile_fill.comp", {"FILL 0"}, {}}}, "tile count"),
      prefix_({{"tile_prefix.comp", {}, {}}}, "tile prefix sum"),
      fill_({{"tile_fill.comp", {"FILL 1"}, {}}}, "tile fill"),
      shade_("", "tile_shade.comp", {}),
      boxBuffer_("tile boxes"),
      countBuffer_("tile counts"),
      startBuffer_("tile starts"),
      listBuffer_("tile lists"),
      totalBuffer_("tile total"),
      groupBuffer_("tile groups"),
      readbackBuffer_("tile total, read back") {
    listBuffer_.reserve(firstListEntries * sizeof(std::uint32_t));
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

void ComputeTiles::growLists() {
    if (totalCopied_ == nullptr || glClientWaitSync(totalCopied_, 0, 0) == GL_TIMEOUT_EXPIRED) return;
    glDeleteSync(totalCopied_);
    totalCopied_ = nullptr;
    std::uint32_t entries = 0;
    glGetNamedBufferSubData(readbackBuffer_.name(), 0, sizeof entries, &entries);
    // A quarter more, so that a scene that grows slowly does not outgrow its lists every frame.
    const std::size_t needed = std::size_t{entries} * sizeof(std::uint32_t);
    if (needed > listBuffer_.capacity()) listBuffer_.reserve(needed + needed / 4);
}

void ComputeTiles::bindStorage(const Grid& grid, const LightCounts& counts) {
    groupBuffer_.reserve(partsOf(counts) * groupBytes);
    boxBuffer_.reserve(grid.tiles() * boxBytes);
    countBuffer_.reserve(grid.tiles() * sizeof(std::uint32_t));
    startBuffer_.reserve(grid.tiles() * sizeof(std::uint32_t));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::TILE_BOXES_STORAGE, boxBuffer_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::TILE_COUNTS_STORAGE, countBuffer_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::TILE_STARTS_STORAGE, startBuffer_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::TILE_LISTS_STORAGE, listBuffer_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::TILE_TOTAL_STORAGE, totalBuffer_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::TILE_GROUPS_STORAGE, groupBuffer_.name());
}

void ComputeTiles::scatter(const gl::Program& program, const LightCounts& counts) const {
    glUseProgram(program.name());
    // 65,535 groups are what every device takes in one dispatch.
    constexpr int most = 65535 * scatterGroup;
    for (int first = 0; first < counts.points + counts.spots; first += most) {
        const int lights = std::min(most, counts.points + counts.spots - first);
        glUniform1i(layout::FIRST_LIGHT_LOCATION, first);
        glDispatchCompute(static_cast<GLuint>((lights + scatterGroup - 1) / scatterGroup), 1, 1);
    }
    storageBarrier();
}

void ComputeTiles::shade(const LightingInputs& inputs) const {
    glUseProgram(shade_.get(inputs.brdf).name());
    glUniform1i(layout::KEEPS_EMISSION_LOCATION, inputs.emissionDrawn ? 1 : 0);
    glBindImageTexture(layout::RADIANCE_IMAGE, inputs.targets.radiance.name(), 0, GL_FALSE, 0, GL_READ_WRITE,
                       GL_RGBA32F);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groupBuffer_.name());
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
    for (std::size_t part = 0; part < partsOf(inputs.lights.counts()); ++part) {
        glUniform1i(layout::LIST_PART_LOCATION, static_cast<GLint>(part));
        glDispatchComputeIndirect(static_cast<GLintptr>(part * groupBytes));
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    }
}

void ComputeTiles::render(const LightingInputs& inputs, gl::PassTimer& timer) {
    const gl::PassTimer::Scope pass(timer, "lighting");
    const Grid grid = gridOf(inputs);
    growLists();
    bindStorage(grid, inputs.lights.counts());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glUseProgram(boxes_.name());
    glDispatchCompute(grid.columns, grid.rows, 1);
    storageBarrier();
    scatter(count_, inputs.lights.counts());
    glUseProgram(prefix_.name());
    glDispatchCompute(1, 1, 1);
    storageBarrier();
    scatter(fill_, inputs.lights.counts());
    shade(inputs);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
    if (totalCopied_ != nullptr) return;
    glCopyNamedBufferSubData(totalBuffer_.name(), readbackBuffer_.name(), 0, 0, totalBytes);
    totalCopied_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

std::uint64_t ComputeTiles::countEvaluated(const LightingInputs& inputs, PairCounter&) {
    const Grid grid = gridOf(inputs);
    std::vector<std::uint32_t> counts(grid.tiles());
    glGetNamedBufferSubData(countBuffer_.name(), 0,
                            static_cast<GLsizeiptr>(counts.size() * sizeof(std::uint32_t)), counts.data());
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
    return std::uint64_t{entries} * sizeof(std::uint32_t) + startBuffer_.capacity() + countBuffer_.capacity();
}

}  // namespace candela
