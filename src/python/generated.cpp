#include "plumb/figure/generated/generated.hpp"

#include <optional>

#include "plumb/degenerate/entropy.hpp"
#include "python/figure_class.hpp"
#include "python/rooms.hpp"

namespace plumb::python {
namespace {

/// A kind that the generators have, by the name of Python's class.
struct GeneratedClass {
  std::string name;
  int dimension;
  degenerate::ShapeKind kind;
  AnyFigure (*from)(std::span<const double>);
};

const std::vector<GeneratedClass>& generated_classes() {
  static const std::vector<GeneratedClass> all = [] {
    std::vector<GeneratedClass> found;
    for (const FigureClass& c : figure_classes()) {
      query::with_figure_type({c.kind, c.dimension, nullptr}, [&]<class Shape>(const Shape*) {
        if constexpr (GeneratedShape<Shape>) {
          found.push_back({c.name, c.dimension, generated_kind<Shape>,
                           [](std::span<const double> x) { return AnyFigure(shape_from<Shape>(x)); }});
        }
      });
    }
    return found;
  }();
  return all;
}

const GeneratedClass& generated_class(const std::string& name) {
  for (const GeneratedClass& c : generated_classes()) {
    if (c.name == name) return c;
  }
  throw py::value_error("no hard inputs are made of " + name);
}

Entropy entropy_of(const std::string& bytes) {
  return Entropy::from_bytes({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

/// Points of one plane are no polyhedron: None.
template <class Made>
py::object or_none_of(const Made& made) {
  try {
    return made();
  } catch (const InvalidShape&) {
    return py::none();
  }
}

py::object generate(const std::string& name, const py::bytes& choices) {
  const GeneratedClass& is = generated_class(name);
  const std::string bytes = choices;
  Entropy entropy = entropy_of(bytes);
  const degenerate::Form form = degenerate::any_form(entropy);
  return or_none_of([&] { return object_of(is.from(degenerate::shape(is.kind, is.dimension, form, entropy))); });
}

py::object generate_pair(const std::string& first, const std::string& second, const py::bytes& choices) {
  const GeneratedClass &a = generated_class(first), &b = generated_class(second);
  if (a.dimension != b.dimension) throw py::value_error("a figure of the plane and one of space are no pair");
  const std::string bytes = choices;
  Entropy entropy = entropy_of(bytes);
  const degenerate::ShapePair pair = degenerate::any_shape_pair(a.kind, b.kind, a.dimension, entropy);
  return or_none_of([&] { return py::make_tuple(object_of(a.from(pair.a)), object_of(b.from(pair.b))); });
}

}  // namespace

void add_generated(py::module_& module) {
  py::list names;
  for (const GeneratedClass& c : generated_classes()) names.append(c.name);
  module.attr("_generated_classes") = py::tuple(names);
  module.def("_generate", generate);
  module.def("_generate_pair", generate_pair);
}

}  // namespace plumb::python
