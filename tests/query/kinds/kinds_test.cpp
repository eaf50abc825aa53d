// Are the kinds' exact answers exact, and are foreign functions caught where they are wrong, and only there?
#include "plumb/query/kinds/kinds.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "degenerate/rational_signs.hpp"
#include "figure/basic/rational_polygon.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/degenerate.hpp"
#include "query/closest/oracle.hpp"
#include "query/kinds/foreign_functions.hpp"
#include "query/kinds/kind_judges.hpp"
#include "query/ray/mesh_oracle.hpp"

namespace plumb::degenerate {
namespace {

namespace foreign = plumb_test::foreign;

#ifdef PLUMB_LONG_TESTS
constexpr std::uint64_t asked_cases = 10'000, judged_cases = 1'000;
#else
constexpr std::uint64_t asked_cases = 200, judged_cases = 12;
#endif

template <class R, class... A>
ForeignFunction function(R (*f)(A...)) {
  return reinterpret_cast<ForeignFunction>(f);
}

using HullFunction = std::size_t(const double*, std::size_t, std::size_t*, std::size_t);

ForeignFunction right_one(std::string_view kind) {
  if (kind == "orient2d") return function(foreign::orient2d);
  if (kind == "orient3d") return function(foreign::orient3d);
  if (kind == "incircle") return function(foreign::incircle);
  if (kind == "insphere") return function(foreign::insphere);
  if (kind == "segment-segment") return function(foreign::segment_segment);
  if (kind == "segment-segment-3d") return function(foreign::segment_segment_3d);
  if (kind == "triangle-triangle") return function(foreign::triangle_triangle);
  if (kind == "ray-triangle") return function(foreign::ray_triangle);
  if (kind == "ray-mesh") return function(foreign::ray_mesh);
  if (kind == "point-in-polygon") return function(foreign::point_in_polygon);
  if (kind == "point-in-polyhedron") return function(foreign::point_in_polyhedron);
  if (kind == "box-box") return function(foreign::box_box);
  if (kind == "obb-obb") return function(foreign::obb_obb);
  if (kind == "hull") return function(foreign::hull);
  return nullptr;
}

TEST(Kinds, AreKnownByName) {
  std::set<std::string_view> names;
  for (const Kind& kind : kinds()) {
    names.insert(kind.name);
    EXPECT_EQ(&kind_named(kind.name), &kind);
    EXPECT_NE(kind.signature.find(" f("), std::string_view::npos) << kind.name;
    std::set<std::string> generators;
    for (const Generator& g : kind.generators) generators.insert(g.name);
    EXPECT_EQ(generators.size(), kind.generators.size()) << kind.name;
  }
  EXPECT_EQ(names.size(), 15u);
  try {
    kind_named("orient4d");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string_view(e.what()).find("orient4d; there are orient2d"), std::string_view::npos) << e.what();
  }
}

TEST(Kinds, TakeFunctionsOfTheirSignatureOnly) {
  EXPECT_TRUE(check(kind_named("ray-triangle"), foreign::ray_hits_triangle, {.cases = 50}).clean());
  EXPECT_THROW(check(kind_named("orient3d"), foreign::orient2d), Error);
  EXPECT_THROW(check(kind_named("hull"), foreign::ray_triangle), Error);
}

TEST(Kinds, FindNothingWrongWithTheLibrary) {
  for (const Kind& kind : kinds()) {
    const ForeignFunction right = right_one(kind.name);
    const CheckOptions options{.seed = 11, .cases = right == nullptr ? asked_cases / 10 : asked_cases};
    const Findings findings = check(kind, right == nullptr ? Callable(kind.exact) : callable_of(kind, right), options);
    EXPECT_TRUE(findings.clean()) << text(kind, findings);
    EXPECT_EQ(findings.asked(), options.cases * (kind.generators.size() + 1)) << kind.name;
    for (const Tally& t : findings.tallies) EXPECT_EQ(t.unsure, 0u) << kind.name << ' ' << t.generator;
  }
}

// The rational judges, each by a way of its own.
using kind_judges::at, kind_judges::meet_by_program, kind_judges::spanned, oracle::RationalPoint, oracle::Spanned;
using Given = std::span<const double>;

int sign_by_determinant(const Kind& kind, Given q) {
  const std::vector<std::size_t> which{0, 1, 2, 3, 4};
  if (kind.name == "orient2d") return plumb_test::sign_of_flat(q, 2, std::span(which).first(3));
  if (kind.name == "orient3d") return -plumb_test::sign_of_flat(q, 3, std::span(which).first(4));
  if (kind.name == "incircle") return -plumb_test::sign_of_round(q, 2, std::span(which).first(4));
  return plumb_test::sign_of_round(q, 3, which);
}

bool in_polygon_by_winding(Given q) {
  std::vector<Point2> chain;
  for (std::size_t i = 3; i < q.size(); i += 2) chain.push_back({q[i], q[i + 1]});
  const std::span<const Point2> one(chain);
  return plumb_test::location(std::span(&one, 1), {q[0], q[1]}) != Location::outside;
}

bool yes_by_rationals(const Kind& kind, Given q) {
  if (kind.name == "point-in-polygon") return in_polygon_by_winding(q);
  return kind.name == "point-in-polyhedron" ? mesh_oracle::is_in(q) : meet_by_program(kind, q);
}

std::optional<mpq_class> first_hit_by_program(Given q) {
  const Ray3 ray{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}};
  return ray_oracle::first(ray_oracle::Path(ray), ray_oracle::corners_of(foreign::triangle(&q[6])));
}

