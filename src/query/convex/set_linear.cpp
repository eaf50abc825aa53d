// Lines, rays and segments as what is on a line, between the ends along every axis.
#include "plumb/arith/error_free.hpp"
#include "plumb/predicates.hpp"
#include "query/convex/set.hpp"

namespace plumb::query::meeting {
namespace {

template <std::size_t N>
using SetBoundKind = typename Bound<N>::Kind;

template <std::size_t N>
Bound<N> on_axis(std::size_t axis, double offset, int side, int vertex = infinity) {
  Bound<N> b{SetBoundKind<N>::axis, side};
  b.vertex = vertex;
  b.axis = axis;
  b.offset = offset;
  return b;
}

template <std::size_t N>
void add_line(ConvexSet<N>& set, const Point<N>& a, const Point<N>& b) {
  for (std::size_t axis = 3; axis-- > (N == 2 ? 2 : 0);) {
    Bound<N> bound{SetBoundKind<N>::line, 0};
    bound.axis = axis;
    bound.a = a;
    bound.b = b;
    if (!(seen<N>(a, bound.look()) == seen<N>(b, bound.look()))) set.bounds.push_back(bound);
  }
}

}  // namespace

template <std::size_t N>
ConvexSet<N> point_set(const Point<N>& p) {
  ConvexSet<N> set;
  set.dimension = 0;
  set.vertices = {p};
  set.edges = {{.from = 0, .to = 0}};
  for (std::size_t axis = 0; axis < N; ++axis) set.bounds.push_back(on_axis<N>(axis, part(p, axis), 0));
  return set;
}

template <std::size_t N>
ConvexSet<N> segment_set(const Point<N>& a, const Point<N>& b) {
  if (a == b) return point_set<N>(a);
  ConvexSet<N> set;
  set.dimension = 1;
  set.bounds.reserve(N == 2 ? 5 : 9);
  set.vertices = {a, b};
  set.edges = {{.from = 0, .to = 1}};
  add_line<N>(set, a, b);
  for (std::size_t axis = 0; axis < N; ++axis) {
    const double p = part(a, axis), q = part(b, axis);
    if (p == q) continue;  // the line says it
    set.bounds.push_back(on_axis<N>(axis, p < q ? q : p, 1, p < q ? 1 : 0));
    set.bounds.push_back(on_axis<N>(axis, p < q ? p : q, -1, p < q ? 0 : 1));
  }
  return set;
}

template <std::size_t N>
ConvexSet<N> line_set(const Point<N>& a, const Point<N>& b) {
  if (a == b) return point_set<N>(a);
  ConvexSet<N> set;
  set.dimension = 1;
  set.edges = {{.from = infinity, .to = infinity, .point = a, .second = b}};
  add_line<N>(set, a, b);
  return set;
}

template ConvexSet<2> point_set<2>(const Point2&);
template ConvexSet<3> point_set<3>(const Point3&);
template ConvexSet<2> segment_set<2>(const Point2&, const Point2&);
template ConvexSet<3> segment_set<3>(const Point3&, const Point3&);
template ConvexSet<3> line_set<3>(const Point3&, const Point3&);

namespace {

/// The line, or the ray where `has_end`.
template <std::size_t N>
ConvexSet<N> directed_set(const Point<N>& p, const Vector<N>& d, bool has_end) {
  if (d == Vector<N>{}) return point_set<N>(p);
  ConvexSet<N> set;
  set.dimension = 1;
  Edge<N> edge{.from = has_end ? 0 : infinity, .to = infinity, .point = p, .direction = d, .named = true, .second = p};
  constexpr double may_be_doubled = 0x1p1022;
  for (std::size_t axis = 0; axis < N; ++axis) {
    const Rounded sum = two_sum(part(p, axis), part(d, axis));
    edge.named = edge.named && sum.error == 0 && magnitude_of(sum.value) <= may_be_doubled;
    part(edge.second, axis) = sum.value;
  }
  if (has_end) set.vertices = {p};
  set.edges = {edge};
  if (edge.named) {
    add_line<N>(set, p, edge.second);
  } else {
    for (std::size_t axis = 3; axis-- > (N == 2 ? 2 : 0);) {
      Bound<N> bound{SetBoundKind<N>::toward, 0};
      bound.axis = axis;
      bound.a = p;
      bound.direction = d;
      if (part(d, bound.look().right) != 0 || part(d, bound.look().up) != 0) set.bounds.push_back(bound);
    }
  }
  for (std::size_t axis = 0; axis < N && has_end; ++axis) {
    if (part(d, axis) != 0) set.bounds.push_back(on_axis<N>(axis, part(p, axis), part(d, axis) > 0 ? -1 : 1, 0));
  }
  return set;
}

struct Beside {  // which side of the line through a in direction d is p on?
  static constexpr std::string_view name = "intersection";
  static constexpr std::array arguments{2, 2, 2};
  static constexpr bool homogeneous = true;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return p[0] * (p[5] - p[3]) - p[1] * (p[4] - p[2]);
  }
};

template <std::size_t N>
Sign sign_at_point(const Bound<N>& b, const Point<N>& p) {
  switch (b.kind) {
    case SetBoundKind<N>::axis:
      return sign_of_number(static_cast<int>(part(p, b.axis) > b.offset) -
                            static_cast<int>(part(p, b.axis) < b.offset));
    case SetBoundKind<N>::line:
      return orient2d(seen<N>(b.a, b.look()), seen<N>(b.b, b.look()), seen<N>(p, b.look()));
    case SetBoundKind<N>::toward: {
      const Vector2 d{part(b.direction, b.look().right), part(b.direction, b.look().up)};
      return sign_of(Beside{}, d, seen<N>(b.a, b.look()), seen<N>(p, b.look()));
    }
    case SetBoundKind<N>::face:
      if constexpr (N == 3) return orient3d(b.a, b.b, b.c, p);
      [[fallthrough]];
    case SetBoundKind<N>::normal:
      if constexpr (N == 3) return side_of_plane(b.direction, b.offset, p);
      [[fallthrough]];
    default: {
      BigDyadic value = BigDyadic(0.0) - b.given->offset;
      for (std::size_t axis = 0; axis < N; ++axis) value = value + b.given->gradient[axis] * BigDyadic(part(p, axis));
      return value.sign();
    }
  }
}

}  // namespace

Sign value_sign(const Bound<2>& bound, const Point2& p) { return sign_at_point<2>(bound, p); }
Sign value_sign(const Bound<3>& bound, const Point3& p) { return sign_at_point<3>(bound, p); }

ConvexSet<2> convex_set(const Line2& l) { return directed_set<2>(l.point, l.direction, false); }
ConvexSet<2> convex_set(const Ray2& r) { return directed_set<2>(r.origin, r.direction, true); }
ConvexSet<2> convex_set(const Segment2& s) { return segment_set<2>(s.a, s.b); }
ConvexSet<3> convex_set(const Line3& l) { return directed_set<3>(l.point, l.direction, false); }
ConvexSet<3> convex_set(const Ray3& r) { return directed_set<3>(r.origin, r.direction, true); }
ConvexSet<3> convex_set(const Segment3& s) { return segment_set<3>(s.a, s.b); }

}  // namespace plumb::query::meeting
