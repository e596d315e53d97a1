#include "volume/grid_geometry.h"
