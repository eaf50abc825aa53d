// The formulas beyond the classic four, all in one target: the first byte says which.
#include "predicate_fuzz.hpp"

namespace {

using namespace plumb;

// The tape over rationals.
Sign replayed(const certify::tape::Program& program, const std::vector<double>& p) {
  std::vector<BigRational> number;
  for (const double x : p) number.push_back(big_rational(x));
  for (const certify::tape::Instruction& i : program.instructions) {
    const BigRational &l = number[i.left], &r = number[i.right];
    number.push_back(i.operation == '+' ? l + r : i.operation == '-' ? l - r : l * r);
  }
  return number.back().sign();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::span<const CatalogEntry> formulas = catalog().subspan(classics().size());
  const CatalogEntry& e = formulas[data[0] % formulas.size()];
  return fuzz::run(e, {data + 1, size - 1}, [&](const std::vector<double>& p) { return replayed(e.program, p); });
}
