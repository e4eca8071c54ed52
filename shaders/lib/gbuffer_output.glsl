// What the geometry pass writes of a surface.

#include "shared/bindings.h"
#include "lib/gbuffer.glsl"

layout(location = SURFACE_OUTPUT) out uvec2 surfaceWords;

void writeWords(GBufferWords words) {
    surfaceWords = words.surface;
}
