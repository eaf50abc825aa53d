// What holds of every triangulation of points and segments: the laws of delaunay.hpp, looked at edge by edge.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "plumb/arith/rational.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/predicates.hpp"
#include "plumb/surface/planar/delaunay.hpp"

namespace plumb::planar_laws {

using Corners = std::array<std::uint32_t, 3>;

inline Rational twice_area(const Point2& a, const Point2& b, const Point2& c) {
  const Rational ax = b.x, ay = b.y;
  return (ax - Rational(a.x)) * (Rational(c.y) - Rational(a.y)) -
         (ay - Rational(a.y)) * (Rational(c.x) - Rational(a.x));
}

template <class Triangles>
Rational twice_area(const std::vector<Point2>& points, const Triangles& triangles) {
  Rational sum = 0;
  for (const Corners& t : triangles) sum = sum + twice_area(points[t[0]], points[t[1]], points[t[2]]);
  return sum;
}

/// Beginning with its lowest corner.
inline Corners turned(Corners t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}
template <class Triangles>
std::set<Corners> as_set(const Triangles& triangles) {
  std::set<Corners> set;
  for (const Corners& t : triangles) set.insert(turned(t));
  return set;
}

/// Twice the area of the convex hull, by Andrew's chain.
inline Rational hull_area(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(),
            [](const Point2& l, const Point2& r) { return l.x < r.x || (l.x == r.x && l.y < r.y); });
  Rational area = 0;
  for (const Sign turn : {Sign::positive, Sign::negative}) {
    std::vector<Point2> chain;
    for (const Point2& p : points) {
      while (chain.size() > 1 && orient2d(chain[chain.size() - 2], chain.back(), p) != turn) chain.pop_back();
      chain.push_back(p);
    }
    for (std::size_t k = 1; k + 1 < chain.size(); ++k) {
      const Rational part = twice_area(chain[0], chain[k], chain[k + 1]);
      area = turn == Sign::positive ? area + part : area - part;
    }
  }
  return area;
}

inline void expect_laws(const std::vector<Point2>& points, std::span<const PlanarSegment> segments,
                        const PlanarTriangulation& made) {
  ASSERT_EQ(made.same.size(), points.size());
  ASSERT_EQ(made.neighbors.size(), made.triangles.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto first = std::find(points.begin(), points.end(), points[i]) - points.begin();
    EXPECT_EQ(made.same[i], first);
  }
  EXPECT_EQ(twice_area(points, made.triangles), hull_area(points));
  if (made.triangles.empty()) return;
  std::set<std::uint32_t> corners;
  std::set<PlanarSegment> covered;
  for (std::uint32_t f = 0; f < made.triangles.size(); ++f) {
    const Corners& t = made.triangles[f];
    corners.insert(t.begin(), t.end());
    EXPECT_EQ(orient2d(points[t[0]], points[t[1]], points[t[2]]), Sign::positive);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3], p = t[(k + 2) % 3], over = made.neighbors[f][k];
      const std::uint32_t cover = segments.empty() ? PlanarTriangulation::none : made.segments[f][k];
      if (cover != PlanarTriangulation::none) {
        covered.insert({a, b});
        covered.insert({b, a});
        const auto& [from, to] = segments[cover];
        EXPECT_EQ(orient2d(points[from], points[to], points[a]), Sign::zero);
        EXPECT_EQ(orient2d(points[from], points[to], points[b]), Sign::zero);
      }
      if (over == PlanarTriangulation::none) continue;
      ASSERT_LT(over, made.triangles.size());
      const Corners& u = made.triangles[over];
      std::size_t j = 0;
      while (j < 3 && !(u[j] == b && u[(j + 1) % 3] == a)) ++j;
      ASSERT_LT(j, 3U);
      EXPECT_EQ(made.neighbors[over][j], f);
      if (!segments.empty()) {
        EXPECT_EQ(made.segments[over][j], cover);
      }
      if (cover != PlanarTriangulation::none) continue;
      const std::uint32_t d = u[(j + 2) % 3];
      const Sign inside = incircle(points[a], points[b], points[p], points[d]);
      EXPECT_NE(inside, Sign::positive);
      if (inside == Sign::zero) {
        EXPECT_LT(std::min(a, b), std::min(p, d)) << "the diagonal is that of the lowest index";
      }
    }
  }
  EXPECT_EQ(corners, std::set<std::uint32_t>(made.same.begin(), made.same.end()));
  for (const auto& [from, to] : segments) {
    std::uint32_t at = made.same[from];
    for (std::size_t steps = 0; at != made.same[to]; ++steps) {
      ASSERT_LE(steps, points.size());
      // The nearest corner of those ahead on the segment to which an edge goes.
      std::uint32_t ahead = PlanarTriangulation::none;
      for (auto e = covered.lower_bound({at, 0}); e != covered.end() && (*e)[0] == at; ++e)
        if (orient2d(points[at], points[to], points[(*e)[1]]) == Sign::zero &&
            compare_xy(points[at], points[(*e)[1]]) == compare_xy(points[at], points[to]))
          ahead = (*e)[1];
      ASSERT_NE(ahead, PlanarTriangulation::none);
      at = ahead;
    }
  }
}

/// Of those given, in turn, each that crosses none before it.
inline std::vector<PlanarSegment> uncrossed(const std::vector<Point2>& points,
                                            const std::vector<PlanarSegment>& segments, std::size_t* crossed) {
  std::vector<PlanarSegment> kept;
  for (const PlanarSegment& s : segments) {
    kept.push_back(s);
    try {
      (void)delaunay(points, kept);
    } catch (const CrossingSegments& crossing) {
      const auto& [i, k] = crossing.segments;
      EXPECT_LT(i, k);
      EXPECT_EQ(k, kept.size() - 1) << "those before do not cross";
      for (const std::uint32_t which : crossing.segments) {
        const auto& [a, b] = kept[which];
        EXPECT_EQ(orient2d(ExactPoint2(points[a]), ExactPoint2(points[b]), crossing.place), Sign::zero);
        EXPECT_EQ(static_cast<int>(compare_xy(ExactPoint2(points[a]), crossing.place)) *
                      static_cast<int>(compare_xy(ExactPoint2(points[b]), crossing.place)),
                  -1);
      }
      kept.pop_back();
      ++*crossed;
    }
  }
  return kept;
}

}  // namespace plumb::planar_laws
