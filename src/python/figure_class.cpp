#include "python/figure_class.hpp"

namespace plumb::python {
namespace {

/// The struct's own name; of a template, that of its kind.
template <Figure Shape>
std::string struct_name() {
  constexpr std::string_view text = __PRETTY_FUNCTION__, before = "Shape = plumb::";
  const std::size_t from = text.find(before) + before.size();
  std::string name(text.substr(from, text.find_first_of("<;]", from) - from));
  const char digit = static_cast<char>('0' + figure_dimension<Shape>);
  if (name.back() != digit) name += digit;
  return name;
}

struct Matrix {
  py::array_t<double> rows;
  [[nodiscard]] double at(py::ssize_t row, py::ssize_t column) const { return rows.at(row, column); }
};

/// Its last row must be that of a map of places: 0, ..., 0, 1.
Matrix matrix_of(const py::object& given, const Asked& asked, py::ssize_t n) {
  bool single = false;
  const Matrix m{row_or_rows_of(given, asked, n, single)};
  const std::string expected = "shape (" + std::to_string(n) + ", " + std::to_string(n) + ")";
  if (single || m.rows.shape(0) != n) refuse(asked, py::array::ensure(given), expected);
  for (py::ssize_t i = 0; i < n; ++i) {
    if (m.at(n - 1, i) == (i == n - 1 ? 1.0 : 0.0)) continue;
    throw py::value_error(std::string(asked.function) + ": " + std::string(asked.argument) +
                          " has a last row other than 0, ..., 0, 1; a projective map is no pose");
  }
  return m;
}

void require_finite(double x, const Asked& asked, const std::string& place) {
  if (std::isfinite(x)) [[likely]]
    return;
  throw py::value_error(std::string(asked.function) + ": " + std::string(asked.argument) + place + " is " +
                        std::string(py::str(py::float_(x))) + "; a finite number is needed");
}

template <class Rigid>
AnyPose rigid_pose(const py::object& turn, const py::object& translation, std::string_view function) {
  Rigid pose;
  if (!turn.is_none()) {
    constexpr py::ssize_t n = numbers_in<decltype(pose.turn)>;
    std::copy_n(row_in(turn, {function, "turn"}, n).data(), n, &pose.turn.w);
  }
  if (!translation.is_none()) read_member(pose.translation, translation, {function, "translation"});
  figure::require_sound(function, pose);
  return pose;
}

}  // namespace

const std::vector<FigureClass>& figure_classes() {
  static const std::vector<FigureClass> all = [] {
    std::vector<FigureClass> found;
    for (const int dimension : {2, 3}) {
      for (std::size_t k = 0; k < figure_kinds; ++k) {
        const query::FigureView v{static_cast<FigureKind>(k), dimension, nullptr};
        query::with_figure_type(v, [&]<class Shape>(const Shape*) {
          if (figure_dimension<Shape> != dimension) return;
          found.push_back({struct_name<Shape>(), v.kind, dimension, members_of<Shape>(), figure_from<Shape>});
        });
      }
    }
    return found;
  }();
  return all;
}

const FigureClass& class_of(const AnyFigure& figure) {
  for (const FigureClass& c : figure_classes()) {
    if (c.kind == figure.kind() && c.dimension == figure.dimension()) return c;
  }
  throw py::value_error("a figure of a kind that Python does not know");
}

std::vector<py::object> members_of_figure(const AnyFigure& figure) {
  return visit([](const auto& shape) { return shown_members(shape); }, figure);
}

AnyPose pose_of(int dimension, const py::object& pose, const py::object& turn, const py::object& translation,
                std::string_view function) {
  const bool is_rigid = !turn.is_none() || !translation.is_none();
  if (pose.is_none() && !is_rigid) return {};
  if (!pose.is_none() && is_rigid)
    throw py::type_error(std::string(function) + ": give pose, or turn and translation, not both");
  if (is_rigid) {
    return dimension == 2 ? rigid_pose<RigidPose2>(turn, translation, function)
                          : rigid_pose<RigidPose>(turn, translation, function);
  }
  const Matrix m = matrix_of(pose, {function, "pose"}, dimension + 1);
  if (dimension == 2) return Pose2{{{{m.at(0, 0), m.at(1, 0)}, {m.at(0, 1), m.at(1, 1)}}}, {m.at(0, 2), m.at(1, 2)}};
  const auto column = [&m](py::ssize_t j) { return Vector3{m.at(0, j), m.at(1, j), m.at(2, j)}; };
  return Pose{{{column(0), column(1), column(2)}}, column(3)};
}

py::array_t<double> row_in(const py::handle& given, const Asked& asked, py::ssize_t n) {
  const py::array numbers = numbers_of(given, asked);
  if (numbers.ndim() != 1 || numbers.shape(0) != n)
    refuse(asked, py::array::ensure(given), "shape (" + std::to_string(n) + ",)");
  auto row = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(numbers);
  if (!row) throw py::error_already_set();
  for (py::ssize_t i = 0; i < n; ++i) require_finite(row.at(i), asked, "[" + std::to_string(i) + "]");
  return py::array_t<double>(std::move(row));
}

double number_of(const py::handle& given, const Asked& asked) {
  const py::array number = numbers_of(given, asked);
  if (number.ndim() != 0) refuse(asked, py::array::ensure(given), "one number");
  const double x = *static_cast<const double*>(number.data());
  require_finite(x, asked, "");
  return x;
}

std::vector<double> list_of(const py::handle& given, const Asked& asked) {
  const py::array numbers = numbers_of(given, asked);
  if (numbers.ndim() != 1) refuse(asked, numbers, "shape (k,)");
  std::vector<double> all;
  for (const py::handle& x : numbers) all.push_back(number_of(x, asked));
  return all;
}

PolygonMesh surface_of(const py::handle& vertices, const py::handle& faces, std::string_view name) {
  PolygonMesh mesh;
  mesh.vertices = places_of<Point3>(vertices, {name, "vertices"});
  if (!py::isinstance<py::iterable>(faces)) throw py::type_error(std::string(name) + ": faces are no sequences of int");
  for (const py::handle& face : faces) {
    for (const py::handle& corner : py::iter(face)) {
      const auto v = py::int_(py::reinterpret_borrow<py::object>(corner)).cast<std::int64_t>();
      if (v < 0 || static_cast<std::size_t>(v) >= mesh.vertices.size()) {
        throw py::value_error(std::string(name) + ": faces name vertex " + std::to_string(v) + ", but there are " +
                              std::to_string(mesh.vertices.size()));
      }
      mesh.corners.push_back(static_cast<std::uint32_t>(v));
    }
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  return mesh;
}

const AnyFigure& figure_in(const py::handle& given, const Asked& asked) {
  const std::string where = std::string(asked.function) + ": " + std::string(asked.argument);
  if (!py::isinstance<AnyFigure>(given)) {
    throw py::type_error(where + " is no figure, but " + std::string(py::str(py::type::of(given).attr("__name__"))));
  }
  const auto& figure = given.cast<const AnyFigure&>();
  if (figure.is_posed()) throw py::value_error(where + " is under a pose; give it as it stands");
  return figure;
}

void refuse_kind(const Asked& asked, const AnyFigure& given, FigureKind wanted, int dimension) {
  for (const FigureClass& c : figure_classes()) {
    if (c.kind != wanted || c.dimension != dimension) continue;
    throw py::value_error(std::string(asked.function) + ": " + std::string(asked.argument) + " is a " +
                          class_of(given).name + "; expected a " + c.name);
  }
  throw py::value_error(std::string(asked.function) + ": " + std::string(asked.argument) + " is of another kind");
}

AnyFigure figure_or_point(const py::handle& given, const Asked& asked) {
  if (py::isinstance<AnyFigure>(given)) return given.cast<const AnyFigure&>();
  const bool may_be_row = py::isinstance<py::sequence>(given) || py::isinstance<py::array>(given);
  if (!may_be_row || py::isinstance<py::str>(given)) {
    throw py::type_error(std::string(asked.function) + ": " + std::string(asked.argument) + " is no figure, but " +
                         std::string(py::str(py::type::of(given).attr("__name__"))) +
                         "; give a figure, or a row of 2 or 3 numbers, which is a point");
  }
  const py::array row = numbers_of(given, asked);
  if (row.ndim() == 1 && row.shape(0) == 2) {
    Point2 p{};
    read_member(p, row, asked);
    return p;
  }
  if (row.ndim() != 1 || row.shape(0) != 3) refuse(asked, row, "a figure, or shape (2,) or (3,)");
  Point3 p{};
  read_member(p, row, asked);
  return p;
}

}  // namespace plumb::python
