// Conservative advancement, interval halving: when can two figures that move straight, or whose corners do, first meet?
// Interval halving for whatever has a distance.
//
//   first_contact_span(Moving<Triangle3>{from, to}, Moving<Triangle3>{rest, rest})
//   first_contact_span(Translating<Point3>{p, by}, Translating<Polygon3>{polygon, {0, 0, 0}})
//
// For all pairs that distance(a, b) answers (query/closest/closest.hpp, query/separation/separation.hpp).
// Laws: those of query/time_of_impact/interval_halving.hpp, with the distances of the figures themselves: nothing means that they
// never meet in [0, 1], and a span that they do not meet before it.  Places at a time between are rounded, by no more
// than is taken off the distance; of Translating figures neither of which is a point, line, ray, segment or triangle they
// are exact.
// NaN and infinity throw NonFinite, what is no shape InvalidShape, by name.
// Source: RTCD 5.5.1.
// Cost: two distances for each span that cannot be told apart, some tens of them where figures come close or meet.
// Bounded by a fixed number of distances, 2 / resolution.
#pragma once

#include <concepts>
#include <string_view>

#include "plumb/query/body/pairs.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "plumb/query/separation/separation.hpp"
#include "plumb/query/time_of_impact/interval_halving.hpp"
#include "plumb/query/time_of_impact/motion.hpp"

namespace plumb {

namespace query {

/// Whose corners say it.
template <class Shape>
concept OfCorners = std::same_as<Shape, Point3> || std::same_as<Shape, Segment3> || std::same_as<Shape, Triangle3> ||
    std::same_as<Shape, Tetrahedron3>;
/// Those, and what a place moves that has a direction.
template <class Shape>
concept OfPlaces = OfCorners<Shape> || std::same_as<Shape, Line3> || std::same_as<Shape, Ray3>;

/// Doubles near to exact places, and how far off the farthest of them can be.
class NearbyPlaces {
 public:
  Point3 operator()(const Interval& x, const Interval& y, const Interval& z);
  [[nodiscard]] double off() const { return off_; }

 private:
  double off_ = 0;
};

/// No more than d - off - other_off, where d is a distance rounded to the nearest double.
double surely_apart(double d, double off, double other_off);
/// No less than the length.
double length_at_most(const Interval& x, const Interval& y, const Interval& z);
void require_moving(std::string_view name, const FigureView& shape);
void require_way(std::string_view name, const Vector3& by);

template <OfPlaces Shape, class F>
Shape with_places(const Shape& s, F f) {
  if constexpr (std::same_as<Shape, Point3>) {
    return f(s);
  } else if constexpr (std::same_as<Shape, Line3>) {
    return {f(s.point), s.direction};
  } else if constexpr (std::same_as<Shape, Ray3>) {
    return {f(s.origin), s.direction};
  } else if constexpr (std::same_as<Shape, Segment3>) {
    return {f(s.a), f(s.b)};
  } else if constexpr (std::same_as<Shape, Triangle3>) {
    return {f(s.a), f(s.b), f(s.c)};
  } else {
    return {f(s.a), f(s.b), f(s.c), f(s.d)};
  }
}

/// Only the difference of the motions counts: b rests.
template <OfPlaces A, class B>
class RelativeMotion {
 public:
  RelativeMotion(const Translating<A>& a, const Translating<B>& b)
      : a_(a.shape),
        b_(b.shape),
        x_(Interval(a.by.x) - Interval(b.by.x)),
        y_(Interval(a.by.y) - Interval(b.by.y)),
        z_(Interval(a.by.z) - Interval(b.by.z)) {}

  [[nodiscard]] double distance_at(double t) const {
    NearbyPlaces near;
    const Interval time(t);
    const A moved = with_places(a_, [&](const Point3& p) {
      return near(Interval(p.x) + time * x_, Interval(p.y) + time * y_, Interval(p.z) + time * z_);
    });
    return surely_apart(distance(moved, b_), near.off(), 0);
  }
  [[nodiscard]] double speed_between(double, double) const { return length_at_most(x_, y_, z_); }

