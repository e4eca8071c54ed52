// Draws the overlays' lines over the displayed picture.

#include "shared/bindings.h"

layout(binding = OVERLAY_UNIT) uniform sampler2D overlayTexture;
layout(location = ORIGIN_LOCATION) uniform ivec2 origin;  // the picture's lower left corner in the target

layout(location = 0) out vec4 code;

void main() {
    vec4 line = texelFetch(overlayTexture, ivec2(gl_FragCoord.xy) - origin, 0);
    if (line.a == 0.0) discard;
    code = line;
}
