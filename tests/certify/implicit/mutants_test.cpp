// Would a slip in the statement of a mix be noticed?  Each operation of a mix is changed in turn, and the cases must
// tell the changed one from the rationals, which know no weights.
#include <gmpxx.h>

#include <iostream>

#include "certify/implicit/cases.hpp"
#include "plumb/arith/big.hpp"

namespace plumb::implicit_cases {
namespace {

using Instructions = std::vector<certify::tape::Instruction>;

struct Judged {
  std::vector<double> numbers;
  Sign sign;  // that the polynomial must have
};

template <class Point>
void add(const Point& p, bool squared, Judged& judged, std::vector<oracle::Constructed>& told) {
  const auto numbers = coordinates(p);
  judged.numbers.insert(judged.numbers.end(), numbers.begin(), numbers.end());
  told.push_back(constructed(p));
  if (squared) return;
  judged.sign = judged.sign * homogeneous(p, [](double x) { return big_rational(x); }).weight.sign();
}

template <class... Points>
std::vector<Judged> judged_cases(Question question, bool squared, std::uint64_t count) {
  std::vector<Judged> all;
  for (std::uint64_t index = 0; index < count; ++index) {
    Entropy entropy(14, index);
    Pool pool({index % 4 != 0, Family::uniform}, std::array{KindOf<Points>::dimension...}[0], entropy);
    std::tuple<Points...> points;
    Judged judged{{}, Sign::positive};
    std::vector<oracle::Constructed> told;
    std::apply([&](auto&... p) { ((pool.make(p), add(p, squared, judged, told)), ...); }, points);
    const auto exact = oracle::rational_sign(question, told);
    if (!exact) continue;
    judged.sign = judged.sign * *exact;
    all.push_back(std::move(judged));
  }
  return all;
}

bool noticed(const certify::tape::Program& program, const std::vector<Judged>& judged) {
  return std::ranges::any_of(judged, [&](const Judged& c) { return big_integer_sign(program, c.numbers) != c.sign; });
}

mpz_class value(const certify::tape::Program& program, std::vector<mpz_class> number) {
  for (const certify::tape::Instruction& i : program.instructions) {
    const mpz_class &l = number[i.left], &r = number[i.right];
    number.push_back(i.operation == '+' ? mpz_class(l + r) : i.operation == '-' ? mpz_class(l - r) : mpz_class(l * r));
  }
  return number.back();
}

// At a random point, which two different polynomials share with a probability below 2^-40.
bool same_polynomial(const certify::tape::Program& a, const certify::tape::Program& b) {
  Entropy entropy(99);
  std::vector<mpz_class> x;
  for (std::size_t i = 0; i < a.arity; ++i) x.emplace_back(static_cast<unsigned long>(entropy.bits(50)));
  return value(a, x) == value(b, x);
}

template <class Predicate, class... Points>
void check_mutants(Question question) {
  SCOPED_TRACE(__PRETTY_FUNCTION__);
  const certify::tape::Program program = plumb::certify::tape::program<Mixed<Predicate, KindOf<Points>...>>();
  const auto judged = judged_cases<Points...>(question, Predicate::weights_are_squared, 300);
  ASSERT_GT(judged.size(), 25u);
  ASSERT_FALSE(noticed(program, judged));
  int mutants = 0, equal = 0;
  const auto try_mutant = [&](std::size_t at, const certify::tape::Instruction& changed) {
    Instructions instructions(program.instructions.begin(), program.instructions.end());
    instructions[at] = changed;
    const certify::tape::Program mutant{program.arity, instructions};
    ++mutants;
    if (noticed(mutant, judged)) return;
    if (same_polynomial(mutant, program)) {
      ++equal;
    } else {
      ADD_FAILURE() << "instruction " << at << " may become " << changed.operation << " unnoticed";
    }
  };
  for (std::size_t at = 0; at < program.instructions.size(); ++at) {
    const certify::tape::Instruction is = program.instructions[at];
    if (is.operation == '*') continue;
    try_mutant(at, {is.operation == '+' ? '-' : '+', is.left, is.right});
    if (is.operation == '-') try_mutant(at, {'-', is.right, is.left});
  }
  std::cout << Predicate::name << ": " << mutants << " mutants, " << equal << " equivalent, " << judged.size()
            << " cases\n";
  EXPECT_LT(equal * 20, mutants);
}

TEST(ImplicitMutants, OfOrient2d) {
  using C = LineLinePoint2;
  check_mutants<predicates::HomogeneousOrient2d, C, C, C>(Question::orient);
  check_mutants<predicates::HomogeneousOrient2d, SegmentPoint2, C, Posed<Point2, Pose2>>(Question::orient);
}

TEST(ImplicitMutants, OfInCircle) {
  using C = LineLinePoint2;
  check_mutants<predicates::HomogeneousInCircle, C, C, C, C>(Question::in_sphere);
  check_mutants<predicates::HomogeneousInCircle, C, Point2, C, SegmentPoint2>(Question::in_sphere);
}

TEST(ImplicitMutants, OfOrient3d) {
  using L = LinePlanePoint3;
  using T = ThreePlanePoint3;
  check_mutants<predicates::HomogeneousOrient3d, L, L, L, L>(Question::orient);
  check_mutants<predicates::HomogeneousOrient3d, T, Point3, Point3, L>(Question::orient);
  check_mutants<predicates::HomogeneousOrient3d, Posed<Point3>, SegmentPoint3, L, SegmentPoint3>(Question::orient);
}

TEST(ImplicitMutants, OfInSphere) {
  using L = LinePlanePoint3;
  check_mutants<predicates::HomogeneousInSphere, L, L, L, L, L>(Question::in_sphere);
  check_mutants<predicates::HomogeneousInSphere, L, Posed<Point3>, Point3, L, SegmentPoint3>(Question::in_sphere);
}

}  // namespace
}  // namespace plumb::implicit_cases
