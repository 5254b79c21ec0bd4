#include "core/integration/deformer.h"
