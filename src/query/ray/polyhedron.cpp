// Convex polyhedra, as the intersection of the halfspaces below their faces.
#include "figure/basic/mesh_input.hpp"
#include "query/ray/answers.hpp"

namespace plumb::query {
namespace {

struct PolyhedronModel {
  static constexpr bool feature_by_point = true;
  const ConvexPolyhedron3& polyhedron;
  PolygonFaces faces = faces_of(polyhedron.mesh);

  [[nodiscard]] std::size_t size() const { return faces.size(); }

  /// By the first three corners, of which the third is not on one line with the others.
  template <class T>
  [[nodiscard]] Vec3<T> outward(std::uint32_t face, RaySigns& ask) const {
    const auto corners = faces[face];
    const Point3& a = faces.at(corners[0]);
    const Vec3<T> u = between<T>(a, faces.at(corners[1]));
    Vec3<T> n = cross(u, between<T>(a, faces.at(corners[2])));
    for (std::size_t k = 3; k < corners.size() && is_zero(n, ask); ++k)
      n = cross(u, between<T>(a, faces.at(corners[k])));
    return n;
  }
  template <class T>
  Linear<T> linear(const ShotLine<T>& line, std::uint32_t i, RaySigns& ask) const {
    const Vec3<T> out = outward<T>(i, ask);
    return {dot(line.origin_from(faces.at(faces[i][0])), out), dot(line.direction, out)};
  }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided& decided, RaySigns& ask) const {
    return still_normal(outward<T>(decided.normal, ask));
  }

  /// The point is on all faces that are tight, or in one plane with them.
  template <class T>
  Feature feature(const ShotLine<T>& line, const Time<T>& time, std::span<const std::uint32_t> tight,
                  RaySigns& ask) const {
    const Vec3<T> p = times(line.direction, time.numerator);
    const T& w = time.denominator;
    std::optional<Feature> best;
    const auto take = [&](FeatureKind kind, std::uint32_t number) {
      if (!best || std::pair(kind, number) < std::pair(best->kind, best->index)) best = Feature{kind, number};
    };
    for (const std::uint32_t face : tight) {
      const auto corners = faces[face];
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::uint32_t here = corners[k], next = corners[k + 1 < corners.size() ? k + 1 : 0];
        const Vec3<T> from = line.from_origin(faces.at(here)), to = line.from_origin(faces.at(next));
        if (is_zero(p - times(from, w), ask)) take(FeatureKind::vertex, here);
        if (on_segment(p, w, from, to, ask))
          take(FeatureKind::edge, polyhedron.mesh.first[face] + static_cast<std::uint32_t>(k));
      }
    }
    if (best) return *best;
    for (const std::uint32_t face : tight) {
      if (tight.size() == 1 || is_within(line, face, p, w, ask)) return {FeatureKind::face, face};
    }
    return {FeatureKind::face, tight[0]};
  }

 private:
  /// Of a point in the face's plane.
  template <class T>
  bool is_within(const ShotLine<T>& line, std::uint32_t face, const Vec3<T>& p, const T& w, RaySigns& ask) const {
    const auto corners = faces[face];
    const Vec3<T> normal = outward<T>(face, ask);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec3<T> from = line.from_origin(faces.at(corners[k]));
      const Vec3<T> e = line.from_origin(faces.at(corners[k + 1 < corners.size() ? k + 1 : 0])) - from;
      if (ask(dot(cross(e, p - times(from, w)), normal)) == Sign::negative) return false;
    }
    return true;
  }
};

}  // namespace

template <class F>
auto with_model(const ConvexPolyhedron3& polyhedron, const RayQuestion&, const F& f) {
  return f(PolyhedronModel{polyhedron});
}

template struct RayAnswers<ConvexPolyhedron3>;

}  // namespace plumb::query
