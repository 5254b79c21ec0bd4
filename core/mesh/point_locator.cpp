#include "core/mesh/point_locator.h"
