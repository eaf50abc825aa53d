// Are these round shapes, and what they are asked about, shapes at all?  Real numbers, and radii that are not negative.
//
// Laws: NonFinite for a number that is none, by its part ("relate: a.center.y is nan, ..."), InvalidShape for a radius
// below zero.
// Cost: one subtraction for each number.
#pragma once

#include <bit>
#include <string>

#include "figure/finite_parts.hpp"
#include "figure/k_dop_sets.hpp"
#include "plumb/figure/box.hpp"
#include "plumb/figure/convex_polyhedron.hpp"
#include "plumb/figure/linear.hpp"
#include "plumb/figure/round.hpp"
#include "plumb/figure/simplex.hpp"

namespace plumb::query {

template <class Shape>
concept IsRound = requires(const Shape& s) {
  s.radius;
};

/// Zero, where the numbers add up to a double; NaN where one of them is no real number.  In a tree, without waiting.
template <std::size_t From, std::size_t Count, std::size_t N>
constexpr double tree_sum(const std::array<double, N>& x) {
  if constexpr (Count == 1) {
    return x[From];
  } else {
    return tree_sum<From, Count / 2>(x) + tree_sum<From + Count / 2, Count - Count / 2>(x);
  }
}
constexpr double sum_of(const Point3& p) { return p.x + (p.y + p.z); }
constexpr double sum_of(const Vector3& v) { return v.x + (v.y + v.z); }
template <class Shape>
double unreal(const Shape& s) {
  // Those that are asked most, without a copy.
  if constexpr (std::is_same_v<Shape, Segment3>) {
    const double sum = sum_of(s.a) + sum_of(s.b);
    return sum - sum;
  } else if constexpr (std::is_same_v<Shape, Ray3>) {
    const double sum = sum_of(s.origin) + sum_of(s.direction);
    return sum - sum;
  } else if constexpr (std::is_same_v<Shape, Triangle3>) {
    const double sum = (sum_of(s.a) + sum_of(s.b)) + sum_of(s.c);
    return sum - sum;
  } else if constexpr (std::is_same_v<Shape, Aabb3>) {
    const double sum = sum_of(s.min) + sum_of(s.max);
    return sum - sum;
  } else if constexpr (std::is_same_v<Shape, Obb3>) {
    const double sum =
        (sum_of(s.center) + sum_of(s.half)) + (sum_of(s.axes[0]) + (sum_of(s.axes[1]) + sum_of(s.axes[2])));
    return sum - sum;
  } else if constexpr (std::is_same_v<Shape, Sphere3>) {
    const double sum = sum_of(s.center) + s.radius;
    return sum - sum;
  } else if constexpr (std::is_same_v<Shape, Capsule3> || std::is_same_v<Shape, Cylinder3>) {
    const double sum = (sum_of(s.a) + sum_of(s.b)) + s.radius;
    return sum - sum;
  } else if constexpr (std::is_trivially_copyable_v<Shape>) {
    constexpr std::size_t n = sizeof(Shape) / sizeof(double);
    const double sum = tree_sum<0, n>(std::bit_cast<std::array<double, n>>(s));
    return sum - sum;
  } else if constexpr (requires { s.mesh; }) {
    double sum = 0;
    for (const Point3& p : s.mesh.vertices) sum += sum_of(p);
    return sum - sum;  // overflow only costs the quick test
  } else {
    return 0;  // lists are looked at by who asks
  }
}

/// May the shape go to the quick tests?  Real numbers, and a radius that is not negative.
template <class Shape>
bool is_sound(const Shape& s) {
  if constexpr (IsRound<Shape>) {
    return unreal(s) == 0 && s.radius >= 0;
  } else {
    return unreal(s) == 0;
  }
}

class Input {
 public:
  Input(std::string_view function, std::string_view which) : function_(function), which_(which) {}

  template <class Shape>
  void require(const Shape& s) const {
    if constexpr (requires { s.halfspaces; }) {
      for (std::size_t i = 0; i < s.halfspaces.size(); ++i) {
        const std::string h = std::string(".halfspaces[").append(std::to_string(i)).append("]");
        real(h + ".normal", s.halfspaces[i].normal), real(h + ".offset", s.halfspaces[i].offset);
      }
    } else if constexpr (requires { s.directions; }) {
      figure::check(function_, which_, s);
    } else if constexpr (requires { s.mesh; }) {
      require_finite_points<Point3>(function_, std::string(which_).append(".mesh.vertices"), s.mesh.vertices);
    } else if constexpr (requires { s.point; }) {
      real(".point", s.point), real(".direction", s.direction);
    } else if constexpr (requires { s.origin; }) {
      real(".origin", s.origin), real(".direction", s.direction);
    } else if constexpr (requires { s.normal; }) {
      real(".normal", s.normal), real(".offset", s.offset);
    } else if constexpr (requires { s.axes; }) {
      real(".center", s.center), real(".axes[0]", s.axes[0]), real(".axes[1]", s.axes[1]);
      if constexpr (std::tuple_size_v<decltype(s.axes)> == 3) real(".axes[2]", s.axes[2]);
      real(".half", s.half);
    } else if constexpr (requires { s.center; }) {
      real(".center", s.center);
    } else if constexpr (requires { s.min; }) {
      real(".min", s.min), real(".max", s.max);
    } else if constexpr (requires { s.corner; }) {
      real(".corner", s.corner), real(".edges[0]", s.edges[0]), real(".edges[1]", s.edges[1]);
    } else if constexpr (requires { s.apex; }) {
      real(".apex", s.apex), real(".base", s.base);
    } else if constexpr (requires { coordinates(s); }) {
      real("", s);
    } else {
      real(".a", s.a), real(".b", s.b);
      if constexpr (requires { s.c; }) real(".c", s.c);
      if constexpr (requires { s.d; }) real(".d", s.d);
    }
    if constexpr (IsRound<Shape>) {
      real(".radius", s.radius);
      if (s.radius < 0) {
        throw InvalidShape(
            std::string(function_).append(": ").append(which_).append(".radius is negative; give zero or more"));
      }
    }
  }

 private:
  template <class Part>
  void real(std::string_view part, const Part& numbers) const {
    const std::string name = std::string(which_).append(part);
    require_finite_parts(function_, std::array<std::string_view, 1>{name}, numbers);
  }

  std::string_view function_, which_;
};

template <class A, class B>
void require_shapes_of(std::string_view function, const A& a, const B& b) {
  Input(function, "a").require(a);
  Input(function, "b").require(b);
}

}  // namespace plumb::query
