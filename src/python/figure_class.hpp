// Which classes of figures has Python?  One for each struct of the library that is a figure, by its name, all below Figure.
//
// Laws: (1) the classes are those of the table of kinds (query/body/pairs.hpp), their arguments those of the structs' bodies;
//       no kind is listed here.  (2) A figure never changes; repr and pickle give it back, bit for bit.
// Source: RTCD 2.3.
// Cost: a copy of the numbers.  Nothing is searched.
#pragma once

#include "plumb/query/body/any_figure.hpp"
#include "python/figure_members.hpp"

namespace plumb::python {

struct FigureClass {
  std::string name;
  FigureKind kind;
  int dimension;
  std::vector<MemberOfFigure> members;
  AnyFigure (*make)(const std::vector<py::object>& members, std::string_view name);
};

/// All of them; in the order of the table, the plane's first.
const std::vector<FigureClass>& figure_classes();
const FigureClass& class_of(const AnyFigure& figure);
/// The members' values, in order.
std::vector<py::object> members_of_figure(const AnyFigure& figure);

/// A pose as Python gives it: rows of a matrix, or a quaternion and a translation; none of these where it stands as it is.
AnyPose pose_of(int dimension, const py::object& pose, const py::object& turn, const py::object& translation,
                std::string_view function);

/// A figure, or a row of two or three numbers that is a point.
AnyFigure figure_or_point(const py::handle& given, const Asked& asked);

}  // namespace plumb::python
