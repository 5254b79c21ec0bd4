#include "core/motion/trajectory.h"
