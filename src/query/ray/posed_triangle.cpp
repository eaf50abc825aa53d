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

}  // namespace

std::optional<Hit> first_hit(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule) {
  return answer_by<Hit>(rule, ray, PosedModel(triangle));
}
std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule) {
  return answer_by<RayParameter>(rule, ray, PosedModel(triangle));
}
bool hits(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule) {
  return answer_by<Decided>(rule, ray, PosedModel(triangle)).has_value();
}
Sign compare_hits(const AnyRay& ray, const PosedTriangle3& first, const PosedTriangle3& second, HitRule rule) {
  const auto order = *first_hit_parameter(ray, first, rule) <=> *first_hit_parameter(ray, second, rule);
  return order < 0 ? Sign::negative : order > 0 ? Sign::positive : Sign::zero;
}

}  // namespace plumb::query
