#include "examples.h"

#include "interaction.h"
#include "scene_lighting.h"

#include <candela/error.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace {

constexpr int width = 192, height = 108;

struct Known {
    const char* scheme;
    const char* scene;  ///< That is opened.
    const char* small;  ///< The same, or less of it, for the picture.
};

constexpr std::array known{
    Known{"plaza", "plaza:4096", "plaza:4096"},
    Known{"colonnade", "colonnade:4096", "colonnade:256"},
    Known{"sculpture", "sculpture:4096", "sculpture:4096"},
    Known{"rooms", "rooms:4096", "rooms:4096"},
    Known{"crowd", "crowd:64", "crowd:16"},
    Known{"triangles", "triangles:1000000", "triangles:50000"},
};

unsigned textureOf(const std::vector<std::uint8_t>& rgba) {
    unsigned texture = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glObjectLabel(GL_TEXTURE, texture, -1, "example");
    glTextureStorage2D(texture, 1, GL_RGBA8, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage2D(texture, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

}  // namespace

std::vector<Example> exampleScenes(std::span<const std::string> schemes) {
    std::vector<Example> examples;
    for (const Known& one : known)
        if (std::ranges::find(schemes, one.scheme) != schemes.end())
            examples.push_back({.scene = one.scene, .small = one.small});
    return examples;
}

ExamplePictures::~ExamplePictures() {
    glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
}

void ExamplePictures::draw(const Inputs& inputs, SceneLoader::Result loaded, Example& example) {
    ViewModel model;
    model.options = std::move(loaded.options);
    model.document =
        std::make_unique<Document>(std::move(*loaded.scene), inputs.viewport.context(), inputs.upload, 0);
    const candela::CameraView view = selectedView(model);
    lightDocument(model, view);
    inputs.viewport.draw({model.document->gpuScene(), model.options, view, inputs.display, 1});
    measureExposure(model, *inputs.viewport.frame());
    const candela::DisplayTransform exposed = inputs.color.displayTransform(model.options.display);
    std::vector<std::uint8_t> rgba = inputs.viewport.frame()->displayPicture(exposed);
    for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 255;
    example.texture = textureOf(rgba);
    textures_.push_back(example.texture);
}

bool ExamplePictures::advance(const Inputs& inputs, std::vector<Example>& examples) {
    bool drawn = false;
    if (std::optional<SceneLoader::Result> loaded = reading_ ? loader_.take() : std::nullopt) {
        reading_ = false;
        const bool stopped = !loaded->scene && loaded->error.empty();
        try {
            if (loaded->scene) draw(inputs, std::move(*loaded), examples[next_]);
            drawn = loaded->scene.has_value();
        } catch (const candela::Error&) {
            // The example is offered without a picture; opening it tells what is wrong.
        }
        if (!stopped) ++next_;
    }
    if (reading_ || next_ == examples.size()) return drawn;
    SceneOptions options;
    options.scene = examples[next_].small;
    options.width = width;
    options.height = height;
    loader_.start(inputs.plugins, options, inputs.wake);
    reading_ = true;
    return drawn;
}
