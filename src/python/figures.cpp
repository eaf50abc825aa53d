#include <map>

#include "python/figure_class.hpp"
#include "python/rooms.hpp"

namespace plumb::python {
namespace {

/// Python's classes, in the order of figure_classes(); kept as long as the module is.
py::list& classes_of_python() {
  static auto* classes = new py::list;  // never destroyed: the interpreter may end first
  return *classes;
}

std::size_t number_of_class(const AnyFigure& figure) {
  return static_cast<std::size_t>(&class_of(figure) - figure_classes().data());
}

constexpr std::array pose_names{"pose", "turn", "translation"};

/// The arguments of a class in the order of its members, each given once, by place or by name.
std::vector<py::object> bound_members(const FigureClass& is, const py::args& positional, const py::kwargs& named) {
  std::vector<py::object> given(is.members.size());
  if (positional.size() > given.size()) {
    throw py::type_error(is.name + "() takes " + std::to_string(given.size()) + " arguments, but " +
                         std::to_string(positional.size()) + " were given");
  }
  for (std::size_t i = 0; i < positional.size(); ++i) given[i] = positional[i];
  for (const auto& [key, value] : named) {
    const std::string name = py::str(key);
    if (std::ranges::find(pose_names, name) != pose_names.end()) continue;
    const auto at = std::ranges::find(is.members, name, &MemberOfFigure::name);
    if (at == is.members.end()) throw py::type_error(is.name + "() has no argument '" + name + "'");
    py::object& place = given[static_cast<std::size_t>(at - is.members.begin())];
    if (place) throw py::type_error(is.name + "() got argument '" + name + "' twice");
    place = py::reinterpret_borrow<py::object>(value);
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i]) throw py::type_error(is.name + "() is missing the argument '" + is.members[i].name + "'");
  }
  return given;
}

py::object in_or_none(const py::kwargs& named, const char* name) {
  return named.contains(name) ? py::reinterpret_borrow<py::object>(named[name]) : py::none();
}

AnyFigure made(const py::handle& type, const py::args& positional, const py::kwargs& named) {
  if (!py::hasattr(type, "_number")) {
    throw py::type_error("Figure() is of no kind; make one of its subclasses, such as Sphere3, or ask parse_figure");
  }
  const FigureClass& is = figure_classes()[type.attr("_number").cast<std::size_t>()];
  if (positional.size() == 1 && named.empty() && py::isinstance<AnyFigure>(positional[0])) {
    const auto& other = positional[0].cast<const AnyFigure&>();
    if (&class_of(other) == &is) return other;
  }
  const AnyFigure figure = is.make(bound_members(is, positional, named), is.name);
  return figure.under(pose_of(is.dimension, in_or_none(named, "pose"), in_or_none(named, "turn"),
                              in_or_none(named, "translation"), is.name));
}

struct ShownPose {
  py::object pose = py::none(), turn = py::none(), translation = py::none();
  bool is_chain = false;
};

ShownPose shown_pose(const AnyPose& pose) {
  ShownPose shown;
  std::visit(
      [&shown]<class By>(const By& by) {
        if constexpr (requires { by.columns; }) {
          constexpr py::ssize_t n = numbers_in<decltype(by.translation)>;
          py::array_t<double> rows(std::vector<py::ssize_t>{n + 1, n + 1});
          std::fill_n(rows.mutable_data(), rows.size(), 0.0);
          for (py::ssize_t i = 0; i < n; ++i) {
            for (py::ssize_t j = 0; j < n; ++j) rows.mutable_at(i, j) = (&by.columns[static_cast<std::size_t>(j)].x)[i];
            rows.mutable_at(i, n) = (&by.translation.x)[i];
          }
          rows.mutable_at(n, n) = 1;
          shown.pose = rows;
        } else if constexpr (requires { by.turn; }) {
          py::array_t<double> turn(numbers_in<decltype(by.turn)>);
          std::copy_n(&by.turn.w, turn.size(), turn.mutable_data());
          shown.turn = turn;
          shown.translation = shown_member(by.translation);
        } else if constexpr (requires { by.links; }) {
          shown.is_chain = true;
        }
      },
      pose);
  return shown;
}

std::string repr_of_value(const py::object& value) {
  return py::repr(py::isinstance<py::array>(value) ? py::object(value.attr("tolist")()) : value);
}

std::string repr_of(const AnyFigure& figure) {
  const FigureClass& is = class_of(figure);
  const ShownPose by = shown_pose(figure.pose());
  if (by.is_chain) return "parse_figure(" + std::string(py::repr(py::str(to_string(figure)))) + ")";
  std::string text = is.name + "(";
  const std::vector<py::object> members = members_of_figure(figure);
  for (std::size_t i = 0; i < members.size(); ++i)
    text += (i == 0 ? "" : ", ") + is.members[i].name + "=" + repr_of_value(members[i]);
  for (const auto& [name, value] : {std::pair{"pose", by.pose}, {"turn", by.turn}, {"translation", by.translation}}) {
    if (!value.is_none()) text += std::string(", ") + name + "=" + repr_of_value(value);
  }
  return text + ")";
}

