// Cylinders and cones against lines, rays and segments by a quadratic; against what has faces and against balls by
// query/convex/axis_relation.hpp.
#include <optional>

#include "arith/approximate.hpp"
#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "figure/swept_sphere/core_distance.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "query/body/axis_shape.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/past_cylinder.hpp"
#include "query/body/vectors.hpp"
#include "query/convex/axis_relation.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/overlap/pair_answer.hpp"
#include "query/overlap/polygon_relation.hpp"

namespace plumb {
namespace query {
namespace {

template <class T>
using Vec = arith::Vec<T>;

/// a t^2 + 2 b t + c.
template <class T>
struct AxisQuadratic {
  T a, b, c;
};

/// A place on the line: numerator / denominator, denominator > 0.
template <class T>
struct AxisQuotient {
  T numerator, denominator;
};

template <class T>
class LineThroughRound {
 public:
  LineThroughRound(const StraightAxis<T>& line, const RoundAxis& axis)
      : has_start_(line.has_start),
        has_end_(line.has_end),
        height_(T(0.0)),
        rise_(T(0.0)),
        top_(T(0.0)),
        surface_{T(0.0), T(0.0), T(0.0)} {
    const Vec<T> from = arith::vec<T>(axis.from), h = arith::vec<T>(axis.to) - from, w = line.from - from;
    height_ = arith::dot(w, h), rise_ = arith::dot(line.along, h), top_ = arith::dot(h, h);
    const Vec<T> off = arith::cross(w, h), change = arith::cross(line.along, h);
    const T r = T(axis.radius) * T(axis.radius);
    surface_ = {arith::dot(change, change), arith::dot(off, change), arith::dot(off, off)};
    if (axis.is_cone) {
      surface_ = {surface_.a * top_ - r * rise_ * rise_, surface_.b * top_ - r * height_ * rise_,
                  surface_.c * top_ - r * height_ * height_};
    } else {
      surface_.c = surface_.c - r * top_;
    }
  }

  /// Nothing where a sign is not certain.
  std::optional<Relation> relation() {
    const Relation r = related();
    if (!ask_.certain()) return {};
    return r;
  }

 private:
  Relation related() {
    const T zero = T(0.0), one = T(1.0);
    std::optional<AxisQuotient<T>> first, last;
    if (has_start_) first = {zero, one};
    if (has_end_) last = {one, one};
    bool crosses_inside = true;  // do places between first and last lie strictly between the two planes?
    const Sign rises = ask_(rise_);
    if (!ask_.certain()) return Relation::disjoint;
    if (rises == Sign::zero) {
      const Sign above = ask_(height_), below = ask_(top_ - height_);
      if (above == Sign::negative || below == Sign::negative) return Relation::disjoint;
      crosses_inside = above == Sign::positive && below == Sign::positive;
    } else {
      const bool up = rises == Sign::positive;
      const T slope = up ? rise_ : zero - rise_;
      later(first, {up ? zero - height_ : height_ - top_, slope});
      sooner(last, {up ? top_ - height_ : height_, slope});
    }
    const Sign length = first && last ? order(*last, *first) : Sign::positive;
    if (length == Sign::negative) return Relation::disjoint;
    const Sign least = least_value(first, last);
    if (least != Sign::negative) return least == Sign::zero ? Relation::touching : Relation::disjoint;
    return length == Sign::positive && crosses_inside ? Relation::overlapping : Relation::touching;
  }

  Sign order(const AxisQuotient<T>& p, const AxisQuotient<T>& q) {
    return ask_(p.numerator * q.denominator - q.numerator * p.denominator);
  }
  void later(std::optional<AxisQuotient<T>>& first, const AxisQuotient<T>& p) {
    if (!first || order(p, *first) == Sign::positive) first = p;
  }
  void sooner(std::optional<AxisQuotient<T>>& last, const AxisQuotient<T>& p) {
    if (!last || order(p, *last) == Sign::negative) last = p;
  }

  /// The sign of the least value of the surface's quadratic: at its bottom, if it has one between the ends, else at an
  /// end; without a bottom both ends are there, for the line is not level then.
  Sign least_value(const std::optional<AxisQuotient<T>>& first, const std::optional<AxisQuotient<T>>& last) {
    const auto& [a, b, c] = surface_;
    if (ask_(a) == Sign::positive) {
      const AxisQuotient<T> bottom{T(0.0) - b, a};
      if (first && order(bottom, *first) != Sign::positive) return value(*first);
      if (last && order(bottom, *last) != Sign::negative) return value(*last);
      return ask_(a * c - b * b);
    }
    if (!ask_.certain()) return Sign::zero;
    return std::min(value(*first), value(*last));
  }
  Sign value(const AxisQuotient<T>& p) {
    const auto& [a, b, c] = surface_;
    const auto& [n, d] = p;
    return ask_(a * n * n + (b + b) * n * d + c * d * d);
  }

