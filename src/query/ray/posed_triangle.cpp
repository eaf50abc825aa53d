#include "query/ray/posed_triangle.hpp"

#include "query/ray/half_open.hpp"

namespace plumb::query {
namespace {

struct PosedModel : FacetModel<PosedModel> {
  explicit PosedModel(const PosedTriangle3& t) : triangle(t) {}
  const PosedTriangle3& triangle;

  static std::size_t facets() { return 1; }
  template <class T>
  Facet<T> facet(const ShotLine<T>& line, std::uint32_t) const {
    const Vec3<T> from = vector_of<T>(line.ray.origin);
    const auto [a, b, c] = posed_corners<T>(triangle);
    return {3, {a - from, b - from, c - from, a - from}, {0, 1, 2, 0}, {0, 1, 2, 0}, 0};
  }
};

template <class Answer>
std::optional<Answer> of_posed(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule) {
  const PosedModel model(triangle);
  if (rule == HitRule::closed) return answer<Answer>(ray, model, meet(ray, model));
  return answer<Answer>(ray, model,
                        certainly<RayWorlds>([&]<class T>(RayWorld<T>& ask) { return half_open<T>(ray, model, ask); }));
}

}  // namespace

std::optional<Hit> first_hit(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule) {
  return of_posed<Hit>(ray, triangle, rule);
}
std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule) {
  return of_posed<RayParameter>(ray, triangle, rule);
}
bool hits(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule) {
  return of_posed<Decided>(ray, triangle, rule).has_value();
}
Sign compare_hits(const AnyRay& ray, const PosedTriangle3& first, const PosedTriangle3& second, HitRule rule) {
  const auto order = *first_hit_parameter(ray, first, rule) <=> *first_hit_parameter(ray, second, rule);
  return order < 0 ? Sign::negative : order > 0 ? Sign::positive : Sign::zero;
}

}  // namespace plumb::query
