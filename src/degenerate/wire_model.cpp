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

// A corner for each set of axes, where bit k of its number says which end of axis k it is at.
template <class Corner>
void add_box(WireFigure& figure, std::size_t axes, const Corner& corner) {
  const std::size_t first = figure.points.size();
  for (std::size_t i = 0; i < std::size_t{1} << axes; ++i) figure.points.push_back(corner(i));
  using Face = std::vector<std::size_t>;
  const std::vector<Face> of_space = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  const std::vector<Face> of_plane = {{0, 1, 3, 2}};
  if (axes == 1) figure.edges.push_back({first, first + 1});
  for (Face face : axes == 3 ? of_space : axes == 2 ? of_plane : std::vector<Face>{}) {
    for (std::size_t& at : face) at += first;
    figure.faces.push_back(std::move(face));
  }
}

WirePoint point_at(std::span<const double> coordinates) {
  WirePoint p{};
  std::ranges::copy(coordinates, p.begin());
  return p;
}

void add_points(WireFigure& figure, std::span<const double> x, std::size_t dimension, bool any_number) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < x.size(); i += dimension) {
    all.push_back(figure.points.size());
    figure.points.push_back(point_at(x.subspan(i, dimension)));
  }
  if ((any_number && dimension == 2) || (!any_number && all.size() == 3)) {
    figure.faces.push_back(std::move(all));
  } else if (!any_number && all.size() == 2) {
    figure.edges.push_back({all[0], all[1]});
  } else {
    figure.dots.insert(figure.dots.end(), all.begin(), all.end());
  }
}

void add_arrow(WireFigure& figure, std::size_t from, std::span<const double> direction) {
  WirePoint tip = figure.points[from];
  for (std::size_t k = 0; k < direction.size(); ++k) tip[k] = finite(tip[k] + direction[k]);
  std::erase(figure.dots, from);  // the arrow shows it
  figure.arrows.push_back({from, figure.points.size()});
  figure.points.push_back(tip);
}

// Three corners each.
void add_triangles(WireFigure& figure, std::span<const double> corners) {
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    std::vector<std::size_t> face;
    for (std::size_t k = 0; k < 3; ++k) face.push_back(static_cast<std::size_t>(corners[i + k]));
    figure.faces.push_back(std::move(face));
  }
}

bool is_oriented_box(const std::vector<Part>& parts) {
  return parts.size() == 3 && parts[0].role == Role::points && parts[0].dimension == 3 && parts[0].count == 1 &&
         parts[1].role == Role::frame && parts[1].dimension == 3 && parts[1].count == 3 &&
         parts[2].role == Role::extents && parts[2].dimension == 3;
}

void add_figure(WireFigure& figure, const Given& g) {
  const std::span<const double> x = g.numbers;
  if (is_oriented_box(g.argument.parts)) {  // center, axes, half extents: corners are rounded
    return add_box(figure, 3, [&](std::size_t i) {
      std::array<long double, 3> p{x[0], x[1], x[2]};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const long double by = (i >> axis & 1) != 0 ? x[12 + axis] : -x[12 + axis];
        for (std::size_t k = 0; k < 3; ++k) p[k] += by * x[3 + 3 * axis + k];
      }
      return WirePoint{finite(p[0]), finite(p[1]), finite(p[2])};
    });
  }
  std::span<const double> rest = x;
  for (std::size_t i = 0; i < g.argument.parts.size(); ++i) {
    const Part& part = g.argument.parts[i];
    const auto dimension = static_cast<std::size_t>(part.dimension);
    const std::span<const double> of_part = rest.first(g.argument.any_number() ? rest.size() : dimension * part.count);
    rest = rest.subspan(of_part.size());
    if (dimension > 3) continue;
    if (part.role == Role::points) {
      add_points(figure, of_part, dimension, g.argument.any_number());
    } else if (part.role == Role::corners) {
      add_box(figure, dimension, [&](std::size_t corner) {
        WirePoint p{};
        for (std::size_t k = 0; k < dimension; ++k) p[k] = of_part[(corner >> k & 1) != 0 ? dimension + k : k];
        return p;
      });
    } else if (part.role == Role::vector && i > 0 && g.argument.parts[i - 1].role == Role::points &&
               g.argument.parts[i - 1].dimension == part.dimension) {
      const std::size_t from = figure.points.size() - 1;
      for (std::size_t v = 0; v < part.count; ++v) add_arrow(figure, from, of_part.subspan(v * dimension, dimension));
    }
  }
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
      for (std::size_t v = 0; v < arguments[i].numbers.size(); v += 3)
        figure.points.push_back(point_at(arguments[i].numbers.subspan(v, 3)));
      add_triangles(figure, arguments[++i].numbers);
    } else {
      add_figure(figure, arguments[i]);
    }
  }
  if (kind.form == AnswerForm::triangles) add_triangles(figures[0], kind.exact(numbers).numbers);
  return figures;
}

}  // namespace plumb::degenerate
