#version 330 core
// Makes strips of lines: OpenGL's own need not be wider than one pixel.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

uniform vec2 pixels;  // of the picture
uniform float width;  // of the line, in pixels

void emit(vec4 end, vec2 shift) {
    gl_Position = end + vec4(shift * width / pixels * end.w, 0.0, 0.0);
    EmitVertex();
}

void main() {
    vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
    // What lies behind the eye has no place on the screen.
    float fromA = a.z + a.w, fromB = b.z + b.w;
    if (fromA < 0.0 && fromB < 0.0) return;
    if (fromA < 0.0) a = mix(a, b, fromA / (fromA - fromB));
    if (fromB < 0.0) b = mix(b, a, fromB / (fromB - fromA));
    vec2 along = (b.xy / b.w - a.xy / a.w) * pixels;
    along = length(along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    emit(a, -along - across);
    emit(a, -along + across);
    emit(b, along - across);
    emit(b, along + across);
    EndPrimitive();
}
