// Is every answer asked for often?  Counts of the three relations, and the comparison of one pair with the oracle.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "figure/basic/shape_cases.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/overlap/rational_relation.hpp"

namespace plumb {

struct Counts {
  std::array<int, 3> of{};
  void add(Relation r) { ++of[static_cast<std::size_t>(static_cast<int>(r) + 1)]; }
};

/// Every relation in at least this many cases of a hundred.
inline void expect_all_answers(const Counts& counts, std::uint64_t cases, int percent = 1) {
  for (const int n : counts.of)
    EXPECT_GE(static_cast<std::uint64_t>(n) * 100, cases * static_cast<std::uint64_t>(percent));
}

/// Sets without a boundary, which nothing can only touch.
template <class Shape>
inline constexpr bool is_boundless = requires(Shape s) {
  s.point;
}
|| std::is_same_v<Shape, Plane3> || std::is_same_v<Shape, ThreePointPlane3> || std::is_same_v<Shape, Point3>;

template <class Shape>
Shape drawn(shape_cases::Material& m) {
  if constexpr (std::is_same_v<Shape, Point3>) {
    return m.below(2) == 0 ? m.point3() : m.probe3();
  } else {
    return m.shape<Shape>();
  }
}

/// A shape whose points lie near to what was drawn, every second time: in the middles of edges, on lines, at corners.
template <class Shape>
Shape near_drawn(shape_cases::Material& m) {
  Shape s = drawn<Shape>(m);
  if (m.below(2) == 0) return s;
  const auto probe = [&](auto&... p) { ((p = m.probe<std::remove_cvref_t<decltype(p)>>()), ...); };
  const auto toward = [&](const auto& p, auto& d) {  // where doubles hold the difference
    auto q = p;
    probe(q);
    const auto difference = std::remove_cvref_t<decltype(d)>{};
    d = difference;
    d.x = q.x - p.x, d.y = q.y - p.y;
    if constexpr (requires { d.z; }) d.z = q.z - p.z;
    bool finite = std::isfinite(d.x) && std::isfinite(d.y);
    if constexpr (requires { d.z; }) finite = finite && std::isfinite(d.z);
    if (!finite) d = difference;
  };
  if constexpr (requires { s.axes; }) {
    probe(s.center);
  } else if constexpr (requires { s.point; }) {
    probe(s.point), toward(s.point, s.direction);
  } else if constexpr (requires { s.origin; }) {
    probe(s.origin), toward(s.origin, s.direction);
  } else if constexpr (requires { s.d; }) {
    probe(s.a, s.b, s.c, s.d);
  } else if constexpr (requires { s.c; }) {
    probe(s.a, s.b, s.c);
  } else if constexpr (requires { s.a; }) {
    probe(s.a, s.b);
  } else if constexpr (requires { s.min; }) {
    auto &a = s.min, &b = s.max;
    probe(a, b);
    if (a.x > b.x) std::swap(a.x, b.x);
    if (a.y > b.y) std::swap(a.y, b.y);
    if constexpr (requires { a.z; }) {
      if (a.z > b.z) std::swap(a.z, b.z);
    }
  }
  return s;
}

/// relate and intersects of A and B against the oracle, on random shapes.  A shape is drawn after the other one, so
/// they share corners now and then.
template <class A, class B>
void expect_as_oracle(std::uint64_t start, std::uint64_t cases, int percent = 1) {
  Counts counts;
  shape_cases::on_shapes(start, cases, [&](shape_cases::Material& m) {
    const A a = drawn<A>(m);
    const B b = near_drawn<B>(m);
    const Relation expected = oracle::rational_relation(a, b);
    counts.add(expected);
    ASSERT_EQ(relate(a, b), expected) << m.about(a, b);
    ASSERT_EQ(intersects(a, b), expected != Relation::disjoint) << m.about(a, b);
  });
  std::printf("disjoint %d, touching %d, overlapping %d\n", counts.of[0], counts.of[1], counts.of[2]);
  if (is_boundless<A> && is_boundless<B>) counts.of[1] = counts.of[2];
  expect_all_answers(counts, cases * shape_cases::more, percent);
}

}  // namespace plumb
