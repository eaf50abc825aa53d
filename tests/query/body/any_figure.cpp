#include "query/body/any_figure.hpp"

#include <cstring>
#include <limits>

#include "query/body/degenerate_forms.hpp"

namespace plumb::pair_cases {
namespace {

template <class Shape>
const Shape& as(const void* s) {
  return *static_cast<const Shape*>(s);
}
template <class Shape>
const void* kept(Shape s) {
  return new Shape(std::move(s));
}

template <class Shape>
const void* figure_of(Material& m) {
  return kept(figure<Shape>(m));
}
template <class Shape>
const void* near_figure_of(Material& m) {
  return kept(near_figure<Shape>(m));
}
template <class Shape>
const void* degenerate_of(Material& m) {
  return kept(degenerate_form<Shape>(m));
}
template <class Shape>
const void* renamed_of(Material& m, const void* s) {
  return kept(renamed(m, as<Shape>(s)));
}
template <class Shape>
const void* mapped_of(const void* s, Map& map) {
  return kept(mapped(as<Shape>(s), map));
}
template <class Shape>
std::string numbers_of(const void* s) {
  return Material::numbers(as<Shape>(s));
}
template <class Shape>
void drop_of(const void* s) {
  delete static_cast<const Shape*>(s);
}

template <class Shape>
const void* spoiled_of(Material& m, const void* of) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Shape s = as<Shape>(of);
  if constexpr (requires { s.outer; }) {
    s.outer.vertices[m.below(s.outer.vertices.size())].y = nan;
  } else if constexpr (requires { s.vertices; }) {
    s.vertices[m.below(s.vertices.size())].x = nan;
  } else if constexpr (requires { s.directions; }) {
    s.max[m.below(s.max.size())] = nan;
  } else if constexpr (requires { s.halfspaces; }) {
    s.halfspaces.push_back({{}, nan});
  } else if constexpr (requires { s.mesh; }) {
    s.mesh.vertices[s.mesh.corners[m.below(s.mesh.corners.size())]].x = nan;
  } else {
    std::array<double, sizeof(Shape) / sizeof(double)> numbers;
    std::memcpy(numbers.data(), &s, sizeof(Shape));
    numbers[m.below(numbers.size())] = nan;
    std::memcpy(&s, numbers.data(), sizeof(Shape));
  }
  return kept(std::move(s));
}

template <class Shape>
constexpr FigureRow row_of{figure_kind<Shape>,    figure_dimension<Shape>, &figure_of<Shape>, &near_figure_of<Shape>,
                           &degenerate_of<Shape>, &renamed_of<Shape>,      &mapped_of<Shape>, &spoiled_of<Shape>,
                           &numbers_of<Shape>,    &drop_of<Shape>};

template <class... Shapes>
constexpr std::array<const FigureRow*, sizeof...(Shapes)> rows_of(Types<Shapes...>) {
  return {&row_of<Shapes>...};
}
constexpr auto rows_of_plane = rows_of(Plane{});
constexpr auto rows_of_space = rows_of(Space{});

}  // namespace

const FigureRow& figure_row(FigureKind kind, int dimension) {
  for (const FigureRow* row : rows_of_plane) {
    if (dimension == 2 && row->kind == kind) return *row;
  }
  for (const FigureRow* row : rows_of_space) {
    if (dimension == 3 && row->kind == kind) return *row;
  }
  throw std::logic_error("no figure of this kind and dimension: " + std::string(name_of(kind)));
}

}  // namespace plumb::pair_cases
