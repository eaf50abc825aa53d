#include "certify/catalog_entry.hpp"

PLUMB_CATALOG_PART(rays, PLUMB_RAYS)
