#version 330 core
#ifdef EDGES
in Edged {
    vec3 eyePosition;
    vec3 eyeNormal;
    vec2 uv;
    vec4 colour;
    vec3 place;
    vec3 barycentric;
} vertex;
uniform vec3 edgeColour;
#else
in Vertex {
    vec3 eyePosition;
    vec3 eyeNormal;
    vec2 uv;
    vec4 colour;
    vec3 place;
} vertex;
#endif

uniform bool flatShading;
uniform bool orthographic;
uniform vec3 backColour;
uniform float ownFromBehind;  // 0 … 1: of the colour in front
uniform float dimming;  // 0 … 1: towards grey
// The colours of the triangles, row by row; without them the vertices have their own.
uniform bool coloursOfTriangles;
uniform sampler2D colours;
uniform int firstTriangle;
uniform bool textured;
uniform sampler2D picture;
// Another colour for each triangle lies over what is then gray, as in pictures.
uniform sampler2D map;
uniform float mapOpacity;  // 0: there is none
// Colours that change smoothly: the vertices have places in a row of them, or colours.
uniform bool isSmooth;
uniform bool hasRamp;
uniform sampler2D ramp;
uniform float opacity;

out vec4 fragment;

vec3 smoothColour() {
    if (!hasRamp) return vertex.place;
    float count = textureSize(ramp, 0).x;
    return texture(ramp, vec2((0.5 + clamp(vertex.place.x, 0.0, 1.0) * (count - 1.0)) / count, 0.5)).rgb;
}

vec4 surfaceColour() {
    if (!coloursOfTriangles) return vertex.colour;
    if (isSmooth && mapOpacity == 0.0) return vec4(smoothColour(), 1.0);
    int triangle = firstTriangle + gl_PrimitiveID, width = textureSize(colours, 0).x;
    ivec2 place = ivec2(triangle % width, triangle / width);
    vec4 colour = texelFetch(colours, place, 0);
    if (textured) colour *= texture(picture, vertex.uv);
    if (mapOpacity == 0.0) return colour;
    float gray = dot(colour.rgb, vec3(0.34375, 0.5, 0.15625));  // as qGray
    vec3 mapped = isSmooth ? smoothColour() : texelFetch(map, place, 0).rgb;
    return vec4(mix(vec3(gray), mapped, mapOpacity), colour.a);
}

void main() {
    vec3 n = flatShading ? cross(dFdx(vertex.eyePosition), dFdy(vertex.eyePosition)) : vertex.eyeNormal;
    n = normalize(n);
    vec3 toEye = orthographic ? vec3(0, 0, 1) : normalize(-vertex.eyePosition);
    if (dot(n, toEye) < 0.0) n = -n;
    vec4 colour = surfaceColour();
    if (colour.a < 0.5) discard;  // cut-out leaves and feathers
    vec3 base = gl_FrontFacing ? colour.rgb : mix(backColour, colour.rgb, ownFromBehind);
    base = mix(base, vec3(0.5), dimming);
    // A key light over the left shoulder, a soft fill from the right, and a little of the sky.
    float key = max(dot(n, normalize(vec3(-0.45, 0.7, 0.9))), 0.0);
    float fill = max(dot(n, normalize(vec3(0.8, 0.1, 0.5))), 0.0);
    float sky = 0.5 + 0.5 * n.y;
    vec3 lit = base * (0.30 + 0.56 * key + 0.30 * fill + 0.10 * sky);
#ifdef EDGES
    vec3 width = fwidth(vertex.barycentric);
    vec3 near = smoothstep(width * 0.25, width * 1.15, vertex.barycentric);
    float edge = 1.0 - min(near.x, min(near.y, near.z));
    float altitude = 3.0 / (width.x + width.y + width.z);  // of the triangle, in pixels, about
    lit = mix(lit, edgeColour, 0.45 * clamp(altitude / 10.0, 0.2, 1.0) * edge);  // a dense mesh is no veil
#endif
    fragment = vec4(lit, opacity);
}
