// The last stage: replays a formula's tape over GMP integers with exponents.
#include <vector>

#include "plumb/arith/big.hpp"
#include "plumb/certify/exact_stages.hpp"

namespace plumb {

Sign big_integer_sign(Program program, std::span<const double> coordinates) {
  std::vector<BigDyadic> number;
  number.reserve(coordinates.size() + program.instructions.size());
  for (const double x : coordinates) number.emplace_back(x);
  for (const Instruction& i : program.instructions) {
    const BigDyadic &l = number[i.left], &r = number[i.right];
    number.push_back(i.operation == '+' ? l + r : i.operation == '-' ? l - r : l * r);
  }
  return number.back().sign();
}

}  // namespace plumb
