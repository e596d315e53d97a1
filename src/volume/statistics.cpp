#include "volume/statistics.h"
