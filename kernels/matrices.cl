// Vectors and small matrices, in front of kernels that are built with -DDIM=2|3. A vector is a double2 or a double4 with
// w = 0; a matrix is its rows.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#if DIM == 2
typedef double2 vec;
typedef struct { vec r0, r1; } mat;
#define ZERO ((vec)(0.0, 0.0))
#define UNIT(j) ((vec)((j) == 0, (j) == 1))
#define GET(v, j) ((j) == 0 ? (v).x : (v).y)
vec load(global const double* x, int i) { return (vec)(x[2 * i], x[2 * i + 1]); }
void store(global double* x, int i, vec v) { x[2 * i] = v.x; x[2 * i + 1] = v.y; }
#else
typedef double4 vec;
typedef struct { vec r0, r1, r2; } mat;
#define ZERO ((vec)(0.0, 0.0, 0.0, 0.0))
#define UNIT(j) ((vec)((j) == 0, (j) == 1, (j) == 2, 0.0))
#define GET(v, j) ((j) == 0 ? (v).x : (j) == 1 ? (v).y : (v).z)
vec load(global const double* x, int i) { return (vec)(x[3 * i], x[3 * i + 1], x[3 * i + 2], 0.0); }
void store(global double* x, int i, vec v) { x[3 * i] = v.x; x[3 * i + 1] = v.y; x[3 * i + 2] = v.z; }
#endif

#if DIM == 2
mat rows(vec a, vec b, vec c) { mat m = {a, b}; return m; }
vec times(mat m, vec x) { return (vec)(dot(m.r0, x), dot(m.r1, x)); }
mat transposed(mat m) { mat t = {(vec)(m.r0.x, m.r1.x), (vec)(m.r0.y, m.r1.y)}; return t; }
mat add(mat a, double s, mat b) { mat m = {a.r0 + s * b.r0, a.r1 + s * b.r1}; return m; }
mat scaled(double s, mat a) { mat m = {s * a.r0, s * a.r1}; return m; }
double frobenius(mat a, mat b) { return dot(a.r0, b.r0) + dot(a.r1, b.r1); }
double trace(mat m) { return m.r0.x + m.r1.y; }
mat outer(vec a, vec b) { mat m = {a.x * b, a.y * b}; return m; }
mat identity(double s) { mat m = {s * UNIT(0), s * UNIT(1)}; return m; }
double determinant(mat m) { return m.r0.x * m.r1.y - m.r0.y * m.r1.x; }
// The transposed cofactor matrix: inverse = adjugate / determinant.
mat adjugate(mat m) { mat a = {(vec)(m.r1.y, -m.r0.y), (vec)(-m.r1.x, m.r0.x)}; return a; }
mat loadMat(global const double* x, int i) {
    mat m = {(vec)(x[4 * i], x[4 * i + 1]), (vec)(x[4 * i + 2], x[4 * i + 3])};
    return m;
}
void storeMat(global double* x, int i, mat m) {
    x[4 * i] = m.r0.x; x[4 * i + 1] = m.r0.y; x[4 * i + 2] = m.r1.x; x[4 * i + 3] = m.r1.y;
}
#else
mat rows(vec a, vec b, vec c) { mat m = {a, b, c}; return m; }
vec times(mat m, vec x) { return (vec)(dot(m.r0, x), dot(m.r1, x), dot(m.r2, x), 0.0); }
mat transposed(mat m) {
    mat t = {(vec)(m.r0.x, m.r1.x, m.r2.x, 0.0), (vec)(m.r0.y, m.r1.y, m.r2.y, 0.0), (vec)(m.r0.z, m.r1.z, m.r2.z, 0.0)};
    return t;
}
mat add(mat a, double s, mat b) { mat m = {a.r0 + s * b.r0, a.r1 + s * b.r1, a.r2 + s * b.r2}; return m; }
mat scaled(double s, mat a) { mat m = {s * a.r0, s * a.r1, s * a.r2}; return m; }
double frobenius(mat a, mat b) { return dot(a.r0, b.r0) + dot(a.r1, b.r1) + dot(a.r2, b.r2); }
double trace(mat m) { return m.r0.x + m.r1.y + m.r2.z; }
mat outer(vec a, vec b) { mat m = {a.x * b, a.y * b, a.z * b}; return m; }
mat identity(double s) { mat m = {s * UNIT(0), s * UNIT(1), s * UNIT(2)}; return m; }
double determinant(mat m) { return dot(m.r0, cross(m.r1, m.r2)); }
mat adjugate(mat m) { return transposed(rows(cross(m.r1, m.r2), cross(m.r2, m.r0), cross(m.r0, m.r1))); }
mat loadMat(global const double* x, int i) {
    global const double* p = x + 9 * i;
    mat m = {(vec)(p[0], p[1], p[2], 0.0), (vec)(p[3], p[4], p[5], 0.0), (vec)(p[6], p[7], p[8], 0.0)};
    return m;
}
void storeMat(global double* x, int i, mat m) {
    global double* p = x + 9 * i;
    p[0] = m.r0.x; p[1] = m.r0.y; p[2] = m.r0.z; p[3] = m.r1.x; p[4] = m.r1.y; p[5] = m.r1.z;
    p[6] = m.r2.x; p[7] = m.r2.y; p[8] = m.r2.z;
}
#endif

mat product(mat a, mat b) {
    mat t = transposed(b);
    mat m;
    m.r0 = times(t, a.r0);
    m.r1 = times(t, a.r1);
#if DIM == 3
    m.r2 = times(t, a.r2);
#endif
    return m;
}
