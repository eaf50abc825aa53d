// What weights at the corners balance at a point?  Barycentric coordinates with respect to segments, triangles and
// tetrahedra: rounded once, exact on request, their signs exact; and the point of given weights.
//
// Laws: (1) the exact coordinates sum to one, and the corners weighted by them sum to the point (for a segment, and for
// a triangle in space, to its orthogonal projection onto the line or plane).  (2) Permuting corners permutes the
// coordinates.  (3) The point is in the closed triangle or tetrahedron exactly when no sign is negative (in space: its
// projection is).  (4) For points of the plane itself, areas and projection onto a coordinate plane give the same exact
// numbers, whichever axis is dropped; off the plane the projection answers for the point of the plane met along that
// axis.  Corners that span no line, plane or space have no such coordinates: InvalidShape (figure/containment/voronoi_region.hpp
// answers for them).  A number beyond the doubles throws BeyondDoubles, NaN and infinity NonFinite, by name.
// Source: RTCD 3.4 (figures 3.9, 3.10).
// Cost: a quotient of two determinants each, some 100 ns; a sign costs a filter.  Nothing is searched.
#pragma once

#include "plumb/arith/sign.hpp"
#include "plumb/certify/constructed.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/predicates/cross_products.hpp"
#include "plumb/predicates/distance.hpp"
#include "plumb/predicates/orient.hpp"

namespace plumb {

/// The coordinates of p, of corner a first: the nearest doubles.
std::array<double, 2> barycentric(const Segment2& segment, const Point2& p);
std::array<double, 2> barycentric(const Segment3& segment, const Point3& p);
std::array<double, 3> barycentric(const Triangle2& triangle, const Point2& p);
std::array<double, 3> barycentric(const Triangle3& triangle, const Point3& p);
std::array<double, 4> barycentric(const Tetrahedron3& tetrahedron, const Point3& p);

/// Of triangle and point without their coordinate number `axis` (0 for x): cheaper by half, and the same for points of
/// the plane.  InvalidShape where the triangle is seen as a line along that axis.
std::array<double, 3> barycentric_along_axis(const Triangle3& triangle, const Point3& p, std::size_t axis);

/// The same along the axis that sees the largest area, the first of those as large.
std::array<double, 3> barycentric_by_projection(const Triangle3& triangle, const Point3& p);

/// Their signs, exactly.
std::array<Sign, 2> barycentric_signs(const Segment2& segment, const Point2& p);
std::array<Sign, 2> barycentric_signs(const Segment3& segment, const Point3& p);
std::array<Sign, 3> barycentric_signs(const Triangle2& triangle, const Point2& p);
std::array<Sign, 3> barycentric_signs(const Triangle3& triangle, const Point3& p);
std::array<Sign, 4> barycentric_signs(const Tetrahedron3& tetrahedron, const Point3& p);

/// The lines of the edges cut the plane into seven regions: the triangle, three beyond one edge, three beyond two.
enum class BarycentricRegion : unsigned char {
  triangle,
  beyond_ab,
  beyond_bc,
  beyond_ca,
  beyond_a,
  beyond_b,
  beyond_c
};

/// A point on a line belongs to the side of the triangle, as a closed set has it: `triangle` where p is in it.
BarycentricRegion barycentric_region(const Triangle2& triangle, const Point2& p);
BarycentricRegion barycentric_region(const Triangle3& triangle, const Point3& p);

/// The center of gravity of these weights at the corners, rounded once: the weighted sum over the sum of the weights,
/// which need not be one.  DegeneratePoint where that is zero.
Point2 from_barycentric(const Segment2& segment, const std::array<double, 2>& weights);
Point3 from_barycentric(const Segment3& segment, const std::array<double, 2>& weights);
Point2 from_barycentric(const Triangle2& triangle, const std::array<double, 3>& weights);
Point3 from_barycentric(const Triangle3& triangle, const std::array<double, 3>& weights);
Point3 from_barycentric(const Tetrahedron3& tetrahedron, const std::array<double, 4>& weights);

/// What one coordinate is a quotient of: a part and a whole, of the corners in an even permutation that has the
/// coordinate's corner first, and the point.
namespace figure::barycentric_form {

template <class Point>
struct SegmentWhole;
template <>
struct SegmentWhole<Point2> {
  static constexpr std::string_view name = "barycentric";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return predicates::squared(predicates::difference2(p, 0, 1));
  }
};
template <>
struct SegmentWhole<Point3> {
  static constexpr std::string_view name = "barycentric";
  static constexpr int points = 3, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    return predicates::squared(predicates::difference(p, 0, 1));
  }
};
struct TrianglePart2 {
  static constexpr std::string_view name = "barycentric";
  static constexpr int points = 4, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    return predicates::cross(predicates::difference2(p, 3, 1), predicates::difference2(p, 3, 2));
  }
};
struct TriangleWhole2 {
  static constexpr std::string_view name = "barycentric";
  static constexpr int points = 4, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    return predicates::cross(predicates::difference2(p, 0, 1), predicates::difference2(p, 0, 2));
  }
};
struct TrianglePart3 {
  static constexpr std::string_view name = "barycentric";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    const auto edge = predicates::difference(p, 1, 2);
    return predicates::dot(predicates::cross(edge, predicates::difference(p, 1, 0)),
                           predicates::cross(edge, predicates::difference(p, 1, 3)));
  }
};
struct TriangleWhole3 {
  static constexpr std::string_view name = "barycentric";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    return predicates::squared(predicates::cross(predicates::difference(p, 0, 1), predicates::difference(p, 0, 2)));
  }
};
struct TetrahedronPart {
  static constexpr std::string_view name = "barycentric";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    return predicates::triple(predicates::difference(p, 4, 1), predicates::difference(p, 4, 2),
                              predicates::difference(p, 4, 3));
  }
};
struct TetrahedronWhole {
  static constexpr std::string_view name = "barycentric";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    return predicates::triple(predicates::difference(p, 0, 1), predicates::difference(p, 0, 2),
                              predicates::difference(p, 0, 3));
  }
};

