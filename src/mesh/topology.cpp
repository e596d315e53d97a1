#include "mesh/topology.h"
