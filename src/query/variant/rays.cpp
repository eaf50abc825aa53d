#include "plumb/query/body/hit_pairs.hpp"
#include "plumb/query/ray/hits.hpp"
#include "plumb/query/ray/posed.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/asked.hpp"
#include "query/variant/recorded.hpp"

namespace plumb::query {
namespace {

std::optional<Hit> hit_in_space(const std::optional<Hit>& hit) { return hit; }
std::optional<Hit> hit_in_space(const std::optional<Hit2>& hit) {
  if (!hit) return {};
  return Hit{hit->t, {hit->point.x, hit->point.y, 0}, hit->feature, {hit->normal.x, hit->normal.y, 0}};
}

AnyRay ray_of(const FigureView& v) {
  if (v.kind == FigureKind::line) return *static_cast<const Line3*>(v.shape);
  if (v.kind == FigureKind::ray) return *static_cast<const Ray3*>(v.shape);
  return *static_cast<const Segment3*>(v.shape);
}

std::optional<Hit> first_hit_of_view(const PosedView& ray, const PosedView& figure) {
  require_answer(hit_pairs, "first_hit", ray.figure, figure.figure);
  if (is_posed_view(ray) || is_posed_view(figure)) {
    const auto triangle = posed_triangle(figure);
    if (triangle && !is_posed_view(ray)) return posed_first_hit(ray_of(ray.figure), *triangle, HitRule::closed);
    return posed_first_hit(ray, figure);
  }
  return asked_by_types<PairsOf<hit_pairs>, std::optional<Hit>>(
      "first_hit", ray.figure, figure.figure, [](const auto& x, const auto& y) requires requires { first_hit(x, y); } {
        return hit_in_space(first_hit(x, y));
      });
}

std::optional<RayParameter> first_parameter_of_view(const PosedView& ray, const PosedView& figure) {
  require_answer(hit_pairs, "first_hit_parameter", ray.figure, figure.figure);
  if (is_posed_view(ray) || is_posed_view(figure)) return posed_first_hit_parameter("first_hit_parameter", ray, figure);
  return asked_by_types<PairsOf<hit_pairs>, std::optional<RayParameter>>(
      "first_hit_parameter", ray.figure, figure.figure, [](const auto& x, const auto& y) requires requires {
        first_hit_parameter(x, y);
      } { return first_hit_parameter(x, y); });
}

bool hits_view(const PosedView& ray, const PosedView& figure) {
  require_answer(hit_pairs, "hits", ray.figure, figure.figure);
  if (is_posed_view(ray) || is_posed_view(figure)) return posed_first_hit_parameter("hits", ray, figure).has_value();
  return asked_by_types<PairsOf<hit_pairs>, bool>(
      "hits", ray.figure, figure.figure,
      [](const auto& x, const auto& y) requires requires { hits(x, y); } { return hits(x, y); });
}

}  // namespace

std::optional<Hit> any_first_hit(const PosedView& ray, const PosedView& figure) {
  return recorded("first_hit", {ray, figure}, {}, [&] { return first_hit_of_view(ray, figure); });
}
std::optional<RayParameter> any_first_hit_parameter(const PosedView& ray, const PosedView& figure) {
  return recorded("first_hit_parameter", {ray, figure}, {}, [&] { return first_parameter_of_view(ray, figure); });
}
bool any_hits(const PosedView& ray, const PosedView& figure) {
  return recorded("hits", {ray, figure}, {}, [&] { return hits_view(ray, figure); });
}

}  // namespace plumb::query
