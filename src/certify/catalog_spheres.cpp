#include "certify/catalog_entry.hpp"

PLUMB_CATALOG_PART(spheres, PLUMB_SPHERES)
