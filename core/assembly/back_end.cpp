#include "core/assembly/back_end.h"
