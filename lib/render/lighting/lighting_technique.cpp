#include "render/lighting/lighting_technique.h"

#include "render/layout.h"
#include "shading/directional_albedo.h"
#include "shading/sheen_albedo.h"

#include <span>
#include <utility>

namespace candela {

namespace {

// `BRDF` of the shaders that include lib/lighting.glsl.
const char* brdfDefinition(BrdfModel model) {
    return model == BrdfModel::course ? "BRDF BRDF_COURSE" : "BRDF BRDF_GLTF";
}

gl::Texture tableTexture(std::span<const float> table, const char* label) {
    gl::Texture texture = gl::Texture::target2d(GL_RG32F, albedoTableSize, albedoTableSize, label);
    glTextureSubImage2D(texture.name(), 0, 0, 0, albedoTableSize, albedoTableSize, GL_RG, GL_FLOAT,
                        table.data());
    return texture;
}

}  // namespace

gl::Texture makeAlbedoTexture(BrdfModel model) {
    return tableTexture(directionalAlbedoTable(model), "directional albedo");
}

gl::Texture makeSheenTexture() {
    return tableTexture(sheenAlbedoTable(), "directional albedo of sheen");
}

void bindForLighting(const GBufferTargets& targets, const GpuLights& lights, const gl::Texture& albedo) {
    targets.bind();
    glBindTextureUnit(layout::LIGHTS_UNIT, lights.records().name());
    glBindTextureUnit(layout::CONES_UNIT, lights.cones().name());
    glBindTextureUnit(layout::ALBEDO_UNIT, albedo.name());
}

ModelPrograms::ModelPrograms(std::string vertexFile, std::string file, std::vector<std::string> definitions)
    : vertexFile_(std::move(vertexFile)), file_(std::move(file)), definitions_(std::move(definitions)) {}

const gl::Program& ModelPrograms::get(const LightingInputs& inputs) const {
    const bool withShadows = inputs.occlusion != nullptr;
    const bool withLobes = inputs.targets.parts.lobes;
    auto& program =
        programs_[4 * static_cast<std::size_t>(inputs.brdf) + (withLobes ? 2 : 0) + (withShadows ? 1 : 0)];
    if (!program) {
        std::vector<std::string> definitions = definitions_;
        definitions.emplace_back(brdfDefinition(inputs.brdf));
        if (withShadows) definitions.emplace_back("SHADOWS 1");
        if (withLobes) definitions.emplace_back("LOBES 1");
        std::vector<gl::Stage> stages;
        if (!vertexFile_.empty()) stages.push_back({vertexFile_, {}, {}});
        stages.push_back({file_, definitions, {}});
        program.emplace(stages, file_.c_str());
    }
    return *program;
}

}  // namespace candela
