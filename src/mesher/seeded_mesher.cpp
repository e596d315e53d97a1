#include "mesher/seeded_mesher.h"
