#include "warp/image.h"
