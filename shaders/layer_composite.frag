// A layer of transparent surfaces; blending lays it over what is behind.

#include "shared/bindings.h"

layout(binding = LAYER_COLOR_UNIT) uniform sampler2D layerTexture;

layout(location = 0) out vec4 color;

void main() {
    color = texelFetch(layerTexture, ivec2(gl_FragCoord.xy), 0);
    if (color.a == 0.0) discard;
}
