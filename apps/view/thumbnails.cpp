#include "thumbnails.h"

#include "common/scene_selection.h"
#include "interaction.h"
#include "render_command_line.h"
#include "scene_lighting.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <utility>

namespace {

/// Twice as large as lists show them, so that their pixels are means of four.
constexpr int width = 256, height = 144;
/// A variant is drawn from a copy of the scene on the device. Larger scenes have no pictures of variants.
constexpr std::uint64_t maxCopiedTriangles = 2'000'000, maxCopiedTexels = 64'000'000;

std::string keyOf(SceneOptions options, std::uint64_t revision) {
    options.sampling = {};
    options.debug = {};
    options.width = width;
    options.height = height;
    return renderCommandLine(options) + " #" + std::to_string(revision);
}

/// Cameras of the scene do not depend on the one that the window looks through.
std::string cameraKey(const ViewModel& model) {
    SceneOptions options = model.options;
    options.camera.reset();
    options.eye.reset();
    options.verticalFov.reset();
    options.orthographicHeight.reset();
    return keyOf(std::move(options), model.document->revision());
}

std::string variantKey(const ViewModel& model) {
    SceneOptions options = model.options;
    options.variant.reset();
    return keyOf(std::move(options), model.document->revision());
}

/// The first of `count` that was not drawn as of `key`.
std::optional<std::uint32_t> outdated(std::size_t count, const std::vector<std::string>& keys,
                                      const std::string& key) {
    for (std::uint32_t i = 0; i < count; ++i)
        if (i >= keys.size() || keys[i] != key) return i;
    return std::nullopt;
}

bool canBeCopied(const Document& document) {
    std::uint64_t texels = 0;
    for (const candela::Image& image : document.scene().images)
        texels += std::uint64_t{image.width} * image.height;
    return candela::triangleCount(document.scene()) <= maxCopiedTriangles && texels <= maxCopiedTexels;
}

SceneOptions smallOptions(const ViewModel& model) {
    SceneOptions options = model.options;
    options.debug = {};
    options.width = width;
    options.height = height;
    return options;
}

std::vector<std::uint8_t> pictureOf(Viewport& viewport, const candela::DisplayTransform& display) {
    std::vector<std::uint8_t> rgba = viewport.frame()->displayPicture(display);
    for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 255;
    return rgba;
}

void store(unsigned& texture, const std::vector<std::uint8_t>& rgba) {
    if (texture == 0) {
        glCreateTextures(GL_TEXTURE_2D, 1, &texture);
        glObjectLabel(GL_TEXTURE, texture, -1, "thumbnail");
        glTextureStorage2D(texture, 1, GL_RGBA8, width, height);
        glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage2D(texture, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
}

}  // namespace

ThumbnailPictures::~ThumbnailPictures() {
    glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
}

void ThumbnailPictures::forget(ViewModel& model) {
    glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    textures_.clear();
    cameraKeys_.clear();
    variantKeys_.clear();
    model.thumbnails.cameras.clear();
    model.thumbnails.variants.clear();
}

std::optional<ThumbnailPictures::Due> ThumbnailPictures::next(const ViewModel& model) const {
    const candela::Scene& scene = model.document->scene();
    if (model.thumbnails.camerasShown)
        if (const auto camera = outdated(scene.cameras.size(), cameraKeys_, cameraKey(model)))
            return Due{false, *camera};
    if (!model.thumbnails.variantsShown || !canBeCopied(*model.document)) return std::nullopt;
    if (const auto row = outdated(scene.variants.size() + 1, variantKeys_, variantKey(model)))
        return Due{true, *row};
    return std::nullopt;
}

std::vector<std::uint8_t> ThumbnailPictures::drawCamera(ViewModel& model, std::uint32_t camera,
                                                        const Inputs& inputs) const {
    SceneOptions options = smallOptions(model);
    options.verticalFov.reset();
    options.orthographicHeight.reset();
    Document& document = *model.document;
    const candela::CameraView view = CameraSelection(document.scene(), options, camera)
                                         .at(poseTime(document.scene(), options, options.time));
    withLighting(model, options, view, [&] {
        inputs.viewport.draw({document.gpuScene(), options, view, inputs.display, 1});
    });
    return pictureOf(inputs.viewport, inputs.display);
}

/// Row 0 is the scene without a variant.
std::vector<std::uint8_t> ThumbnailPictures::drawVariant(ViewModel& model, std::uint32_t row,
                                                         const Inputs& inputs) const {
    SceneOptions options = smallOptions(model);
    // Of a copy, each would need a tree of its own for its rays.
    options.shadows = candela::Shadows::off;
    const candela::CameraView view = selectedView(model);
    candela::GpuScene copy = model.document->uploadVariant(row == 0 ? std::nullopt : std::optional(row - 1),
                                                           inputs.viewport.context(), inputs.upload);
    inputs.viewport.draw({copy, options, view, inputs.display, 1});
    return pictureOf(inputs.viewport, inputs.display);
}

void ThumbnailPictures::drawNext(ViewModel& model, const Inputs& inputs) {
    const std::optional<Due> due = next(model);
    if (!due) return;
    std::vector<std::string>& keys = due->isVariant ? variantKeys_ : cameraKeys_;
    std::vector<unsigned>& shown = due->isVariant ? model.thumbnails.variants : model.thumbnails.cameras;
    keys.resize(std::max<std::size_t>(keys.size(), due->index + 1));
    shown.resize(std::max<std::size_t>(shown.size(), due->index + 1), 0);
    // What can not be drawn is not tried again.
    keys[due->index] = due->isVariant ? variantKey(model) : cameraKey(model);
    const std::vector<std::uint8_t> rgba =
        due->isVariant ? drawVariant(model, due->index, inputs) : drawCamera(model, due->index, inputs);
    const bool isNew = shown[due->index] == 0;
    store(shown[due->index], rgba);
    if (isNew) textures_.push_back(shown[due->index]);
}
