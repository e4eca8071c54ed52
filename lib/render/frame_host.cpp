// What a frame gives to hosts: its textures, depth in their buffers, ids, and pictures that are read later.

#include "gl/state_guard.h"
#include "render/display/display_target.h"
#include "render/frame_request.h"
#include "render/frame_uniforms.h"
#include "render/gbuffer/readback.h"
#include "render/host/pending_pictures.h"
#include "render/host/pixel_transfer.h"
#include "render/renderer_state.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace candela {

namespace {

constexpr const char* user = "a Frame";

struct WordsMeaning {
    int output;
    const char* name;
    const char* meaning;
};
constexpr std::array wordMeanings{
    WordsMeaning{layout::SURFACE_OUTPUT, "surface",
                 "x: base colour and metallic; y: normal and roughness, 0 where no light falls "
                 "(unpackSurface)"},
    WordsMeaning{layout::SHADOW_OUTPUT, "shadow", "lift and geometric normal, from which rays start"},
    WordsMeaning{layout::OCCLUSION_OUTPUT, "occlusion",
                 "what occlusion textures leave of the environment's light, 0 to 1"},
    WordsMeaning{layout::LOBES_OUTPUT, "lobes",
                 "F0 and F90; sheen; clear coat; anisotropy and transmission; 0 without further lobes"},
    WordsMeaning{layout::DIFFUSE_TRANSMISSION_OUTPUT, "diffuse_transmission",
                 "colour and factor of diffuse transmission"},
};

FrameTexture describe(const char* name, GLuint texture, GLenum format, const GBufferTargets& targets,
                      std::string meaning) {
    return {name, texture, GL_TEXTURE_2D, format, targets.width, targets.height, std::move(meaning)};
}

std::string depthMeaning(const CameraView& view) {
    if (view.orthographicHeight)
        return "reversed depth, linear: (far - Z) / (far - near), 0 on the background";
    return view.farPlane ? "reversed depth: (near / Z - near / far) / (1 - near / far), 0 on the background"
                         : "reversed depth: near / Z, 0 on the background";
}

}  // namespace

void Renderer::renderViews(GpuScene& scene, std::span<const CameraView> views, const FrameSettings& settings,
                           const std::function<void(std::size_t view, const Frame& frame)>& use) {
    for (std::size_t i = 0; i < views.size(); ++i) use(i, render(scene, views[i], settings));
}

void Renderer::makeCurrent() const {
    if (!state_) refuse("a Renderer is used that was moved from");
    state_->binding->makeCurrent();
}

std::vector<std::uint8_t> displayPicture(const HdrImage& radiance, const DisplayTransform& transform) {
    const bool hasSize = radiance.width >= 1 && radiance.height >= 1;
    const std::size_t pixels =
        hasSize ? static_cast<std::size_t>(radiance.width) * static_cast<std::size_t>(radiance.height) : 0;
    if (!hasSize || radiance.rgba.size() != 4 * pixels) {
        refuse("radiance of " + std::to_string(radiance.width) + "x" + std::to_string(radiance.height) +
               " pixels has " + std::to_string(radiance.rgba.size()) + " numbers; four a pixel are expected");
    }
    std::vector<float> turned = radiance.rgba;
    flipRows(turned, radiance.width, radiance.height);
    return MemoryDisplay().codes({turned, radiance.width, radiance.height}, transform);
}

std::vector<FrameTexture> Frame::textures() const {
    const Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    const GBufferTargets& targets = *state.targets;
    targets.isHandedOut = true;
    const bool isLit = state.frame->settings.debugView == DebugView::none;
    std::vector<FrameTexture> textures{
        describe("radiance", targets.litRadiance().name(), GL_RGBA32F, targets,
                 isLit ? "radiance in the working space; alpha: coverage of transparent layers alone"
                       : "code values of the debug view"),
        describe("depth", targets.depth.name(), GL_DEPTH_COMPONENT32F, targets,
                 depthMeaning(state.frame->view))};
    for (std::size_t i = 0; i < targets.words.size(); ++i) {
        const auto known = std::ranges::find(wordMeanings, targets.layout[i].output, &WordsMeaning::output);
        if (known == wordMeanings.end()) continue;
        textures.push_back(describe(known->name, targets.words[i].name(), targets.layout[i].internalFormat,
                                    targets, known->meaning));
    }
    return textures;
}

