// The plane of a triangle of a difference: which bounds were derived, does each world tell what is so, and are numbers
// within what they are said to be off?
#include "query/penetration/triangle_plane.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/predicates.hpp"
#include "query/body/told_alike.hpp"
#include "query/penetration/facet_lengths.hpp"

namespace plumb::query::parting {
namespace {

TEST(TrianglePlane, DerivedBoundsAreAsRecordedAndProved) {
  const Point3 o{0, 0, 0};
  const TrianglePairs above{{{{3, 0, 1}, {0, 3, 1}, {-2, -1, 1}}}, {o, o, o}};
  const auto bounds = judged_bounds(PassesBeyond{}, above, 0.5);
  expect_golden("passes_beyond", bounds);
  expect_proved(bounds, judged_proofs("passes_beyond", PassesBeyond{}, above, 0.5));
  const auto of_ways = judged_bounds(LeadsAlong{}, above, o, Point3{1, 2, 3});
  expect_golden("leads_along", of_ways);
  EXPECT_EQ(of_ways, std::vector(bounds.begin(), bounds.begin() + 1));  // that of the height
}

/// Numbers as rational ones tell them.
struct Numbers {
  std::array<Rational, 3> way;
  Rational square, overlap;

  explicit Numbers(const TrianglePairs& of) {
    RationalWorld w;
    FacetLengths{}(w, of, [&](const auto& x, const auto& y, const auto& z, const auto& s, const auto& h) {
      way = {x, y, z}, square = s, overlap = h;
    });
  }
};

TEST(TrianglePlane, EachWorldTellsWhatIsSo) {
  int on_plane = 0, as_far = 0;
  for (const FamilyInfo& info : families) {
    int sure = 0, asked = 0;
    for (std::uint64_t i = 0; i < 60; ++i) {
      Entropy entropy(72, i);
      const std::vector<Point3> c = points3(info.family, Degeneracy::coplanar, 5, entropy);
      const std::string about = std::string(info.name) + ", replay: " + std::to_string(i);
      // Corners less one point: the origin is on the inner side where that point is below their plane.
      for (std::size_t k = 3; k < 5; ++k) {
        const Point3 &o = c[k], &other = c[7 - k];
        const TrianglePairs pairs{{c[0], c[1], c[2]}, {o, o, o}};
        const Sign side = orient3d(c[0], c[1], c[2], o);
        sure += told(PassesBeyond{}, side == Sign::positive, about, pairs, 0.0), ++asked;
        told(LeadsAlong{}, orient3d(c[0], c[1], c[2], other) * Sign::negative, about, pairs, c[0], other);
        on_plane += side == Sign::zero ? 1 : 0;
        if (side != Sign::positive) continue;
        const Numbers n(pairs);
        const Rational square = n.overlap * n.overlap / n.square;
        const double length = std::sqrt(square.rounded());
        if (!(length > 0 && length < 1e300)) continue;
        for (const double l : {std::nextafter(length, 0.0), length, std::nextafter(length, HUGE_VAL), length * 0.75}) {
          told(PassesBeyond{}, square > Rational(l) * Rational(l), about, pairs, l);
          as_far += square == Rational(l) * Rational(l) ? 1 : 0;
        }
      }
    }
    const bool is_plain = info.family == Family::uniform || info.family == Family::float32;
    EXPECT_GE(sure, is_plain ? asked * 9 / 10 : 0) << info.name;
  }
  EXPECT_GE(on_plane, 50);
  EXPECT_GE(as_far, 1);
}

TEST(TrianglePlane, DoublesTellInPromisedShare) {
  const auto at = [](const auto& x, std::size_t k) { return Point3{x[3 * k], x[3 * k + 1], x[3 * k + 2]}; };
  const auto pairs = [&](const auto& x) {
    const Point3 o = at(x, 3);
    return TrianglePairs{{at(x, 0), at(x, 1), at(x, 2)}, {o, o, o}};
  };
  expect_share<15>("passes_beyond", PassesBeyond{},
                   [&](const auto& ask, const auto& x) { ask(pairs(x), std::fabs(x[12]) / 4); });
  expect_share<15>("leads_along", LeadsAlong{},
                   [&](const auto& ask, const auto& x) { ask(pairs(x), at(x, 0), at(x, 4)); });
}

TEST(TrianglePlane, MutantsAreNoticed) {
  struct Drawn {
    TrianglePairs of;
    double length;
    Point3 from, to;
  };
  const auto draw = [](mutants::Draw& d) {
    const auto three = [&] { return std::array{d.point(), d.point(), d.point()}; };
    return Drawn{{three(), three()}, d.quarter() + d.positive() - 1, d.point(), d.point()};
  };
  struct Known {
    arith::Plain p, n;
    double square;  // of n, by Lagrange's identity

    explicit Known(const TrianglePairs& of) : p(corner(of, 0)) {
      const arith::Plain u = corner(of, 1) - p, v = corner(of, 2) - p;
      n = cross(u, v), square = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
    }
    static arith::Plain corner(const TrianglePairs& of, std::size_t i) {
      return arith::Plain{of.a[i].x, of.a[i].y, of.a[i].z} - arith::Plain{of.b[i].x, of.b[i].y, of.b[i].z};
    }
  };
  mutants::expect_noticed(
      "passes_beyond",
      mutants::unnoticed(
          draw, [](const Drawn& x) { return mutants::told<mutants::World>(PassesBeyond{}, x.of, x.length); },
          [](const Drawn& x) {
            const Known plane(x.of);
            const double height = dot(plane.n, plane.p);
            return height > 0 && height * height > x.length * x.length * plane.square;
          }),
      "34 ");  // from the length nothing is taken away
  mutants::expect_noticed(
      "leads_along",
      mutants::unnoticed(
          draw, [](const Drawn& x) { return mutants::told<mutants::World>(LeadsAlong{}, x.of, x.from, x.to); },
          [](const Drawn& x) {
            const Known plane(x.of);
            const double lead =
                plane.n.x * (x.to.x - x.from.x) + plane.n.y * (x.to.y - x.from.y) + plane.n.z * (x.to.z - x.from.z);
            return static_cast<Sign>((lead > 0) - (lead < 0));
          }),
      "24 25 26 27 28 29 30 31 32 33 ");  // the plane's height and its square have no part in a way
}

/// Planes along two axes are as far as their third coordinate says.
TEST(TrianglePlane, IsNoFartherThanItsDistance) {
  int sure = 0, asked = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Entropy entropy(74, i);
    const auto number = [&] { return static_cast<double>(entropy.within(1 << 10)) / 64; };
    const double far = std::fabs(number()) + 1;
    const auto corner = [&] { return Point3{number(), number(), far}; };
    const Point3 p = corner(), q = corner(), r = corner(), below{0, 0, 0};
    if (orient3d(p, q, r, below) != Sign::positive) continue;
    const TrianglePairs pairs{{p, q, r}, {below, below, below}};
    const std::string about = "replay: " + std::to_string(i);
    told(PassesBeyond{}, false, about, pairs, far);
    told(PassesBeyond{}, true, about, pairs, std::nextafter(far, 0.0));
    sure += told(PassesBeyond{}, true, about, pairs, far * (1 - 0x1p-12));
    sure += told(PassesBeyond{}, false, about, pairs, far * (1 + 0x1p-12));
    asked += 2;
  }
  EXPECT_GE(asked, 60);
  EXPECT_GE(sure, asked * 9 / 10);  // by doubles alone
}

TEST(FacetLengths, AreWithinTheirRadii) {
  const auto is_within = [](const Ball& told, const Rational& truth) {
    const Rational off = Rational(told.high) + Rational(told.low) - truth;
    return told.radius == Ball::infinity || magnitude(off) <= Rational(told.radius);
  };
  int exact = 0, all = 0;
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 60; ++i) {
      Entropy entropy(73, i);
      const std::vector<Point3> c = points3(info.family, Degeneracy::cospherical, 6, entropy);
      const auto a = CoreCorners::of(BodyView{.vertices = std::span(c).first(3)}),
                 b = CoreCorners::of(BodyView{.vertices = std::span(c).last(3)});
      const std::array<Ends, 3> facet{Ends{0, 0}, Ends{1, 0}, Ends{2, i % 2 == 0 ? 1U : 0U}};
      const auto lengths = facet_lengths({*a, *b}, facet);
      const Numbers n({{c[0], c[1], c[2]}, {c[3], c[3], i % 2 == 0 ? c[4] : c[3]}});
      const std::string about = std::string(info.name) + ", replay: " + std::to_string(i);
      if (!lengths) {
        EXPECT_TRUE(info.family != Family::uniform && info.family != Family::grid) << about;
        continue;
      }
      EXPECT_TRUE(is_within(lengths->way.x, n.way[0])) << about;
      EXPECT_TRUE(is_within(lengths->way.y, n.way[1])) << about;
      EXPECT_TRUE(is_within(lengths->way.z, n.way[2])) << about;
      EXPECT_TRUE(is_within(lengths->square, n.square)) << about;
      EXPECT_TRUE(is_within(lengths->overlap, n.overlap)) << about;
      if (info.family != Family::grid) continue;
      ++all;
      exact += lengths->square.radius == 0 && lengths->overlap.radius == 0 ? 1 : 0;
    }
  }
  EXPECT_EQ(exact, all);
}

}  // namespace
}  // namespace plumb::query::parting
