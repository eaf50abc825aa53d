#include "plumb/query/gjk/contact_manifold.hpp"

#include <algorithm>

#include "arith/exact_number.hpp"
#include "query/convex/exact_map.hpp"
#include "query/convex/features.hpp"
#include "query/gjk/body_pair.hpp"
#include "query/gjk/least_face.hpp"
#include "query/gjk/touching_faces.hpp"
#include "query/section/exact_section.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb::query {
namespace {

Exact3 exact3(const RationalPoint3& p) { return {gmp_number(p.x), gmp_number(p.y), gmp_number(p.z)}; }

/// Those of the points that are farthest along the way.
std::vector<Exact3> farthest(const std::vector<Exact3>& points, const Exact3& way) {
  std::vector<Exact3> far;
  std::optional<mpq_class> most;
  for (const Exact3& p : points) {
    const mpq_class reach = dot(way, p);
    if (!most || reach > *most) most = reach, far.clear();
    if (reach == *most) far.push_back(p);
  }
  return far;
}

std::vector<Exact3> moved(std::vector<Exact3> points, const Exact3& by) {
  for (Exact3& p : points) p = p + by;
  return points;
}

/// The vertices of a feature of a polyhedron; none of its inside.
std::vector<std::uint32_t> vertices_of(const PolygonMesh& m, const Feature& f) {
  const auto face = [&](std::size_t i) {
    return std::span(m.corners).subspan(m.first[i], m.first[i + 1] - m.first[i]);
  };
  if (f.kind == FeatureKind::vertex) return {f.index};
  if (f.kind == FeatureKind::face) return {face(f.index).begin(), face(f.index).end()};
  if (f.kind == FeatureKind::interior) return {};
  const auto next = std::ranges::upper_bound(m.first, f.index);
  const bool is_last = f.index + 1 == *next;
  return {m.corners[f.index], m.corners[is_last ? *(next - 1) : f.index + 1]};
}

/// All corners of a body; or enough of them that it is near to x what their hull is: of a polyhedron those of the least face
/// that holds x, and their neighbors.
std::vector<Exact3> corners_about(const BodyView& view, const CoreCorners& corners, const std::vector<Exact3>& all,
                                  const Exact3& x) {
  if (corners.polyhedron() == nullptr) return all;
  std::optional<ExactMap> map;
  if (!view.pose.stands()) map = exact_map(view.pose);
  if (map && is_singular(*map)) return all;
  const Feature f = feature_at(view.figure, x, false, map ? &*map : nullptr);
  std::vector<std::uint32_t> near = vertices_of(corners.polyhedron()->mesh, f);
  for (const std::uint32_t v : std::vector<std::uint32_t>(near)) {
    for (const std::uint32_t i : corners.polyhedron()->neighbors_of(v)) near.push_back(i);
  }
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<Exact3> points;
  for (const std::uint32_t i : near) points.push_back(all[i]);
  return points.empty() || dimension_of(points) < 3 ? all : points;  // within a flat part none shows its inner side
}

}  // namespace

ContactManifold manifold_of(const BodyView& a, const BodyView& b) {
  const BodyPair pair("contact_manifold", a, b);
  DifferenceCorners first;
  first.add({0, 0});
  std::uint32_t steps = 0;
  const ProvedCorners proved = certainly_nearest(pair.a(), pair.b(), guessed_nearest(pair.a(), pair.b(), first, steps));
  const NearestPair at = pair.nearest(proved);
  const std::vector<Exact3> of_a = exact_corners(pair.a()), of_b = exact_corners(pair.b());
  ContactManifold m;
  m.meets = proved.meets, m.distance = rounded_distance(at.square, 0);
  const Exact3 way = at.on_b - at.on_a, back = at.on_a - at.on_b;
  if (!m.meets) {
    const FlatSet face_a{farthest(of_a, way), {}, {}}, face_b{moved(farthest(of_b, back), back), {}, {}};
    m.on_a = common_part3(face_a, face_b);
  } else if (const auto normal = touching_plane(corners_about(a, pair.a(), of_a, at.on_a),
                                                corners_about(b, pair.b(), of_b, at.on_a), at.on_a)) {
    m.on_a = common_part3({farthest(of_a, mpq_class(-1) * *normal), {}, {}}, {farthest(of_b, *normal), {}, {}});
  } else if (dimension_of(of_a) == 3 && dimension_of(of_b) == 3) {
    m.on_a.kind = IntersectionKind::solid;
  } else {
    m.on_a = common_part3({of_a, {}, {}}, {of_b, {}, {}});
  }
  m.on_b.kind = m.on_a.kind;
  for (const ExactPoint3& p : m.on_a.vertices) {
    m.on_b.vertices.push_back(m.meets ? p : exact_point3(exact3(rational_point(p)) + way));
  }
  return m;
}

}  // namespace plumb::query
