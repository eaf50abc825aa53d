#include "certify/catalog.hpp"

#include <algorithm>
#include <vector>

namespace plumb {

// The parts, each defined by its own catalog_*.cpp.
namespace certify::catalog_part {
std::span<const CatalogEntry> classics();
std::span<const CatalogEntry> directions();
std::span<const CatalogEntry> distances();
std::span<const CatalogEntry> spheres();
std::span<const CatalogEntry> determinants();
std::span<const CatalogEntry> rays();
std::span<const CatalogEntry> cross_products();
std::span<const CatalogEntry> radicals();
}  // namespace certify::catalog_part

std::span<const CatalogEntry> classics() { return catalog().first(certify::catalog_part::classics().size()); }

std::span<const CatalogEntry> catalog() {
  static const std::vector<CatalogEntry> entries = [] {
    std::vector<CatalogEntry> all;
    for (const auto part :
         {certify::catalog_part::classics(), certify::catalog_part::directions(), certify::catalog_part::distances(),
          certify::catalog_part::spheres(), certify::catalog_part::determinants(), certify::catalog_part::rays(),
          certify::catalog_part::cross_products(), certify::catalog_part::radicals()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return entries;
}

const CatalogEntry* find_predicate(std::string_view name) {
  const auto found = std::ranges::find(catalog(), name, &CatalogEntry::name);
  return found == catalog().end() ? nullptr : &*found;
}

}  // namespace plumb
