#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texturePoint;
layout(location = 3) in vec4 colour;
layout(location = 4) in vec4 place;

uniform mat4 view;
uniform mat4 projection;
uniform vec4 clipPlane;  // in the eye's coordinates; what is above goes

out Vertex {
    vec3 eyePosition;
    vec3 eyeNormal;
    vec2 uv;
    vec4 colour;
    vec4 place;
} vertex;

void main() {
    vec4 eye = view * vec4(position, 1.0);
    vertex.eyePosition = eye.xyz;
    vertex.eyeNormal = mat3(view) * normal;
    vertex.uv = texturePoint;
    vertex.colour = colour;
    vertex.place = place;
    gl_ClipDistance[0] = -dot(clipPlane, eye);
    gl_Position = projection * eye;
}
