// Is this a nearest pair?  Figures whose type was forgotten, and what proves an answer: written from the definition.
//
// Laws: two points of two convex sets are nearest exactly where the plane through each, at right angles to the way between
// them, has all of its set beyond.  Membership is asked of a linear program, independent of the search.
#pragma once

#include <algorithm>
#include <memory>

#include "figure/basic/rationals.hpp"
#include "query/body/pair_shapes.hpp"
#include "query/body/pair_types.hpp"
#include "query/convex/core.hpp"

namespace plumb::certificate {

using query::Exact3, query::FigureView, query::FlatSet, query::dot;

/// A figure that lives as long as this does.
struct AnyFigure {
  std::shared_ptr<const void> shape;
  FigureView view;
};
template <class Shape>
AnyFigure any(Shape s) {
  auto shape = std::make_shared<const Shape>(std::move(s));
  const FigureView view = query::view_of(*shape);
  return {std::move(shape), view};
}

inline Exact3 exact(const Point3& p) { return {p.x, p.y, p.z}; }

inline bool holds(const FlatSet& s, const Exact3& p) {
  return query::relate(FlatSet{{p}, {}, {}}, s) != Relation::disjoint;
}

/// Is all of the set beyond the plane through p, which may be in it, along the way?
inline bool is_beyond(const FlatSet& s, const Exact3& p, const Exact3& way) {
  using query::operator-;
  const auto least = [&](const Exact3& v) { return sgn(dot(way, v)); };
  return std::ranges::all_of(s.points, [&](const Exact3& v) { return least(v - p) >= 0; }) &&
         std::ranges::all_of(s.directions, [&](const Exact3& v) { return least(v) >= 0; }) &&
         std::ranges::all_of(s.lines, [&](const Exact3& v) { return least(v) == 0; });
}

inline bool are_nearest(const FlatSet& a, const FlatSet& b, const Exact3& on_a, const Exact3& on_b) {
  using query::operator-;
  return holds(a, on_a) && holds(b, on_b) && is_beyond(a, on_a, on_a - on_b) && is_beyond(b, on_b, on_b - on_a);
}

/// Is d the double nearest to sqrt(square) - inset, which is not negative?
inline bool is_nearest_distance(double d, const mpq_class& square, const mpq_class& inset) {
  if (!(d >= 0) || !std::isfinite(d)) return false;
  const auto from = [&](double neighbor) { return mpq_class((mpq_class(d) + mpq_class(neighbor)) / 2 + inset); };
  if (d > 0) {
    const mpq_class low = from(std::nextafter(d, 0.0));
    if (low * low > square) return false;
  }
  const double above = std::nextafter(d, std::numeric_limits<double>::infinity());
  if (!std::isfinite(above)) return true;
  const mpq_class high = from(above);
  return high * high >= square;
}

/// Is d the double nearest to from + way * radius / sqrt(square)?  By bounds of that number of 400 bits.
inline bool is_nearest_moved(double d, const mpq_class& from, const mpq_class& way, double radius,
                             const mpq_class& square) {
  mpf_class s(square, 2000);
  const mpf_class root = sqrt(s), exact = mpf_class(from, 2000) + mpf_class(way, 2000) * radius / root;
  const mpf_class off = abs(mpf_class(exact - mpf_class(d, 2000)));
  const mpf_class up(std::nextafter(d, HUGE_VAL), 2000), down(std::nextafter(d, -HUGE_VAL), 2000);
  const mpf_class little = (up - down) * mpf_class(0x1p-300, 2000);
  return off <= abs(mpf_class(exact - up)) + little && off <= abs(mpf_class(exact - down)) + little;
}

}  // namespace plumb::certificate
