// Which numbers is a figure of Python made of?  Each member of a struct, read from what Python gives and shown to it, by what
// the figure's body says (figure/basic/body.hpp).
//
// Laws: (1) no kind is listed here: a member is a number, a place, rows of places, a figure, figures, slabs or a surface.
//       (2) What is read is what is shown.  (3) A wrong shape or type and a number that is none are refused by name.
// Source: RTCD 2.3.
// Cost: a copy of the numbers.  Nothing is searched.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/query/body/any_figure.hpp"
#include "python/numbers.hpp"

namespace plumb::python {

/// The figure as an object of Python's class for its kind.
py::object object_of(const AnyFigure& figure);

struct MemberOfFigure {
  std::string name, told;
};

template <class Numbers>
inline constexpr py::ssize_t numbers_in = static_cast<py::ssize_t>(sizeof(Numbers) / sizeof(double));

template <class Member>
struct ItemOf {
  using Type = void;
};
template <class Item>
struct ItemOf<std::vector<Item>> {
  using Type = Item;
};
template <class Item, std::size_t N>
struct ItemOf<std::array<Item, N>> {
  using Type = Item;
};
template <class Member>
using Item = typename ItemOf<Member>::Type;
template <class Member>
inline constexpr bool is_place = requires(const Member& m) {
  m.x + m.y;
};

// What a docstring tells of it.
template <class Member>
std::string told_member() {
  if constexpr (std::is_same_v<Member, double>) {
    return "float";
  } else if constexpr (is_place<Member>) {
    return "array_like, shape (" + std::to_string(numbers_in<Member>) + ",)";
  } else if constexpr (Figure<Member>) {
    return "Figure";
  } else if constexpr (Figure<Item<Member>> && !is_place<Item<Member>>) {
    return "sequence of Figure";
  } else {
    const std::string n = std::to_string(numbers_in<Item<Member>>);
    if constexpr (std::is_same_v<Member, std::vector<Item<Member>>>) return "array_like, shape (n, " + n + ")";
    return "array_like, shape (" + std::to_string(numbers_in<Member> / numbers_in<Item<Member>>) + ", " + n + ")";
  }
}

template <class Place>
std::vector<Place> places_of(const py::handle& given, const Asked& asked) {
  const py::array_t<double> rows = rows_of(given, asked, numbers_in<Place>);
  const std::span<const Place> places = points_of<Place>(rows);
  return {places.begin(), places.end()};
}

/// So many finite numbers, shape (n,).
py::array_t<double> row_in(const py::handle& given, const Asked& asked, py::ssize_t n);
double number_of(const py::handle& given, const Asked& asked);
std::vector<double> list_of(const py::handle& given, const Asked& asked);
PolygonMesh surface_of(const py::handle& vertices, const py::handle& faces, std::string_view name);
/// A figure that stands as it is, of any kind; what else is given is refused.
const AnyFigure& figure_in(const py::handle& given, const Asked& asked);
[[noreturn]] void refuse_kind(const Asked& asked, const AnyFigure& given, FigureKind wanted, int dimension);

template <class Member>
void read_member(Member& to, const py::handle& given, const Asked& asked) {
  if constexpr (std::is_same_v<Member, double>) {
    to = number_of(given, asked);
  } else if constexpr (is_place<Member>) {
    to = points_of<Member>(row_in(given, asked, numbers_in<Member>)).front();
  } else if constexpr (Figure<Member>) {
    const AnyFigure& figure = figure_in(given, asked);
    const Member* is = get_if<Member>(figure);
    if (is == nullptr) refuse_kind(asked, figure, figure_kind<Member>, figure_dimension<Member>);
    to = *is;
  } else if constexpr (Figure<Item<Member>> && !is_place<Item<Member>>) {
    for (const py::handle& one : py::reinterpret_borrow<py::sequence>(given))
      read_member(to.emplace_back(), one, asked);
  } else {
    const std::vector<Item<Member>> rows = places_of<Item<Member>>(given, asked);
    if constexpr (std::is_same_v<Member, std::vector<Item<Member>>>) {
      to = rows;
    } else {
      const auto n = static_cast<py::ssize_t>(to.size());
      if (rows.size() != to.size())
        refuse(asked, py::array::ensure(given),
               "shape (" + std::to_string(n) + ", " + std::to_string(numbers_in<Item<Member>>) + ")");
      std::copy(rows.begin(), rows.end(), to.begin());
    }
  }
}

template <class Member>
py::object shown_member(const Member& is) {
  if constexpr (std::is_same_v<Member, double>) {
    return py::float_(is);
  } else if constexpr (is_place<Member>) {
    py::array_t<double> row(numbers_in<Member>);
    std::copy_n(&is.x, numbers_in<Member>, row.mutable_data());
    return row;
  } else if constexpr (Figure<Member>) {
    return object_of(is);
  } else if constexpr (Figure<Item<Member>> && !is_place<Item<Member>>) {
    py::list all;
    for (const auto& one : is) all.append(object_of(one));
    return all;
  } else {
    return array_of<double>(std::span<const Item<Member>>(is));
  }
}

template <class Shape>
inline constexpr bool has_slabs = requires(const Shape& s) {
  s.directions;
};
template <class Shape>
inline constexpr bool has_surface = requires(const Shape& s) {
  s.mesh;
};

template <Figure Shape>
std::vector<MemberOfFigure> members_of() {
  const std::string n = std::to_string(figure_dimension<Shape>);
  if constexpr (has_slabs<Shape>) {
    return {{"directions", "array_like, shape (k, " + n + ")"},
            {"min", "array_like, shape (k,)"},
            {"max", "array_like, shape (k,)"}};
  } else if constexpr (has_surface<Shape>) {
    return {{"vertices", "array_like, shape (n, 3)"},
            {"faces",
             "sequence of sequences of int, seen from outside "
             "counterclockwise"}};
  } else {
    return body(Shape{}, []<class... Parts>(std::string_view, const Parts&... parts) {
      const auto member = []<class Part>(const Part& p) {
        const std::string name(p.name.empty() ? "coordinates" : p.name);
        return MemberOfFigure{name, told_member<std::remove_cvref_t<decltype(p.is)>>() +
                                        (Part::role == part::Role::length ? ", not negative" : "")};
      };
      return std::vector<MemberOfFigure>{member(parts)...};
    });
  }
}

/// The name is what errors begin with.
template <Figure Shape>
AnyFigure figure_from(const std::vector<py::object>& given, std::string_view name) {
  const std::vector<MemberOfFigure> members = members_of<Shape>();
  if constexpr (has_slabs<Shape>) {
    using Vector = std::remove_cvref_t<decltype(std::declval<Shape>().directions.all()[0])>;
    const Shape s{Directions<Vector>(places_of<Vector>(given[0], {name, "directions"})),
                  list_of(given[1], {name, "min"}), list_of(given[2], {name, "max"})};
    figure::require_sound(name, s);
    return s;
  } else if constexpr (has_surface<Shape>) {
    return convex_polyhedron(surface_of(given[0], given[1], name));
  } else {
    Shape s{};
    std::size_t next = 0;
    change_members(s, [&](auto, auto& to) {
      read_member(to, given[next], {name, members[next].name});
      ++next;
    });
    figure::require_sound(name, s);
    return s;
  }
}

template <Figure Shape>
std::vector<py::object> shown_members(const Shape& s) {
  if constexpr (has_slabs<Shape>) {
    return {array_of<double>(s.directions.all()), array_of<double>(std::span<const double>(s.min)),
            array_of<double>(std::span<const double>(s.max))};
  } else if constexpr (has_surface<Shape>) {
    py::list faces;
    for (std::size_t f = 0; f + 1 < s.mesh.first.size(); ++f) {
      py::list corners;
      for (std::size_t i = s.mesh.first[f]; i < s.mesh.first[f + 1]; ++i) corners.append(s.mesh.corners[i]);
      faces.append(corners);
    }
    return {array_of<double>(std::span<const Point3>(s.mesh.vertices)), faces};
  } else {
    return body(s, []<class... Parts>(std::string_view, const Parts&... parts) {
      return std::vector<py::object>{shown_member(parts.is)...};
    });
  }
}

}  // namespace plumb::python
