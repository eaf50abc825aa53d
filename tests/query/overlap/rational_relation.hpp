// How do two convex sets lie to one another, by a linear program in rationals?  For sets given by points and
// directions.
//
// A point of both is a combination of the points and directions of each, with weights that are not negative; it lies in
// both relative interiors when all weights can be positive.  So the largest weight that all can have at least tells the
// relation: none at all, zero, or more.
// Laws: exact.
// Source: the simplex method with Bland's rule; Rockafellar, Convex Analysis, section 6.
// Cost: some 50 us for small integers.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <vector>

#include "plumb/figure.hpp"

namespace plumb::oracle {

using RationalPoint = std::array<mpq_class, 3>;

/// All sums of weighted points, of weight one together, and of directions with weights that are not negative.
struct Spanned {
  std::vector<RationalPoint> points, directions;
};

inline RationalPoint rational(const Point3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }
inline RationalPoint rational(const Vector3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }
inline RationalPoint rational(const Point2& p) { return {mpq_class(p.x), mpq_class(p.y), 0}; }
inline RationalPoint rational(const Vector2& p) { return {mpq_class(p.x), mpq_class(p.y), 0}; }
inline RationalPoint opposite(const RationalPoint& v) { return {-v[0], -v[1], -v[2]}; }

template <class Shape>
Spanned spanned(const Shape& s) {
  Spanned all;
  const auto add = [&](const auto&... p) { (all.points.push_back(rational(p)), ...); };
  if constexpr (requires { s.direction; }) {
    const RationalPoint d = rational(s.direction);
    all.directions.push_back(d);
    if constexpr (requires { s.point; }) {
      add(s.point);
      all.directions.push_back(opposite(d));
    } else {
      add(s.origin);
    }
  } else if constexpr (requires { s.axes; }) {
    const std::array half{s.half.x, s.half.y, s.half.z};
    for (unsigned corner = 0; corner < 8; ++corner) {
      RationalPoint p = rational(s.center);
      for (std::size_t i = 0; i < 3; ++i) {
        const RationalPoint axis = rational(s.axes[i]);
        const mpq_class by = (corner >> i & 1u) != 0 ? mpq_class(half[i]) : -mpq_class(half[i]);
        for (std::size_t k = 0; k < 3; ++k) p[k] += by * axis[k];
      }
      all.points.push_back(p);
    }
  } else if constexpr (requires { s.min.z; }) {
    const auto& [a, b] = s;
    if (a.x > b.x || a.y > b.y || a.z > b.z) return all;
    for (unsigned corner = 0; corner < 8; ++corner)
      add(Point3{corner & 1u ? b.x : a.x, corner & 2u ? b.y : a.y, corner & 4u ? b.z : a.z});
  } else if constexpr (requires { s.min; }) {
    const auto& [a, b] = s;
    if (a.x > b.x || a.y > b.y) return all;
    for (unsigned corner = 0; corner < 4; ++corner) add(Point2{corner & 1u ? b.x : a.x, corner & 2u ? b.y : a.y});
  } else if constexpr (requires { s.d; }) {
    add(s.a, s.b, s.c, s.d);
  } else if constexpr (requires { s.c; }) {
    add(s.a, s.b, s.c);
  } else if constexpr (requires { s.a; }) {
    add(s.a, s.b);
  } else {
    add(s);
  }
  return all;
}

/// The affine hull of three points.
inline Spanned spanned(const ThreePointPlane3& plane) {
  Spanned all{{rational(plane.a)}, {}};
  for (const Point3& p : {plane.b, plane.c}) {
    RationalPoint d = rational(p);
    for (std::size_t k = 0; k < 3; ++k) d[k] -= all.points[0][k];
    all.directions.push_back(d);
    all.directions.push_back(opposite(d));
  }
  return all;
}

/// A normal that is zero leaves all of space or nothing.
inline Spanned spanned_by_normal(const Vector3& normal, double offset, bool halfspace) {
  const RationalPoint n = rational(normal), x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  if (normal == Vector3{0, 0, 0}) {
    if (halfspace ? offset < 0 : offset != 0) return {};
    return {{{0, 0, 0}}, {x, opposite(x), y, opposite(y), z, opposite(z)}};
  }
  const mpq_class square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  const mpq_class by = mpq_class(offset) / square;
  Spanned all{{{by * n[0], by * n[1], by * n[2]}}, {}};
  for (const RationalPoint& d :
       {RationalPoint{n[1], -n[0], 0}, RationalPoint{n[2], 0, -n[0]}, RationalPoint{0, n[2], -n[1]}}) {
    all.directions.push_back(d);
    all.directions.push_back(opposite(d));
  }
  if (halfspace) all.directions.push_back(opposite(n));
  return all;
}
inline Spanned spanned(const Plane3& plane) { return spanned_by_normal(plane.normal, plane.offset, false); }
inline Spanned spanned(const Halfspace3& half) { return spanned_by_normal(half.normal, half.offset, true); }

/// max of the common weight over five equations; artificial columns are driven out by a cost beyond all others.
class CommonWeight {
 public:
  CommonWeight(const Spanned& a, const Spanned& b) {
    const auto add = [&](const RationalPoint& p, int way, int of_a, int of_b) {
      columns_.push_back({way * p[0], way * p[1], way * p[2], of_a, of_b});
    };
    for (const auto& p : a.points) add(p, 1, 1, 0);
    for (const auto& p : b.points) add(p, -1, 0, 1);
    for (const auto& d : a.directions) add(d, 1, 0, 0);
    for (const auto& d : b.directions) add(d, -1, 0, 0);
    Column common{};
    for (const Column& c : columns_) {
      for (std::size_t k = 0; k < rows; ++k) common[k] += c[k];
    }
    columns_.push_back(common);
    weight_ = columns_.size() - 1;
    for (std::size_t k = 0; k < rows; ++k) {
      Column artificial{};
      artificial[k] = 1;
      columns_.push_back(artificial);
      basis_[k] = weight_ + 1 + k;
      right_[k] = k < 3 ? 0 : 1;
    }
  }

