// Boxes and rectangles.  All are zonotopes: a center and the multiples of some axes up to a half extent each.  A point
// is beyond one where its way from the center reaches farther along a face's normal than all axes together do; the
// normals are zero vectors where the axes are dependent, and then the set is looked at in the flat that these span.  An
// axis taken zero times does no harm there: what it adds bounds the set as well.
#include "figure/containment/contains_input.hpp"
#include "figure/containment/generated_set.hpp"
#include "plumb/certify/coplanar.hpp"
#include "plumb/certify/detail/gap_filter.hpp"
#include "plumb/certify/determinant_sign.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/predicates/cross.hpp"
#include "plumb/predicates/distance.hpp"

namespace plumb {
namespace figure::containment {
namespace {

constexpr Sign farther(Sign s, Sign t) { return s > t ? s : t; }

// The coordinate `one` of these formulas is 1: it brings the terms to one degree, so that small integers may stand for
// the doubles.  The polynomials are the differences of reaches for absolute values that are resolved.

/// (center, p, a0, a1, a2, h0, h1, h2, one) on a line.
struct BeyondInterval {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{1, 1, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& x) const {
    return (x[1] - x[0]) * x[8] - (x[2] * x[5] + x[3] * x[6] + x[4] * x[7]);
  }
};

/// (center, p, edge, a, b, ha, hb, one) in the plane, across an edge.
struct BeyondEdge {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{2, 2, 2, 2, 2, 1, 1, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 13>& x) const {
    const auto across = [&](const auto& u, const auto& v) { return x[4] * v - x[5] * u; };
    return across(x[2] - x[0], x[3] - x[1]) * x[12] - (across(x[6], x[7]) * x[10] + across(x[8], x[9]) * x[11]);
  }
};

/// (center, p, u, v, w, h, one) in space, through the face spanned by u and v.
struct BeyondFace {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 1, 1};
  template <class T, class Size>
  static constexpr auto gap(const std::array<T, 17>& x, Size size) {
    using predicates::argument;
    const auto normal = predicates::cross(argument(x, 2), argument(x, 3));
    return size(predicates::dot(predicates::difference(x, 0, 1), normal)) * x[16] -
           size(predicates::dot(argument(x, 4), normal)) * x[15];
  }
  template <class T>
  constexpr auto operator()(const std::array<T, 17>& x) const {
    return gap(x, [](const auto& product) { return product; });
  }
};

Sign beyond_interval(double center, double p, const Numbers& axes, const Numbers& half) {
  if (p < center) std::swap(p, center);
  Numbers a{}, h{};
  for (std::size_t i = 0; i < 3; ++i) a[i] = magnitude_of(axes[i]), h[i] = magnitude_of(half[i]);
  return sign_of(BeyondInterval{}, center, p, a, h, 1.0);
}

/// For axes of which two are independent.  An axis that is zero spans no edge.
Sign beyond_zonogon(const Point2& center, const Point2& p, const Axes2& axes, const Numbers& half) {
  Sign all = Sign::negative;
  for (std::size_t i = 0; i < 3 && all != Sign::positive; ++i) {
    const Vector2& edge = axes[i];
    if (is_zero(edge)) continue;
    Vector2 a = axes[(i + 1) % 3], b = axes[(i + 2) % 3];
    if (cross_sign(edge, a) == Sign::negative) a = {-a.x, -a.y};
    if (cross_sign(edge, b) == Sign::negative) b = {-b.x, -b.y};
    const bool left = compare_along_direction(p, center, Vector2{-edge.y, edge.x}) != Sign::negative;
    all = farther(all, sign_of(BeyondEdge{}, left ? center : p, left ? p : center, edge, a, b,
                               magnitude_of(half[(i + 1) % 3]), magnitude_of(half[(i + 2) % 3]), 1.0));
  }
  return all;
}

/// Of a segment or point: axes that are parallel.
bool in_interval(const Point2& center, const Point2& p, const Axes2& axes, const Numbers& half) {
  const auto axis = any_of(axes);
  if (!axis) return p == center;
  if (!on_line(center, *axis, p)) return false;
  if (axis->x != 0) return beyond_interval(center.x, p.x, {axes[0].x, axes[1].x, axes[2].x}, half) != Sign::positive;
  return beyond_interval(center.y, p.y, {axes[0].y, axes[1].y, axes[2].y}, half) != Sign::positive;
}

Location locate_in_plane(const Point2& center, const Point2& p, const Axes2& axes, const Numbers& half) {
  if (independent(axes)) return location(beyond_zonogon(center, p, axes, half));
  return boundary_if(in_interval(center, p, axes, half));
}

/// Of axes that are dependent.
bool in_flat(const Point3& center, const Point3& p, const Axes3& axes, const Numbers& half) {
  const Numbers c = numbers(center), x = numbers(p);
  if (const auto span = independent(axes)) {
    if (!in_plane(center, *span, p)) return false;
    const std::size_t first = telling_coordinates(*span);
    Axes2 flat{};
    for (std::size_t i = 0; i < 3; ++i) flat[i] = kept<Vector2>(numbers(axes[i]), first);
    return beyond_zonogon(kept<Point2>(c, first), kept<Point2>(x, first), flat, half) != Sign::positive;
  }
  const auto axis = any_of(axes);
  if (!axis) return p == center;
  if (!on_line(center, *axis, p)) return false;
  const std::size_t k = telling_coordinate(numbers(*axis));
  return beyond_interval(c[k], x[k], {numbers(axes[0])[k], numbers(axes[1])[k], numbers(axes[2])[k]}, half) !=
         Sign::positive;
}

/// Exactly, for axes whose determinant has this sign, which is not zero.
Sign beyond_face(const Point3& center, const Point3& p, const Vector3& u, const Vector3& v, const Vector3& w,
                 double half, Sign determinant) {
  const bool ahead = sign_of(predicates::OrderAlongCross{}, u, v, center, p) != Sign::negative;
  return sign_of(BeyondFace{}, ahead ? center : p, ahead ? p : center, u, v, w,
                 determinant == Sign::negative ? -half : half, 1.0);
}

[[gnu::noinline]] Location locate_exactly(const Obb3& box, const Point3& p, const Numbers& half) {
  const auto& [u, v, w] = box.axes;
  const Sign determinant = determinant_sign(Rows<3>{numbers(u), numbers(v), numbers(w)});
  if (determinant == Sign::zero) {
    return boundary_if(in_flat(box.center, p, {u, v, w}, half));
  }
  return location(farther(beyond_face(box.center, p, u, v, w, half[2], determinant),
                          farther(beyond_face(box.center, p, v, w, u, half[0], determinant),
                                  beyond_face(box.center, p, w, u, v, half[1], determinant))));
}

/// p against the end of a box's side from a to a + b.  Rounding keeps order: only where p is the rounded end, the exact
/// sum is asked.
Sign compare_to_sum(double p, double a, double b) {
  const double end = a + b;
  if (p != end) return p > end ? Sign::positive : Sign::negative;
  return sign_of([](auto x, auto y, auto z) { return (x - y) - z; }, p, a, b);
}

/// From low + below to high + above.
Location along_axis(double p, double low, double below, double high, double above) {
  return both(location(-compare_to_sum(p, low, below)), location(compare_to_sum(p, high, above)));
}

}  // namespace

void throw_non_finite(const Aabb2& box, const Point2& p) {
  figure::require_sound("contains", box, part::place("p", p));
  throw std::logic_error("contains: every number of the box and the point is finite");
}
void throw_non_finite(const Aabb3& box, const Point3& p) {
  figure::require_sound("contains", box, part::place("p", p));
  throw std::logic_error("contains: every number of the box and the point is finite");
}

}  // namespace figure::containment

