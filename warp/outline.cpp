#include "warp/outline.h"
