#include "mesh/measures.h"
