// The formulas of the manifest over GMP's rationals.
#include <stdexcept>
#include <string>

#include "oracle/oracle.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb::oracle {
namespace {

// As BigRational, but its operations are calls: so many formulas of so many operations compile in no time.
struct Exact {
  BigRational value;
};
[[gnu::noinline]] Exact operator+(const Exact& a, const Exact& b) { return {a.value + b.value}; }
[[gnu::noinline]] Exact operator-(const Exact& a, const Exact& b) { return {a.value - b.value}; }
[[gnu::noinline]] Exact operator*(const Exact& a, const Exact& b) { return {a.value * b.value}; }

template <Formula F>
Sign run(std::span<const double> p) {
  return evaluate<F>([&](std::size_t i) { return Exact{big_rational(p[i])}; }).value.sign();
}

}  // namespace

Sign rational_sign(std::string_view predicate, std::span<const double> coordinates) {
#define PLUMB_IF_NAMED(formula)                                                                   \
  if (predicate == predicates::formula::name && coordinates.size() == arity<predicates::formula>) \
    return run<predicates::formula>(coordinates);
  PLUMB_PREDICATES(PLUMB_IF_NAMED)
#undef PLUMB_IF_NAMED
  throw std::invalid_argument("no predicate " + std::string(predicate) + " of " + std::to_string(coordinates.size()) +
                              " coordinates");
}

}  // namespace plumb::oracle
