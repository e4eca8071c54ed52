#include "render/lighting/tiled/tiles_choice.h"

#include "render/lighting/lighting_bindings.h"
#include "render/lighting/tiled/compute_tiles.h"
#include "render/lighting/tiled/software_tiles.h"

#include <candela/gbuffer.h>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>

namespace candela {

namespace {

constexpr int trialSize = 64;    // pixels a side
constexpr int trialLights = 64;  // each reaches every pixel

enum class Form { compute, software };

/// A wall that faces the camera, and lights before it.
class TrialFrame {
  public:
    TrialFrame()
        : targets_(trialSize, trialSize),
          lights_({}),
          frustum_(view_, 1.0f),
          albedo_(makeAlbedoTexture()),
          uniformBuffer_("trial frame") {
        const GBufferTexel wall = packSurface({.baseColor = glm::vec3(0.5f), .roughness = 0.5f});
        const std::array<GLuint, 4> words{wall.x, wall.y, 0, 0};
        const GLfloat depth = view_.nearPlane / 2.0f;
        glClearNamedFramebufferuiv(targets_.surfaces.name(), GL_COLOR, 0, words.data());
        glClearNamedFramebufferfv(targets_.surfaces.name(), GL_DEPTH, 0, &depth);
        std::vector<WorldLight> lights(trialLights);
        for (int i = 0; i < trialLights; ++i) {
            lights[static_cast<std::size_t>(i)] = {.position = {0.01f * static_cast<float>(i), 0.0f, -1.0f},
                                                   .range = 10.0f};
        }
        lights_.set(lights);
        uniforms_ = frameUniforms(view_, trialSize, trialSize, glm::dmat3(1.0), lights_.counts());
        uniformBuffer_.upload(std::span<const layout::FrameUniforms>(&uniforms_, 1));
    }

    /// Milliseconds that the technique takes, the least of a few runs.
    double time(LightingTechnique& technique) {
        glBindBufferBase(GL_UNIFORM_BUFFER, layout::FRAME_BINDING, uniformBuffer_.name());
        bindForLighting(targets_, lights_, albedo_);
        const LightingInputs inputs{targets_, lights_, frustum_, uniforms_, BrdfModel::course, false};
        gl::PassTimer timer(gl::PassTimer::Clock::wallAroundFinish);
        technique.render(inputs, timer);
        timer.beginFrame();
        for (int run = 0; run < 3; ++run) technique.render(inputs, timer);
        double least = timer.results().front().second;
        for (const auto& [name, milliseconds] : timer.results()) least = std::min(least, milliseconds);
        return least;
    }

  private:
    CameraView view_;
    GBufferTargets targets_;
    GpuLights lights_;
    Frustum frustum_;
    gl::Texture albedo_;
    gl::Buffer uniformBuffer_;
    layout::FrameUniforms uniforms_{};
};

Form fasterForm() {
    TrialFrame frame;
    SoftwareTiles software;
    ComputeTiles compute;
    return frame.time(compute) < frame.time(software) ? Form::compute : Form::software;
}

Form rememberedForm(const std::string& renderer) {
    static std::mutex mutex;
    static std::map<std::string, Form> forms;
    const std::lock_guard lock(mutex);
    const auto known = forms.find(renderer);
    if (known != forms.end()) return known->second;
    return forms.emplace(renderer, fasterForm()).first->second;
}

}  // namespace

std::unique_ptr<LightingTechnique> makeFasterTiles(const std::string& renderer) {
    if (rememberedForm(renderer) == Form::compute) return std::make_unique<ComputeTiles>();
    return std::make_unique<SoftwareTiles>();
}

}  // namespace candela