/// Nothing for more pairs of points than brute force takes.
std::optional<mpq_class> square_by_simplices(Given q) {
  const auto n = static_cast<std::size_t>(q[0]), second = 1 + 3 * n, m = static_cast<std::size_t>(q[second]);
  if (n * m > 12) return {};
  closest_oracle::Corners apart;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      const RationalPoint a = at(q, 1 + 3 * i), b = at(q, second + 1 + 3 * j);
      apart.push_back({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
    }
  }
  return closest_oracle::nearest_of_hull(apart, {0, 0, 0}).square;
}

/// The places that are in no hull of the others; none where all points are in one plane.
std::set<std::array<double, 3>> extreme_places(Given q) {
  std::set<std::array<double, 3>> places, extreme;
  for (std::size_t i = 1; i < q.size(); i += 3) places.insert({q[i] + 0.0, q[i + 1] + 0.0, q[i + 2] + 0.0});
  for (const auto& p : places) {
    Spanned others;
    for (const auto& o : places) {
      if (o != p) others.points.push_back(at(o, 0));
    }
    if (oracle::relation(spanned(p, 0, 1), others) == Relation::disjoint) extreme.insert(p);
  }
  return extreme;
}

bool is_flat_by_determinants(Given q) {
  bool flat = true;
  plumb_test::for_each_subset((q.size() - 1) / 3, 4, [&](std::span<const std::size_t> four) {
    flat = flat && plumb_test::sign_of_flat(q.subspan(1), 3, four) == 0;
  });
  return flat;
}

struct Judges {
  std::map<std::string, int> told;  // how often each answer came

  void judge(const Kind& kind, Given q) {
    const Answer exact = kind.exact(q);
    switch (kind.form) {
      case AnswerForm::sign:
        EXPECT_EQ(exact.numbers[0], sign_by_determinant(kind, q)) << case_line(kind, q);
        break;
      case AnswerForm::yes_no:
        EXPECT_EQ(exact.numbers[0] != 0, yes_by_rationals(kind, q)) << case_line(kind, q);
        break;
      case AnswerForm::hit: {
        const auto t = kind.name == "ray-mesh" ? mesh_oracle::first_hit(q) : first_hit_by_program(q);
        ASSERT_EQ(exact.numbers.size(), t ? 2u : 1u) << case_line(kind, q);
        if (t) {
          EXPECT_TRUE(ray_oracle::is_nearest(exact.numbers[1], *t)) << case_line(kind, q);
        }
        break;
      }
      case AnswerForm::number:
        if (const auto square = square_by_simplices(q)) {
          EXPECT_EQ(exact.numbers[0], rounded_root(Rounding::nearest, Rational(BigRational{*square})))
              << case_line(kind, q);
          ++told[exact.numbers[0] == 0 ? "apart by nothing" : "apart"];
        }
        return;
      case AnswerForm::triangles:
        judge_hull(kind, q, exact);
        return;
    }
    ++told[std::string(kind.name).append(" ").append(words(kind, {exact.numbers[0]}))];
  }

