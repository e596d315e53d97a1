#include "io/volume_reader.h"
