#include "oracles/vdb_oracle.h"
