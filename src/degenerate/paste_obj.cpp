#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "degenerate/fields.hpp"
#include "degenerate/words.hpp"
#include "plumb/degenerate/paste.hpp"

namespace plumb::degenerate {

namespace {

// Not infinite, which no reader takes.
double finite(long double x) {
  constexpr long double most = std::numeric_limits<double>::max();
  return static_cast<double>(std::clamp(x, -most, most));
}

// Vertices, and elements that name them; OBJ counts from 1 through the whole file.
class Obj {
 public:
  // One of each point's coordinates, or as many as there are.
  std::size_t vertex(std::span<const double> p) {
    text_.append("v");
    for (std::size_t axis = 0; axis < 3; ++axis) text_.append(" ").append(decimal(axis < p.size() ? p[axis] : 0.0));
    text_.append("\n");
    return ++vertices_;
  }
  void element(std::string_view letter, std::span<const std::size_t> of) {
    elements_.append(letter);
    for (const std::size_t v : of) elements_.append(" ").append(std::to_string(v));
    elements_.append("\n");
  }
  // Eight corners, where bit k of the number says which end of axis k.
  template <class Corner>
  void box(const Corner& corner) {
    std::array<std::size_t, 8> at{};
    for (std::size_t i = 0; i < 8; ++i) at[i] = vertex(corner(i));
    constexpr std::array<std::array<std::size_t, 4>, 6> faces = {
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& f : faces) element("f", std::array{at[f[0]], at[f[1]], at[f[2]], at[f[3]]});
  }
  void begin(std::string_view name) { text_.append("o ").append(name).append("\n"); }
  void end() { text_.append(std::exchange(elements_, {})); }
  [[nodiscard]] std::size_t vertices() const { return vertices_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_, elements_;
  std::size_t vertices_ = 0;
};

void add_points(Obj& obj, const Given& g) {
  const auto dimension = static_cast<std::size_t>(g.argument.parts[0].dimension);
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < g.numbers.size(); i += dimension)
    at.push_back(obj.vertex(g.numbers.subspan(i, dimension)));
  const bool chain = g.argument.any_number() && dimension == 2;
  if (chain || (!g.argument.any_number() && at.size() == 3)) return obj.element("f", at);
  if (!g.argument.any_number() && at.size() == 2) return obj.element("l", at);
  for (const std::size_t v : at) obj.element("p", std::array{v});
}

// Three corners each; `first` is the number of the first point.
void add_triangles(Obj& obj, std::span<const double> corners, std::size_t first) {
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    std::array<std::size_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k) face[k] = first + static_cast<std::size_t>(corners[i + k]);
    obj.element("f", face);
  }
}

void add_figure(Obj& obj, const Given& g) {
  const std::span<const double> x = g.numbers;
  const std::vector<Part>& parts = g.argument.parts;
  if (parts[0].role == Role::corners) {
    return obj.box([&](std::size_t i) { return std::array{x[i & 1 ? 3 : 0], x[i & 2 ? 4 : 1], x[i & 4 ? 5 : 2]}; });
  }
  if (parts.size() == 3) {  // center, axes, half extents: corners are rounded
    return obj.box([&](std::size_t i) {
      std::array<long double, 3> p{x[0], x[1], x[2]};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const long double by = (i >> axis & 1) != 0 ? x[12 + axis] : -x[12 + axis];
        for (std::size_t k = 0; k < 3; ++k) p[k] += by * x[3 + 3 * axis + k];
      }
      return std::array{finite(p[0]), finite(p[1]), finite(p[2])};
    });
  }
  if (parts.size() == 2) {  // a ray, as far as its direction
    const std::size_t from = obj.vertex(x.first(3));
    const std::size_t to = obj.vertex(std::array{finite(x[0] + x[3]), finite(x[1] + x[4]), finite(x[2] + x[5])});
    return obj.element("l", std::array{from, to});
  }
  add_points(obj, g);
}

}  // namespace

std::string obj_text(const Kind& kind, std::span<const double> numbers) {
  Obj obj;
  const std::vector<Given> arguments = given(kind, numbers);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    obj.begin(arguments[i].argument.name);
    // Points that triangles name are shown by these alone.
    if (i + 1 < arguments.size() && names_points(arguments[i + 1].argument.parts[0].role)) {
      const std::size_t first = obj.vertices() + 1;
      for (std::size_t v = 0; v < arguments[i].numbers.size(); v += 3) obj.vertex(arguments[i].numbers.subspan(v, 3));
      add_triangles(obj, arguments[++i].numbers, first);
    } else {
      add_figure(obj, arguments[i]);
    }
    obj.end();
  }
  if (kind.form == AnswerForm::triangles) {
    add_triangles(obj, kind.exact(numbers).numbers, 1);
    obj.end();
  }
  return std::string("# ").append(case_line(kind, numbers)).append("\n").append(obj.text());
}

}  // namespace plumb::degenerate
