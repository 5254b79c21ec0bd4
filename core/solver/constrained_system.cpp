#include "core/solver/constrained_system.h"
