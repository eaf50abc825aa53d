#include "degenerate/wire_model.hpp"

#include <algorithm>
#include <limits>

#include "degenerate/fields.hpp"

namespace plumb::degenerate {

namespace {

using WirePoint = std::array<double, 3>;

// Not infinite, which no reader takes.
double finite(long double x) {
  constexpr long double most = std::numeric_limits<double>::max();
  return static_cast<double>(std::clamp(x, -most, most));
}

// Eight corners, where bit k of the number says which end of axis k.
template <class Corner>
void add_box(WireFigure& figure, const Corner& corner) {
  for (std::size_t i = 0; i < 8; ++i) figure.points.push_back(corner(i));
  figure.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
}

void add_points(WireFigure& figure, const Given& g) {
  const auto dimension = static_cast<std::size_t>(g.argument.parts[0].dimension);
  for (std::size_t i = 0; i < g.numbers.size(); i += dimension) {
    WirePoint p{};
    std::ranges::copy(g.numbers.subspan(i, dimension), p.begin());
    figure.points.push_back(p);
  }
  std::vector<std::size_t> all(figure.points.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const bool any_number = g.argument.any_number();
  if ((any_number && dimension == 2) || (!any_number && all.size() == 3)) {
    figure.faces = {all};
  } else if (!any_number && all.size() == 2) {
    figure.edges = {{0, 1}};
  } else {
    figure.dots = all;
  }
}

// Three corners each.
void add_triangles(WireFigure& figure, std::span<const double> corners) {
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    std::vector<std::size_t> face;
    for (std::size_t k = 0; k < 3; ++k) face.push_back(static_cast<std::size_t>(corners[i + k]));
    figure.faces.push_back(std::move(face));
  }
}

void add_figure(WireFigure& figure, const Given& g) {
  const std::span<const double> x = g.numbers;
  const std::vector<Part>& parts = g.argument.parts;
  if (parts[0].role == Role::corners && parts[0].dimension == 3) {
    return add_box(figure, [&](std::size_t i) {
      return WirePoint{x[i & 1 ? 3 : 0], x[i & 2 ? 4 : 1], x[i & 4 ? 5 : 2]};
    });
  }
  if (parts.size() == 3 && parts[1].role == Role::frame) {  // center, axes, half extents: corners are rounded
    return add_box(figure, [&](std::size_t i) {
      std::array<long double, 3> p{x[0], x[1], x[2]};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const long double by = (i >> axis & 1) != 0 ? x[12 + axis] : -x[12 + axis];
        for (std::size_t k = 0; k < 3; ++k) p[k] += by * x[3 + 3 * axis + k];
      }
      return WirePoint{finite(p[0]), finite(p[1]), finite(p[2])};
    });
  }
  if (parts.size() == 2 && parts[1].role == Role::vector) {  // a ray, as far as its direction
    figure.points = {{x[0], x[1], x[2]}, {finite(x[0] + x[3]), finite(x[1] + x[4]), finite(x[2] + x[5])}};
    figure.edges = {{0, 1}};
    figure.directed = true;
    return;
  }
  add_points(figure, g);
}

}  // namespace

std::vector<WireFigure> wire_model(const Kind& kind, std::span<const double> numbers) {
  std::vector<WireFigure> figures;
  const std::vector<Given> arguments = given(kind, numbers);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    WireFigure& figure = figures.emplace_back();
    figure.name = arguments[i].argument.name;
    // Points that triangles name are shown by these alone.
    if (i + 1 < arguments.size() && names_points(arguments[i + 1].argument.parts[0].role)) {
      for (std::size_t v = 0; v < arguments[i].numbers.size(); v += 3) {
        const std::span<const double> p = arguments[i].numbers.subspan(v, 3);
        figure.points.push_back({p[0], p[1], p[2]});
      }
      add_triangles(figure, arguments[++i].numbers);
    } else {
      add_figure(figure, arguments[i]);
    }
  }
  if (kind.form == AnswerForm::triangles) add_triangles(figures[0], kind.exact(numbers).numbers);
  return figures;
}

}  // namespace plumb::degenerate
