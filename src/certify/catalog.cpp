#include "plumb/certify/catalog.hpp"

#include <algorithm>
#include <vector>

namespace plumb {

// The parts, each defined by its own catalog_*.cpp.
namespace catalog_part {
std::span<const CatalogEntry> classics();
std::span<const CatalogEntry> directions();
std::span<const CatalogEntry> distances();
std::span<const CatalogEntry> spheres();
std::span<const CatalogEntry> determinants();
std::span<const CatalogEntry> rays();
std::span<const CatalogEntry> cross_products();
std::span<const CatalogEntry> radicals();
}  // namespace catalog_part

std::span<const CatalogEntry> classics() { return catalog().first(catalog_part::classics().size()); }

std::span<const CatalogEntry> catalog() {
  static const std::vector<CatalogEntry> entries = [] {
    std::vector<CatalogEntry> all;
    for (const auto part : {catalog_part::classics(), catalog_part::directions(), catalog_part::distances(),
                            catalog_part::spheres(), catalog_part::determinants(), catalog_part::rays(),
                            catalog_part::cross_products(), catalog_part::radicals()}) {
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
