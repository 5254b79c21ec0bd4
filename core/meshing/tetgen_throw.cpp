// In Debian's TetGen 1.5.0, terminatetetgen() frees the mesh before it throws, and unwinding frees it again.
// The symbol is weak in the library; this definition replaces it, and the code that it throws can be caught.
// tetgen.h must not be included here.

class tetgenmesh;

void terminatetetgen(tetgenmesh*, int code);  // NOLINT(misc-unused-parameters)
void terminatetetgen(tetgenmesh*, int code) {
    throw code;
}
