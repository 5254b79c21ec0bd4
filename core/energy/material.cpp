#include "core/energy/material.h"
