#include "certify/catalog_entry.hpp"

PLUMB_CATALOG_PART(classics, PLUMB_CLASSICS)
