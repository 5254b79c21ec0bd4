using Real = double;
#include "core/solver/dense_kernels_body.h"
