// Vertices of the triangles whose edges are drawn.

#include "lib/frame.glsl"
#include "lib/instance.glsl"

layout(location = POSITION_ATTRIBUTE) in vec3 position;
layout(location = DRAW_ATTRIBUTE) in uvec2 draw;

void main() {
    gl_Position = frame.clipFromWorld * vec4(instancePosition(draw.x, position), 1.0);
}
