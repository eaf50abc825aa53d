// Is a user's own question asked as the library's are: hard inputs, valid cases, small findings, lines that replay?
#include "plumb/degenerate/own_kind.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "plumb/arith/error.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/degenerate/check.hpp"
#include "plumb/degenerate/paste.hpp"
#include "plumb/degenerate/ulps.hpp"
#include "plumb/query/kinds/kinds.hpp"

namespace plumb::degenerate {
namespace {

struct NearerSite {
  static constexpr std::string_view name = "nearer-site";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    const auto ax = p[0] - p[2], ay = p[1] - p[3], bx = p[0] - p[4], by = p[1] - p[5];
    return ax * ax + ay * ay - bx * bx - by * by;
  }
};

double by_hypot(const double* p, const double* a, const double* b) {
  return std::hypot(p[0] - a[0], p[1] - a[1]) - std::hypot(p[0] - b[0], p[1] - b[1]);
}

int sign_by_rationals(std::span<const double> q) {
  const auto square = [&](std::size_t to) {
    const Rational x = Rational(q[0]) - Rational(q[to]), y = Rational(q[1]) - Rational(q[to + 1]);
    return x * x + y * y;
  };
  return static_cast<int>((square(2) - square(4)).sign());
}

/// Whether some coordinate's neighbor has another answer, or none is needed: the answer is zero.
bool is_at_change(const Kind& kind, const Numbers& numbers) {
  const double answer = kind.exact(numbers).numbers[0];
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (const int step : {-1, 1}) {
      Numbers moved = numbers;
      moved[i] = moved_by_ulps(moved[i], step);
      if (kind.exact(moved).numbers[0] != answer) return true;
    }
  }
  return false;
}

TEST(OwnKind, OfAFormulaIsAskedShrunkAndWritten) {
  const Kind kind = formula_kind<NearerSite>();
  EXPECT_EQ(kind.signature, "double f(const double a[2], const double b[2], const double c[2])");
  for (const Generator& g : kind.generators) {
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Numbers q = case_of(kind, g.name, 4, i);
      ASSERT_EQ(flaw_of(kind, q), "") << g.name;
      EXPECT_EQ(kind.exact(q).numbers[0], sign_by_rationals(q)) << case_line(kind, q);
    }
  }
  const Findings findings = check(kind, by_hypot, {.cases = 200});
  ASSERT_FALSE(findings.clean());
  EXPECT_FALSE(check(kind, by_hypot, {.cases = 200, .generators = {"at_change"}, .domain = {.largest = 1000}}).clean());
  for (const Finding& f : findings.findings) {
    const auto read = parse_case(kind, case_line(kind, f.smallest));
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, f.smallest);
    EXPECT_EQ(judge(kind, *read, by_hypot(&(*read)[0], &(*read)[2], &(*read)[4]), {}).sort, f.sort);
  }
  EXPECT_TRUE(check(kind, kind.exact, {.cases = 50}).clean());
  EXPECT_NE(cpp_text(kind, findings.findings[0].smallest, "mine").find("(mine(a, b, c), 0);"), std::string::npos);
  EXPECT_THROW(check(
                   kind, +[](const double*, const double*) { return 0.0; }),
               Error);
}

TEST(OwnKind, OfEveryPredicateHasCasesWhereItsSignChanges) {
  std::set<std::string> names;
  int all_changes = 0;
  for (const Kind& kind : predicate_kinds()) {
    names.insert(kind.name);
    EXPECT_EQ(&kind_named(kind.name), &kind);
    int changes = 0;
    for (std::uint64_t i = 0; i < 12; ++i) {
      const Numbers q = case_of(kind, "at_change", 8, i);
      ASSERT_EQ(flaw_of(kind, q), "") << kind.name;
      changes += is_at_change(kind, q) ? 1 : 0;
    }
    EXPECT_GE(changes, 1) << kind.name;  // sums of squares change where they vanish alone
    all_changes += changes;
    for (const Generator& g : kind.generators) EXPECT_EQ(flaw_of(kind, case_of(kind, g.name, 8, 0)), "") << g.name;
  }
  EXPECT_GT(names.size(), 50u);
  EXPECT_GT(all_changes, static_cast<int>(9 * names.size()));
  EXPECT_FALSE(names.contains("orient2d"));  // which is a kind of the table
}

/// A ball around a point of a counted set that is above a box's lowest corner, along a direction: all roles at once.
Kind of_all_roles() {
  return own_kind({.name = "all-roles",
                   .arguments = {any_points("set", 3, 2),
                                 box("bounds", 3),
                                 lengths("radius"),
                                 {"ray", {{Role::points, 3}, {Role::vector, 3}}}},
                   .form = AnswerForm::yes_no,
                   .exact = [](std::span<const double> q) { return Answer(q[1] > q[q.size() - 3] ? 1.0 : 0.0); }});
}

