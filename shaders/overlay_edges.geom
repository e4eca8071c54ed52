// Edges as lines: the edges of triangles (CORNERS 3), or lines unchanged (CORNERS 2). Unlike polygons in line mode, a triangle that is
// clipped gets no edge along the border of the picture.

#if CORNERS == 3
layout(triangles) in;
#else
layout(lines) in;
#endif
layout(line_strip, max_vertices = 2 * CORNERS) out;

// Whether `a` is to the left of `b` on the screen, or below it at the same x.
bool isBefore(vec4 a, vec4 b) {
    precise vec2 toA = a.xy * b.w;
    precise vec2 toB = b.xy * a.w;
    return toA.x < toB.x || (toA.x == toB.x && toA.y < toB.y);
}

// The rasteriser leaves out the last pixel of a line. Drawn from left to right, the two triangles of an edge cover the same pixels, and
// consecutive edges leave no gap.
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
