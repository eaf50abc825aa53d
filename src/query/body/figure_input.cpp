#include "query/body/figure_input.hpp"

#include "figure/basic/chain_input.hpp"
#include "figure/k_dop/sets.hpp"
#include "query/body/figure_view.hpp"

namespace plumb::query {
namespace {

template <class Shape>
void require(std::string_view function, const std::string& name, const Shape& s) {
  const auto item = [&](const char* list, std::size_t i) {
    return std::string(name).append(list).append("[").append(std::to_string(i)).append("]");
  };
  if constexpr (requires { s.directions; }) {
    figure::check(function, name, s);
  } else if constexpr (requires { s.halfspaces; }) {
    for (std::size_t i = 0; i < s.halfspaces.size(); ++i) require(function, item(".halfspaces", i), s.halfspaces[i]);
  } else if constexpr (requires { s.vertices; }) {
    require_chain(function, std::string(name).append(".vertices"), std::span(s.vertices));
  } else if constexpr (requires { s.outer; }) {
    require(function, std::string(name).append(".outer"), s.outer);
    for (std::size_t k = 0; k < s.holes.size(); ++k) require(function, item(".holes", k), s.holes[k]);
  } else if constexpr (requires { s.mesh; }) {
    if (s.mesh.corners.empty()) {
      throw InvalidShape(
          std::string(function).append(": ").append(name).append(" has no faces; make it by convex_polyhedron"));
    }
    require_finite_points(function, std::string(name).append(".mesh.vertices"), std::span(s.mesh.vertices));
  } else {
    const auto look = [&](const auto& part) {
      const std::string whole = std::string(name).append(part.name);
      require_finite_parts(function, std::array<std::string_view, 1>{whole}, part.numbers);
    };
    std::apply([&](const auto&... part) { (look(part), ...); }, parts(s));
    if constexpr (HasRadius<Shape>) {
      if (s.radius < 0) {
        throw InvalidShape(
            std::string(function).append(": ").append(name).append(".radius is negative; give zero or more"));
      }
    }
  }
}

}  // namespace

std::string_view spoken(const FigureView& figure) {
  switch (figure.kind) {
    case FigureKind::three_point_plane:
      return "plane_of_points";
    case FigureKind::quadrilateral:
      return "quadrilateral";
    case FigureKind::holed_polygon:
      return "holed_polygon";
    case FigureKind::tetrahedron:
      return "tetrahedron";
    case FigureKind::ball:
      return figure.dimension == 2 ? "circle" : "sphere";
    case FigureKind::k_dop:
      return "k_dop";
    case FigureKind::halfspace_intersection:
      return "intersection";
    default:
      return name_of(figure.kind);
  }
}

void require_figure(std::string_view function, std::string_view name, const FigureView& figure) {
  with_figure(figure, [&](const auto& s) {
    if (!is_sound(s)) [[unlikely]]
      require(function, std::string(name), s);
  });
}

void require_figures(std::string_view function, const FigureView& a, const FigureView& b) {
  require_figure(function, a.kind == b.kind ? "a" : spoken(a), a);
  require_figure(function, a.kind == b.kind ? "b" : spoken(b), b);
}

}  // namespace plumb::query
