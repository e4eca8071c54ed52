// Copies the code values of a debug view to the display.

#include "shared/bindings.h"

layout(binding = RADIANCE_UNIT) uniform sampler2D codeTexture;
layout(location = ORIGIN_LOCATION) uniform ivec2 origin;  // the picture's lower left corner in the target

layout(location = 0) out vec4 code;

void main() {
    code = vec4(texelFetch(codeTexture, ivec2(gl_FragCoord.xy) - origin, 0).rgb, 1.0);
}
