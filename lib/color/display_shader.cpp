#include "color/display_shader.h"

#include <candela/error.h>

#include "color/display_transform_state.h"
#include "color/sanitize.h"

namespace candela {

namespace {

using Filter = LookupTexture::Filter;

Filter filterFor(OCIO::Interpolation interpolation) {
    // For tetrahedra the shader fetches the corners themselves.
    const bool isNearest = interpolation == OCIO::INTERP_NEAREST || interpolation == OCIO::INTERP_TETRAHEDRAL;
    return isNearest ? Filter::nearest : Filter::linear;
}

/// A one-dimensional table; OpenColorIO folds long ones into rows.
LookupTexture table1D(const OCIO::GpuShaderDesc& description, unsigned index) {
    const char *texture = nullptr, *sampler = nullptr;
    unsigned width = 0, height = 0;
    OCIO::GpuShaderDesc::TextureType channel{};
    OCIO::Interpolation interpolation{};
    description.getTexture(index, texture, sampler, width, height, channel, interpolation);
    const float* values = nullptr;
    description.getTextureValues(index, values);
    const int channels = channel == OCIO::GpuShaderDesc::TEXTURE_RED_CHANNEL ? 1 : 3;
    const std::size_t count = std::size_t(width) * height * channels;
    return {sampler,
            height > 1 ? 2 : 1,
            int(width),
            int(height),
            1,
            channels,
            filterFor(interpolation),
            {values, values + count}};
}

LookupTexture table3D(const OCIO::GpuShaderDesc& description, unsigned index) {
    const char *texture = nullptr, *sampler = nullptr;
    unsigned edge = 0;
    OCIO::Interpolation interpolation{};
    description.get3DTexture(index, texture, sampler, edge, interpolation);
    const float* values = nullptr;
    description.get3DTextureValues(index, values);
    const std::size_t count = std::size_t(edge) * edge * edge * 3;
    return {
        sampler, 3, int(edge), int(edge), int(edge), 3, filterFor(interpolation), {values, values + count}};
}

DisplayShader makeShader(const DisplayTransform::State& state) {
    OCIO::GpuShaderDescRcPtr description = OCIO::GpuShaderDesc::CreateShaderDesc();
    description->setLanguage(OCIO::GPU_LANGUAGE_GLSL_4_0);
    description->setFunctionName("ocioTransform");
    description->setResourcePrefix("ocio");
    state.processor->getOptimizedGPUProcessor(ocioPrecision)->extractGpuShaderInfo(description);
    if (description->getNumUniforms() > 0)
        throw Error(ErrorKind::unsupported, state.source,
                    "the transform of display '" + state.choice.display + "', view '" + state.choice.view +
                        "' has values that change from outside (dynamic properties); none were expected");

    DisplayShader shader;
    shader.glsl = sanitizeGlsl() + description->getShaderText() +
                  "\nvec4 displayTransform(vec4 radiance) {\n"
                  "    vec4 code = ocioTransform(vec4(sanitizedRadiance(radiance.rgb), 1.0));\n"
                  "    return vec4(sanitizedCode(code.rgb), radiance.a);\n"
                  "}\n";
    for (unsigned i = 0; i < description->getNumTextures(); ++i)
        shader.textures.push_back(table1D(*description, i));
    for (unsigned i = 0; i < description->getNum3DTextures(); ++i)
        shader.textures.push_back(table3D(*description, i));
    return shader;
}

}  // namespace

const DisplayShader& displayShader(const DisplayTransform& transform) {
    const DisplayTransform::State& state = transform.state();
    std::call_once(state.shaderOnce, [&] {
        try {
            state.shader = makeShader(state);
        } catch (const OCIO::Exception& e) {
            throw Error(ErrorKind::unsupported, state.source,
                        "the transform of display '" + state.choice.display + "', view '" +
                            state.choice.view + "' cannot run on a GPU: " + oneLine(e.what()));
        }
    });
    return state.shader;
}

}  // namespace candela
