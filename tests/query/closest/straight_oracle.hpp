// Where do two straight shapes come closest, in rationals?  Brute force over all pairs of their features.
//
// Laws: a pair of features has a candidate where the normal equations of its two affine hulls have one solution, and
// that lies strictly within both; the least of them, of equal ones that which is first in lexicographic order, of equal
// points the features of the lowest dimension and number, is the answer.  Written from the definition, independent of
// the library's formulas.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "figure/basic/rationals.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"

namespace plumb::straight_oracle {

using namespace plumb::rationals;

/// base + sum of t_i ways[i], 0 < t_i where bounded below, t_i < 1 where bounded above (of a triangle's face their
/// sum).
struct Part {
  Feature feature;
  Vector base;
  std::vector<Vector> ways;
  bool starts = true, ends = true;
  bool only_given = false;  // a line's given point
};

inline Part corner(std::uint32_t index, const Vector& at) { return {{FeatureKind::vertex, index}, at, {}}; }
inline Part edge(std::uint32_t index, const Vector& a, const Vector& b) {
  return {{FeatureKind::edge, index}, a, {b - a}};
}
inline bool is_zero(const Vector& v) { return dot(v, v) == 0; }
inline bool are_parallel(const Vector& u, const Vector& v) {
  const mpq_class along = dot(u, v);
  return dot(u, u) * dot(v, v) == along * along;
}

inline Vector way_of(const Ray3& r) { return exact(r.direction); }
inline Vector way_of(const Segment3& s) { return exact(s.b) - exact(s.a); }

template <class S>
std::vector<Part> parts_of(const S& s) {
  std::vector<Part> parts;
  if constexpr (requires { s.direction; }) {
    constexpr bool line = requires { s.point; };
    Vector from;
    if constexpr (line) {
      from = exact(s.point);
    } else {
      from = exact(s.origin);
    }
    const Vector way = exact(s.direction);
    if (!line || is_zero(way)) parts.push_back(corner(0, from));
    if (is_zero(way)) return parts;
    if (line) parts.push_back({{FeatureKind::edge, 0}, from, {}, true, true, true});
    parts.push_back({{FeatureKind::edge, 0}, from, {way}, !line, false});
  } else {
    std::vector<Vector> corners{exact(s.a), exact(s.b)};
    if constexpr (requires { s.c; }) corners.push_back(exact(s.c));
    for (std::size_t i = 0; i < corners.size(); ++i) parts.push_back(corner(static_cast<std::uint32_t>(i), corners[i]));
    const std::size_t edges = corners.size() == 2 ? 1 : 3;
    for (std::size_t i = 0; i < edges; ++i) {
      const Vector &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if (!is_zero(b - a)) parts.push_back(edge(static_cast<std::uint32_t>(i), a, b));
    }
    if (edges == 3)
      parts.push_back({{FeatureKind::face, 0}, corners[0], {corners[1] - corners[0], corners[2] - corners[0]}});
  }
  return parts;
}

/// Is it a set of less dimensions than its kind has?
template <class S>
bool is_flat(const S& s) {
  if constexpr (requires { s.direction; }) {
    return is_zero(exact(s.direction));
  } else if constexpr (requires { s.c; }) {
    return are_parallel(exact(s.b) - exact(s.a), exact(s.c) - exact(s.a));
  } else {
    return is_zero(exact(s.b) - exact(s.a));
  }
}

struct Pair {
  Vector on_a, on_b;
  mpq_class square;
  Feature a, b;
  std::optional<mpq_class> s, t;  // along edges
};

inline bool within(const Part& part, const Vector& t) {
  mpq_class sum = 0;
  for (const mpq_class& x : t) {
    if (part.starts && x <= 0) return false;
    sum += x;
  }
  return part.ways.empty() || !part.ends || sum < 1;
}

inline Vector moved(const Part& part, const Vector& t) {
  Vector p = part.base;
  for (std::size_t i = 0; i < t.size(); ++i) p = p + t[i] * part.ways[i];
  return p;
}

inline std::optional<Pair> candidate(const Part& p, const Part& q) {
  std::vector<Vector> ways = p.ways;
  for (const Vector& way : q.ways) ways.push_back(mpq_class(-1) * way);
  if (ways.size() > 3) return {};  // two faces: never at one point alone
  std::vector<Vector> rows;
  for (const Vector& way : ways) {
    rows.emplace_back();
    for (const Vector& other : ways) rows.back().push_back(dot(way, other));
    rows.back().push_back(dot(way, q.base - p.base));
  }
  const auto x = only_solution(rows);
  if (!x) return {};
  const auto split = static_cast<std::ptrdiff_t>(p.ways.size());
  const Vector s(x->begin(), x->begin() + split), t(x->begin() + split, x->end());
  if (!within(p, s) || !within(q, t)) return {};
  Pair pair{moved(p, s), moved(q, t), 0, p.feature, q.feature, {}, {}};
  const Vector gap = pair.on_b - pair.on_a;
  pair.square = dot(gap, gap);
  if (s.size() == 1) pair.s = s[0];
  if (t.size() == 1) pair.t = t[0];
  return pair;
}

inline int rank(const Feature& f) { return static_cast<int>(f.kind) * 8 + static_cast<int>(f.index); }

/// Of two candidates: does the first come before?
inline bool before(const Pair& x, const Pair& y) {
  if (x.square != y.square) return x.square < y.square;
  if (x.on_a != y.on_a) return x.on_a < y.on_a;  // lexicographic
  return std::pair(rank(x.a), rank(x.b)) < std::pair(rank(y.a), rank(y.b));
}

template <class A, class B>
Pair closest(const A& a, const B& b) {
  std::optional<Pair> best;
  for (const Part& p : parts_of(a)) {
    for (const Part& q : parts_of(b)) {
      // A line's given point counts among the pairs of two parallel lines alone.
      const bool both_lines = requires {
        a.point;
        b.point;
      };
      if ((p.only_given || q.only_given) && !both_lines) continue;
      auto pair = candidate(p, q);
      if (pair && (!best || before(*pair, *best))) best = std::move(pair);
    }
  }
  return *best;
}

/// Is the finite d the double nearest to the root of a rational number?
inline bool is_nearest_root(double d, const mpq_class& square) {
  if (!(d >= 0) || !std::isfinite(d)) return false;
  const auto half_way = [&](double neighbor) {
    const mpq_class middle = (mpq_class(d) + mpq_class(neighbor)) / 2;
    return mpq_class(middle * middle);
  };
  if (d > 0 && half_way(std::nextafter(d, 0.0)) > square) return false;
  const double above = std::nextafter(d, std::numeric_limits<double>::infinity());
  return !std::isfinite(above) || half_way(above) >= square;
}

}  // namespace plumb::straight_oracle
