#version 330 core
#ifdef EDGES
in Edged {
    vec3 eyePosition;
    vec3 eyeNormal;
    vec2 uv;
    vec4 colour;
    vec4 place;
    vec3 barycentric;
} vertex;
uniform vec3 edgeColour;
uniform vec3 lightEdgeColour;
#else
in Vertex {
    vec3 eyePosition;
    vec3 eyeNormal;
    vec2 uv;
    vec4 colour;
    vec4 place;
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
uniform bool isTinted;  // by colours of the vertices
uniform sampler2D picture;
// Another colour for each triangle lies over what is then gray, as in pictures.
uniform sampler2D map;
uniform float mapOpacity;  // 0: there is none
// What is painted lies over the colours as they are: the places of the vertices are its colours times their
// opacity, but where the triangle has one of its own, which is no black, in the map.
uniform bool isPaint;
// Colours that change smoothly: the vertices have places in a row of them.
uniform bool isSmooth;
uniform bool hasRamp;
uniform sampler2D ramp;
uniform float opacity;
uniform float stripes;  // of the screen, in pixels; 0: none

out vec4 fragment;

vec3 smoothColour() {
    float count = textureSize(ramp, 0).x;
    return texture(ramp, vec2((0.5 + clamp(vertex.place.x, 0.0, 1.0) * (count - 1.0)) / count, 0.5)).rgb;
}

vec4 paintColour(ivec2 place) {
    vec4 own = texelFetch(map, place, 0);
    return own.rgb == vec3(0.0) ? vertex.place : vec4(own.rgb * own.a, own.a);
}

// With its picture as from that many times farther away, in powers of two.
vec4 surfaceColour(float blur) {
    if (!coloursOfTriangles) return vertex.colour;
    if (isSmooth && hasRamp && mapOpacity == 0.0) return vec4(smoothColour(), 1.0);
    int triangle = firstTriangle + gl_PrimitiveID, width = textureSize(colours, 0).x;
    ivec2 place = ivec2(triangle % width, triangle / width);
    vec4 colour = texelFetch(colours, place, 0);
    if (textured) colour *= texture(picture, vertex.uv, blur);
    if (isTinted) colour.rgb *= vertex.colour.rgb;
    if (mapOpacity == 0.0) return colour;
    if (isPaint) {
        vec4 paint = paintColour(place);
        return vec4(colour.rgb * (1.0 - mapOpacity * paint.a) + mapOpacity * paint.rgb, colour.a);
    }
    float gray = dot(colour.rgb, vec3(0.34375, 0.5, 0.15625));  // as qGray
    vec3 mapped = isSmooth ? smoothColour() : texelFetch(map, place, 0).rgb;
    return vec4(mix(vec3(gray), mapped, mapOpacity), colour.a);
}

#ifdef EDGES
const float kDarkGround = 0.36;

// Lines are seen on what is dark, too: by the colours around, so that a grained picture does not break them.
vec3 lineColour(float light) {
    vec3 ground = mix(surfaceColour(4.0).rgb, vec3(0.5), dimming) * light;
    return dot(ground, vec3(0.34375, 0.5, 0.15625)) < kDarkGround ? lightEdgeColour : edgeColour;
}
#endif

void main() {
    if (stripes > 0.0 && fract((gl_FragCoord.x + gl_FragCoord.y) / stripes) > 0.5) discard;
    vec3 n = flatShading ? cross(dFdx(vertex.eyePosition), dFdy(vertex.eyePosition)) : vertex.eyeNormal;
    n = normalize(n);
    vec3 toEye = orthographic ? vec3(0, 0, 1) : normalize(-vertex.eyePosition);
    if (dot(n, toEye) < 0.0) n = -n;
    vec4 colour = surfaceColour(0.0);
    if (colour.a < 0.5) discard;  // cut-out leaves and feathers
    vec3 base = gl_FrontFacing ? colour.rgb : mix(backColour, colour.rgb, ownFromBehind);
    base = mix(base, vec3(0.5), dimming);
    // A key light over the left shoulder, a soft fill from the right, and a little of the sky.
    float key = max(dot(n, normalize(vec3(-0.45, 0.7, 0.9))), 0.0);
    float fill = max(dot(n, normalize(vec3(0.8, 0.1, 0.5))), 0.0);
    float sky = 0.5 + 0.5 * n.y;
    float light = 0.30 + 0.56 * key + 0.30 * fill + 0.10 * sky;
    vec3 lit = base * light;
#ifdef EDGES
    vec3 width = fwidth(vertex.barycentric);
    vec3 near = smoothstep(width * 0.25, width * 1.15, vertex.barycentric);
    float edge = 1.0 - min(near.x, min(near.y, near.z));
    float altitude = 3.0 / (width.x + width.y + width.z);  // of the triangle, in pixels, about
    lit = mix(lit, lineColour(light), 0.45 * clamp(altitude / 10.0, 0.2, 1.0) * edge);  // a dense mesh is no veil
#endif
    fragment = vec4(lit, opacity);
}
