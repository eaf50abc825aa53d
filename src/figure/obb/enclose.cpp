#include "figure/obb/enclose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "arith/big_rounding.hpp"
#include "arith/running_error.hpp"
#include "arith/vec.hpp"
#include "figure/basic/frame.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/filtered.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/certify/determinant_sign.hpp"

namespace plumb::figure::enclosing {
namespace {

using arith::cross, arith::dot, arith::Plain, arith::vec, arith::Vec;

// What the faces through one axis are measured with.
template <class N>
struct Measure {
  Vec<N> normal;
  N volume;

  Measure(const std::array<Vector3, 3>& axes, std::size_t i)
      : normal(cross(vec<N>(axes[(i + 1) % 3]), vec<N>(axes[(i + 2) % 3]))),
        volume(magnitude(dot(normal, vec<N>(axes[i])))) {}
};

std::optional<double> quotient_up(const Ball& n, const Ball& d) { return quotient(n, d).rounded(Rounding::up); }
std::optional<double> quotient_up(const BigDyadic& n, const BigDyadic& d) {
  return rounded_quotient(Rounding::up, n, d);
}

template <class N>
std::optional<double> reach(const Measure<N>& m, const Point3& center, const Point3& p) {
  return quotient_up(magnitude(dot(m.normal, vec<N>(p) - vec<N>(center))), m.volume);
}

template <class N>
std::optional<double> reach(const Measure<N>& m, const Point3& center, const Body& body) {
  // What is measured of an image is measured times its weight.
  const PoseNumbers<N>* pose = body.pose == nullptr ? nullptr : &body.pose->in<N>();
  const Vec<N> place = vec<N>(body.box.center);
  N sum = magnitude(
      dot(m.normal, pose == nullptr ? place - vec<N>(center) : pose->image(place) - vec<N>(center) * pose->weight));
  const std::array half{body.box.half.x, body.box.half.y, body.box.half.z};
  for (std::size_t j = 0; j < 3; ++j) {
    Vec<N> axis = vec<N>(body.box.axes[j]);
    if (pose != nullptr) axis = pose->turned(axis);
    sum = sum + magnitude(N(half[j]) * dot(m.normal, axis));
  }
  return quotient_up(sum, pose == nullptr ? m.volume : m.volume * pose->weight);
}

// The largest reach of all of them, by pairs of doubles where these suffice.
class Farthest {
 public:
  Farthest(const std::array<Vector3, 3>& axes, const Point3& center, std::size_t i)
      : axes_(axes), center_(center), i_(i), measure_(axes, i) {}

  template <class What>
  void add(const What& what) {
    std::optional<double> far = reach(measure_, center_, what);
    if (!far) {
      if (!exact_) exact_.emplace(axes_, i_);
      far = reach(*exact_, center_, what);
    }
    reach_ = std::max(reach_, *far);
  }
  [[nodiscard]] double operator()() const { return reach_; }

 private:
  const std::array<Vector3, 3>& axes_;
  const Point3& center_;
  std::size_t i_;
  Measure<Ball> measure_;
  std::optional<Measure<BigDyadic>> exact_;
  double reach_ = 0;
};

// |(u x v) . (p - c)| in doubles.
struct Rough {
  Plain normal;
  const Point3& center;

  double operator()(const Point3& p) const { return magnitude_of(dot(normal, vec<double>(p) - vec<double>(center))); }

  // By how much it can be off where no coordinate of u, of v or of p - c is larger: the same sums, at these values.
  static double error(double u, double v, double apart) {
    const Running product = Running(u) * Running(v), normal = product + product;
    const Running along = normal * (Running(apart) + Running(0.0));
    return (along + along + along).bound();
  }
};

}  // namespace

bool independent(const std::array<Vector3, 3>& axes) {
  const auto row = [](const Vector3& v) { return std::array{v.x, v.y, v.z}; };
  return determinant_sign(Rows<3>{row(axes[0]), row(axes[1]), row(axes[2])}) != Sign::zero;
}

Vector3 half(const std::array<Vector3, 3>& axes, const Point3& center, std::span<const Point3> points) {
  double apart = 0;
  for (const Point3& p : points) {
    apart = std::max({apart, magnitude_of(p.x - center.x), magnitude_of(p.y - center.y), magnitude_of(p.z - center.z)});
  }
  std::array<double, 3> reach{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 &u = axes[(i + 1) % 3], &v = axes[(i + 2) % 3];
    const Rough rough{cross(vec<double>(u), vec<double>(v)), center};
    const double error = Rough::error(figure::frame::largest(u), figure::frame::largest(v), apart);
    double most = 0;
    for (const Point3& p : points) most = std::max(most, rough(p));
    const double enough = Interval::sum_down(Interval::sum_down(most, -error), -error);
    Farthest farthest(axes, center, i);
    for (const Point3& p : points) {
      if (!(rough(p) < enough)) farthest.add(p);  // all of them where doubles overflow
    }
    reach[i] = farthest();
  }
  return {reach[0], reach[1], reach[2]};
}

Vector3 half(const std::array<Vector3, 3>& axes, const Point3& center, std::span<const Body> bodies) {
  std::array<double, 3> reach{};
  for (std::size_t i = 0; i < 3; ++i) {
    Farthest farthest(axes, center, i);
    for (const Body& b : bodies) farthest.add(b);
    reach[i] = farthest();
  }
  return {reach[0], reach[1], reach[2]};
}

Point3 center(const std::array<Vector3, 3>& axes, std::span<const Point3> points) {
  const auto middle = [&](double Point3::*x) {
    const auto [least, most] = std::ranges::minmax(points, {}, x);
    const double sum = least.*x + most.*x;
    return std::fabs(sum) < std::numeric_limits<double>::infinity() ? sum / 2 : least.*x / 2 + most.*x / 2;
  };
  const Point3 start{middle(&Point3::x), middle(&Point3::y), middle(&Point3::z)};
  const auto is_of_space = [](const Vector3& v) { return (v.x != 0) + (v.y != 0) + (v.z != 0) == 1; };
  if (std::ranges::all_of(axes, is_of_space)) return start;  // no double is nearer to the middle
  Vector3 by{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 normal = figure::frame::cross(axes[(i + 1) % 3], axes[(i + 2) % 3]);
    const double volume = figure::frame::dot(normal, axes[i]);
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Point3& p : points) {
      const double far = figure::frame::dot(normal, {p.x - start.x, p.y - start.y, p.z - start.z});
      least = std::min(least, far);
      most = std::max(most, far);
    }
    by = figure::frame::plus(by, figure::frame::times(axes[i], (least + most) / 2 / volume));
  }
  const Point3 moved{start.x + by.x, start.y + by.y, start.z + by.z};
  const double finite = (moved.x - moved.x) + (moved.y - moved.y) + (moved.z - moved.z);
  return finite == 0 ? moved : start;
}

}  // namespace plumb::figure::enclosing