  Relation relation() {
    while (step()) {
    }
    mpq_class weight = 0;
    for (std::size_t k = 0; k < rows; ++k) {
      if (basis_[k] > weight_ && sgn(right_[k]) != 0) return Relation::disjoint;
      if (basis_[k] == weight_) weight = right_[k];
    }
    return sgn(weight) > 0 ? Relation::overlapping : Relation::touching;
  }

 private:
  static constexpr std::size_t rows = 5;
  using Column = std::array<mpq_class, rows>;

  // The cost saved by a column: of artificial weight first, then of the common weight.
  [[nodiscard]] bool improves(std::size_t j) const {
    mpq_class artificial = 0;
    mpq_class common = j == weight_ ? 1 : 0;
    for (std::size_t k = 0; k < rows; ++k) {
      if (basis_[k] > weight_) artificial += columns_[j][k];
      if (basis_[k] == weight_) common -= columns_[j][k];
    }
    return sgn(artificial) > 0 || (sgn(artificial) == 0 && sgn(common) > 0);
  }

  bool step() {
    std::size_t in = 0;
    while (in <= weight_ && (std::ranges::find(basis_, in) != basis_.end() || !improves(in))) ++in;
    if (in > weight_) return false;
    std::size_t out = rows;
    mpq_class least;
    for (std::size_t k = 0; k < rows; ++k) {
      if (sgn(columns_[in][k]) <= 0) continue;
      const mpq_class ratio = right_[k] / columns_[in][k];
      const int order = out == rows ? -1 : cmp(ratio, least);
      if (order < 0 || (order == 0 && basis_[k] < basis_[out])) out = k, least = ratio;
    }
    if (out == rows) return false;
    const Column pivot = columns_[in];
    for (std::size_t j = 0; j <= weight_; ++j) eliminate(columns_[j], pivot, out);
    eliminate(right_, pivot, out);
    basis_[out] = in;
    return true;
  }

  static void eliminate(Column& c, const Column& pivot, std::size_t row) {
    if (sgn(c[row]) == 0) return;
    c[row] /= pivot[row];
    for (std::size_t k = 0; k < rows; ++k) {
      if (k != row && sgn(pivot[k]) != 0) c[k] -= pivot[k] * c[row];
    }
  }

  std::vector<Column> columns_;
  std::size_t weight_ = 0;
  std::array<std::size_t, rows> basis_{};
  Column right_{};
};

inline Relation relation(const Spanned& a, const Spanned& b) {
  if (a.points.empty() || b.points.empty()) return Relation::disjoint;
  return CommonWeight(a, b).relation();
}

template <class A, class B>
Relation rational_relation(const A& a, const B& b) {
  return relation(spanned(a), spanned(b));
}

}  // namespace plumb::oracle
