#include "render/layers/fragment_lists.h"

#include "render/layout.h"

#include <candela/error.h>
#include <candela/frame_settings.h>

#include <algorithm>
#include <string>

namespace candela {

namespace {

/// Layers that a list has room for at first. One more than a picture often has.
constexpr std::uint32_t firstLength = 4;
/// Of `Storage::ties`: the flag, and a bit for each pair of neighbours of the longest list.
constexpr int tieWords = 4;
static_assert(32 * (tieWords - 1) >= maxLayers);

gl::Texture makeWords(int width, int height, const char* label) {
    return gl::Texture::target2d(GL_R32UI, width, height, label);
}

gl::Texture makeDepths(int width, int height, int length) {
    while (glGetError() != GL_NO_ERROR) {
    }
    gl::Texture texture(GL_TEXTURE_2D_ARRAY, "fragment depths");
    glTextureStorage3D(texture.name(), 1, GL_R32UI, width, height, length);
    if (glGetError() != GL_NO_ERROR) {
        throw Error(ErrorKind::limit, "",
                    "the device has no memory for " + std::to_string(length) +
                        " layers of transparent surfaces in a picture of " + std::to_string(width) + "x" +
                        std::to_string(height) + " pixels; fewer layers or a smaller picture need less");
    }
    glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

void clear(const gl::Texture& texture, const gl::PixelRectangle& within, int length, GLuint value) {
    glClearTexSubImage(texture.name(), 0, within.x, within.y, 0, within.width, within.height, length,
                       GL_RED_INTEGER, GL_UNSIGNED_INT, &value);
}

std::vector<std::uint32_t> read(const gl::Texture& texture, const gl::PixelRectangle& from) {
    std::vector<std::uint32_t> words(static_cast<std::size_t>(from.width) *
                                     static_cast<std::size_t>(from.height));
    glGetTextureSubImage(texture.name(), 0, from.x, from.y, 0, from.width, from.height, 1, GL_RED_INTEGER,
                         GL_UNSIGNED_INT, static_cast<GLsizei>(4 * words.size()), words.data());
    return words;
}

void bindImage(int unit, const gl::Texture& texture, GLboolean layered) {
    glBindImageTexture(static_cast<GLuint>(unit), texture.name(), 0, layered, 0, GL_READ_WRITE, GL_R32UI);
}

/// The columns that a layer has pixels in, of one row or of several.
struct Columns {
    int first, last;
};

/// Widens `columns` to those of a row: of layer i the pixels whose count is over i.
void addRow(std::span<const std::uint32_t> counts, std::span<Columns> columns) {
    const int width = static_cast<int>(counts.size());
    std::size_t found = 0;
    for (int x = 0; x < width && found < columns.size(); ++x) {
        const std::size_t count = std::min<std::size_t>(counts[static_cast<std::size_t>(x)], columns.size());
        for (; found < count; ++found) columns[found].first = std::min(columns[found].first, x);
    }
    std::size_t ended = 0;
    for (int x = width; x-- > 0 && ended < found;) {
        const std::size_t count = std::min<std::size_t>(counts[static_cast<std::size_t>(x)], columns.size());
        for (; ended < count; ++ended) columns[ended].last = std::max(columns[ended].last, x);
    }
}

}  // namespace

LayerExtents extentsOf(std::span<const std::uint32_t> counts, const gl::PixelRectangle& rectangle,
                       std::uint32_t limit) {
    LayerExtents extents;
    if (counts.empty()) return extents;
    const std::uint32_t most = std::ranges::max(counts);
    for (const std::uint32_t count : counts) extents.fragmentsBeyond += count - std::min(count, limit);
    extents.layers.resize(std::min(most, limit));
    std::vector<Columns> columns(extents.layers.size(), Columns{rectangle.width, -1});
    std::vector<Columns> row(columns.size()), rows(columns.size(), Columns{rectangle.height, -1});
    for (int y = 0; y < rectangle.height; ++y) {
        std::ranges::fill(row, Columns{rectangle.width, -1});
        const auto width = static_cast<std::size_t>(rectangle.width);
        addRow(counts.subspan(static_cast<std::size_t>(y) * width, width), row);
        for (std::size_t i = 0; i < row.size() && row[i].last >= 0; ++i) {
            columns[i] = {std::min(columns[i].first, row[i].first), std::max(columns[i].last, row[i].last)};
            rows[i] = {std::min(rows[i].first, y), y};
        }
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
        extents.layers[i].rectangle = {rectangle.x + columns[i].first, rectangle.y + rows[i].first,
                                       columns[i].last - columns[i].first + 1,
                                       rows[i].last - rows[i].first + 1};
    }
    return extents;
}

FragmentLists::FragmentLists()
    : depthProgram_({{"fullscreen_triangle.vert", {}, {}}, {"layer_depth.frag", {}, {}}}, "layer depth"),
      tieProgram_({{"fullscreen_triangle.vert", {}, {}}, {"layer_ties.frag", {}, {}}}, "layer ties"),
      vertexArray_("fragment lists") {}

FragmentLists::Storage::Storage(int pixelsWide, int pixelsHigh, int fragments)
    : width(pixelsWide),
      height(pixelsHigh),
      length(fragments),
      depths(makeDepths(width, height, length)),
      counts(makeWords(width, height, "fragment counts")),
      ties(makeWords(tieWords, 1, "depth ties")),
      numbers{makeWords(width, height, "layer numbers"), makeWords(width, height, "layer numbers")} {}

void FragmentLists::fit(int width, int height, std::uint32_t length) {
    if (storage_ && storage_->width == width && storage_->height == height &&
        storage_->length >= static_cast<int>(length))
        return;
    storage_.reset();
    storage_.emplace(width, height, static_cast<int>(length));
}

std::vector<std::uint32_t> FragmentLists::recordOnce(const gl::PixelRectangle& rectangle,
                                                     const std::function<void()>& draw) {
    clear(storage_->depths, rectangle, storage_->length, 0);
    clear(storage_->counts, rectangle, 1, 0);
    clear(storage_->ties, {0, 0, tieWords, 1}, 1, 0);
    bindImage(layout::FRAGMENT_DEPTHS_IMAGE, storage_->depths, GL_TRUE);
    bindImage(layout::FRAGMENT_COUNTS_IMAGE, storage_->counts, GL_FALSE);
    bindImage(layout::DEPTH_TIES_IMAGE, storage_->ties, GL_FALSE);
    const gl::Scissor within(rectangle);
    draw();
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    return read(storage_->counts, rectangle);
}

LayerExtents FragmentLists::record(int width, int height, const gl::PixelRectangle& rectangle,
                                   std::uint32_t limit, const std::function<void()>& draw) {
    if (rectangle.width == 0 || rectangle.height == 0) return {};
    fit(width, height, std::min(firstLength, limit + 1));
    std::vector<std::uint32_t> counts = recordOnce(rectangle, draw);
    // One more than the layers: whether the last one shares its depth with a fragment beyond.
    const std::uint32_t needed = std::min(std::ranges::max(counts), limit + 1);
    if (static_cast<int>(needed) > storage_->length) {
        fit(width, height, needed);
        counts = recordOnce(rectangle, draw);
    }
    LayerExtents extents = extentsOf(counts, rectangle, limit);
    if (!extents.layers.empty()) findTies(rectangle, extents);
    return extents;
}

void FragmentLists::findTies(const gl::PixelRectangle& rectangle, LayerExtents& extents) {
    if (read(storage_->ties, {0, 0, 1, 1})[0] == 0) return;
    bind();
    bindImage(layout::DEPTH_TIES_IMAGE, storage_->ties, GL_FALSE);
    drawTriangle(tieProgram_, rectangle);
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    const std::vector<std::uint32_t> words = read(storage_->ties, {0, 0, tieWords, 1});
    for (std::size_t i = 0; i < extents.layers.size(); ++i) {
        if ((words[1 + i / 32] >> (i % 32) & 1u) == 0) continue;
        extents.layers[i].sharesDepths = true;
        if (i + 1 < extents.layers.size()) extents.layers[i + 1].sharesDepths = true;
    }
}

void FragmentLists::bind() const {
    glBindTextureUnit(layout::LAYER_DEPTHS_UNIT, storage_->depths.name());
}

void FragmentLists::drawDepth(std::uint32_t index, const GBufferTargets& targets,
                              const gl::PixelRectangle& rectangle) {
    bind();
    glProgramUniform1i(depthProgram_.name(), layout::LAYER_LOCATION, static_cast<GLint>(index));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, targets.surfaces.name());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    drawTriangle(depthProgram_, rectangle);
    glDisable(GL_DEPTH_TEST);
    // The programs of surfaces have it, also where they do not read it.
    glBindTextureUnit(layout::LAYER_NUMBERS_UNIT, storage_->numbers[index % 2].name());
}

void FragmentLists::number(std::uint32_t index, const gl::PixelRectangle& rectangle,
                           const std::function<void()>& draw) {
    const gl::Texture &numbers = storage_->numbers[index % 2], &before = storage_->numbers[(index + 1) % 2];
    clear(numbers, rectangle, 1, layout::LAYER_NO_NUMBER);
    bindImage(layout::LAYER_NUMBERS_IMAGE, numbers, GL_FALSE);
    bind();
    glBindTextureUnit(layout::LAYER_NUMBERS_UNIT, before.name());
    draw();
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    glBindTextureUnit(layout::LAYER_NUMBERS_UNIT, numbers.name());
}

void FragmentLists::drawTriangle(const gl::Program& program, const gl::PixelRectangle& rectangle) const {
    glUseProgram(program.name());
    glBindVertexArray(vertexArray_.name());
    glViewport(0, 0, storage_->width, storage_->height);
    const gl::Scissor within(rectangle);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace candela
