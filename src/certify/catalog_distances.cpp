#include "certify/catalog_entry.hpp"

PLUMB_CATALOG_PART(distances, PLUMB_DISTANCES)
