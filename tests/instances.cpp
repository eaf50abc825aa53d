#define PLUMB_INSTANCE template
#include "instances.hpp"
