#pragma once

#include "support/frame_request.h"
#include "support/techniques.h"

#include <candela/context.h>
#include <candela/error.h>
#include <candela/gpu_scene.h>
#include <candela/renderer.h>

#include <gtest/gtest.h>

#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela::test {

/// AOVs of a frame, addressed by pixel; y counts from the top.
class AovReader {
  public:
    AovReader(const std::vector<Aov>& aovs, int width) : width_(width) {
        for (const Aov& aov : aovs) aovs_.emplace(aov.name, aov);
    }

    float scalar(const std::string& name, int x, int y) const { return aovs_.at(name).values[0][at(x, y)]; }
    glm::vec3 vector(const std::string& name, int x, int y) const {
        const auto& values = aovs_.at(name).values;
        return {values[0][at(x, y)], values[1][at(x, y)], values[2][at(x, y)]};
    }

  private:
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    int width_;
    std::map<std::string, Aov> aovs_;
};

inline glm::vec3 pixelOf(const HdrImage& picture, int x, int y) {
    const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                               static_cast<std::size_t>(x));
    return {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]};
}

inline bool allFinite(const HdrImage& picture) {
    for (const float value : picture.rgba) {
        if (!std::isfinite(value)) return false;
    }
    return true;
}

/// Tests that draw: one headless context and one renderer for the whole suite.
class DrawingTest : public testing::Test {
  protected:
    static void SetUpTestSuite() { shared_ = std::make_unique<Shared>(); }
    static void TearDownTestSuite() { shared_.reset(); }

    static const Context& context() { return shared_->context; }
    static Renderer& renderer() { return shared_->renderer; }

    static GpuScene upload(const Scene& scene, std::span<const WorldLight> lights = {}) {
        GpuScene uploaded(context(), scene);
        uploaded.setLights(lights);
        return uploaded;
    }

    /// Draws a frame, which is `lastFrame` until the next one. `scene` may be a temporary.
    template <typename Uploaded>
    static const Frame& render(Uploaded&& scene, const FrameRequest& request) {
        return shared_->frame.emplace(test::render(renderer(), scene, request));
    }
    static const Frame& lastFrame() { return *shared_->frame; }

    template <typename Uploaded>
    static HdrImage drawn(Uploaded&& scene, const FrameRequest& request) {
        return render(scene, request).radiance();
    }

    /// The AOVs of the frame drawn last, of `width` pixels: all but `ambient_occlusion`, which takes longest.
    static AovReader aovs(int width) {
        std::vector<std::string> names = Renderer::aovNames();
        std::erase(names, "ambient_occlusion");
        return {lastFrame().aovs(names), width};
    }

    /// Expects an error of bad input whose text has `part`.
    static void expectRefused(const std::function<void()>& action, const std::string& part) {
        try {
            action();
            ADD_FAILURE() << "no error, expected: " << part;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }

  private:
    struct Shared {
        Context context = Context::createHeadless();
        Renderer renderer{context};
        std::optional<Frame> frame;
    };
    static inline std::unique_ptr<Shared> shared_;
};

}  // namespace candela::test
