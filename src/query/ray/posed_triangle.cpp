#include "query/ray/posed_triangle.hpp"

#include "query/ray/half_open.hpp"

namespace plumb::query {
namespace {

/// All of it, the ray as well, times the weight of the pose.
struct PosedModel : FacetModel<PosedModel> {
  explicit PosedModel(const PosedTriangle3& t) : triangle(t) {}
  const PosedTriangle3& triangle;

  static std::size_t facets() { return 1; }
  template <class T>
  ShotLine<T> beside(ShotLine<T> line) const {
    const WeightedPose<T> by = weighted_pose<T>(triangle.pose);
    if (by.has_weight) line.direction = times(line.direction, by.weight);
    return line;
  }
  template <class T>
  Facet<T> facet(const ShotLine<T>& line, std::uint32_t) const {
    const WeightedCorners<T> corners(triangle);
    const Vec3<T> from = corners.beside(vector_of<T>(line.ray.origin));
    const auto& [a, b, c] = corners.at;
    return {3, {a - from, b - from, c - from, a - from}, {0, 1, 2, 0}, {0, 1, 2, 0}, 0};
  }

  template <class T>
  std::optional<Decided> decide(const ShotLine<T>& line, RaySigns& ask) const {
    return meet_facets<T>(beside(line), *this, ask);
  }
  template <class T>
  Time<T> time(const ShotLine<T>& line, const When& when, RaySigns& ask) const {
    return facet_time<T>(beside(line), *this, when, ask);
  }
  template <class T>
  std::optional<PlaneMeeting<T>> plane_meeting(const ShotLine<T>& line, const Decided& decided) const {
    if (weighted_pose<T>(triangle.pose).has_weight) return {};
    return FacetModel<PosedModel>::plane_meeting<T>(line, decided);
  }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>& line, const Decided& decided, RaySigns& ask) const {
    const WeightedPose<T> by = weighted_pose<T>(triangle.pose);
    NormalForm<T> form = FacetModel<PosedModel>::normal<T>(line, decided, ask);
    if (!by.has_weight) return form;
    const T zero(0.0);
    return {form.still, {zero, zero, zero}, by.weight * by.weight, true};
  }
};

template <class Answer>
std::optional<Answer> answer_of_posed(HitRule rule, const AnyRay& ray, const PosedTriangle3& triangle) {
  const PosedModel model(triangle);
  if (rule == HitRule::closed) return answer_of_model<Answer>(ray, model);
  return answer<Answer>(ray, model, certainly<RayWorlds>([&]<class T>(RayWorld<T>& ask) {
                          return half_open<T>(model.beside(ShotLine<T>(ray)), model, ask);
                        }));
}

}  // namespace

std::optional<Hit> first_hit(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule) {
  return answer_of_posed<Hit>(rule, ray, triangle);
}
std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule) {
  return answer_of_posed<RayParameter>(rule, ray, triangle);
}
bool hits(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule) {
  return answer_of_posed<Decided>(rule, ray, triangle).has_value();
}
Sign compare_hits(const AnyRay& ray, const PosedTriangle3& first, const PosedTriangle3& second, HitRule rule) {
  const auto order = *first_hit_parameter(ray, first, rule) <=> *first_hit_parameter(ray, second, rule);
  return order < 0 ? Sign::negative : order > 0 ? Sign::positive : Sign::zero;
}

}  // namespace plumb::query
