// End points of the lines of a cage.

#include "lib/frame.glsl"
#include "lib/instance.glsl"

layout(location = POSITION_ATTRIBUTE) in vec3 position;
layout(location = LINE_INSTANCE_LOCATION) uniform uint instance;

void main() {
    gl_Position = frame.clipFromWorld * vec4(instancePosition(instance, position), 1.0);
}