 private:
  const A& a_;
  const B& b_;
  Interval x_, y_, z_;  // the way of a
};

template <OfCorners A, OfCorners B>
class CornerMotion {
 public:
  CornerMotion(const Moving<A>& a, const Moving<B>& b) : a_(a), b_(b), speed_(speed(a) + Interval(speed(b))) {}

  [[nodiscard]] double distance_at(double t) const {
    NearbyPlaces near_a, near_b;
    const A a = placed(a_, t, near_a);
    const B b = placed(b_, t, near_b);
    return surely_apart(distance(a, b), near_a.off(), near_b.off());
  }
  [[nodiscard]] double speed_between(double, double) const { return speed_.upper; }

 private:
  /// Calls f(from, to) for every corner.
  template <class Shape, class F>
  static Shape on_corners(const Moving<Shape>& m, F f) {
    if constexpr (std::same_as<Shape, Point3>) {
      return f(m.from, m.to);
    } else if constexpr (std::same_as<Shape, Segment3>) {
      return {f(m.from.a, m.to.a), f(m.from.b, m.to.b)};
    } else if constexpr (std::same_as<Shape, Triangle3>) {
      return {f(m.from.a, m.to.a), f(m.from.b, m.to.b), f(m.from.c, m.to.c)};
    } else {
      return {f(m.from.a, m.to.a), f(m.from.b, m.to.b), f(m.from.c, m.to.c), f(m.from.d, m.to.d)};
    }
  }
  template <class Shape>
  static Shape placed(const Moving<Shape>& m, double t, NearbyPlaces& near) {
    const auto between = [s = Interval(1 - t), t = Interval(t)](double from, double to) {  // 1 - t is exact
      return s * Interval(from) + t * Interval(to);
    };
    return on_corners(m, [&](const Point3& p, const Point3& q) {
      return near(between(p.x, q.x), between(p.y, q.y), between(p.z, q.z));
    });
  }
  template <class Shape>
  static Interval speed(const Moving<Shape>& m) {
    double most = 0;
    on_corners(m, [&](const Point3& p, const Point3& q) {
      const auto way = [](double from, double to) { return Interval(to) - Interval(from); };
      const double length = length_at_most(way(p.x, q.x), way(p.y, q.y), way(p.z, q.z));
      if (most < length) most = length;
      return p;
    });
    return Interval(most);
  }

  const Moving<A>& a_;
  const Moving<B>& b_;
  Interval speed_;
};

/// Whatever the two are.
class TranslatingPair {
 public:
  TranslatingPair(const FigureView& a, const Vector3& by_a, const FigureView& b, const Vector3& by_b);

  [[nodiscard]] double distance_at(double t) const;
  [[nodiscard]] double speed_between(double, double) const { return speed_; }

 private:
  FigureView a_, b_;
  Vector3 by_a_, by_b_;
  double speed_;
};

}  // namespace query

/// The first span of time in which the two may meet; nothing where they never do.
template <Figure A, Figure B>
requires(HasDistance<A, B>&& figure_dimension<A> == 3)  //
    std::optional<TimeSpan> first_contact_span(const Translating<A>& a, const Translating<B>& b,
                                               const HalvingOptions& options = {}) {
  query::require_moving("a.shape", query::view_of(a.shape)), query::require_way("a.by", a.by);
  query::require_moving("b.shape", query::view_of(b.shape)), query::require_way("b.by", b.by);
  if constexpr (!query::OfPlaces<A> && !query::OfPlaces<B>) {
    return first_contact_span(query::TranslatingPair(query::view_of(a.shape), a.by, query::view_of(b.shape), b.by),
                              options);
  } else if constexpr (query::OfPlaces<A>) {
    return first_contact_span(query::RelativeMotion<A, B>(a, b), options);
  } else {
    return first_contact_span(query::RelativeMotion<B, A>(b, a), options);
  }
}
template <query::OfCorners A, query::OfCorners B>
std::optional<TimeSpan> first_contact_span(const Moving<A>& a, const Moving<B>& b, const HalvingOptions& options = {}) {
  query::require_moving("a.from", query::view_of(a.from)), query::require_moving("a.to", query::view_of(a.to));
  query::require_moving("b.from", query::view_of(b.from)), query::require_moving("b.to", query::view_of(b.to));
  return first_contact_span(query::CornerMotion<A, B>(a, b), options);
}

}  // namespace plumb
