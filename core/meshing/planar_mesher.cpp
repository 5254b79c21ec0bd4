#include "core/meshing/planar_mesher.h"
