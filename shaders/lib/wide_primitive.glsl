// Geometry shaders that draw lines (WIDE_CORNERS 2) as rectangles and points (WIDE_CORNERS 1) as squares of a width in pixels. Lines in a core profile are
// one pixel wide on most devices, and cover other pixels on each. A line ends half of its width beyond its last corner, so that lines that meet
// at an angle leave no gap. The includer defines writeVertex.

#include "lib/frame.glsl"

#if WIDE_CORNERS == 2
layout(lines) in;
layout(triangle_strip, max_vertices = 8) out;
#else
layout(points) in;
layout(triangle_strip, max_vertices = 4) out;
#endif

// The programs of surfaces and of instances write the same depth for the same vertex.
invariant gl_Position;

const int LAST_CORNER = WIDE_CORNERS - 1;

// Writes what the fragment shader reads at the share `t` of the way from the first corner to the last. `offset` is the way in the world from
// there to the vertex, metres.
void writeVertex(float t, vec3 offset);

// `pixels` is the way on the screen from the point `clip` to the vertex.
void emitVertex(vec4 clip, float t, vec2 pixels) {
    vec2 way = clip.w * 2.0 * pixels / vec2(frame.size.xy);
    writeVertex(t, way.x * frame.cameraRight.w * frame.cameraRight.xyz + way.y * frame.cameraUp.w * frame.cameraUp.xyz);
    gl_Position = vec4(clip.xy + way, clip.zw);
    EmitVertex();
}

// The unit direction on the screen from one point in front of the eye to another; to the right where they coincide.
vec2 screenDirection(vec4 from, vec4 to) {
    vec2 way = (to.xy / to.w - from.xy / from.w) * vec2(frame.size.xy);
    float largest = max(abs(way.x), abs(way.y));
    return largest > 0.0 ? normalize(way / largest) : vec2(1.0, 0.0);
}

// First and end of the part of a line in front of the near plane, where reversed depth is below 1, as shares of its length. The first is the
// larger one where there is none.
vec2 partInFront(vec4 a, vec4 b) {
    float fromA = a.w - a.z, fromB = b.w - b.z;
    if (fromA < 0.0 && fromB < 0.0) return vec2(1.0, 0.0);
    float crossing = fromA / (fromA - fromB);
    return vec2(fromA < 0.0 ? crossing : 0.0, fromB < 0.0 ? crossing : 1.0);
}

#if WIDE_CORNERS == 2
void main() {
    vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
    vec2 part = partInFront(a, b);
    if (part.x > part.y) return;
    vec4 from = mix(a, b, part.x), to = mix(a, b, part.y);
    vec2 cap = 0.5 * frame.elementSizes.y * screenDirection(from, to), side = vec2(-cap.y, cap.x);
    emitVertex(from, part.x, side - cap);
    emitVertex(from, part.x, -side - cap);
    emitVertex(from, part.x, side);
    emitVertex(from, part.x, -side);
    emitVertex(to, part.y, side);
    emitVertex(to, part.y, -side);
    emitVertex(to, part.y, side + cap);
    emitVertex(to, part.y, cap - side);
    EndPrimitive();
}
#else
void main() {
    vec4 center = gl_in[0].gl_Position;
    float reach = 0.5 * frame.elementSizes.x;
    emitVertex(center, 0.0, vec2(-reach, reach));
    emitVertex(center, 0.0, vec2(-reach, -reach));
    emitVertex(center, 0.0, vec2(reach, reach));
    emitVertex(center, 0.0, vec2(reach, -reach));
    EndPrimitive();
}
#endif