FrameTexture Frame::displayTexture(const DisplayTransform& transform) const {
    Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    const DisplayTarget& shown = state.shownTarget(transform);
    return describe("display", shown.texture.name(), GL_RGBA8, *state.targets, "code values of the display");
}

void Frame::writeDepth(const FrameTarget& target, const DepthConvention& convention) const {
    Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    requireTarget(target);
    state.writeDepth(target, convention);
}

std::vector<PickedSurface> Frame::pick(const PictureRectangle& rectangle) const {
    Renderer::State& state = this->state();
    const DrawnFrame& frame = *state.frame;
    const auto& [x, y, width, height] = rectangle;
    if (x < 0 || y < 0 || width < 1 || height < 1 || width > frame.settings.width - x ||
        height > frame.settings.height - y) {
        refuse("the rectangle of " + std::to_string(width) + "x" + std::to_string(height) + " pixels at (" +
               std::to_string(x) + ", " + std::to_string(y) + ") is picked of a picture of " +
               std::to_string(frame.settings.width) + "x" + std::to_string(frame.settings.height) +
               " pixels");
    }
    const gl::StateGuard guard(*state.binding, user);
    const std::shared_ptr<GpuScene::State> scene = this->scene();
    const gl::PixelRectangle part{x, frame.settings.height - y - height, width, height};
    state.bindFrame();
    const ShadedSurfaces& shown = frame.hasTransparent ? state.drawMasked(*scene) : state.frameSurfaces;
    std::vector<float> depth(static_cast<std::size_t>(frame.settings.width) *
                             static_cast<std::size_t>(frame.settings.height));
    readDepth(*shown.targets, part, depth);
    const std::vector<SurfaceId> ids = state.surfaceIds(*scene, part);
    std::map<std::pair<std::uint32_t, std::uint32_t>, PickedSurface> found;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i].instance == 0) continue;
        const int column = x + static_cast<int>(i) % width, row = part.y + static_cast<int>(i) / width;
        const float reversed =
            depth[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.settings.width) +
                  static_cast<std::size_t>(column)];
        if (!(reversed > 0.0f)) continue;
        const float z = viewDistance(frame.uniforms, reversed);
        const std::uint32_t node = scene->instances[ids[i].instance - 1].node;
        PickedSurface& surface = found[{node, ids[i].material}];
        surface.z = surface.pixels == 0 ? z : std::min(surface.z, z);
        ++surface.pixels;
        surface.node = node;
        if (ids[i].material != scene->draws.noMaterial() + 1) surface.material = ids[i].material - 1;
    }
    std::vector<PickedSurface> surfaces;
    for (const auto& [key, surface] : found) surfaces.push_back(surface);
    std::ranges::stable_sort(surfaces, std::ranges::greater{}, &PickedSurface::pixels);
    return surfaces;
}

PendingPicture Frame::readDisplayPicture(const DisplayTransform& transform) const {
    Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    const MemoryPicture picture = state.pictureInMemory();
    if (!picture.radiance.empty() && !hasLines(state.frame->settings.overlays)) {
        return showLater(state.binding, picture, transform);
    }
    return transferPicture(state.binding, state.shownTarget(transform));
}

PendingRadiance Frame::readRadiance() const {
    Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    const GBufferTargets& targets = *state.targets;
    const int width = targets.width, height = targets.height;
    if (const auto& [radiance, depth, rectangle, isUploaded] = targets.memory; !radiance.empty()) {
        return computeLater<HdrImage>(
            state.binding, [rgba = std::vector<float>(radiance.begin(), radiance.end()),
                            z = std::vector<float>(depth.begin(), depth.end()), width,
                            height]() mutable { return wholeRadiance(width, height, std::move(rgba), z); });
    }
    const auto transfer = std::make_shared<PixelTransfer>();
    transfer->start(
        std::array{PixelTransfer::Source{targets.litRadiance(), GL_RGBA, GL_FLOAT, width, height, 16},
                   PixelTransfer::Source{targets.depth, GL_DEPTH_COMPONENT, GL_FLOAT, width, height, 4}});
    return makePending<HdrImage>(
        state.binding, [transfer] { return transfer->isReady(); },
        [transfer, width, height] {
            return wholeRadiance(width, height, elementsOf<float>(transfer->read(0)),
                                 elementsOf<float>(transfer->read(1)));
        });
}

}  // namespace candela
