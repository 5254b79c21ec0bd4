#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;

uniform mat4 view;
uniform mat4 projection;

out vec3 eyePosition;
out vec3 eyeNormal;
out vec4 surfaceColour;
out vec3 barycentric;

void main() {
    vec4 eye = view * vec4(position, 1.0);
    eyePosition = eye.xyz;
    eyeNormal = mat3(view) * normal;
    surfaceColour = colour;
    int corner = gl_VertexID % 3;  // triangles do not share vertices
    barycentric = vec3(corner == 0, corner == 1, corner == 2);
    gl_Position = projection * eye;
}