std::string about(const FigureClass& is) {
  std::string signature, text;
  for (const MemberOfFigure& m : is.members) {
    signature += (signature.empty() ? "" : ", ") + m.name;
    text += m.name + " : " + m.told + "\n";
  }
  const std::string n = std::to_string(is.dimension + 1),
                    quaternion = is.dimension == 2 ? "(2,), w and z" : "(4,), w first";
  return is.name + "(" + signature +
         ", *, pose=None, turn=None, translation=None)\n--\n\nThe closed set that its numbers " + "say: a figure of " +
         (is.dimension == 2 ? "the plane" : "space") + ", as it stands or under a pose.\n\n" +
         "Parameters\n----------\n" + text + "pose : array_like, shape (" + n + ", " + n +
         "), whose last row is 0, ..., 0, 1; any matrix, never rounded\nturn : array_like, shape " + quaternion +
         ": a quaternion of any length but zero, which is exactly a rotation\ntranslation : array_like, shape (" +
         std::to_string(is.dimension) +
         ",)\n\nRaises\n------\nValueError\n    If a shape is another, a number is not " +
         "finite, a length is negative, or there is no such figure.\n";
}

void add_classes(py::module_& module, const py::object& base) {
  const py::object property = py::module_::import("builtins").attr("property");
  for (std::size_t c = 0; c < figure_classes().size(); ++c) {
    const FigureClass& is = figure_classes()[c];
    py::dict content;
    content["__doc__"] = about(is);
    content["__module__"] = "plumb";
    content["_number"] = c;
    for (std::size_t i = 0; i < is.members.size(); ++i) {
      const py::cpp_function get([i](const AnyFigure& self) { return members_of_figure(self)[i]; });
      content[py::str(is.members[i].name)] =
          property(get, py::none(), py::none(), is.members[i].name + " : " + is.members[i].told);
    }
    const py::object type = py::type::of(base)(is.name, py::make_tuple(base), content);
    module.attr(is.name.c_str()) = type;
    classes_of_python().append(type);
  }
}

}  // namespace

py::object object_of(const AnyFigure& figure) { return classes_of_python()[number_of_class(figure)](py::cast(figure)); }

void add_figures(py::module_& module) {
  py::class_<AnyFigure> figure(module, "Figure",
                               "A closed set of the plane or of space: what all classes of figures have in "
                               "common.\n\nFigures never change; they "
                               "compare by their numbers, and pickle.  What is asked about them is exact.");
  figure
      .def(
          "__init__",
          [](py::detail::value_and_holder& v, const py::args& positional, const py::kwargs& named) {
            const py::handle type(reinterpret_cast<PyObject*>(Py_TYPE(reinterpret_cast<PyObject*>(v.inst))));
            v.value_ptr() = new AnyFigure(made(type, positional, named));
          },
          py::detail::is_new_style_constructor())
      .def_property_readonly(
          "kind", [](const AnyFigure& self) { return std::string(name_of(self.kind())); },
          "str: the name of its kind, such as 'ball', 'triangle' or 'k-dop'.")
      .def_property_readonly("dimension", &AnyFigure::dimension, "int: 2 of the plane, 3 of space.")
      .def_property_readonly(
          "pose", [](const AnyFigure& self) { return shown_pose(self.pose()).pose; },
          "float64, shape (4, 4), in the plane (3, 3), or None where it is under no matrix.")
      .def_property_readonly(
          "turn", [](const AnyFigure& self) { return shown_pose(self.pose()).turn; },
          "float64, shape (4,), in the plane (2,): its quaternion, w first; None where it is under no rigid pose.")
      .def_property_readonly(
          "translation", [](const AnyFigure& self) { return shown_pose(self.pose()).translation; },
          "float64, shape (3,), in the plane (2,): that of its rigid pose, or None.")
      .def(
          "posed",
          [](const AnyFigure& self, const py::object& pose, const py::object& turn, const py::object& translation) {
            return object_of(self.under(pose_of(self.dimension(), pose, turn, translation, "posed")));
          },
          py::arg("pose") = py::none(), py::kw_only(), py::arg("turn") = py::none(),
          py::arg("translation") = py::none(),
          "posed(self, pose=None, *, turn=None, translation=None)\n--\n\nThe same shape under this pose, in place of "
          "the "
          "one it has; without arguments as it stands.\n\nIts arguments are those of the classes.  Nothing is rounded.")
      .def("__eq__",
           [](const AnyFigure& self, const py::object& other) {
             return py::isinstance<AnyFigure>(other) && self == other.cast<const AnyFigure&>();
           })
      .def("__hash__", [](const AnyFigure& self) { return py::hash(py::str(to_string(self))); })
      .def("__repr__", repr_of)
      .def("__str__", repr_of)
      .def("__reduce__", [](const AnyFigure& self) {
        return py::make_tuple(py::module_::import("plumb._pickled").attr("figure"), py::make_tuple(to_string(self)));
      });
  add_classes(module, figure);
  module.def(
      "parse_figure",
      [](const std::string& line) {
        const std::optional<AnyFigure> read = parse_figure(line);
        return read ? object_of(*read) : py::none();
      },
      py::arg("line"),
      "parse_figure(line)\n--\n\nThe figure that a line of text says, as `plumb` and pickles write it; None for a "
      "blank "
      "line or a comment.\n\nRaises\n------\nValueError\n    If a word is no number, or the numbers are no figure.");
}

}  // namespace plumb::python
