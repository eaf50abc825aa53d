// Quotients of areas and volumes: one formula a shape, asked of the corners in turn.
#include "plumb/figure/basic/barycentric.hpp"

#include <cmath>

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

using namespace figure::barycentric_form;

[[noreturn]] void throw_flat(std::string_view function, std::string_view shape, std::string_view wanted) {
  throw InvalidShape(std::string(function)
                         .append(": ")
                         .append(shape)
                         .append(", so that no coordinates are the point's alone; give ")
                         .append(wanted));
}
[[noreturn]] void throw_flat_segment(std::string_view function) {
  throw_flat(function, "the ends of the segment are equal", "two points");
}
[[noreturn]] void throw_flat_triangle(std::string_view function) {
  throw_flat(function, "the corners of the triangle lie on one line", "three that do not");
}
[[noreturn]] void throw_flat_tetrahedron(std::string_view function) {
  throw_flat(function, "the corners of the tetrahedron lie in one plane", "four that do not");
}

constexpr std::array<std::string_view, 3> segment_parts{"segment.a", "segment.b", "p"};
constexpr std::array<std::string_view, 4> triangle_parts{"triangle.a", "triangle.b", "triangle.c", "p"};
constexpr std::array<std::string_view, 5> tetrahedron_parts{"tetrahedron.a", "tetrahedron.b", "tetrahedron.c",
                                                            "tetrahedron.d", "p"};

void look_at(std::string_view function, const Segment2& s, const Point2& p) {
  require_finite_parts(function, segment_parts, s.a, s.b, p);
  if (s.a == s.b) throw_flat_segment(function);
}
void look_at(std::string_view function, const Segment3& s, const Point3& p) {
  require_finite_parts(function, segment_parts, s.a, s.b, p);
  if (s.a == s.b) throw_flat_segment(function);
}
/// The sign of the area: of the sense in which the corners turn.
Sign look_at(std::string_view function, const Triangle2& t, const Point2& p) {
  require_finite_parts(function, triangle_parts, t.a, t.b, t.c, p);
  const Sign s = orient2d(t.a, t.b, t.c);
  if (s == Sign::zero) throw_flat_triangle(function);
  return s;
}
void look_at(std::string_view function, const Triangle3& t, const Point3& p) {
  require_finite_parts(function, triangle_parts, t.a, t.b, t.c, p);
  if (collinear(t.a, t.b, t.c)) throw_flat_triangle(function);
}
Sign look_at(std::string_view function, const Tetrahedron3& t, const Point3& p) {
  require_finite_parts(function, tetrahedron_parts, t.a, t.b, t.c, t.d, p);
  const Sign s = orient3d(t.a, t.b, t.c, t.d);
  if (s == Sign::zero) throw_flat_tetrahedron(function);
  return s;
}

double finite(double x, std::string_view function, std::string_view what, std::size_t i) {
  if (!std::isinf(x)) return x;
  std::string text(function);
  throw BeyondDoubles(text.append(": ").append(what).append(1, "abcdxyz"[i]).append(" is beyond the largest double"));
}

template <class Part, class Whole, std::size_t N, class Point>
std::array<double, N> quotients(const std::array<Point, N>& corner, const Point& p) {
  std::array<double, N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    result[i] = [&]<std::size_t... I>(std::index_sequence<I...>) {
      return rounded_quotient(Rounding::nearest, Part{}, Whole{}, corner[permuted(N, i, I)]..., p);
    }
    (std::make_index_sequence<N>{});
    finite(result[i], "barycentric", "the coordinate of corner ", i);
  }
  return result;
}

BarycentricRegion region_of(const std::array<Sign, 3>& s) {
  const bool a = s[0] == Sign::negative, b = s[1] == Sign::negative, c = s[2] == Sign::negative;
  if (a) return b ? BarycentricRegion::beyond_c : c ? BarycentricRegion::beyond_b : BarycentricRegion::beyond_bc;
  if (b) return c ? BarycentricRegion::beyond_a : BarycentricRegion::beyond_ca;
  return c ? BarycentricRegion::beyond_ab : BarycentricRegion::triangle;
}

