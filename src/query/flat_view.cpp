#include "flat_view.hpp"

#include "figure/chain_input.hpp"
#include "figure/k_dop_sets.hpp"
#include "flat_parts.hpp"

namespace plumb::query {
namespace {

template <class Shape>
void require_form(std::string_view function, std::string_view name, const Shape& s) {
  if constexpr (requires { s.directions; }) {
    figure::check(function, name, s);
  } else if constexpr (requires { s.vertices; }) {
    require_chain<typename decltype(s.vertices)::value_type>(function, std::string(name).append(".vertices"),
                                                             s.vertices);
  } else if constexpr (requires { s.outer; }) {
    require_form(function, std::string(name).append(".outer"), s.outer);
    for (std::size_t k = 0; k < s.holes.size(); ++k)
      require_form(function, std::string(name).append(".holes[").append(std::to_string(k)).append("]"), s.holes[k]);
  } else if constexpr (requires { s.mesh; }) {
    if (!s.mesh.corners.empty()) return;
    throw InvalidShape(
        std::string(function).append(": ").append(name).append(" has no faces; make it by convex_polyhedron"));
  }
}

template <class Shape>
void require_numbers(std::string_view function, std::string_view name, const Shape& s) {
  double zero = 0;  // becomes NaN, and stays it
  each_part(s, [&zero](const PartName&, const auto& coordinates) {
    for (const double x : coordinates) zero += x - x;
  });
  if (zero == 0) [[likely]]
    return;
  each_part(s, [&]<std::size_t N>(const PartName& part, const std::array<double, N>& coordinates) {
    const std::string which = std::string(name).append(part.text());
    const std::array<std::string_view, 1> names{which};
    for (const double x : coordinates) {
      if (!(x - x == 0)) throw_non_finite(function, std::array{static_cast<int>(N)}, coordinates, "xyz", names);
    }
  });
}

void require(std::string_view function, std::string_view name, const FlatView& v) {
  with_shape(v, [&](const auto& shape) {
    require_form(function, name, shape);
    require_numbers(function, name, shape);
  });
}

}  // namespace

FlatSet flat_set(const FlatView& v) {
  return with_shape(v, [](const auto& s) {
    if constexpr (requires { query::flat_set(s); }) {
      return query::flat_set(s);
    } else {
      return FlatSet{};
    }
  });
}

std::string_view spoken(FigureKind kind) {
  switch (kind) {
    case FigureKind::three_point_plane:
      return "plane_of_points";
    case FigureKind::quadrilateral:
      return "quadrilateral";
    case FigureKind::holed_polygon:
      return "holed_polygon";
    case FigureKind::tetrahedron:
      return "tetrahedron";
    case FigureKind::k_dop:
      return "k_dop";
    case FigureKind::halfspace_intersection:
      return "intersection";
    default:
      return name_of(kind);
  }
}

void require(std::string_view function, const FlatView& a, const FlatView& b) {
  require(function, a.kind == b.kind ? "a" : spoken(a.kind), a);
  require(function, a.kind == b.kind ? "b" : spoken(b.kind), b);
}

}  // namespace plumb::query
