using Real = float;
#include "core/factor/dense_kernels_body.h"
