#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>

#include "degenerate/body.hpp"

namespace plumb::degenerate {

namespace {

__extension__ using Wide = __int128;

/// Numbers one after the other, as long as each is a double.
class Writer {
 public:
  Writer(int dimension, const Placement& placement) : placement_(placement) {
    axes_ = dimension == 2 ? std::vector<std::size_t>{0, 2} : std::vector<std::size_t>{0, 1, 2};
  }

  void point(const Int3& p) {
    for (const std::size_t axis : axes_) number(at(p, axis), true);
  }
  void scaled(const Int3& v) {
    for (const std::size_t axis : axes_) number(Wide{placement_.scale} * v[axis], true);
  }
  void vector(const Int3& v) {
    for (const std::size_t axis : axes_) number(v[axis], false);
  }
  void length(Int x) { number(Wide{placement_.scale} * x, true); }

  /// The plane through p.
  void plane(const Int3& normal, const Int3& p) {
    vector(normal);
    Wide offset = 0;
    for (const std::size_t axis : axes_) offset += normal[axis] * at(p, axis);
    number(offset, true);
  }

  std::optional<std::vector<double>> made() && {
    if (too_long_) return std::nullopt;
    return std::move(made_);
  }

 private:
  [[nodiscard]] Wide at(const Int3& p, std::size_t axis) const {
    return placement_.base[axis] + Wide{placement_.scale} * p[axis];
  }
  void number(Wide x, bool placed) {
    constexpr Wide most = Wide{1} << 53;
    if (x > most || x < -most) {
      too_long_ = true;
      x = 0;
    }
    const auto integer = static_cast<double>(static_cast<Int>(x));
    made_.push_back(placed ? std::ldexp(integer, placement_.exponent) : integer);
  }

  const Placement& placement_;
  std::vector<std::size_t> axes_;
  std::vector<double> made_;
  bool too_long_ = false;
};

Int3 divided(const Int3& v, Int by) { return by == 0 ? v : Int3{v[0] / by, v[1] / by, v[2] / by}; }

/// Without a common factor.
Int3 normal_of(const Body& body, int dimension) {
  const auto& p = body.points;
  const Int3 normal = cross(p[1] - p[0], dimension == 2 ? Int3{0, 1, 0} : p[2] - p[0]);
  return divided(normal, std::gcd(normal[0], std::gcd(normal[1], normal[2])));
}

}  // namespace

std::optional<std::vector<double>> written(const Body& body, int dimension, const Placement& placement) {
  Writer writer(dimension, placement);
  const auto& p = body.points;
  switch (body.kind) {
    case ShapeKind::line:
    case ShapeKind::ray:
      writer.point(p[0]);
      writer.scaled(p[1] - p[0]);
      break;
    case ShapeKind::plane:
      writer.plane(normal_of(body, dimension), p[0]);
      break;
    case ShapeKind::halfspace: {
      const Int3 normal = normal_of(body, dimension);
      writer.plane(dot(normal, p[3] - p[0]) > 0 ? -1 * normal : normal, p[0]);
      break;
    }
    case ShapeKind::aabb: {
      Int3 half{};
      for (std::size_t i = 1; i < p.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) half[axis] += std::abs(p[i][axis] - p[0][axis]);
      }
      writer.point(p[0] - half);
      writer.point(p[0] + half);
      break;
    }
    case ShapeKind::rectangle:
    case ShapeKind::obb:
      writer.point(p[0]);
      for (std::size_t i = 1; i < p.size(); ++i) writer.vector(divided(p[i] - p[0], body.half[i - 1]));
      for (const Int half : body.half) writer.length(half);
      break;
    case ShapeKind::lozenge:
      writer.point(p[0]);
      for (std::size_t i = 1; i < p.size(); ++i) writer.scaled(p[i] - p[0]);
      writer.length(body.radius);
      break;
    default:
      for (const Int3& each : p) writer.point(each);
      if (is_round(body.kind)) writer.length(body.radius);
  }
  return std::move(writer).made();
}

}  // namespace plumb::degenerate
