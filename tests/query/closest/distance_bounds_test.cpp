// Bounds of a square of a distance: as recorded and proved, around the exact one on every family, and near to it.
#include "query/closest/distance_bounds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "certify/sanitized.hpp"
#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/query/body/item_batch.hpp"
#include "query/closest/batch_scan.hpp"
#include "query/closest/oracle.hpp"

namespace plumb::query {
namespace {

namespace statement = distance_bounds::HWY_NAMESPACE;
using statement::DistanceBounds;

/// Where on the figure it is guessed that the nearest point is.
struct Guess {
  double s, t;
};

/// Judges the bounds less a number as given, by the point a + s ab, or a + s (ab + t bc).
template <std::size_t corners, bool less_a_number>
struct Judged {
  static constexpr int highest = DistanceBounds::highest;
  static constexpr Scales scales = DistanceBounds::scales;

  template <class W>
  std::array<Sign, 2> operator()(W& w, const Point3& p, const std::array<Point3, 3>& c, const Guess& g,
                                 double number) const {
    using S = DistanceBounds;
    const auto judge = [&](const auto& x) {
      if constexpr (less_a_number) {
        return w.compare(x, w.number(number));
      } else {
        return w.sign(x);
      }
    };
    const auto both = [&](const auto& b) { return std::array{judge(b.lower), judge(b.upper)}; };
    const auto told = [&](const auto& r, const auto&... corner) {
      return both(S::between(r, S::dot(r, r), corner...));
    };
    const auto qa = S::way(w, p, c[0]);
    if constexpr (corners == 1) {
      return both(S::between(qa));
    } else {
      const auto qb = S::way(w, p, c[1]);
      const auto ab = S::edge(w, c[0], c[1], qa, qb);
      if constexpr (corners == 2) {
        return told(S::along(qa, ab, w.portion(g.s)), qa, qb);
      } else {
        const auto qc = S::way(w, p, c[2]);
        const auto across = S::along(ab, S::edge(w, c[1], c[2], qb, qc), w.portion(g.t));
        return told(S::along(qa, across, w.portion(g.s)), qa, qb, qc);
      }
    }
  }
};

template <std::size_t corners>
void expect_bounds_of(const char* name) {
  const Point3 p{-3, 0.25, 0.25};
  const std::array<Point3, 3> c{{{1, 2, 3}, {0.5, -1, 2}, {0.25, 4, 1}}};
  const Judged<corners, false> judged;
  const std::vector<std::string> bounds = judged_bounds(judged, p, c, Guess{0.25, 0.5}, 0.0);
  expect_golden(name, bounds);
  expect_proved(bounds, judged_proofs(name, judged, p, c, Guess{0.25, 0.5}, 0.0));
}
TEST(DistanceBounds, DerivedBoundsAreAsRecordedAndProved) {
  expect_bounds_of<1>("point_distance");
  expect_bounds_of<2>("segment_distance");
  expect_bounds_of<3>("triangle_distance");
}

struct Drawn {
  Point3 p;
  std::array<Point3, 3> c;
  Guess g;
  double number;
};
template <std::size_t corners>
std::string unnoticed() {
  return mutants::unnoticed(
      [](mutants::Draw& d) {
        return Drawn{d.point(), {d.point(), d.point(), d.point()}, {d.quarter(), d.quarter()}, d.number()};
      },
      [](const Drawn& d) { return mutants::told<mutants::World>(Judged<corners, true>{}, d.p, d.c, d.g, d.number); },
      [](const Drawn& d) {
        // The squares of the corners' distances from p, less those from the point that was guessed.
        const double s = corners > 1 ? d.g.s : 0, t = corners > 2 ? d.g.t : 0;
        const auto on_figure = [&](double a, double b, double c) { return (1 - s) * a + s * (1 - t) * b + s * t * c; };
        const Point3 at{on_figure(d.c[0].x, d.c[1].x, d.c[2].x), on_figure(d.c[0].y, d.c[1].y, d.c[2].y),
                        on_figure(d.c[0].z, d.c[1].z, d.c[2].z)};
        const auto square = [](const Point3& a, const Point3& b) {
          return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
        };
        double lower = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < corners; ++k) lower = std::fmin(lower, square(d.c[k], d.p) - square(d.c[k], at));
        const auto sign = [](double x) { return static_cast<Sign>((x > 0) - (x < 0)); };
        return std::array{sign(lower - d.number), sign(square(at, d.p) - d.number)};
      });
}
TEST(DistanceBounds, MutantsAreNoticed) {
  mutants::expect_noticed("point_distance", unnoticed<1>());
  mutants::expect_noticed("segment_distance", unnoticed<2>());
  mutants::expect_noticed("triangle_distance", unnoticed<3>());
}

mpq_class exact_square(const Point3& p, const Point3& a) {
  return closest_oracle::nearest_of_hull({rationals::exact(a)}, rationals::exact(p)).square;
}
mpq_class exact_square(const Point3& p, const auto& item) {
  return closest_oracle::nearest_of(closest_oracle::shape_of(item), rationals::exact(p)).square;
}

template <class Batch>
constexpr std::size_t corners_of = std::is_same_v<Batch, PointBatch>     ? 1
                                   : std::is_same_v<Batch, SegmentBatch> ? 2
                                                                         : 3;
struct Scanned {
  double least;
  std::vector<double> lower;
};
/// What is told of the batch.
template <class Batch>
Scanned scanned(const Batch& many, const Point3& p) {
  constexpr std::size_t corners = corners_of<Batch>;
  std::array<const double*, 3 * corners> of;
  for (std::size_t k = 0; k < of.size(); ++k) of[k] = many.numbers(k);
  constexpr batch::Scan& scan = corners == 1   ? batch::scan_points
                                : corners == 2 ? batch::scan_segments
                                               : batch::scan_triangles;
  Scanned s{0, std::vector<double>(many.size() + batch::most_lanes)};
  s.least = scan(of.data(), many.size(), p, s.lower.data());
  return s;
}

/// Of many items alone: the bounds contain the square; how many are told to ten digits.
template <class Batch, class Item>
int told(const std::vector<Item>& items, const Point3& p, const std::string& about) {
  int count = 0;
  for (const Item& item : items) {
    const auto [upper, lower] = scanned(Batch({&item, 1}), p);
    const mpq_class square = exact_square(p, item);
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(lower[0] == -infinity || mpq_class(lower[0]) <= square) << about;
    EXPECT_TRUE(upper == infinity || mpq_class(upper) >= square) << about;
    count += upper - lower[0] <= 1e-10 * upper ? 1 : 0;
  }
  return count;
}

TEST(DistanceBounds, LanesTellWhatIsSo) {
  PromisedShare of_points("point_distance"), of_segments("segment_distance"), of_triangles("triangle_distance");
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(40); ++i) {
      Entropy entropy(63, i);
      const Degeneracy degeneracy = degeneracies[i % degeneracies.size()];
      const std::vector<Point3> all = points3(info.family, degeneracy, 10, entropy);
      std::vector<Point3> points(all.begin(), all.begin() + 3);
      std::vector<Segment3> segments;
      std::vector<Triangle3> triangles;
      for (std::size_t k = 0; k < 3; ++k) {
        segments.push_back({all[3 * k], all[3 * k + 1]});
        triangles.push_back({all[3 * k], all[3 * k + 1], all[3 * k + 2]});
      }
      const std::string about = std::string(info.name) + ", replay: " + std::to_string(i);
      of_points.add(info.family, told<PointBatch>(points, all[9], about), 3);
      of_segments.add(info.family, told<SegmentBatch>(segments, all[9], about), 3);
      of_triangles.add(info.family, told<TriangleBatch>(triangles, all[9], about), 3);
    }
  }
}

