#include "candela_program.h"

#include "gl_drawing.h"

namespace {

class CandelaProgram final : public Program {
  public:
    CandelaProgram(const candela::Context& context, const BenchScene& scene, const BenchOptions& options,
                   candela::Technique technique)
        : renderer_(context),
          scene_(context, scene.scene),
          transform_(transformOf(options)),
          screen_(options.width, options.height) {
        scene_.setLights(scene.lights);
        inputs_ = {options.width, options.height, scene.view, options.brdf, technique};
    }

    std::vector<candela::PassTime> draw() override {
        renderer_.render(scene_, inputs_);
        renderer_.display(transform_, {.framebuffer = screen_.framebuffer()});
        finishDrawing();
        return renderer_.passTimes();
    }

    void count(Result& result) override {
        const candela::PairCounts pairs = renderer_.countPairs(scene_);
        result.technique = candela::toString(renderer_.technique());
        result.pairsLit = pairs.pairsLit;
        result.pairsEvaluated = pairs.pairsEvaluated;
        result.lightsVisible = pairs.lightsVisible;
        result.lightsDropped = pairs.lightsDropped;
        result.lightListBytes = pairs.lightListBytes;
    }

    std::vector<float> picture() override {
        const candela::RadiancePicture radiance = renderer_.radiance();
        std::vector<float> rgb;
        rgb.reserve(radiance.rgba.size() / 4 * 3);
        for (std::size_t i = 0; i < radiance.rgba.size(); ++i) {
            if (i % 4 != 3) rgb.push_back(radiance.rgba[i]);
        }
        return rgb;
    }

  private:
    static candela::DisplayTransform transformOf(const BenchOptions& options) {
        candela::DisplayChoice choice;
        choice.view = options.view.value_or("");
        return candela::ColorConfig::builtIn().displayTransform(choice);
    }

    candela::Renderer renderer_;
    candela::GpuScene scene_;
    candela::DisplayTransform transform_;
    Screen screen_;
    candela::FrameInputs inputs_;
};

}  // namespace

std::unique_ptr<Program> makeCandelaProgram(const candela::Context& context, const BenchScene& scene,
                                            const BenchOptions& options, candela::Technique technique) {
    return std::make_unique<CandelaProgram>(context, scene, options, technique);
}
