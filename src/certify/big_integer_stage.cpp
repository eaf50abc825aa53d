// The last stage: replays a formula's tape over GMP integers.
#include <vector>

#include "plumb/arith/big.hpp"
#include "plumb/certify/exact_stages.hpp"

namespace plumb {

Sign big_integer_sign(Program program, std::span<const double> coordinates) {
  const int exponent = lattice_of(coordinates).exponent;
  std::vector<BigInteger> number;
  number.reserve(coordinates.size() + program.instructions.size());
  for (const double x : coordinates) number.push_back(big_integer(x, exponent));
  for (const Instruction& i : program.instructions) {
    const BigInteger &l = number[i.left], &r = number[i.right];
    number.push_back(i.operation == '+' ? l + r : i.operation == '-' ? l - r : l * r);
  }
  return number.back().sign();
}

}  // namespace plumb
