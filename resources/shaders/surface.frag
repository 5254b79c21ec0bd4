#version 330 core
in vec3 eyePosition;
in vec3 eyeNormal;
in vec4 surfaceColour;
in vec3 barycentric;

uniform bool flatShading;
uniform bool orthographic;
uniform float edgeStrength;  // 0: no edges
uniform vec3 edgeColour;
uniform vec3 backColour;

out vec4 fragment;

void main() {
    vec3 n = flatShading ? cross(dFdx(eyePosition), dFdy(eyePosition)) : eyeNormal;
    n = normalize(n);
    vec3 toEye = orthographic ? vec3(0, 0, 1) : normalize(-eyePosition);
    if (dot(n, toEye) < 0.0) n = -n;
    vec3 base = gl_FrontFacing ? surfaceColour.rgb : backColour;
    // A key light over the left shoulder, a soft fill from the right, and a little of the sky.
    float key = max(dot(n, normalize(vec3(-0.45, 0.7, 0.9))), 0.0);
    float fill = max(dot(n, normalize(vec3(0.8, 0.1, 0.5))), 0.0);
    float sky = 0.5 + 0.5 * n.y;
    vec3 lit = base * (0.30 + 0.56 * key + 0.30 * fill + 0.10 * sky);
    vec3 width = fwidth(barycentric);
    vec3 near = smoothstep(width * 0.25, width * 1.15, barycentric);
    float edge = 1.0 - min(near.x, min(near.y, near.z));
    fragment = vec4(mix(lit, edgeColour, edge * edgeStrength), surfaceColour.a);
}