  void judge_hull(const Kind& kind, Given q, const Answer& exact) {
    if (q.size() > 37) return;  // more than twelve points
    ++told[exact.numbers.empty() ? "flat" : "solid"];
    ASSERT_EQ(exact.numbers.empty(), is_flat_by_determinants(q)) << case_line(kind, q);
    if (exact.numbers.empty()) return;
    std::set<std::array<double, 3>> corners;
    for (const double index : exact.numbers) {
      const std::size_t i = 1 + 3 * static_cast<std::size_t>(index);
      corners.insert({q[i] + 0.0, q[i + 1] + 0.0, q[i + 2] + 0.0});
    }
    EXPECT_EQ(corners, extreme_places(q)) << case_line(kind, q);
  }
};

/// Axes of oriented boxes are perpendicular and of length one, but for a few roundings.
void expect_frames(const Kind& kind, Given q) {
  if (kind.name != "obb-obb") return;
  for (const std::size_t box : {0u, 15u}) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const RationalPoint a = at(q, box + 3 + 3 * i), b = at(q, box + 3 + 3 * j);
        const mpq_class off = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] - (i == j ? 1 : 0);
        EXPECT_LT(abs(off), 0x1p-48) << case_line(kind, q);
      }
    }
  }
}

TEST(Kinds, AgreeWithRationals) {
  Judges judges;
  for (const Kind& kind : kinds()) {
    std::vector<std::string> generators{std::string(mutated_generator)};
    for (const Generator& g : kind.generators) generators.push_back(g.name);
    for (const std::string& generator : generators) {
      for (std::uint64_t i = 0; i < judged_cases; ++i) {
        const Numbers numbers = case_of(kind, generator, 5, i);
        ASSERT_EQ(flaw_of(kind, numbers), "") << kind.name << ' ' << generator << ' ' << i;
        expect_frames(kind, numbers);
        judges.judge(kind, numbers);
      }
    }
  }
  // Each answer that a kind has came at least five times.
  for (const Kind& kind : kinds()) {
    if (kind.form == AnswerForm::sign) {
      for (const char* sign : {" +", " 0", " -"}) EXPECT_GE(judges.told[std::string(kind.name) + sign], 5) << kind.name;
    } else if (kind.form == AnswerForm::yes_no || kind.form == AnswerForm::hit) {
      for (const char* told : {" yes", " no"}) EXPECT_GE(judges.told[std::string(kind.name) + told], 5) << kind.name;
    }
  }
  for (const char* told : {"apart by nothing", "apart", "flat", "solid"}) EXPECT_GE(judges.told[told], 5) << told;
}

// A cube's hull, then spoiled in every way that is told.
TEST(Kinds, TellWhatIsWrongWithAHull) {
  const Kind& kind = kind_named("hull");
  Numbers cube{9};
  for (int i = 0; i < 8; ++i) cube.insert(cube.end(), {double(i & 1) * 4, double(i >> 1 & 1) * 4, double(i >> 2) * 4});
  cube.insert(cube.end(), {4, 4, 4});  // a corner once more
  const Answer right = kind.exact(cube);
  ASSERT_EQ(right.numbers.size(), 36u);
  const auto sort = [&](const auto& spoil, const Numbers& points) {
    Answer given = right;
    spoil(given.numbers);
    return std::string(judge(kind, points, given, {}).sort);
  };
  EXPECT_EQ(sort([](Numbers&) {}, cube), "");
  EXPECT_EQ(sort([](Numbers& t) { std::ranges::replace(t, 7, 8); }, cube), "");  // by its other number
  EXPECT_EQ(sort([](Numbers& t) { t.clear(); }, cube), "no triangles");
  EXPECT_EQ(sort([](Numbers& t) { t.pop_back(); }, cube), "more triangles than its capacity");
  for (const double index : {9.0, -1.0, 0.5, HUGE_VAL, std::nan("")})
    EXPECT_EQ(sort([=](Numbers& t) { t[4] = index; }, cube), "an index beyond the points") << index;
  EXPECT_EQ(sort([](Numbers& t) { std::swap(t[0], t[1]); }, cube), "a point outside of a triangle");
  EXPECT_EQ(sort([](Numbers& t) { t[0] = t[1]; }, cube), "a triangle without area");
  EXPECT_EQ(sort([](Numbers& t) { t.resize(33); }, cube), "triangles that do not close");
  EXPECT_EQ(sort([](Numbers&) {}, {4, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}), "triangles for points of one plane");
  Numbers larger = cube;
  larger[0] = 10;
  larger.insert(larger.end(), {2, 2, 9});
  EXPECT_EQ(sort([](Numbers&) {}, larger), "a point outside of a triangle");
}

