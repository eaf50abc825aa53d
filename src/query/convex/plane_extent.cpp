#include "query/convex/plane_extent.hpp"

#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/certify/direction.hpp"
#include "query/body/axis_body.hpp"
#include "query/convex/bounding_side.hpp"

namespace plumb::query {
namespace {

using namespace axes;

/// Signs of the least and the greatest value; a side on which the figure goes on counts as one that it reaches.
struct Extent {
  Sign least = Sign::positive, greatest = Sign::negative;

  void add(Sign s) {
    least = std::min(least, s);
    greatest = std::max(greatest, s);
  }
};

template <class T>
std::optional<Extent> extent_of(const AxisBody<T>& body, const arith::Vec<T>& normal, const T& offset) {
  Extent extent;
  CertainSigns ask;
  for (std::size_t i = 0; i < body.point_count; ++i) {
    const Sign sign = ask(arith::dot(normal, body.points[i]) - offset);
    if (!ask.certain()) return {};
    extent.add(sign);
  }
  for (std::size_t i = 0; i < body.edge_count; ++i) {
    if (body.ends[i] == EdgeEnd::none) continue;
    const Sign sign = ask(arith::dot(normal, body.edges[i]));
    if (!ask.certain()) return {};
    if (sign == Sign::zero) continue;
    extent.add(sign);
    if (body.ends[i] == EdgeEnd::both) extent.add(-sign);
  }
  return extent;
}

template <class T, class Shape>
std::optional<Extent> extent_of(const Shape& s, const Vector3& normal, double offset) {
  return extent_of(axis_body_of<T>(s, {0, 0, 0}), arith::vec<T>(normal), T(offset));
}

std::optional<Extent> extent_of(const ConvexPolyhedron3& polyhedron, const Vector3& normal, double offset) {
  Extent extent;
  const Side side{normal, offset};
  const Beyond beyond(side);
  for (const Point3& p : polyhedron.mesh.vertices) {
    extent.add(beyond.sign(p));
    if (extent.least == Sign::negative && extent.greatest == Sign::positive) break;
  }
  return extent;
}

std::optional<Extent> extent_of(const FlatView& v, const Vector3& normal, double offset) {
  return with_shape(v, [&](const auto& s) -> std::optional<Extent> {
    using Shape = std::remove_cvref_t<decltype(s)>;
    if constexpr (std::is_same_v<Shape, ConvexPolyhedron3>) {
      return extent_of(s, normal, offset);
    } else if constexpr (has_body<Shape>) {
      const auto quick = extent_of<Running>(s, normal, offset);
      return quick ? quick : extent_of<BigDyadic>(s, normal, offset);
    } else {
      return {};
    }
  });
}

Relation to_plane(const Extent& e) {
  if (e.least * e.greatest == Sign::negative || e.least == e.greatest)
    return e.least == e.greatest && e.least != Sign::zero ? Relation::disjoint : Relation::overlapping;
  return Relation::touching;
}
Relation to_halfspace(const Extent& e) { return static_cast<Relation>(-e.least); }

Vector3 normal_of(const FlatView& plane) {
  return with_shape(plane, [](const auto& s) {
    if constexpr (requires { s.normal; }) {
      return in_space(s.normal);
    } else {
      return Vector3{0, 0, 0};
    }
  });
}

}  // namespace

std::optional<Relation> relate_by_extent(const FlatView& plane, const FlatView& other) {
  const Vector3 normal = normal_of(plane);
  const double offset = with_shape(plane, [&](const auto& s) {
    if constexpr (requires { s.normal; }) {
      return s.offset;
    } else {
      return 0.0;
    }
  });
  if (normal == Vector3{0, 0, 0}) return {};
  if (is_one_of(other.kind, {FigureKind::plane, FigureKind::halfspace})) {
    const Vector3 second = normal_of(other);  // one that is zero is parallel to all
    return parallel(normal, second) ? std::nullopt : std::optional(Relation::overlapping);
  }
  const auto extent = extent_of(other, normal, offset);
  if (!extent) return {};
  return plane.kind == FigureKind::plane ? to_plane(*extent) : to_halfspace(*extent);
}

}  // namespace plumb::query
