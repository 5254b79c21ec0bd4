#include "core/energy/distortion.h"
