#include "app/document/project.h"
