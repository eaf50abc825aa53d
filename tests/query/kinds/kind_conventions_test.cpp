// Are a kind's answers those of the convention that is declared, and its cases in the domain?
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "figure/basic/rational_polygon.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/query/kinds/kinds.hpp"
#include "query/kinds/kind_judges.hpp"
#include "query/ray/mesh_oracle.hpp"

namespace plumb::degenerate {
namespace {

#ifdef PLUMB_LONG_TESTS
constexpr std::uint64_t judged_cases = 1'000;
#else
constexpr std::uint64_t judged_cases = 12;
#endif

using kind_judges::at, kind_judges::meet_by_program, kind_judges::spanned, oracle::Spanned;
using Given = std::span<const double>;

/// Every way to declare a kind, but `any`.
std::vector<Convention> conventions_of(const Kind& kind) {
  std::vector<Convention> all;
  if (kind.has_boundary) all.push_back({.boundary = Boundary::out});
  if (kind.has_ends) all.push_back({.ends = Ends::open});
  if (kind.has_boundary && kind.has_ends) all.push_back({Boundary::out, Ends::open});
  return all;
}

/// By relative interiors: of the figures, or of one and the corners, edges and insides that make up the other.
bool hits_by_program(Given q, const Convention& c) {
  const auto overlap = [](const Spanned& a, const Spanned& b) {
    return oracle::relation(a, b) == Relation::overlapping;
  };
  const Spanned ray{{at(q, 0)}, {at(q, 3)}}, origin = spanned(q, 0, 1), whole = spanned(q, 6, 3);
  std::vector<Spanned> targets{whole};
  if (c.boundary == Boundary::in) {
    for (std::size_t i = 0; i < 3; ++i) {
      targets.push_back({{whole.points[i]}, {}});
      targets.push_back({{whole.points[i], whole.points[(i + 1) % 3]}, {}});
    }
  }
  return std::ranges::any_of(targets, [&](const Spanned& target) {
    return overlap(ray, target) || (c.ends == Ends::closed && overlap(origin, target));
  });
}

bool yes_under(const Kind& kind, Given q, const Convention& c) {
  if (kind.name == "ray-triangle") return hits_by_program(q, c);
  if (kind.name == "ray-mesh") {
    for (const auto& corners : mesh_oracle::triangles_of(q.subspan(6))) {
      Numbers one(q.begin(), q.begin() + 6);
      for (const double* p : corners.at) one.insert(one.end(), p, p + 3);
      if (hits_by_program(one, c)) return true;
    }
    return false;
  }
  if (kind.name == "point-in-polygon") {
    std::vector<Point2> chain;
    for (std::size_t i = 3; i < q.size(); i += 2) chain.push_back({q[i], q[i + 1]});
    const std::span<const Point2> one(chain);
    return plumb_test::location(std::span(&one, 1), {q[0], q[1]}) == Location::inside;
  }
  if (kind.name == "point-in-polyhedron") {
    const exact::Coordinates p = exact::of(Point3{q[0], q[1], q[2]});
    for (const auto& corners : mesh_oracle::triangles_of(q.subspan(3))) {
      if (exact::in_hull(corners.rational(), p)) return false;
    }
    return mesh_oracle::is_in(q);
  }
  return meet_by_program(kind, q, true);
}

TEST(Convention, IsFollowedByEveryKindThatHasIt) {
  std::map<std::string, int> changed;
  for (const Kind& kind : kinds()) {
    for (const Convention& c : conventions_of(kind)) {
      const Kind other = under(kind, c);
      EXPECT_EQ(other.declared, c);
      EXPECT_NE(other.convention, kind.convention);
      for (const Generator& g : kind.generators) {
        for (std::uint64_t i = 0; i < judged_cases; ++i) {
          const Numbers q = case_of(kind, g.name, 6, i);
          const bool yes = yes_under(kind, q, c);
          const Answer exact = other.exact(q), closed = kind.exact(q);
          ASSERT_EQ(exact.numbers[0] != 0, yes) << other.convention << '\n' << case_line(kind, q);
          EXPECT_LE(exact.numbers[0], closed.numbers[0]);  // nothing is added
          if (yes && kind.name == "ray-triangle") {
            EXPECT_EQ(exact.numbers[1], closed.numbers[1]);
          }
          changed[kind.name] += yes != (closed.numbers[0] != 0) ? 1 : 0;
        }
      }
    }
    if (conventions_of(kind).empty()) {
      EXPECT_THROW(under(kind, {.boundary = Boundary::out}), Error) << kind.name;
      EXPECT_THROW(under(kind, {.ends = Ends::any}), Error) << kind.name;
    } else {
      EXPECT_GE(changed[kind.name], 5) << kind.name;
    }
  }
}

TEST(Convention, LeavesOpenWhatIsNotPromised) {
  const Kind& closed = kind_named("point-in-polygon");
  const Kind open = under(closed, {.boundary = Boundary::out}), any = under(closed, {.boundary = Boundary::any});
  const Numbers corner{0, 0, 3, 0, 0, 2, 0, 0, 2}, inside{0.5, 0.5, 3, 0, 0, 2, 0, 0, 2};
  const auto sort = [](const Kind& kind, const Numbers& q, double given) {
    return std::string(judge(kind, q, given, {}).sort);
  };
  EXPECT_EQ(sort(closed, corner, 0), "no for yes");
  EXPECT_EQ(sort(open, corner, 1), "yes for no");
  EXPECT_EQ(sort(open, corner, 0), "");
  EXPECT_EQ(sort(any, corner, 0), "");
  EXPECT_EQ(sort(any, corner, 1), "");
  EXPECT_EQ(sort(any, inside, 0), "no for yes");
  const Kind ray = under(kind_named("ray-triangle"), {Boundary::any, Ends::any});
  const Numbers from_edge{0, 0, 0, 0, 0, 1, -1, 0, 0, 1, 0, 0, 0, 1, 0};
  EXPECT_EQ(sort(ray, from_edge, 0), "");
  EXPECT_EQ(sort(ray, from_edge, 1), "");
  // Of a test that is written for it, the library judges where two answers are right, and only there.
  const std::string judged = cpp_text(ray, from_edge, "mine");
  EXPECT_NE(judged.find("under(kind_named(\"ray-triangle\"), {Boundary::any, Ends::any})"), std::string::npos)
      << judged;
  EXPECT_NE(cpp_text(any, inside, "mine").find("EXPECT_NE(mine(p, vertices, 3), 0);"), std::string::npos);
  // A function that is right under a convention is found clean under it, and only there.
  const auto strict = [](const double* p, const double* vertices, std::size_t n) {
    Polygon2 polygon;
    for (std::size_t i = 0; i < n; ++i) polygon.vertices.push_back({vertices[2 * i], vertices[2 * i + 1]});
    return locate(polygon, Point2{p[0], p[1]}) == Location::inside ? 1 : 0;
  };
  EXPECT_FALSE(check(closed, +strict, {.cases = 50}).clean());
  EXPECT_TRUE(check(open, +strict, {.cases = 50}).clean());
  EXPECT_TRUE(check(any, +strict, {.cases = 50}).clean());
}

TEST(Domain, HoldsTheCasesOfEveryKind) {
  const std::vector<Domain> domains{{.largest = 1e6},
                                    {.largest = 1e6, .grid = 0x1p-10},
                                    {.largest = 100, .smallest = 1e-3, .bits = 24},
                                    {.grid = 1},
                                    {.largest = 3e38, .smallest = 1e-38, .bits = 24},
                                    {.largest = 1000, .grid = 1, .degenerate = false}};
  for (const Kind& kind : kinds()) {
    for (const Domain& d : domains) {
      std::uint64_t seen = 0;
      const auto ask = [&](Given q) {
        ++seen;
        EXPECT_TRUE(is_in(d, kind, q)) << case_line(kind, q);
        if (kind.form == AnswerForm::sign) {
          for (const double x : q) {
            EXPECT_TRUE(x == 0 || (std::fabs(x) <= d.largest && std::fabs(x) >= d.smallest)) << x;
            EXPECT_TRUE(d.grid == 0 || std::fmod(x, d.grid) == 0) << x;
            EXPECT_TRUE(d.bits == 53 || static_cast<float>(x) == x) << x;
          }
          if (!d.degenerate) {
            EXPECT_NE(kind.exact(q).numbers[0], 0) << case_line(kind, q);
          }
        }
        return kind.exact(q);
      };
      const Findings findings = check(kind, Callable(ask), {.cases = 6, .domain = d});
      EXPECT_EQ(findings.asked(), seen);
      EXPECT_GE(2 * seen, 6 * (kind.generators.size() + 1)) << kind.name;  // most generators have such cases
      for (const Tally& t : findings.tallies) EXPECT_EQ(t.asked + t.passed_over, 6u) << t.generator;
    }
  }
}

}  // namespace
}  // namespace plumb::degenerate
