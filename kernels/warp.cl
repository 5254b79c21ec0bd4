// The cells of a texture warp: every pixel looks up the picture through the inverse affine map of the cell that covers
// it (warp/span_filters_inl.h has the same filters). Built with
//   -DKIND=0|1       numbers of the picture: 8 bit, 16 bit
//   -DN=1…4          its channels; with -DALPHA the last one is alpha, with -DWEIGHTED colours count by it
//   -DADDS=0|1       a further channel of the output, full
//   -DFILTER=0|1|2|3 nearest, bilinear, bicubic, elliptical

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#if KIND == 0
typedef uchar number;
#define FULL 255.0f
#define LOAD(p, i) ((float)(p)[i])
#define STORE(v, p, i) (p)[i] = convert_uchar_sat((v) + 0.5f)
#else
typedef ushort number;
#define FULL 65535.0f
#define LOAD(p, i) ((float)(p)[i])
#define STORE(v, p, i) (p)[i] = convert_ushort_sat((v) + 0.5f)
#endif

#if N == 2
#define LAST(v) (v).y
#elif N == 4
#define LAST(v) (v).w
#else
#define LAST(v) (v).x
#endif
#if defined(ALPHA)
#define OPACITY(v) clamp(LAST(v) / FULL, 0.0f, 1.0f)
#else
#define OPACITY(v) 1.0f
#endif

typedef struct {
    global const number* first;
    int width, height;
} level_t;

// Beyond the border, the border's pixels continue.
float4 pixel(level_t level, int x, int y) {
    const size_t at = ((size_t)clamp(y, 0, level.height - 1) * level.width + clamp(x, 0, level.width - 1)) * N;
    float4 colour = (float4)(0.0f);
    colour.x = LOAD(level.first, at);
#if N > 1
    colour.y = LOAD(level.first, at + 1);
#endif
#if N > 2
    colour.z = LOAD(level.first, at + 2);
#endif
#if N > 3
    colour.w = LOAD(level.first, at + 3);
#endif
    return colour;
}

// --- colours that count by their alpha ------------------------------------------------------------------------------

float4 associated(float4 colour) {
#ifdef WEIGHTED
    const float alpha = LAST(colour) / FULL;
    LAST(colour) = FULL;
    colour *= alpha;
#endif
    return colour;
}

float4 summand(level_t level, int x, int y) { return associated(pixel(level, x, y)); }

float4 colourOf(float4 sum) {
#ifdef WEIGHTED
    const float alpha = LAST(sum);
    if (!(alpha > 0.0f)) return (float4)(0.0f);
    sum *= FULL / alpha;
    LAST(sum) = alpha;
#endif
    return sum;
}

float4 limited(float4 colour) {
#if defined(ALPHA) && !defined(WEIGHTED)
    if (LAST(colour) > FULL) colour *= FULL / LAST(colour);
#endif
    colour = clamp(colour, 0.0f, FULL);
#if defined(ALPHA) && !defined(WEIGHTED)
    colour = min(colour, LAST(colour));
#endif
    return colour;
}

// --- filters: (i, j) is the pixel at or before the position, (s, t) how far beyond its centre ------------------------

float4 bilinear(level_t level, int i, int j, float s, float t) {
    if (s == 0.0f && t == 0.0f) return pixel(level, i, j);
    const float4 a = summand(level, i, j), b = summand(level, i + 1, j);
    const float4 left = a + t * (summand(level, i, j + 1) - a), right = b + t * (summand(level, i + 1, j + 1) - b);
    return colourOf(left + s * (right - left));
}

float4 cubicWeights(float t) {
    const float s = 1.0f - t;
    return (float4)(-0.5f * t * s * s, 1.0f + t * t * (1.5f * t - 2.5f), 1.0f + s * s * (1.5f * s - 2.5f), -0.5f * s * t * t);
}

float4 cubicRow(level_t level, int i, int j, float4 x) {
    return x.x * summand(level, i - 1, j) + x.y * summand(level, i, j) + x.z * summand(level, i + 1, j) +
           x.w * summand(level, i + 2, j);
}

float4 bicubic(level_t level, int i, int j, float s, float t) {
    if (s == 0.0f && t == 0.0f) return pixel(level, i, j);
    const float4 x = cubicWeights(s), y = cubicWeights(t);
    return limited(colourOf(y.x * cubicRow(level, i, j - 1, x) + y.y * cubicRow(level, i, j, x) +
                            y.z * cubicRow(level, i, j + 1, x) + y.w * cubicRow(level, i, j + 2, x)));
}

float radial(float q) {
    const float rest = 4.0f - min(q, 4.0f);
    return rest * rest * (((-0.00488379426f * q + 0.031282487f) * q - 0.0738093829f) * q + 0.0543943942f);
}

