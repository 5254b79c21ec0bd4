#include "core/mesh/region.h"
