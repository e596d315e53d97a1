#include "oracles/implicit_oracle.h"
