#version 330 core
// Tells the fragments how far the edges of their triangle are.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in Vertex {
    vec3 eyePosition;
    vec3 eyeNormal;
    vec2 uv;
    vec4 colour;
    vec4 place;
} corners[];

out Edged {
    vec3 eyePosition;
    vec3 eyeNormal;
    vec2 uv;
    vec4 colour;
    vec4 place;
    vec3 barycentric;
} vertex;

void main() {
    for (int k = 0; k < 3; ++k) {
        vertex.eyePosition = corners[k].eyePosition;
        vertex.eyeNormal = corners[k].eyeNormal;
        vertex.uv = corners[k].uv;
        vertex.colour = corners[k].colour;
        vertex.place = corners[k].place;
        vertex.barycentric = vec3(k == 0, k == 1, k == 2);
        gl_PrimitiveID = gl_PrimitiveIDIn;
        gl_ClipDistance[0] = gl_in[k].gl_ClipDistance[0];
        gl_Position = gl_in[k].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
