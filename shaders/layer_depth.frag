// The depths of a layer, from the lists of fragments: what its surfaces are drawn with equal depths into.

#include "shared/bindings.h"

layout(binding = LAYER_DEPTHS_UNIT) uniform usampler2DArray fragmentDepths;
layout(location = LAYER_LOCATION) uniform int layer;

void main() {
    gl_FragDepth = uintBitsToFloat(texelFetch(fragmentDepths, ivec3(ivec2(gl_FragCoord.xy), layer), 0).x);
}
