#include "app/session/scene.h"
