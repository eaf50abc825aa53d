// Ellipsoids: images of the ball under a matrix M of columns g_i = half_i axes_i.  With w the way from the center,
// w . (M M^T)^-1 w <= 1; times the determinant of M M^T, by Cauchy and Binet, in space, in a plane and on a line,
//   sum of det(w, g_i, g_j)^2 <= det(g_0, g_1, g_2)^2,
//   sum of det(w, g_i)^2 <= sum of det(g_i, g_j)^2,
//   w^2 <= sum of g_i^2,
// each for columns that span what it is asked in.
#include "figure/containment/contains_input.hpp"
#include "figure/containment/generated_set.hpp"
#include "plumb/certify/determinant_sign.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/predicates/cross.hpp"

namespace plumb {
namespace figure::containment {
namespace {

/// (center, p, a0, a1, a2, half).
struct BeyondEllipsoid {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& x) const {
    using namespace predicates;
    const auto w = difference(x, 0, 1);
    const auto a = scaled(argument(x, 2), x[15]), b = scaled(argument(x, 3), x[16]), c = scaled(argument(x, 4), x[17]);
    const auto ab = cross(a, b);
    const auto square = [](const auto& t) { return t * t; };
    return square(dot(w, ab)) + square(triple(w, b, c)) + square(triple(w, c, a)) - square(dot(c, ab));
  }
};

/// (center, p, a0, a1, a2, half) in the plane.
struct BeyondEllipse {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{2, 2, 2, 2, 2, 3};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 13>& x) const {
    const auto wx = x[2] - x[0], wy = x[3] - x[1];
    const auto ax = x[4] * x[10], ay = x[5] * x[10], bx = x[6] * x[11], by = x[7] * x[11];
    const auto cx = x[8] * x[12], cy = x[9] * x[12];
    const auto square = [](const auto& px, const auto& py, const auto& qx, const auto& qy) {
      const auto area = px * qy - py * qx;
      return area * area;
    };
    return (square(wx, wy, ax, ay) + square(wx, wy, bx, by) + square(wx, wy, cx, cy)) -
           (square(ax, ay, bx, by) + square(bx, by, cx, cy) + square(cx, cy, ax, ay));
  }
};

/// (center, p, a0 a1 a2, half) on a line.
struct BeyondReach {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{1, 1, 3, 3};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& x) const {
    const auto w = x[1] - x[0];
    const auto a = x[2] * x[5], b = x[3] * x[6], c = x[4] * x[7];
    return w * w - (a * a + b * b + c * c);
  }
};

/// Zero where it is taken zero times.
constexpr Vector3 taken(const Vector3& axis, double times) { return times == 0 ? Vector3{0, 0, 0} : axis; }

/// For axes that do not span space, none of them taken zero times.
bool in_flat_ellipsoid(const Point3& center, const Point3& p, const Axes3& axes, const Numbers& half) {
  const Numbers c = numbers(center), x = numbers(p);
  if (const auto span = independent(axes)) {
    if (!in_plane(center, *span, p)) return false;
    const std::size_t first = telling_coordinates(*span);
    const auto flat = [&](std::size_t i) { return kept<Vector2>(numbers(axes[i]), first); };
    return sign_of(BeyondEllipse{}, kept<Point2>(c, first), kept<Point2>(x, first), flat(0), flat(1), flat(2), half) !=
           Sign::positive;
  }
  const auto axis = any_of(axes);
  if (!axis) return p == center;
  if (!on_line(center, *axis, p)) return false;
  const std::size_t k = telling_coordinate(numbers(*axis));
  const Numbers along{numbers(axes[0])[k], numbers(axes[1])[k], numbers(axes[2])[k]};
  return sign_of(BeyondReach{}, c[k], x[k], along, half) != Sign::positive;
}

}  // namespace
}  // namespace figure::containment

using namespace figure::containment;

Location locate(const Ellipsoid3& ellipsoid, const Point3& p) {
  const auto& [center, axes, half] = ellipsoid;
  figure::require_sound("contains", ellipsoid, part::place("p", p));
  // A sign that is not zero needs no columns to be independent: dependent ones leave a sum of squares less zero, which
  // is positive for points off their plane.
  const Sign s = sign_of(BeyondEllipsoid{}, center, p, axes[0], axes[1], axes[2], half);
  if (s != Sign::zero) return location(s);
  const bool flat = half.x == 0 || half.y == 0 || half.z == 0 ||
                    determinant_sign(Rows<3>{numbers(axes[0]), numbers(axes[1]), numbers(axes[2])}) == Sign::zero;
  if (!flat) return Location::boundary;
  return boundary_if(in_flat_ellipsoid(
      center, p, {taken(axes[0], half.x), taken(axes[1], half.y), taken(axes[2], half.z)}, numbers(half)));
}

}  // namespace plumb
