// The image of a ball: an ellipsoid, as far from its center as the matrix stretches the vector that it stretches most.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/pose_numbers.hpp"
#include "figure/sphere/ball_reach.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/sphere/sphere.hpp"

namespace plumb {
namespace figure::sphere {
namespace {

using predicates::argument, predicates::dot, predicates::squared;

// The matrix M stretches no vector by more than s when s^2 - M'M has no negative eigenvalue: when none of its principal
// minors is negative.  Its entries are s^2 or 0, less the products of columns.

struct Minor1 {
  static constexpr std::string_view name = "stretch";
  static constexpr std::array arguments{3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return squared(p[3]) - squared(argument(p, 0));
  }
};
struct Minor2 {
  static constexpr std::string_view name = "stretch";
  static constexpr std::array arguments{3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 7>& p) const {
    const auto u = argument(p, 0), v = argument(p, 1);
    const auto s = squared(p[6]);
    return (s - squared(u)) * (s - squared(v)) - squared(dot(u, v));
  }
};
struct Minor3 {
  static constexpr std::string_view name = "stretch";
  static constexpr std::array arguments{3, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    const auto u = argument(p, 0), v = argument(p, 1), w = argument(p, 2);
    const auto s = squared(p[9]);
    const auto a = s - squared(u), b = s - squared(v), c = s - squared(w);
    const auto uv = dot(u, v), vw = dot(v, w), wu = dot(w, u);
    const auto product = uv * vw * wu;
    return a * b * c - (product + product) - a * squared(vw) - b * squared(wu) - c * squared(uv);
  }
};

bool stretches_at_most(const std::array<Vector3, 3>& m, double s) {
  const auto one = [&](std::size_t i) { return sign_of(Minor1{}, m[i], s) != Sign::negative; };
  const auto two = [&](std::size_t i, std::size_t j) { return sign_of(Minor2{}, m[i], m[j], s) != Sign::negative; };
  return one(0) && one(1) && one(2) && two(0, 1) && two(1, 2) && two(2, 0) &&
         sign_of(Minor3{}, m[0], m[1], m[2], s) != Sign::negative;
}

/// In doubles, by the largest eigenvalue of M'M, with a scale that keeps its entries among the doubles.
double guess(const std::array<Vector3, 3>& m, double most) {
  const int exponent = std::ilogb(most);
  Eigen::Matrix3d a;
  for (int j = 0; j < 3; ++j) {
    const auto& [x, y, z] = m[static_cast<std::size_t>(j)];
    a.col(j) << std::ldexp(x, -exponent), std::ldexp(y, -exponent), std::ldexp(z, -exponent);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a.transpose() * a, Eigen::EigenvaluesOnly);
  return std::ldexp(std::sqrt(solver.eigenvalues()(2)), exponent);
}

double stretch(std::string_view function, const std::array<Vector3, 3>& m) {
  double most = 0;
  for (const auto& [x, y, z] : m) most = std::max({most, std::fabs(x), std::fabs(y), std::fabs(z)});
  if (most == 0) return 0;
  constexpr double largest = std::numeric_limits<double>::max();
  const double near = std::fmin(guess(m, most), largest);
  double s = std::nextafter(std::nextafter(near, 0.0), 0.0);
  // By ulps, and soon by more of them: a few dozen steps lead beyond twice of it, and beyond all doubles it throws.
  for (int k = 0; !stretches_at_most(m, s); ++k) {
    figure::within_doubles(s < largest ? s : HUGE_VAL, function, "the stretch");
    const double step = std::ldexp(std::nextafter(s, HUGE_VAL) - s, std::max(0, k - 6));
    s = std::fmin(s + step, largest);
  }
  return s;
}

std::array<Vector3, 3> columns_of(const Pose2& pose) {
  const auto& [u, v] = pose.columns;
  return {{{u.x, u.y, 0}, {v.x, v.y, 0}, {0, 0, 0}}};
}
std::array<Vector3, 3> columns_of(const Pose& pose) { return pose.columns; }

template <class View>
double stretch_of(std::string_view function, View pose) {
  return pose.visit([&](const auto& is) {
    if constexpr (requires { is.columns; }) {
      return stretch(function, columns_of(is));
    } else {
      return 1.0;  // no length changes
    }
  });
}

/// A coordinate of the image of the center, and how far from it the exact one may be.
struct ImageAxis {
  double value;
  Interval off;
};
template <class Center>
ImageAxis axis(const CertainPose& pose, const Center& center, std::size_t i) {
  const auto rounded = [&](Rounding rounding) {
    return pose.rounded(rounding, [&]<class T>(const PoseNumbers<T>& n) { return n.image(arith::vec<T>(center), i); });
  };
  const double down = rounded(Rounding::down), up = rounded(Rounding::up);
  if (down == up) return {up, Interval(0)};
  const double value = figure::within_doubles(rounded(Rounding::nearest), "transform", "center");
  constexpr double largest_ulp = 0x1p971;
  // Exact and nearest lie between neighbors, or beyond the last double by half of its ulp at the most.
  const Interval gap = up - down < HUGE_VAL ? Interval(up) - Interval(down) : Interval(largest_ulp);
  return {value, gap * Interval(0.5)};
}

double radius_of(double stretched, double radius, const Interval& off2) {
  const Interval grown = stretched == 1 ? Interval(radius + 0.0) : Interval(stretched) * Interval(radius);
  const double r = off2.upper == 0 ? grown.upper : (grown + root(off2)).upper;
  return figure::within_doubles(r, "transform", "radius");
}

}  // namespace
}  // namespace figure::sphere

double largest_stretch(PoseView2 pose) {
  figure::require_sound("largest_stretch", pose);
  return figure::sphere::stretch_of("largest_stretch", pose);
}
double largest_stretch(PoseView pose) {
  figure::require_sound("largest_stretch", pose);
  return figure::sphere::stretch_of("largest_stretch", pose);
}

Circle2 transform(const Circle2& circle, PoseView2 pose) {
  figure::sphere::require_ball("transform", "circle", circle);
  figure::require_sound("transform", pose);
  const figure::CertainPose moved(pose);
  const auto x = figure::sphere::axis(moved, circle.center, 0), y = figure::sphere::axis(moved, circle.center, 1);
  const double stretched = circle.radius == 0 ? 0 : figure::sphere::stretch_of("transform", pose);
  return {{x.value, y.value}, figure::sphere::radius_of(stretched, circle.radius, x.off * x.off + y.off * y.off)};
}

Sphere3 transform(const Sphere3& sphere, PoseView pose) {
  figure::sphere::require_ball("transform", "sphere", sphere);
  figure::require_sound("transform", pose);
  const figure::CertainPose moved(pose);
  const auto x = figure::sphere::axis(moved, sphere.center, 0), y = figure::sphere::axis(moved, sphere.center, 1),
             z = figure::sphere::axis(moved, sphere.center, 2);
  const double stretched = sphere.radius == 0 ? 0 : figure::sphere::stretch_of("transform", pose);
  return {{x.value, y.value, z.value},
          figure::sphere::radius_of(stretched, sphere.radius, x.off * x.off + y.off * y.off + z.off * z.off)};
}

}  // namespace plumb
