#include "lattice_savings.hpp"

#include <array>

#include "plumb/certify/catalog.hpp"

namespace plumb::tool {
namespace {

struct Arithmetic {
  int bits;  // values below 2^bits are exact
  const char *name, *skips;
};

constexpr std::array<Arithmetic, 7> ladder{{
    {53, "plain double", "filter and all exact stages"},
    {63, "64-bit integers", "interval, wide integers, GMP"},
    {127, "128-bit integers", "interval, wide integers, GMP"},
    {255, "256-bit integers", "GMP"},
    {511, "512-bit integers", "GMP"},
    {1023, "1024-bit integers", "GMP"},
    {1 << 30, "GMP integers", ""},
}};

}  // namespace

std::vector<Saving> lattice_savings(const Lattice& lattice) {
  std::vector<Saving> savings;
  for (const CatalogEntry& entry : catalog()) {
    const int bits = entry.value_bits(lattice.bits);
    const Arithmetic* a = ladder.data();
    while (bits > a->bits) ++a;
    savings.push_back({std::string(entry.name), bits, a->name, a->skips});
  }
  return savings;
}

}  // namespace plumb::tool
