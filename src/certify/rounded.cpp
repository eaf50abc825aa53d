#include "certify/rounded.hpp"

#include <vector>

#include "arith/big_rounding.hpp"

namespace plumb::certify::rounding {
namespace {

BigDyadic value(certify::tape::Program program, std::span<const double> coordinates) {
  std::vector<BigDyadic> number;
  number.reserve(coordinates.size() + program.instructions.size());
  for (const double x : coordinates) number.emplace_back(x);
  for (const certify::tape::Instruction& i : program.instructions) {
    const BigDyadic &l = number[i.left], &r = number[i.right];
    number.push_back(i.operation == '*' ? l * r : i.operation == '-' ? l - r : l + r);
  }
  return number.back();
}

}  // namespace

double by_integers(Rounding rounding, Form form, certify::tape::Program numerator, certify::tape::Program denominator,
                   std::span<const double> coordinates) {
  const BigDyadic n = value(numerator, coordinates);
  const BigDyadic d = denominator.instructions.empty() ? BigDyadic(1) : value(denominator, coordinates);
  return form == Form::root ? plumb::rounded_root(rounding, n, d) : plumb::rounded_quotient(rounding, n, d);
}

}  // namespace plumb::certify::rounding