// A tetrahedron's faces whole, and once more in four triangles each: no directed edge comes twice.
TEST(Kinds, TellAHullThatCoversItsFacesTwice) {
  const Kind& kind = kind_named("hull");
  const std::vector<std::array<double, 3>> corners{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  Numbers points{10};
  for (const auto& c : corners) points.insert(points.end(), c.begin(), c.end());
  std::map<std::pair<double, double>, double> middle;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      middle[{i, j}] = middle[{j, i}] = static_cast<double>(points.size() / 3);
      for (std::size_t k = 0; k < 3; ++k) points.push_back((corners[i][k] + corners[j][k]) / 2);
    }
  }
  Answer once = kind.exact(points), fine, twice = once;
  ASSERT_EQ(once.numbers.size(), 12u);
  for (std::size_t f = 0; f < 12; f += 3) {
    const double a = once.numbers[f], b = once.numbers[f + 1], c = once.numbers[f + 2];
    const double ab = middle[{a, b}], bc = middle[{b, c}], ca = middle[{c, a}];
    for (const double v : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) fine.numbers.push_back(v);
  }
  twice.numbers.insert(twice.numbers.end(), fine.numbers.begin(), fine.numbers.end());
  EXPECT_EQ(judge(kind, points, once, {}).sort, "");
  EXPECT_EQ(judge(kind, points, fine, {}).sort, "");  // corners need not be extreme
  // Of volumes that are no doubles as well.
  for (const double scale : {1.0, 0x1p-400, 0x1p400}) {
    Numbers scaled = points;
    for (double& x : std::span(scaled).subspan(1)) x *= scale;
    EXPECT_EQ(judge(kind, scaled, fine, {}).sort, "");
    EXPECT_EQ(judge(kind, scaled, twice, {}).sort, "a face covered twice") << scale;
  }
}

