#include "certify/catalog_entry.hpp"

PLUMB_CATALOG_PART(radicals, PLUMB_RADICALS)
