// Which forms of a figure have less than the figure shows?  Vertices that are one, chains that are walked there and
// back, edges that bound no inside, holes that are their outer chain, boxes without width, normals and radii of zero.
//
// Laws: those of a Material; a polygon in space is exactly planar, a polyhedron proved convex.  Every kind of figure has
// such forms, by what it says of its members (figure/basic/body.hpp), so that a new kind has them by itself.
#pragma once

#include <algorithm>

#include "query/body/pair_shapes.hpp"

namespace plumb::pair_cases {

/// Chains of which some edges bound no inside.
enum class ChainForm : unsigned char { as_drawn, spiked, there_and_back, repeated, one_place, on_a_line };
inline constexpr std::size_t chain_forms = 6;

inline Polygon2 degenerate_chain(Material& m, ChainForm form) {
  Polygon2 chain;
  auto& v = chain.vertices;
  const auto random_place = [&] { return v.begin() + static_cast<std::ptrdiff_t>(m.below(v.size())); };
  for (std::size_t n = 3 + m.below(3); n-- > 0;) v.push_back(m.point2());
  if (form == ChainForm::spiked) {
    for (std::size_t n = 1 + m.below(2); n-- > 0;) {
      const auto at = random_place();
      const Point2 root = *at;
      v.insert(at, {root, m.point2()});
    }
  } else if (form == ChainForm::there_and_back) {
    for (std::size_t i = v.size() - 1; i-- > 1;) v.push_back(v[i]);
  } else if (form == ChainForm::repeated) {
    for (std::size_t n = 1 + m.below(3); n-- > 0;) {
      const auto at = random_place();
      v.insert(at, *at);
    }
  } else if (form == ChainForm::one_place) {
    std::ranges::fill(v, v[0]);
  } else if (form == ChainForm::on_a_line) {  // of an axis
    const bool upright = m.below(2) == 0;
    for (Point2& p : v) (upright ? p.x : p.y) = upright ? v[0].x : v[0].y;
  }
  return chain;
}
inline Polygon2 degenerate_chain(Material& m) {
  return degenerate_chain(m, static_cast<ChainForm>(1 + m.below(chain_forms - 1)));
}

inline HoledPolygon2 degenerate_holed(Material& m) {
  HoledPolygon2 s{degenerate_chain(m, static_cast<ChainForm>(m.below(chain_forms))), {}};
  for (std::size_t n = 1 + m.below(2); n-- > 0;) {
    if (m.below(3) != 0) {
      s.holes.push_back(degenerate_chain(m, static_cast<ChainForm>(m.below(chain_forms))));
      continue;
    }
    s.holes.push_back(s.outer);
    if (m.below(2) == 0) std::ranges::reverse(s.holes.back().vertices);
  }
  return s;
}

inline Quadrilateral2 degenerate_quadrilateral(Material& m) {
  const Point2 a = m.point2(), b = m.point2(), c = m.point2();
  constexpr std::size_t forms = 6;
  const std::array<Quadrilateral2, forms> all{
      {{a, b, c, b}, {a, b, a, c}, {a, b, a, b}, {a, a, b, c}, {a, b, b, a}, {a, a, a, a}}};
  return all[m.below(forms)];
}

/// Faces in one plane beside one another, and corners that lie on their straight edges.
inline ConvexPolyhedron3 degenerate_polyhedron(Material& m) {
  const double s = std::fabs(m.number()), size = s == 0 ? 1 : s;
  const Point3 o = m.point3();
  std::vector<Point3> corners;
  bool exact = true;
  for (const double z : {0.0, size}) {
    for (const Point2& p : {Point2{0, 0}, {size, 0}, {2 * size, 0}, {2 * size, size}, {size, size}, {0, size}}) {
      corners.push_back({o.x + p.x, o.y + p.y, o.z + z});
      const Point3& c = corners.back();
      exact = exact && c.x - o.x == p.x && c.y - o.y == p.y && c.z - o.z == z && std::isfinite(c.x + c.y + c.z);
    }
  }
  if (!exact) return random_polyhedron(m);
  PolygonMesh mesh{corners, {}, {0}};
  const auto add = [&mesh](std::initializer_list<std::uint32_t> face) {
    mesh.corners.insert(mesh.corners.end(), face);
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  };
  add({0, 5, 4, 1});  // two below, one above with corners on its straight edges
  add({1, 4, 3, 2});
  add({6, 7, 8, 9, 10, 11});
  add({0, 1, 7, 6});
  add({1, 2, 8, 7});
  add({2, 3, 9, 8});
  add({3, 4, 10, 9});
  add({4, 5, 11, 10});
  add({5, 0, 6, 11});
  try {
    return convex_polyhedron(mesh);
  } catch (const InvalidShape&) {
    return random_polyhedron(m);
  }
}

/// Members that are one, or zero.
template <class Shape>
void degenerate_members(Material& m, Shape& s) {
  using Place = std::conditional_t<figure_dimension<Shape> == 2, Point2, Point3>;
  std::vector<Place*> places;
  const auto lose = [&m](auto& way, const auto& other) {
    const std::size_t how = m.below(3);
    if (how == 0) way = {};
    if (how == 1) way = other;
  };
  change_members(s, [&]<part::Role role, class Member>(part::RoleIs<role>, Member& member) {
    if constexpr (role == part::Role::place && std::is_same_v<Member, Place>) {
      places.push_back(&member);
    } else if constexpr (role == part::Role::way || role == part::Role::axis) {
      if constexpr (requires { member.size(); }) {
        for (auto& one : member) lose(one, member[0]);
      } else {
        lose(member, Member{});
      }
    } else if constexpr (role == part::Role::normal) {
      if (m.below(2) == 0) member = {};
    } else if constexpr (role == part::Role::offset || role == part::Role::length) {
      if (m.below(2) == 0) member = 0;
    } else if constexpr (role == part::Role::multiple) {
      auto& least = m.below(2) == 0 ? member.x : member.y;
      least = 0;
      if constexpr (requires { member.z; }) {
        if (m.below(2) == 0) member.z = 0;
      }
    } else if constexpr (role == part::Role::figure) {
      if constexpr (requires { member.begin(); }) {
        for (auto& one : member) degenerate_members(m, one);
      } else {
        degenerate_members(m, member);
      }
    } else if constexpr (role == part::Role::slabs) {
      const std::size_t flat = m.below(member.max.size());
      member.max[flat] = member.min[flat];
    }
  });
  if (places.size() > 1) {  // two are one, or all
    const bool all = m.below(4) == 0;
    const std::size_t from = m.below(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (all || i == (from + 1) % places.size()) *places[i] = *places[from];
    }
  }
  if constexpr (requires { s.min.x, s.max.x; }) {
    if (m.below(2) == 0) s.max.x = s.min.x;
    if (m.below(2) == 0) s.max.y = s.min.y;
    if constexpr (requires { s.min.z; }) {
      if (m.below(2) == 0) s.max.z = s.min.z;
    }
  }
}

template <class Shape>
Shape degenerate_form(Material& m) {
  constexpr FigureKind kind = figure_kind<Shape>;
  constexpr bool is_flat = figure_dimension<Shape> == 2;
  if constexpr (kind == FigureKind::polygon || kind == FigureKind::holed_polygon || kind == FigureKind::quadrilateral) {
    const auto flat = [&m] {
      if constexpr (kind == FigureKind::polygon) {
        return degenerate_chain(m);
      } else if constexpr (kind == FigureKind::holed_polygon) {
        return degenerate_holed(m);
      } else {
        return degenerate_quadrilateral(m);
      }
    };
    if constexpr (is_flat) {
      return flat();
    } else {
      const RandomPlane plane(m);
      return lifted(plane, flat());
    }
  } else if constexpr (kind == FigureKind::convex_polyhedron) {
    return degenerate_polyhedron(m);
  } else {
    Shape s = figure<Shape>(m);
    degenerate_members(m, s);
    return s;
  }
}

}  // namespace plumb::pair_cases
