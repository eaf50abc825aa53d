#include "tool/mesh/rational_sign.hpp"

#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb::tool {

Sign rational_sign(std::string_view predicate, std::span<const double> coordinates) {
#define PLUMB_RATIONAL(formula)                                                                               \
  if (predicate == predicates::formula::name) {                                                               \
    return evaluate<predicates::formula>([&](std::size_t i) { return big_rational(coordinates[i]); }).sign(); \
  }
  PLUMB_CLASSICS(PLUMB_RATIONAL)
#undef PLUMB_RATIONAL
  throw Error("there is no predicate " + std::string(predicate));
}

}  // namespace plumb::tool
