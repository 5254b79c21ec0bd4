using Real = double;
#include "core/factor/dense_kernels_body.h"
