#include "io/mesh_writer.h"
