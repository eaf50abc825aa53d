#include "tool/plan/lattice_savings.hpp"

#include <array>

#include "plumb/certify/detail/exact_stages.hpp"
#include "plumb/certify/plan.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb::tool {
namespace {

struct Width {
  int bits;  // values below 2^bits are exact
  const char* name;
};

constexpr std::array<Width, 6> ladder{{{63, "64-bit integers"},
                                       {127, "128-bit integers"},
                                       {255, "256-bit integers"},
                                       {511, "512-bit integers"},
                                       {1023, "1024-bit integers"},
                                       {1 << 30, "GMP integers"}}};

template <Formula F>
Saving saving(const Lattice& lattice) {
  const int bits = value_bits<F>(lattice.bits);
  // In doubles every intermediate value is a multiple of 2^(exponent * degree), which must not underflow or overflow.
  const int unit = lattice.exponent * degree<F>();
  if (bits <= 53 && unit >= -1074 && unit + bits <= 1023)
    return {std::string(F::name), bits, "plain double", "the filter or an exact stage",
            std::string(to_string(arithmetic_for<F>(lattice.bits)))};
  const Width* a = ladder.data();
  while (bits > a->bits) ++a;
  const bool in_words = certify::integer::short_enough(lattice);
  return {std::string(F::name), bits, a->name,
          in_words                                    ? "long-double, wide-integer, interval, big-integer"
          : certify::integer::wide_enough<F>(lattice) ? "interval, big-integer"
                                                      : "",
          std::string(to_string(arithmetic_for<F>(lattice.bits)))};
}

}  // namespace

std::vector<Saving> lattice_savings(const Lattice& lattice) {
#define PLUMB_SAVING(formula) saving<predicates::formula>(lattice),
  return {PLUMB_CLASSICS(PLUMB_SAVING)};
#undef PLUMB_SAVING
}

}  // namespace plumb::tool
