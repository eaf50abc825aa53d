#include "plumb/certify/radical.hpp"

#include <string>

#include "plumb/arith/error.hpp"

namespace plumb::certify::radical {
namespace {

using predicates::RadicalNorm, predicates::RadicalPairNorm, predicates::RadicalPairPart;

// Throws for numbers that are none, and for a radicand below zero.
template <Formula F>
void check(std::string_view name, const Coordinates<F>& p) {
  require_finite<F>(p, name);
  for (std::size_t i = 2; i < p.size(); i += 2) {
    if (p[i] < 0) throw_negative(std::string(1, static_cast<char>('a' + i)));
  }
}

}  // namespace

void throw_negative(std::string_view radicand) {
  throw NegativeRadicand("the radicand " + std::string(radicand) +
                         " is negative and has no real root; give one that is zero or positive");
}

Sign decide_exactly(double a, double b, double c) {
  check<RadicalNorm>("sign_of_radical", {a, b, c});
  return sum(sign_of_number(a), sign_of_number(b) * sign_of_number(c), [&] { return decide<RadicalNorm>({a, b, c}); });
}

Sign decide_exactly(double a, double b, double c, double d, double e) {
  check<RadicalPairNorm>("sign_of_radicals", {a, b, c, d, e});
  const Sign x = sign_of_number(a), y = sign_of_number(b) * sign_of_number(c),
             z = sign_of_number(d) * sign_of_number(e);
  return sum(sum(x, y,
                 [&] {
                   return decide<RadicalNorm>({a, b, c});
                 }),
             z, [&] {
               return sum(decide<RadicalPairPart>({a, b, c, d, e}), x * y, [&] {
                 return decide<RadicalPairNorm>({a, b, c, d, e});
               });
             });
}

}  // namespace plumb::certify::radical
