using Real = float;
#include "core/solver/dense_kernels_body.h"
