#include "color/display_shader.h"

#include <candela/error.h>

#include "color/baked_transform.h"
#include "color/display_transform.h"
#include "color/ocio.h"

namespace candela {

namespace {

DisplayShader makeShader(const DisplayTransform::State& state) {
    DisplayShader shader;
    shader.glsl = sanitizeGlsl() + exactGlsl(state.processor, "ocioTransform", shader.textures) +
                  "\nvec4 displayTransform(vec4 radiance) {\n"
                  "    vec4 code = ocioTransform(vec4(sanitizedRadiance(radiance.rgb), 1.0));\n"
                  "    return vec4(sanitizedCode(code.rgb), radiance.a);\n"
                  "}\n";
    return shader;
}

/// Creates a shader once. Its `Error` names the transform when OpenColorIO fails.
template <typename Make>
void createOnce(const DisplayTransform::State& state, std::once_flag& once, const Make& make) {
    std::call_once(once, [&] {
        try {
            make();
        } catch (const OCIO::Exception& e) {
            throw Error(ErrorKind::unsupported, state.source,
                        "the transform of display '" + state.options.display + "', view '" +
                            state.options.view + "' cannot run on a GPU: " + oneLine(e.what()));
        }
    });
}

}  // namespace

const DisplayShader& displayShader(const DisplayTransform& transform) {
    const DisplayTransform::State& state = transform.state();
    createOnce(state, state.shaderOnce, [&] { state.shader = makeShader(state); });
    return state.shader;
}

const DisplayShader* bakedDisplayShader(const DisplayTransform& transform) {
    const DisplayTransform::State& state = transform.state();
    createOnce(state, state.bakedOnce, [&] {
        if (const auto baked = BakedTransform::make(state.processor)) state.baked = baked->shader();
    });
    return state.baked ? &*state.baked : nullptr;
}

}  // namespace candela