template <class Point>
using SegmentPart =
    std::conditional_t<std::is_same_v<Point, Point2>, predicates::Angle2d, predicates::Angle3d>;  // (a - b) . (p - b)

/// Corner number `place` of the even permutation that has corner number `first` in front.
constexpr std::size_t permuted(std::size_t corners, std::size_t first, std::size_t place) {
  return corners == 3 ? (first + place) % 3 : place ^ first;
}

template <class Part, class Whole, std::size_t N, class Point, class Make>
constexpr auto exact(const std::array<Point, N>& corners, const Point& p, Make make) {
  constexpr auto dimension = static_cast<std::size_t>(coordinate_count<Point>);
  using Number = decltype(make(0.0));
  const auto numbers = [&]<std::size_t... I>(std::size_t first, std::index_sequence<I...>) {
    const auto number = [&](std::size_t i) {
      const std::size_t place = i / dimension;
      return make(coordinates(place == N ? p : corners[permuted(N, first, place)])[i % dimension]);
    };
    return std::array<Number, sizeof...(I)>{number(I)...};
  };
  constexpr auto all = std::make_index_sequence<(N + 1) * dimension>();
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Homogeneous<Number, N>{{Part{}(numbers(I, all))...}, Whole{}(numbers(0, all))};
  }
  (std::make_index_sequence<N>{});
}

}  // namespace figure::barycentric_form

/// The exact coordinates, coordinate[i] / weight, over the numbers that make(double) gives, which need + - * (see
/// `homogeneous` in certify/constructed.hpp).  The weight is zero where there are none.
template <class Make>
constexpr auto exact_barycentric(const Segment2& s, const Point2& p, Make make) {
  using namespace figure::barycentric_form;
  return exact<SegmentPart<Point2>, SegmentWhole<Point2>>(std::array{s.a, s.b}, p, make);
}
template <class Make>
constexpr auto exact_barycentric(const Segment3& s, const Point3& p, Make make) {
  using namespace figure::barycentric_form;
  return exact<SegmentPart<Point3>, SegmentWhole<Point3>>(std::array{s.a, s.b}, p, make);
}
template <class Make>
constexpr auto exact_barycentric(const Triangle2& t, const Point2& p, Make make) {
  using namespace figure::barycentric_form;
  return exact<TrianglePart2, TriangleWhole2>(std::array{t.a, t.b, t.c}, p, make);
}
template <class Make>
constexpr auto exact_barycentric(const Triangle3& t, const Point3& p, Make make) {
  using namespace figure::barycentric_form;
  return exact<TrianglePart3, TriangleWhole3>(std::array{t.a, t.b, t.c}, p, make);
}
template <class Make>
constexpr auto exact_barycentric(const Tetrahedron3& t, const Point3& p, Make make) {
  using namespace figure::barycentric_form;
  return exact<TetrahedronPart, TetrahedronWhole>(std::array{t.a, t.b, t.c, t.d}, p, make);
}

}  // namespace plumb
