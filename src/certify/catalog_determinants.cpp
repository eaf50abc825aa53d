#include "certify/catalog_entry.hpp"

PLUMB_CATALOG_PART(determinants, PLUMB_DETERMINANTS)