/// One coordinate of the center of gravity: weights, then the corners' coordinates.
template <std::size_t N>
struct WeightedSum {
  static constexpr std::string_view name = "from_barycentric";
  static constexpr std::array arguments{static_cast<int>(N), static_cast<int>(N)};
  template <class T>
  constexpr auto operator()(const std::array<T, 2 * N>& p) const {
    if constexpr (N == 2) {
      return p[0] * p[2] + p[1] * p[3];
    } else if constexpr (N == 3) {
      return p[0] * p[3] + p[1] * p[4] + p[2] * p[5];
    } else {
      return p[0] * p[4] + p[1] * p[5] + p[2] * p[6] + p[3] * p[7];
    }
  }
};
/// Of the weights alone, or of weights beside what they weigh.
template <std::size_t N, std::size_t Arguments>
struct WeightSum {
  static constexpr std::string_view name = "from_barycentric";
  static constexpr auto arguments = [] {
    std::array<int, Arguments> counts{};
    counts.fill(static_cast<int>(N));
    return counts;
  }();
  template <class T>
  constexpr auto operator()(const std::array<T, Arguments * N>& p) const {
    if constexpr (N == 2) {
      return p[0] + p[1];
    } else if constexpr (N == 3) {
      return p[0] + p[1] + p[2];
    } else {
      return p[0] + p[1] + p[2] + p[3];
    }
  }
};

template <std::size_t N, class Point>
auto center_of_gravity(const std::array<std::string_view, N + 1>& parts, const std::array<Point, N>& corner,
                       const std::array<double, N>& weights) {
  constexpr auto dimension = static_cast<std::size_t>(coordinate_count<Point>);
  static constexpr std::array<std::string_view, 4> weight_names{"weights[0]", "weights[1]", "weights[2]", "weights[3]"};
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    require_finite_parts("from_barycentric", std::array{parts[I]..., weight_names[I]...}, corner[I]..., weights[I]...);
  }
  (std::make_index_sequence<N>{});
  if (sign_of(WeightSum<N, 1>{}, weights) == Sign::zero)
    throw DegeneratePoint("from_barycentric: the weights sum to zero, and have no center of gravity; give others");
  std::array<double, dimension> result{};
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    std::array<double, N> along{};
    for (std::size_t i = 0; i < N; ++i) along[i] = coordinates(corner[i])[axis];
    const double x = rounded_quotient(Rounding::nearest, WeightedSum<N>{}, WeightSum<N, 2>{}, weights, along);
    result[axis] = finite(x, "from_barycentric", "the point's ", 4 + axis);
  }
  return result;
}

Point2 point2(const std::array<double, 2>& x) { return {x[0], x[1]}; }
Point3 point3(const std::array<double, 3>& x) { return {x[0], x[1], x[2]}; }

Point2 without(const Point3& p, std::size_t axis) {
  return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
}
Triangle2 without(const Triangle3& t, std::size_t axis) {
  return {without(t.a, axis), without(t.b, axis), without(t.c, axis)};
}

}  // namespace

std::array<double, 2> barycentric(const Segment2& s, const Point2& p) {
  look_at("barycentric", s, p);
  return quotients<SegmentPart<Point2>, SegmentWhole<Point2>>(std::array{s.a, s.b}, p);
}
std::array<double, 2> barycentric(const Segment3& s, const Point3& p) {
  look_at("barycentric", s, p);
  return quotients<SegmentPart<Point3>, SegmentWhole<Point3>>(std::array{s.a, s.b}, p);
}
std::array<double, 3> barycentric(const Triangle2& t, const Point2& p) {
  look_at("barycentric", t, p);
  return quotients<TrianglePart2, TriangleWhole2>(std::array{t.a, t.b, t.c}, p);
}
std::array<double, 3> barycentric(const Triangle3& t, const Point3& p) {
  look_at("barycentric", t, p);
  return quotients<TrianglePart3, TriangleWhole3>(std::array{t.a, t.b, t.c}, p);
}
std::array<double, 4> barycentric(const Tetrahedron3& t, const Point3& p) {
  look_at("barycentric", t, p);
  return quotients<TetrahedronPart, TetrahedronWhole>(std::array{t.a, t.b, t.c, t.d}, p);
}