  CertainSigns ask_;
  bool has_start_, has_end_;
  T height_, rise_, top_;  // of the start above the first plane, along the line, and of the second plane
  AxisQuadratic<T> surface_;
};

template <class T, class Line, class Round>
[[gnu::flatten]] std::optional<Relation> crossing(const Line& line, const Round& round) {
  return LineThroughRound<T>(straight<T>(line), axis_of(round)).relation();
}

/// Once for all lines and shapes: by integers of any size it is thirty kilobytes.
[[gnu::noinline, gnu::flatten]] Relation exact_crossing(const StraightAxis<BigDyadic>& line, const RoundAxis& round) {
  return *LineThroughRound<BigDyadic>(line, round).relation();
}

template <class Line>
Point3 start_of(const Line& line) {
  if constexpr (requires { line.point; }) {
    return line.point;
  } else if constexpr (requires { line.origin; }) {
    return line.origin;
  } else {
    return line.a;
  }
}

/// Is it certain that the line passes by?  Beyond an end of the axis, or outside of the surface all along.
template <class Line>
[[gnu::flatten]] bool passes_by(const Line& line, const RoundAxis& axis) {
  const StraightAxis<Approximate> s = straight<Approximate>(line);
  const Vec<Approximate> h = between<Approximate>(axis.from, axis.to),
                         w = between<Approximate>(axis.from, start_of(line));
  const Approximate height = arith::dot(w, h), rise = arith::dot(s.along, h), top = arith::dot(h, h);
  if (s.has_start) {
    const Approximate last = s.has_end ? height + rise : rise;  // of a ray the way that it goes
    if (height.certain_sign() < 0 && last.certain_sign() < 0) return true;
    if ((height - top).certain_sign() > 0 && (s.has_end ? last - top : last).certain_sign() > 0) return true;
  }
  const Vec<Approximate> off = arith::cross(w, h), change = arith::cross(s.along, h);
  const Approximate r(axis.radius), reach = r * r;
  Approximate a = arith::dot(change, change), b = arith::dot(off, change), c = arith::dot(off, off);
  if (axis.is_cone) {
    a = a * top - reach * rise * rise, b = b * top - reach * height * rise, c = c * top - reach * height * height;
  } else {
    c = c - reach * top;
  }
  if (a.certain_sign() <= 0) return false;
  if (s.has_start && b.certain_sign() > 0) return c.certain_sign() > 0;
  if (s.has_end && (a + b).certain_sign() < 0) return (a + b + b + c).certain_sign() > 0;
  return (a * c - b * b).certain_sign() > 0;
}

/// Of a shape with an interior, which a point overlaps where it is inside.
template <class Round>
Relation relation_of_point(const Point3& p, const Round& round) {
  return static_cast<Relation>(locate(round, p));
}

template <class Round>
Relation relate_point(const Point3& p, const Round& round, Question question) {
  const auto [from, to, radius, is_cone] = axis_of(round);
  require_figures(question, p, round);
  if (from != to && radius == 0) return relate(flat_set(p), flat_set(Segment3{from, to}));
  return from == to ? relate(p, Sphere3{from, radius}) : relation_of_point(p, round);
}

template <class Line, class Round>
[[gnu::noinline]] Relation relate_straight_and_round(const Line& line, const Round& round, Question question) {
  const auto [from, to, radius, is_cone] = axis_of(round);
  if (is_sound(line) && is_sound(round) && radius > 0 && from != to && !is_point(line)) [[likely]] {
    if (is_cone && passes_by(line, axis_of(round))) return Relation::disjoint;
    if (const auto r = crossing<Approximate>(line, round)) [[likely]]
      return *r;
    if (const auto r = crossing<Running>(line, round)) return *r;
  }
  require_figures(question, line, round);
  if (from == to) return relate(line, Sphere3{from, radius});
  if (radius == 0) return relate(flat_set(line), flat_set(Segment3{from, to}));
  if (is_point(line)) return relation_of_point(start_of(line), round);
  return exact_crossing(straight<BigDyadic>(line), axis_of(round));
}

// As far as doubles tell at once.
template <bool begins, bool ends>
[[gnu::always_inline]] inline std::optional<Relation> quickly(const Point3& start, const auto& to, const Cylinder3& c) {
  if (!(c.radius >= 0)) return {};
  using Statement = PastCylinder<begins, ends>;
  return certify::one_lane::told_by_worlds<FloatWorld<Statement>>(NoWorldRecorder{}, Statement{}, start, to, c);
}
[[gnu::always_inline]] inline std::optional<Relation> quickly(const Segment3& s, const Cylinder3& c) {
  return quickly<true, true>(s.a, s.b, c);
}
[[gnu::always_inline]] inline std::optional<Relation> quickly(const Ray3& r, const Cylinder3& c) {
  return quickly<true, false>(r.origin, r.direction, c);
}
[[gnu::always_inline]] inline std::optional<Relation> quickly(const Line3& l, const Cylinder3& c) {
  return quickly<false, false>(l.point, l.direction, c);
}

template <class Line>
Relation relate_line(const Line& line, const Cylinder3& round, Question question) {
  if (const auto r = quickly(line, round)) [[likely]]
    return *r;
  return relate_straight_and_round(line, round, question);
}
template <class Line>
Relation relate_line(const Line& line, const Cone3& round, Question question) {
  return relate_straight_and_round(line, round, question);
}

/// The capsule around a shape parts it from most; where the inside of the axis is met, so is that of the shape.
template <class Shape, class Round>
std::optional<Relation> quick_axis_relation(const Shape& s, const Round& round, Question question) {
  const auto [from, to, radius, is_cone] = axis_of(round);
  const auto ask = [&](const auto& other) {
    if constexpr (PairOfTable<Shape, std::remove_cvref_t<decltype(other)>>) {
      return relate_as(question, s, other);
    } else {
      return relate(s, other);
    }
  };
  if (from == to) return ask(Sphere3{from, radius});
  if (radius == 0) return ask(Segment3{from, to});
  if (ask(Capsule3{from, to, radius}) == Relation::disjoint) return Relation::disjoint;
  if (relate(s, Segment3{from, to}) == Relation::overlapping) return Relation::overlapping;
  return {};
}

template <class Flat, class Round>
Relation relate_axis_round(const Flat& s, const Round& round, Question question) {
  require_figures(question, s, round);
  if (const auto quick = quick_axis_relation(s, round, question)) return *quick;
  if constexpr (is_one_of(figure_kind<Flat>,
                          {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon})) {
    return relate_axis_shape(exact_chains(name_of(question), view_of(s)), axis_of(round));
  } else {
    return relate_axis_shape(flat_set(s), axis_of(round));
  }
}

template <class Round, class Flat>
Relation relate_axis_round_last(const Round& round, const Flat& s, Question question) {
  return relate_axis_round(s, round, question);
}

template <class Round>
Relation relate_ball_and_axis_round(const Sphere3& ball, const Round& round, Question question) {
  require_figures(question, ball, round);
  if (ball.radius == 0) return relate_as(question, ball.center, round);
  if (const auto quick = quick_axis_relation(ball, round, question)) return *quick;
  const auto& [center, r] = ball;
  const mpq_class radius(r);
  return relate_axis_shape(Exact3{center.x, center.y, center.z}, mpq_class(radius * radius), axis_of(round));
}

}  // namespace

Relation relate_exact_line(const StraightAxis<Rational>& line, const RoundAxis& shape) {
  return *LineThroughRound<Rational>(line, shape).relation();
}

PLUMB_PAIR_ANSWERS_OF(Point3, relate_point, Cylinder3, Cone3)
PLUMB_PAIR_ANSWERS_TO(Cylinder3, relate_line, Line3, Ray3, Segment3)
PLUMB_PAIR_ANSWERS_TO(Cone3, relate_line, Line3, Ray3, Segment3)
PLUMB_PAIR_ANSWERS_TO(Cylinder3, relate_axis_round, Triangle3, Quadrilateral3, Polygon3, HoledPolygon3, Rectangle3,
                      Tetrahedron3, Aabb3, Obb3)
PLUMB_PAIR_ANSWERS_TO(Cone3, relate_axis_round, Triangle3, Quadrilateral3, Polygon3, HoledPolygon3, Rectangle3,
                      Tetrahedron3, Aabb3, Obb3)
PLUMB_PAIR_ANSWERS_OF(Sphere3, relate_ball_and_axis_round, Cylinder3, Cone3)
PLUMB_PAIR_ANSWERS_OF(Cylinder3, relate_axis_round_last, KDop3, HalfspaceIntersection3, ConvexPolyhedron3)
PLUMB_PAIR_ANSWERS_OF(Cone3, relate_axis_round_last, KDop3, HalfspaceIntersection3, ConvexPolyhedron3)

}  // namespace query
}  // namespace plumb
