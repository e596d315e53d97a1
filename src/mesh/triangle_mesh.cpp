#include "mesh/triangle_mesh.h"
