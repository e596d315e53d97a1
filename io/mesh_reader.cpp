#include "io/mesh_reader.h"
