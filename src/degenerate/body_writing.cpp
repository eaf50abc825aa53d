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
  void count(std::size_t n) { number(static_cast<Wide>(n), false); }
  void length(Int x) { number(Wide{placement_.scale} * x, true); }

  /// Where p is along the normal.
  void offset(const Int3& normal, const Int3& p) {
    Wide offset = 0;
    for (const std::size_t axis : axes_) offset += normal[axis] * at(p, axis);
    number(offset, true);
  }
  /// The plane through p.
  void plane(const Int3& normal, const Int3& p) {
    vector(normal);
    offset(normal, p);
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

/// Without a common factor.
Int3 reduced(const Int3& v) {
  const Int by = std::gcd(v[0], std::gcd(v[1], v[2]));
  return by == 0 ? v : Int3{v[0] / by, v[1] / by, v[2] / by};
}

/// Of the plane of the three points from p[first] on.
Int3 normal_of(const std::vector<Int3>& p, int dimension, std::size_t first = 0) {
  const Int3 u = reduced(p[first + 1] - p[first]), v = reduced(p[first + 2] - p[first]);
  // In the plane, where y is no axis, one of the two leads along the line.
  const Int3 y{0, 1, 0};
  return reduced(dimension == 2 ? cross(u[0] == 0 && u[2] == 0 ? v : u, y) : cross(u, v));
}
/// Away from the fourth.
Int3 outward_of(const std::vector<Int3>& p, int dimension, std::size_t first = 0) {
  const Int3 normal = normal_of(p, dimension, first);
  return dot(normal, p[first + 3] - p[first]) > 0 ? -1 * normal : normal;
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
      writer.plane(normal_of(p, dimension), p[0]);
      break;
    case ShapeKind::halfspace:
    case ShapeKind::halfspaces:
      for (std::size_t i = 0; i < p.size(); i += 4) writer.plane(outward_of(p, dimension, i), p[i]);
      break;
    case ShapeKind::slab: {
      const Int3 outward = outward_of(p, dimension);
      writer.plane(outward, p[3]);
      writer.offset(outward, p[0]);
      break;
    }
    case ShapeKind::k_dop:
      for (const std::size_t side : {0u, 1u}) {
        std::size_t i = side;
        for (const Int3& normal : k_dop_normals(dimension, IntMap{}.columns)) {
          writer.offset(normal, p[i]);
          i += 2;
        }
      }
      break;
    case ShapeKind::holed_polygon: {
      writer.count(body.parts.size());
      auto at = p.begin();
      for (const std::size_t size : body.parts) {
        writer.count(size);
        for (std::size_t i = 0; i < size; ++i) writer.point(*at++);
      }
      break;
    }
    case ShapeKind::mesh:
      writer.count(p.size());
      for (const Int3& each : p) writer.point(each);
      for (const std::size_t corner : body.parts) writer.count(corner);
      break;
    case ShapeKind::aabb: {
      Int3 half{};
      for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) half[axis] += std::abs(body.arm(i)[axis]);
      }
      writer.point(p[0] - half);
      writer.point(p[0] + half);
      break;
    }
    case ShapeKind::rectangle:
    case ShapeKind::obb:
    case ShapeKind::ellipsoid:
      writer.point(p[0]);
      for (std::size_t i = 1; i < p.size(); ++i) writer.vector(p[i] - p[0]);
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