using namespace figure::containment;

Location locate(const AabbWidths3& box, const Point3& p) {
  figure::require_sound("contains", box, part::place("p", p));
  const auto along = [](double x, double min, double width) { return along_axis(x, min, 0, min, magnitude_of(width)); };
  return both(along(p.x, box.min.x, box.widths.x),
              both(along(p.y, box.min.y, box.widths.y), along(p.z, box.min.z, box.widths.z)));
}

Location locate(const AabbCenter3& box, const Point3& p) {
  figure::require_sound("contains", box, part::place("p", p));
  const auto along = [](double x, double center, double half) {
    return along_axis(x, center, -magnitude_of(half), center, magnitude_of(half));
  };
  return both(along(p.x, box.center.x, box.half.x),
              both(along(p.y, box.center.y, box.half.y), along(p.z, box.center.z, box.half.z)));
}

Location locate(const Obb2& box, const Point2& p) {
  figure::require_sound("contains", box, part::place("p", p));
  return locate_in_plane(box.center, p, {box.axes[0], box.axes[1], {0, 0}}, {box.half.x, box.half.y, 0});
}

Location locate(const Rectangle3& rectangle, const Point3& p) {
  const auto& [center, axes, half] = rectangle;
  figure::require_sound("contains", rectangle, part::place("p", p));
  return boundary_if(in_flat(center, p, {axes[0], axes[1], {0, 0, 0}}, {half.x, half.y, 0}));
}

Location locate(const Obb3& box, const Point3& p) {
  const auto& [u, v, w] = box.axes;
  figure::require_sound("contains", box, part::place("p", p));
  const Numbers half{magnitude_of(box.half.x), magnitude_of(box.half.y), magnitude_of(box.half.z)};
  // What is certain here needs no axes to be independent: a face whose normal is zero has a gap of zero.
  const auto face = [&](const Vector3& a, const Vector3& b, const Vector3& c, double h) {
    return gap_filter<BeyondFace>(coordinates_of<BeyondFace>(box.center, p, a, b, c, h, 1.0));
  };
  const int x = face(v, w, u, half[0]), y = face(w, u, v, half[1]), z = face(u, v, w, half[2]);
  if (x > 0 || y > 0 || z > 0) return Location::outside;
  if (x + y + z == -3) return Location::inside;
  return locate_exactly(box, p, half);
}

}  // namespace plumb
