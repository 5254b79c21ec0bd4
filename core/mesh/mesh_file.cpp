#include "core/mesh/mesh_file.h"
