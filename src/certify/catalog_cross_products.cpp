#include "certify/catalog_entry.hpp"

PLUMB_CATALOG_PART(cross_products, PLUMB_CROSS_PRODUCTS)
