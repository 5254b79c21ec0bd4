#version 330 core
layout(location = 0) in vec3 position;

uniform mat4 view;
uniform mat4 projection;
uniform bool orthographic;
uniform bool behindAll;  // as far as what is cleared

void main() {
    vec4 eye = view * vec4(position, 1.0);
    // A little before the faces that it runs on, at the same place of the screen.
    if (orthographic) eye.z += 0.002;
    else eye.xyz *= 0.998;
    gl_Position = projection * eye;
    if (behindAll) gl_Position.z = gl_Position.w;
}