TEST(OwnKind, OfAnyArgumentsHasValidCasesAndIsCalled) {
  const Kind kind = of_all_roles();
  EXPECT_EQ(kind.signature,
            "int f(const double* set, size_t set_count, const double bounds[6], const double radius[1], const double "
            "ray[6])");
  std::set<double> counts;
  for (const Generator& g : kind.generators) {
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Numbers q = case_of(kind, g.name, 4, i);
      ASSERT_EQ(flaw_of(kind, q), "") << g.name;
      counts.insert(q[0]);
    }
  }
  EXPECT_GE(counts.size(), 5u);
  EXPECT_EQ(*counts.begin(), 2);
  const auto right = [](const double* set, std::size_t n, const double*, const double*, const double* ray) {
    return n > 1 && set[0] > ray[3] ? 7 : 0;
  };
  EXPECT_TRUE(check(kind, +right, {.cases = 50}).clean());
  const auto wrong = [](const double* set, std::size_t, const double*, const double* radius, const double* ray) {
    return set[0] > ray[3] && radius[0] < 5 ? 1 : 0;
  };
  const Findings findings = check(kind, +wrong, {.cases = 100});
  ASSERT_FALSE(findings.clean());
  EXPECT_EQ(findings.findings[0].smallest[0], 2);  // points are dropped
}

TEST(OwnKind, FindsNothingWhereNothingIsKnown) {
  const Kind kind = own_kind({.name = "unknown", .arguments = {points("a", 1)}, .exact = [](std::span<const double>) {
                                return Answer(std::nan(""));
                              }});
  EXPECT_TRUE(check(kind, Callable([](std::span<const double>) { return Answer(1.0); }), {.cases = 20}).clean());
}

std::vector<Argument> many(std::size_t count, const Argument& argument) {
  std::vector<Argument> all(count, argument);
  for (std::size_t i = 0; i < count; ++i) all[i].name += std::to_string(i);
  return all;
}

