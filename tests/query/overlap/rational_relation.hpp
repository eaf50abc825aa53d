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
#include "query/body/exact_sets.hpp"

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

/// What lies in the plane lies in z = 0.
template <class Shape>
Spanned spanned(const Shape& s) {
  const exact::Generators g = exact::generated(s);
  Spanned all;
  const auto in_space = [](const exact::Coordinates& v) {
    return RationalPoint{v[0], v[1], v.size() == 3 ? v[2] : mpq_class(0)};
  };
  for (const exact::Coordinates& p : g.points) all.points.push_back(in_space(p));
  for (const exact::Coordinates& d : g.rays) all.directions.push_back(in_space(d));
  return all;
}

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