std::array<double, 3> barycentric_along_axis(const Triangle3& t, const Point3& p, std::size_t axis) {
  if (axis > 2) throw InvalidShape("barycentric_along_axis: there is no such axis; give 0, 1 or 2 for x, y or z");
  require_finite_parts("barycentric_along_axis", triangle_parts, t.a, t.b, t.c, p);
  const Triangle2 flat = without(t, axis);
  if (orient2d(flat.a, flat.b, flat.c) == Sign::zero) {
    throw InvalidShape(std::string("barycentric_along_axis: along ")
                           .append(1, "xyz"[axis])
                           .append(" the triangle is seen as a line; take another axis"));
  }
  return barycentric(flat, without(p, axis));
}

std::array<double, 3> barycentric_by_projection(const Triangle3& t, const Point3& p) {
  require_finite_parts("barycentric_by_projection", triangle_parts, t.a, t.b, t.c, p);
  std::optional<std::size_t> best;
  double largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Triangle2 flat = without(t, axis);
    if (orient2d(flat.a, flat.b, flat.c) == Sign::zero) continue;
    const double area = std::fabs(rounded_value(Rounding::nearest, predicates::Orient2d{}, flat.a, flat.b, flat.c));
    if (best && !(area > largest)) continue;
    largest = area;
    best = axis;
  }
  if (!best) throw_flat_triangle("barycentric_by_projection");
  return barycentric(without(t, *best), without(p, *best));
}

std::array<Sign, 2> barycentric_signs(const Segment2& s, const Point2& p) {
  look_at("barycentric_signs", s, p);
  return {angle_sign(s.a, s.b, p), angle_sign(s.b, s.a, p)};
}
std::array<Sign, 2> barycentric_signs(const Segment3& s, const Point3& p) {
  look_at("barycentric_signs", s, p);
  return {angle_sign(s.a, s.b, p), angle_sign(s.b, s.a, p)};
}
std::array<Sign, 3> barycentric_signs(const Triangle2& t, const Point2& p) {
  const Sign turn = look_at("barycentric_signs", t, p);
  return {turn * orient2d(p, t.b, t.c), turn * orient2d(t.a, p, t.c), turn * orient2d(t.a, t.b, p)};
}
std::array<Sign, 3> barycentric_signs(const Triangle3& t, const Point3& p) {
  look_at("barycentric_signs", t, p);
  return {coplanar_orientation(t.b, t.c, t.a, p), coplanar_orientation(t.c, t.a, t.b, p),
          coplanar_orientation(t.a, t.b, t.c, p)};
}
std::array<Sign, 4> barycentric_signs(const Tetrahedron3& t, const Point3& p) {
  const Sign side = look_at("barycentric_signs", t, p);
  return {side * orient3d(p, t.b, t.c, t.d), side * orient3d(t.a, p, t.c, t.d), side * orient3d(t.a, t.b, p, t.d),
          side * orient3d(t.a, t.b, t.c, p)};
}

BarycentricRegion barycentric_region(const Triangle2& triangle, const Point2& p) {
  return region_of(barycentric_signs(triangle, p));
}
BarycentricRegion barycentric_region(const Triangle3& triangle, const Point3& p) {
  return region_of(barycentric_signs(triangle, p));
}

Point2 from_barycentric(const Segment2& s, const std::array<double, 2>& weights) {
  return point2(center_of_gravity(segment_parts, std::array{s.a, s.b}, weights));
}
Point3 from_barycentric(const Segment3& s, const std::array<double, 2>& weights) {
  return point3(center_of_gravity(segment_parts, std::array{s.a, s.b}, weights));
}
Point2 from_barycentric(const Triangle2& t, const std::array<double, 3>& weights) {
  return point2(center_of_gravity(triangle_parts, std::array{t.a, t.b, t.c}, weights));
}
Point3 from_barycentric(const Triangle3& t, const std::array<double, 3>& weights) {
  return point3(center_of_gravity(triangle_parts, std::array{t.a, t.b, t.c}, weights));
}
Point3 from_barycentric(const Tetrahedron3& t, const std::array<double, 4>& weights) {
  return point3(center_of_gravity(tetrahedron_parts, std::array{t.a, t.b, t.c, t.d}, weights));
}

}  // namespace plumb
