// Edges as lines: the edges of triangles (CORNERS 3), or lines as they are (CORNERS 2). Unlike polygons in line mode, clipped triangles
// do not get an edge along the picture's border.

#if CORNERS == 3
layout(triangles) in;
#else
layout(lines) in;
#endif
layout(line_strip, max_vertices = 2 * CORNERS) out;

// Is `a` to the left of `b` on the screen, or below it?
bool isBefore(vec4 a, vec4 b) {
    precise vec2 toA = a.xy * b.w;
    precise vec2 toB = b.xy * a.w;
    return toA.x < toB.x || (toA.x == toB.x && toA.y < toB.y);
}

// A line leaves out its last pixel. From left to right, both triangles of an edge draw the same pixels, and edges that follow one another
// leave no gap.
void edge(vec4 a, vec4 b) {
    bool swapped = isBefore(b, a);
    gl_Position = swapped ? b : a;
    EmitVertex();
    gl_Position = swapped ? a : b;
    EmitVertex();
    EndPrimitive();
}

void main() {
    edge(gl_in[0].gl_Position, gl_in[1].gl_Position);
#if CORNERS == 3
    edge(gl_in[1].gl_Position, gl_in[2].gl_Position);
    edge(gl_in[2].gl_Position, gl_in[0].gl_Position);
#endif
}
