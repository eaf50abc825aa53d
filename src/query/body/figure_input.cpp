#include "query/body/figure_input.hpp"

#include "plumb/query/body/detail/with_figure.hpp"

namespace plumb::query {

std::string_view spoken(const FigureView& figure) {
  return with_figure(figure, [](const auto& s) { return name_of_figure(s); });
}

void require_figure(std::string_view function, std::string_view name, const FigureView& figure) {
  with_figure(figure, [&](const auto& s) { figure::require_sound(function, name, s); });
}

void require_figures(std::string_view function, const FigureView& a, const FigureView& b) {
  require_figure(function, a.kind == b.kind ? "a" : spoken(a), a);
  require_figure(function, a.kind == b.kind ? "b" : spoken(b), b);
}

}  // namespace plumb::query
