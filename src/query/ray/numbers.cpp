#include "query/ray/numbers.hpp"

namespace plumb::query {

void require_ray(std::string_view function, const AnyRay& ray, const FigureView& shape) {
  as_given(ray, [&](const auto& given) { require_figures(function, view_of(given), shape); });
}
void require_ray(std::string_view function, const AnyRay& ray) {
  as_given(ray, [&](const auto& given) { require_figure(function, spoken(view_of(given)), given); });
}

}  // namespace plumb::query
