// Perturbation of every formula of the manifest: by moved coordinates and by expansion the sign is the same, is never
// zero, and, where the formula is short, is the one that the definition has.
#include "certify/catalog.hpp"

#include <gtest/gtest.h>

#include "certify/expanded_oracle.hpp"
#include "plumb/certify/perturbed.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb {
namespace {

template <class Number, class Make>
Number replay(const certify::tape::Program& program, Make make) {
  std::vector<Number> value;
  for (std::size_t i = 0; i < program.arity; ++i) value.push_back(make(i));
  for (const certify::tape::Instruction& step : program.instructions) {
    const Number &l = value[step.left], &r = value[step.right];
    value.push_back(step.operation == '*' ? l * r : step.operation == '-' ? l - r : l + r);
  }
  return value.back();
}

const CatalogEntry* asked = nullptr;
Sign ask(std::span<const double> p) { return asked->decide(p).sign; }

class PerturbedCatalog : public testing::TestWithParam<const CatalogEntry*> {
 protected:
  void SetUp() override { asked = GetParam(); }

  const CatalogEntry& entry_ = *GetParam();
  const Occurrence<64> occurrence_ =
      replay<Occurrence<64>>(entry_.program, [](std::size_t i) { return Occurrence<64>::coordinate(i); });
  const certify::perturbation::Subject subject_{
      entry_.name,        entry_.arguments,   false, entry_.homogeneous, entry_.program,
      occurrence_.degree, occurrence_.beside, ask};
};

TEST_P(PerturbedCatalog, AgreesWithTheExpansion) {
  const std::size_t arity = entry_.arity();
  const bool is_short = arity <= 8 && entry_.degree <= 4;
  std::uint64_t zeros = 0;
  for (std::uint64_t number = 0; number < 10'000 && zeros < 100; ++number) {
    Entropy e(17, number);
    std::vector<double> p(arity);
    for (double& x : p) x = static_cast<double>(e.within(number % 3 == 0 ? 2 : 1));
    if (number % 100 == 99) std::ranges::fill(p, number % 200 == 99 ? 0.0 : 0.5);
    if (entry_.decide(p).sign != Sign::zero) continue;
    ++zeros;
    std::vector<std::uint64_t> indices(entry_.arguments.size());
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = e.below(100) * 100 + i;
    std::vector<std::uint16_t> order;
    std::vector<std::size_t> argument(arity);
    for (std::size_t a = 0, i = 0; a < indices.size(); ++a) {
      for (int k = 0; k < entry_.arguments[a]; ++k, ++i) {
        argument[i] = a;
        order.push_back(static_cast<std::uint16_t>(i));
      }
    }
    std::ranges::stable_sort(order, {}, [&](std::uint16_t i) { return indices[argument[i]]; });

    const Sign s = certify::perturbation::sign_of_zero(subject_, p, indices);
    ASSERT_NE(s, Sign::zero) << number;
    ASSERT_EQ(certify::perturbation::expanded_sign(entry_.program, entry_.homogeneous, p, order), s) << number;
    if (!is_short) continue;
    const auto defined = replay<oracle::Expanded>(entry_.program, [&](std::size_t i) {
      oracle::Expanded x;
      x.add(std::vector<int>(arity), mpq_class(p[i]));
      std::vector<int> own(arity);
      own[static_cast<std::size_t>(order.end() - std::ranges::find(order, i)) - 1] = 1;
      x.add(own, 1);
      return x;
    });
    ASSERT_EQ(defined.sign(), s) << number;
  }
  EXPECT_GT(zeros, 0u);
}

std::vector<const CatalogEntry*> entries() {
  std::vector<const CatalogEntry*> all;
  for (const CatalogEntry& e : catalog()) all.push_back(&e);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Manifest, PerturbedCatalog, testing::ValuesIn(entries()),
                         [](const auto& at) { return std::string(at.param->name); });

}  // namespace
}  // namespace plumb
