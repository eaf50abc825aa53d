#include "certify/catalog_entry.hpp"

PLUMB_CATALOG_PART(directions, PLUMB_DIRECTIONS)
