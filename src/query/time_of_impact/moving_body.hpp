// Boundary features: what are the vertices, edges and faces of a convex shape, over any number type?
//
// A body is all points within `reach` of the convex hull of its vertices.  Every point of the hull's boundary is in a
// vertex, edge or face that is listed; of a flat hull every point is.
// Laws: features are numbered as query/body/boundary.hpp does; a ball as a whole is {face, 0}, of a capsule the ends are
// its vertices and the rest its edge 0, a plane is {face, 0}.
// Source: RTCD 5.5.
// Cost: a few sums for each vertex, for oriented boxes products.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "arith/running_error.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"
#include "plumb/query/body/posed.hpp"
#include "query/body/posed_corners.hpp"

namespace plumb::query {

template <class T>
struct MovingBody {
  struct Edge {
    std::array<std::uint32_t, 2> ends;
    Feature feature;
  };
  struct Face {
    std::vector<std::uint32_t> corners;  // in turn, of a convex polygon; none for a plane
    Vec3<T> normal;                      // of any length, the corners counterclockwise about it
    T offset;                            // of its plane, normal . x = offset
    Feature feature;
  };
  std::vector<Vec3<T>> vertices;
  std::vector<Feature> vertex_features;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  T reach{0.0};
  bool swept = false;  // reach > 0
  /// All of the above is that of the figure times this, which is above zero.
  T weight{1.0};
  bool has_weight = false;

  /// The same multiplied by the other's weight, and its own times that.
  void scale(const T& by) {
    for (Vec3<T>& v : vertices) v = v * by;
    for (Face& f : faces) f.offset = f.offset * by;
    reach = reach * by;
    weight = weight * by;
    has_weight = true;
  }
};
/// Two bodies of one weight, and a velocity seen beside them.
template <class T>
Vec3<T> bring_to_one_weight(MovingBody<T>& a, MovingBody<T>& b, const Vec3<T>& velocity) {
  if (!a.has_weight && !b.has_weight) return velocity;
  const T of_a = a.weight;
  const bool scale_b = a.has_weight;
  if (b.has_weight) a.scale(b.weight);
  if (scale_b) b.scale(of_a);
  return velocity * a.weight;
}

template <class T>
MovingBody<T> moving_body(const PosedView& shape);
/// What a pose multiplies lengths by in space, where that is one number for all, and a double.
std::optional<double> scale_of(const AnyPoseView& pose);
extern template MovingBody<Running> moving_body(const PosedView&);
extern template MovingBody<Ball> moving_body(const PosedView&);
extern template MovingBody<BigDyadic> moving_body(const PosedView&);

/// Throws NonFinite and InvalidShape, naming the function and the part; says whether the shape has a point at all.  Of
/// a posed shape finite numbers are taken for granted, and of a round one or a plane a pose that leaves it one.
bool check_body(std::string_view function, std::string_view name, const PosedView& shape);

}  // namespace plumb::query