TEST(OwnKind, IsRefusedWhereItCannotBeAsked) {
  const Exact no = [](std::span<const double>) { return Answer(0.0); };
  const auto refused = [](const OwnKind& own) -> std::string {
    try {
      own_kind(own);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  const std::vector<Argument> one{points("a", 2)};
  EXPECT_EQ(refused({.name = "fine", .arguments = one, .exact = no}), "");
  EXPECT_NE(refused({.name = "two words", .arguments = one, .exact = no}).find("of letters"), std::string::npos);
  EXPECT_NE(refused({.name = "../up", .arguments = one, .exact = no}).find("of letters"), std::string::npos);
  EXPECT_NE(refused({.name = "2d", .arguments = one, .exact = no}).find("of letters"), std::string::npos);
  EXPECT_NE(refused({.name = "n", .arguments = one, .exact = {}}).find("in `exact`"), std::string::npos);
  EXPECT_NE(refused({.name = "n", .arguments = {}, .exact = no}).find("0 arguments"), std::string::npos);
  EXPECT_NE(refused({.name = "n", .arguments = many(13, one[0]), .exact = no}).find("1 to 12"), std::string::npos);
  EXPECT_NE(refused({.name = "n", .arguments = many(6, any_points("a", 2)), .exact = no}).find("1 to 5"),
            std::string::npos);
  EXPECT_NE(refused({.name = "n", .arguments = {points("1a", 2)}, .exact = no}).find("no name for an argument"),
            std::string::npos);
  EXPECT_NE(
      refused({.name = "n", .arguments = one, .form = AnswerForm::triangles, .exact = no}).find("can be answered"),
      std::string::npos);
  EXPECT_NE(
      refused({.name = "n", .arguments = {{"f", {{Role::frame, 3, 3}}}}, .exact = no}).find("generators of your own"),
      std::string::npos);
}

/// One argument, of which nothing is known but its parts.
Kind of_parts(std::vector<Part> parts) {
  return own_kind({.name = "parts",
                   .arguments = {{"a", std::move(parts)}},
                   .form = AnswerForm::yes_no,
                   .exact = [](std::span<const double>) { return Answer(0.0); }});
}

TEST(OwnKind, IsWrittenAndDrawnOfWhateverParts) {
  struct Case {
    std::vector<Part> parts;
    Numbers numbers;
    std::string text, obj;
  };
  for (const Case& c : {
           Case{{{Role::points, 2}, {Role::vector, 2}},
                {1, 2, 3, 4},
                "a = (1, 2) (3, 4)",
                "o a\nv 1 2 0\nv 4 6 0\nl 1 2\n"},
           Case{{{Role::points, 3}, {Role::extents, 1}}, {1, 2, 3, 4}, "a = (1, 2, 3) (4)", "o a\nv 1 2 3\np 1\n"},
           Case{{{Role::points, 3, 2}, {Role::extents, 1}},
                {0, 0, 0, 1, 1, 1, 4},
                "a = (0, 0, 0) (1, 1, 1) (4)",
                "o a\nv 0 0 0\nv 1 1 1\nl 1 2\n"},
           Case{{{Role::corners, 2, 2}},
                {0, 0, 2, 1},
                "a = (0, 0) (2, 1)",
                "o a\nv 0 0 0\nv 2 0 0\nv 0 1 0\nv 2 1 0\nf 1 2 4 3\n"},
           Case{{{Role::corners, 1, 2}}, {0, 2}, "a = (0) (2)", "o a\nv 0 0 0\nv 2 0 0\nl 1 2\n"},
           Case{{{Role::points, 4}}, {1, 2, 3, 4}, "a = (1, 2, 3, 4)", "o a\n"},
           Case{{{Role::vector, 3}}, {1, 2, 3}, "a = (1, 2, 3)", "o a\n"},
       }) {
    const Kind kind = of_parts(c.parts);
    EXPECT_EQ(decimal_text(kind, c.numbers), c.text);
    const std::string obj = obj_text(kind, c.numbers);
    EXPECT_EQ(obj.substr(obj.find('\n') + 1), c.obj) << c.text;
  }
}

TEST(OwnKind, IsAskedAndShrunkOfWhateverParts) {
  for (const std::vector<Part>& parts : std::vector<std::vector<Part>>{{{Role::extents, 1}},
                                                                       {{Role::extents, 3}},
                                                                       {{Role::points, 1, 2}},
                                                                       {{Role::points, 2}, {Role::points, 3, 2}},
                                                                       {{Role::points, 9, 3}},
                                                                       {{Role::vector, 4}}}) {
    const Kind kind = of_parts(parts);
    const Findings found = check(kind, [](std::span<const double>) { return Answer(1.0); }, {.cases = 60});
    ASSERT_FALSE(found.clean());
    for (const Finding& f : found.findings) EXPECT_EQ(flaw_of(kind, f.smallest), "") << f.generator;
  }
  // Of one dimension, and of four: three points of a line span less than others do.
  EXPECT_FALSE(is_degenerate(of_parts({{Role::points, 1, 2}}), Numbers{0, 1}));
  EXPECT_TRUE(is_degenerate(of_parts({{Role::points, 1, 2}}), Numbers{1, 1}));
  const Kind triangle = of_parts({{Role::points, 4, 3}});
  EXPECT_TRUE(is_degenerate(triangle, Numbers{0, 0, 0, 0, 1, 2, 3, 4, 2, 4, 6, 8}));
  EXPECT_FALSE(is_degenerate(triangle, Numbers{0, 0, 0, 0, 1, 2, 3, 4, 2, 4, 6, 9}));
}

TEST(OwnKind, IsPastedWhereNobodyKnowsTheAnswer) {
  for (const AnswerForm form : {AnswerForm::sign, AnswerForm::yes_no, AnswerForm::number}) {
    const Kind kind = own_kind({.name = "open",
                                .arguments = {points("max", 2), points("in", 2)},
                                .form = form,
                                .exact = [](std::span<const double>) { return Answer(std::nan("")); }});
    const Numbers numbers{1, 2, 3, 4};
    EXPECT_NE(cpp_text(kind, numbers, "f").find("  f(max, in);  // any answer will do\n"), std::string::npos);
    const std::string script = python_text(kind, numbers, "f");
    EXPECT_NE(script.find("EXACT = math.nan"), std::string::npos);
    EXPECT_NE(script.find("def judge(given):\n    return \"right\"\n"), std::string::npos);
    // Names that mean something else there.
    EXPECT_NE(script.find("\nmax_ = "), std::string::npos);
    EXPECT_NE(script.find("\nin_ = "), std::string::npos);
  }
}

TEST(OwnKind, HasNamesThatCTakes) {
  const auto named = [](const char* a, const char* b) {
    return own_kind({.name = "k", .arguments = {points(a, 2), points(b, 2)}, .exact = [](std::span<const double>) {
                       return Answer(0.0);
                     }});
  };
  EXPECT_NO_THROW(named("a", "b"));
  EXPECT_THROW(named("a", "a"), Error);
  EXPECT_THROW(named("a", "new"), Error);
  EXPECT_THROW(named("int", "b"), Error);
}

}  // namespace
}  // namespace plumb::degenerate
