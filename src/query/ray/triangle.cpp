// Triangles, by both rules.
#include "plumb/query/ray/hits.hpp"
#include "query/overlap/filters.hpp"
#include "query/ray/half_open.hpp"

namespace plumb {
namespace query {
namespace {

struct TriangleModel : FacetModel<TriangleModel> {
  explicit TriangleModel(const Triangle3& t) : triangle(t) {}
  const Triangle3& triangle;

  static std::size_t facets() { return 1; }
  template <class T>
  Facet<T> facet(const ShotLine<T>& line, std::uint32_t) const {
    const Vec3<T> a = line.from_origin(triangle.a);
    return {3, {a, line.from_origin(triangle.b), line.from_origin(triangle.c), a}, {0, 1, 2, 0}, {0, 1, 2, 0}, 0};
  }
  [[nodiscard]] QuickHit quick(const AnyRay& ray, const Decided& decided) const {
    if (decided.when.at != When::At::quotient || meeting_of(decided.when) != Meeting::plane) return {};
    return quick_hit(ray, triangle);
  }
  void know(const Decided& decided, Known& known) const {
    const auto& [a, b, c] = triangle;
    if (a.x == b.x && b.x == c.x) known[0] = a.x;
    if (a.y == b.y && b.y == c.y) known[1] = a.y;
    if (a.z == b.z && b.z == c.z) known[2] = a.z;
    if (decided.feature.kind != FeatureKind::vertex) return;
    const Point3& p = decided.feature.index == 0 ? a : decided.feature.index == 1 ? b : c;
    known = {p.x, p.y, p.z};
  }
};

template <class Answer>
std::optional<Answer> of(const AnyRay& ray, const Triangle3& triangle, HitRule rule) {
  require_ray(function_of<Answer>, ray, triangle);
  return answer_by<Answer>(rule, ray, TriangleModel(triangle));
}

/// What doubles tell for certain is so for every ray nearby.
template <class A>
bool hits_moved(const A& ray, const Triangle3& triangle) {
  if (const auto told = by_doubles(ray, triangle)) [[likely]]
    return *told != Relation::disjoint;
  return of<Decided>(ray, triangle, HitRule::half_open).has_value();
}

}  // namespace

bool hits_half_open(const Ray3& ray, const Triangle3& triangle) { return hits_moved(ray, triangle); }
bool hits_half_open(const Segment3& segment, const Triangle3& triangle) { return hits_moved(segment, triangle); }
bool hits_half_open(const Line3& line, const Triangle3& triangle) { return hits_moved(line, triangle); }

}  // namespace query

std::optional<Hit> first_hit(const AnyRay& ray, const Triangle3& triangle, HitRule rule) {
  return query::of<Hit>(ray, triangle, rule);
}
std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const Triangle3& triangle, HitRule rule) {
  return query::of<RayParameter>(ray, triangle, rule);
}

}  // namespace plumb
