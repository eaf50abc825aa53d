#include <CGAL/intersections.h>

#include "oracle/cgal_figures.hpp"
#include "oracle/meetings.hpp"

namespace plumb::oracle {
namespace {

/// Is it what CGAL asks for?  Lines of space divide by their direction.
template <class Shape>
bool is_proper(const Shape& s) {
  if constexpr (std::is_same_v<Shape, Point2> || std::is_same_v<Shape, Point3>) {
    return true;
  } else if constexpr (std::is_same_v<Shape, Line3>) {
    return s.direction != Vector3{0, 0, 0};
  } else if constexpr (std::is_same_v<Shape, Aabb2>) {
    return s.min.x < s.max.x && s.min.y < s.max.y;
  } else if constexpr (std::is_same_v<Shape, Aabb3>) {
    return s.min.x < s.max.x && s.min.y < s.max.y && s.min.z < s.max.z;
  } else {
    return !of(s).is_degenerate();
  }
}

template <class Shape>
inline constexpr bool is_ball = std::is_same_v<Shape, Circle2> || std::is_same_v<Shape, Sphere3>;

template <class Ball, class Point>
bool ball_holds(const Ball& ball, const Point& p) {
  return CGAL::squared_distance(of(ball.center), of(p)) <= Number(ball.radius) * Number(ball.radius);
}

/// Of a shape with corners.
template <class Shape>
auto some_point(const Shape& s) {
  if constexpr (requires { s.min; }) {
    return s.min;
  } else if constexpr (requires { s.a; }) {
    return s.a;
  } else if constexpr (requires { s.origin; }) {
    return s.origin;
  } else {
    return s;
  }
}

template <class Ball, class Other>
bool ball_meets(const Ball& ball, const Other& other) {
  if constexpr (is_ball<Other>) {
    if (ball_holds(ball, other.center) || ball_holds(other, ball.center)) return true;
  } else {
    if (CGAL::do_intersect(of(ball.center), of(other))) return true;
    if constexpr (
        requires { other.offset; } || requires { other.point; }) {  // goes out of the ball
    } else {
      if (ball_holds(ball, some_point(other))) return true;
    }
  }
  if constexpr (std::is_same_v<Other, Triangle2>) {  // CGAL 5.5 takes the wrong corner of some for the nearest
    const auto [a, b, c] = other;
    return ball_meets(ball, Segment2{a, b}) || ball_meets(ball, Segment2{b, c}) || ball_meets(ball, Segment2{c, a});
  } else {
    return CGAL::do_intersect(of(ball), of(other));
  }
}

/// CGAL 5.5's do_intersect is wrong where a line's first point lies beyond a ray, and where a line lies in the plane of
/// a box's face, along an axis of it; what it constructs is right.
template <class A, class B>
constexpr bool is_constructed() {
  constexpr auto straight = []<class S>(const S*) {
    return std::is_same_v<S, Line3> || std::is_same_v<S, Ray3> || std::is_same_v<S, Segment3>;
  };
  if constexpr (std::is_same_v<A, Line3> && std::is_same_v<B, Aabb3>) {
    return true;
  } else {
    return straight(static_cast<const A*>(nullptr)) && straight(static_cast<const B*>(nullptr));
  }
}

template <class Variant>
std::optional<bool> meet(const Variant& a, const Variant& b) {
  if (b.index() < a.index()) return meet(b, a);
  return std::visit(
      []<class A, class B>(const A& x, const B& y) -> std::optional<bool> {
        if constexpr (Variant(A{}).index() > Variant(B{}).index()) {
          return {};
        } else if (!is_proper(x) || !is_proper(y)) {
          return {};
        } else if constexpr (is_ball<A>) {
          return ball_meets(x, y);
        } else if constexpr (is_ball<B>) {
          return ball_meets(y, x);
        } else if constexpr (is_constructed<A, B>()) {
          return static_cast<bool>(CGAL::intersection(of(x), of(y)));
        } else {
          return CGAL::do_intersect(of(x), of(y));
        }
      },
      a, b);
}

}  // namespace

std::optional<bool> meet_by_cgal(const CgalFigure2& a, const CgalFigure2& b) { return meet(a, b); }
std::optional<bool> meet_by_cgal(const CgalFigure3& a, const CgalFigure3& b) { return meet(a, b); }

}  // namespace plumb::oracle
