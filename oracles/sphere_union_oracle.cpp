#include "oracles/sphere_union_oracle.h"