/// Of so many questions, each to this many items: how many items are left to be compared?
template <class Batch, class Item>
std::size_t left(const std::vector<Item>& items, const Point3& p) {
  const auto [least, lower] = scanned(Batch(items), p);
  std::vector<std::uint32_t> which(items.size());
  return batch::list_up_to(least, lower.data(), items.size(), which.data());
}
TEST(DistanceBounds, FewAreLeftToBeCompared) {
  std::array<std::size_t, 3> count{};
  constexpr std::size_t questions = 200;
  for (std::uint64_t i = 0; i < questions; ++i) {
    Entropy entropy(64, i);
    const std::vector<Point3> all = points3(Family::uniform, Degeneracy::coplanar, 301, entropy);
    std::vector<Segment3> segments;
    std::vector<Triangle3> triangles;
    for (std::size_t k = 0; k < 300; k += 3) {
      segments.push_back({all[k], all[k + 1]});
      triangles.push_back({all[k], all[k + 1], all[k + 2]});
    }
    count[0] += left<PointBatch>(all, all[300]) - 1;  // itself is one of them
    count[1] += left<SegmentBatch>(segments, all[300]) - 1;
    count[2] += left<TriangleBatch>(triangles, all[300]) - 1;
  }
  for (const std::size_t n : count) EXPECT_LE(n, questions / 100);
  std::printf("beside the first: %zu %zu %zu\n", count[0], count[1], count[2]);
}

TEST(DistanceBounds, NothingIsToldOutOfRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double far : {0x1p484, 1e300, std::numeric_limits<double>::max()}) {
    const Triangle3 t{{far, 0, 0}, {0, far, 0}, {0, 0, -far}};
    const auto [least, lower] = scanned(TriangleBatch({&t, 1}), {1, 1, 1});
    EXPECT_EQ(least, infinity) << far;
    EXPECT_EQ(lower[0], -infinity) << far;
  }
}

}  // namespace
}  // namespace plumb::query