float4 elliptical(level_t level, int i, int j, float s, float t, float4 ellipse, int reachX, int reachY) {
    float4 sum = (float4)(0.0f);
    float weight = 0.0f;
    for (int y = -reachY; y <= reachY + 1; ++y) {
        const float dy = (float)y - t;
        for (int x = -reachX; x <= reachX + 1; ++x) {
            const float dx = (float)x - s;
            const float q = ellipse.x * dx * dx + 2.0f * ellipse.y * dx * dy + ellipse.z * dy * dy;
            if (!(q < 4.0f)) continue;
            const float w = radial(q);
            sum += w * summand(level, i + x, j + y);
            weight += w;
        }
    }
    if (!(weight > 0.0f)) return bicubic(level, i, j, s, t);
    return limited(colourOf(sum * (1.0f / weight)));
}

float4 ewa(level_t level, int i, int j, float s, float t, float4 ellipse, int reachX, int reachY) {
    const float blend = ellipse.w;
    if (blend == 0.0f) return bicubic(level, i, j, s, t);
    const float4 soft = elliptical(level, i, j, s, t, ellipse, reachX, reachY);
    if (blend == 1.0f) return soft;
    return colourOf(associated(soft) * blend + associated(bicubic(level, i, j, s, t)) * (1.0f - blend));
}

float4 colourAt(level_t level, double2 at, float4 ellipse, int reachX, int reachY) {
    const double far = 64.0;
#if FILTER != 0
    at -= 0.5;
#endif
    at = clamp(at, (double2)(-far), (double2)(level.width + far, level.height + far));
    const double2 whole = floor(at);
    const int i = (int)whole.x, j = (int)whole.y;
    const float s = (float)(at.x - whole.x), t = (float)(at.y - whole.y);
#if FILTER == 0
    return pixel(level, i, j);
#elif FILTER == 1
    return bilinear(level, i, j, s, t);
#elif FILTER == 2
    return bicubic(level, i, j, s, t);
#else
    return ewa(level, i, j, s, t, ellipse, reachX, reachY);
#endif
}

// --- cells -------------------------------------------------------------------------------------------------------

// Per cell: `maps` anchor, displacement, its gradient's columns and the level's shrinking; `ellipses` xx, xy, yy, blend;
// `filters` level and reach. `levels`: first number, width, height.
float4 colourOfCell(int cell, double x, double y, global const double* maps, global const float4* ellipses,
                    global const int4* filters, global const number* texels, global const long* levels) {
    global const double* map = maps + 9 * (size_t)cell;
    const int4 filter = filters[cell];
    global const long* l = levels + 3 * filter.x;
    const level_t level = {texels + l[0], (int)l[1], (int)l[2]};
    const double stepX = x - map[0], stepY = y - map[1];
    const double2 source = (double2)(x - (map[2] + map[6] * stepY + map[4] * stepX),
                                     y - (map[3] + map[7] * stepY + map[5] * stepX));
    return colourAt(level, source * map[8], ellipses[cell], filter.y, filter.z);
}

// `cellAt` is the cell of every pixel; −1 where there is none; −2 − k where there are several, listed from
// position k of `layers` on: their number, then the cells from the top one down.
kernel void warp(int count, global const int* cellAt, global const int* layers, global const double* maps,
                 global const float4* ellipses, global const int4* filters, global const number* texels,
                 global const long* levels, int width, int top, double left, double upper, double scale,
                 global number* output) {
    const int p = get_global_id(0);
    if (p >= count) return;
    const size_t at = (size_t)p * (N + ADDS);
    const int cell = cellAt[p];
    const double x = left + scale * (p % width + 0.5), y = upper + scale * (top + p / width + 0.5);
    float4 colour = (float4)(0.0f);
    if (cell >= 0) colour = colourOfCell(cell, x, y, maps, ellipses, filters, texels, levels);
    if (cell < -1) {
        global const int* list = layers + (-2 - cell);
        float through = 1.0f;
        for (int k = 1; k <= list[0] && through > 0.0f; ++k) {
            const float4 layer = colourOfCell(list[k], x, y, maps, ellipses, filters, texels, levels);
            colour += through * associated(layer);
            through *= 1.0f - OPACITY(layer);
        }
        colour = colourOf(colour);
    }
    STORE(colour.x, output, at);
#if N > 1
    STORE(colour.y, output, at + 1);
#endif
#if N > 2
    STORE(colour.z, output, at + 2);
#endif
#if N > 3
    STORE(colour.w, output, at + 3);
#endif
#if ADDS
    STORE(cell != -1 ? FULL : 0.0f, output, at + N);
#endif
}
