#include "oracles/trilinear_oracle.h"