TEST(Kinds, WatchTheRoomThatAHullHas) {
  const Kind& kind = kind_named("hull");
  const Numbers points{4, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto sort = [&](HullFunction* f) {
    return std::string(judge(kind, points, ask(kind, function(f), points), {}).sort);
  };
  EXPECT_EQ(sort([](const double*, std::size_t n, std::size_t* t, std::size_t) -> std::size_t {
              t[6 * n] = 0;
              return 0;
            }),
            "crashed");
  EXPECT_EQ(sort([](const double*, std::size_t, std::size_t*, std::size_t room) { return room + 1; }),
            "more triangles than its capacity");
  EXPECT_EQ(sort([](const double*, std::size_t, std::size_t*, std::size_t) { return std::size_t(-1); }), "NaN");
}

TEST(Kinds, CatchNaiveOrientation) {
  const Kind& kind = kind_named("orient3d");
  const Findings findings = check(kind, foreign::naive_orient3d, {.cases = 300, .keep = 2});
  ASSERT_FALSE(findings.clean());
  std::uint64_t least = 1000;
  for (const Finding& f : findings.findings) {
    const double given = foreign::naive_orient3d(&f.smallest[0], &f.smallest[3], &f.smallest[6], &f.smallest[9]);
    EXPECT_EQ(given, f.given.numbers[0]);
    EXPECT_NE(words(kind, f.given), words(kind, f.exact)) << text(kind, findings);
    std::uint64_t bits = 0;
    for (const double x : f.smallest) bits += static_cast<std::uint64_t>(mantissa_length(x));
    least = std::min(least, bits);
  }
  EXPECT_LT(least, 120u);  // of 12 x 53
  // Sound families stay sound: integers of 17 bits at most, which doubles multiply exactly.
  for (const Tally& t : findings.tallies) {
    if (t.generator == "touching") {
      EXPECT_EQ(t.wrong, 0u);
    }
  }
}

TEST(Kinds, CatchAnEpsilon) {
  const Kind& kind = kind_named("triangle-triangle");
  const Findings findings = check(kind, foreign::epsilon_triangle_triangle, {.cases = 100, .generators = {"uniform"}});
  ASSERT_EQ(findings.findings.size(), 1u);
  EXPECT_EQ(findings.findings[0].sort, "yes for no");
  for (const double x : findings.findings[0].smallest) EXPECT_LE(mantissa_length(x), 3) << text(kind, findings);
  EXPECT_FALSE(is_degenerate(kind, findings.findings[0].smallest)) << text(kind, findings);
  // Where proper triangles fail as well, they are what is kept.
  const Findings equal = check(kind, foreign::epsilon_triangle_triangle, {.cases = 300, .generators = {"near_half"}});
  ASSERT_EQ(equal.findings.size(), 1u);
  EXPECT_GT(equal.tallies[0].degenerate, 0u);
  EXPECT_FALSE(is_degenerate(kind, equal.findings[0].smallest)) << text(kind, equal);
}

TEST(Kinds, CatchWhatIsWrongOnBoundaries) {
  const Kind& polygon = kind_named("point-in-polygon");
  const Findings crossings = check(polygon, foreign::crossing_number, {.cases = 100, .generators = {"boundary"}});
  ASSERT_EQ(crossings.findings.size(), 1u);
  EXPECT_EQ(crossings.findings[0].smallest[2], 3) << text(polygon, crossings);  // shrunk to a triangle

  const Kind& distances = kind_named("convex-distance");
  const Findings vertices = check(distances, foreign::vertex_distance, {.cases = 50, .generators = {"grid"}});
  ASSERT_EQ(vertices.findings.size(), 1u);
  EXPECT_EQ(vertices.findings[0].smallest.size(), 2 + 3 * 3u) << text(distances, vertices);  // a point and a segment
}

/// Of a case's mesh.
std::size_t triangles_in(const Kind& kind, const Numbers& numbers) {
  const std::size_t at = kind.name == "ray-mesh" ? 6 : 3;
  return static_cast<std::size_t>(numbers[at + 1 + 3 * static_cast<std::size_t>(numbers[at])]);
}

TEST(Kinds, ShrinkMeshesToAFewTriangles) {
  const Kind& rays = kind_named("ray-mesh");
  const Findings leaks =
      check(rays, foreign::leaking_ray_mesh, {.cases = 40, .generators = {"box", "sphere", "unwelded"}});
  ASSERT_EQ(leaks.findings.size(), 3u);
  for (const Finding& f : leaks.findings) EXPECT_LE(triangles_in(rays, f.smallest), 2u) << text(rays, leaks);

  const Kind& points = kind_named("point-in-polyhedron");
  const Findings counts = check(points, foreign::counting_in_polyhedron,
                                {.cases = 40, .generators = {"box", "torus", "cut", "unwelded", "slits"}});
  ASSERT_EQ(counts.findings.size(), 5u);
  for (const Finding& f : counts.findings) {
    EXPECT_EQ(triangles_in(points, f.smallest), 4u) << text(points, counts);  // a tetrahedron
    EXPECT_EQ(f.smallest[3], 4) << text(points, counts);
    EXPECT_FALSE(is_degenerate(points, f.smallest));
  }
}

// Leaks are told by rays from within; and points are on, inside and outside of every solid.
TEST(Kinds, AskMeshesFromWithinAndWithout) {
  const Kind &rays = kind_named("ray-mesh"), &points = kind_named("point-in-polyhedron");
  int within = 0;
  for (const Generator& g : points.generators) {
    std::map<Location, int> told;
    for (std::uint64_t i = 0; i < 60; ++i) {
      const Numbers p = case_of(points, g.name, 9, i);
      const auto mesh_at = [](const Numbers& q, std::size_t at) {
        const auto n = static_cast<std::size_t>(q[at]), m = static_cast<std::size_t>(q[at + 1 + 3 * n]);
        const std::vector<std::size_t> indices(q.end() - static_cast<std::ptrdiff_t>(3 * m), q.end());
        return foreign::mesh(&q[at + 1], n, indices.data(), m);
      };
      ++told[locate(mesh_at(p, 3), {p[0], p[1], p[2]})];
      const Numbers r = case_of(rays, g.name, 9, i);
      const TriangleMesh mesh = mesh_at(r, 6);
      if (!is_oriented_closed(mesh) || locate(mesh, {r[0], r[1], r[2]}) != Location::inside) continue;
      if (r[3] == 0 && r[4] == 0 && r[5] == 0) continue;
      ++within;
      EXPECT_EQ(rays.exact(r).numbers[0], 1) << case_line(rays, r);
    }
    if (&g - points.generators.data() >= 13) continue;  // of the families a few are enough
    for (const Location l : {Location::inside, Location::boundary, Location::outside})
      EXPECT_GE(told[l], 3) << g.name << ' ' << static_cast<int>(l);
  }
  EXPECT_GE(within, 40);
}

}  // namespace
}  // namespace plumb::degenerate
