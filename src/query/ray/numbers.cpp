#include "query/ray/numbers.hpp"

namespace plumb::query {

void require_ray(std::string_view function, const AnyRay& ray, const FigureView& shape) {
  as_given(ray, [&](const auto& given) { require_figures(function, view_of(given), shape); });
}
void require_ray(std::string_view function, const AnyRay& ray) {
  as_given(ray, [&](const auto& given) { require_figure(function, spoken(view_of(given)), given); });
}
void require_ray(std::string_view function, const AnyRay& ray, const Ellipsoid3& ellipsoid) {
  if (!is_sound(ray)) require_ray(function, ray);
  figure::require_sound(function, ellipsoid);
}

}  // namespace plumb::query
