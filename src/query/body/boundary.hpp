// Boundary representation: which corners, edges and faces has a figure over any number type, and how are they numbered?
//
// Laws: (1) numbered as figure/containment/voronoi_region.hpp does; the corners and edges of a polygon count through
// its chains in turn, an edge by the corner that it leaves; a rectangle's are those of a box of two axes, an edge 2
// times its axis, plus 1 at the upper end of the other; a lozenge's are those of its parallelogram, of whose corners
// bit k says that it is at the end of way k.  (2) All corners are told before edges, and those before faces, each in
// order.  (3) The upper end of an axis is that of the magnitude of its half extent.  (4) A face's corners come in turn:
// of a polyhedron counterclockwise seen from outside; polygons, which need not be convex, are told without a face.
// (5) Repeated corners and edges of no length are told as others are.
// Source: RTCD 3.10, 12.1.
// Cost: a few sums for each corner, for oriented boxes products.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "arith/vec.hpp"
#include "plumb/certify/accepted.hpp"
#include "plumb/query/body/pairs.hpp"

namespace plumb::query {

inline constexpr std::initializer_list<FigureKind> polygon_kinds{FigureKind::quadrilateral, FigureKind::polygon,
                                                                 FigureKind::holed_polygon};

/// Of what is round by a radius around corners those of the core are told.
template <class Shape>
inline constexpr bool has_boundary = is_one_of(figure_kind<Shape>,
                                               {FigureKind::point, FigureKind::segment, FigureKind::triangle,
                                                FigureKind::tetrahedron, FigureKind::rectangle, FigureKind::aabb,
                                                FigureKind::obb, FigureKind::convex_polyhedron, FigureKind::ball,
                                                FigureKind::capsule, FigureKind::lozenge}) ||
                                     is_one_of(figure_kind<Shape>, polygon_kinds);

namespace boundary {

using Corner = std::uint32_t;

/// f(place) of what a body says as places, of lists in turn.
template <class Shape, class F>
void for_each_place(const Shape& s, F f) {
  const auto see = [&]<part::Role role, class Member>(const part::Part<role, Member>& p) {
    if constexpr (role == part::Role::place) {
      if constexpr (requires { p.is.begin(); }) {
        for (const auto& place : p.is) f(place);
      } else {
        f(p.is);
      }
    }
  };
  body(s, [&](std::string_view, const auto&... parts) { (see(parts), ...); });
}
template <class Shape, class F>
void for_each_chain(const Shape& s, F f) {
  if constexpr (requires { s.outer; }) {
    f(s.outer);
    for (const auto& hole : s.holes) f(hole);
  } else {
    f(s);
  }
}

template <class Shape, class To>
void tell_edges_of_chains(const Shape& s, To& to) {
  Corner first = 0;
  for_each_chain(s, [&](const auto& chain) {
    Corner past = first;
    for_each_place(chain, [&](const auto&) { ++past; });
    for (Corner i = first; i < past; ++i) to.edge(i, i + 1 < past ? i + 1 : first, i);
    first = past;
  });
}

template <class To>
void tell_features_of_tetrahedron(To& to) {
  Corner number = 0;
  for (Corner i = 0; i < 4; ++i) {
    for (Corner j = i + 1; j < 4; ++j) to.edge(i, j, number++);
  }
  for (Corner i = 0; i < 4; ++i) to.face(std::array<Corner, 3>{(i + 1) % 4, (i + 2) % 4, (i + 3) % 4}, i);
}

/// Of two or three axes; bit k of a corner's number: at the upper end of axis k.
template <Corner axes, class To>
void tell_features_of_box(To& to) {
  constexpr Corner along_each = 1u << (axes - 1);
  for (Corner k = 0; k < axes; ++k) {
    for (Corner n = 0; n < along_each; ++n) {
      const Corner before = n & ((1u << k) - 1), from = before | (n - before) << 1;
      to.edge(from, from | 1u << k, along_each * k + n);
    }
  }
  if constexpr (axes == 2) {
    to.face(std::array<Corner, 4>{0, 1, 3, 2}, 0);
  } else {
    for (Corner k = 0; k < axes; ++k) {
      const Corner u = 1u << (k == 0 ? 1 : 0), v = 1u << (k == 2 ? 1 : 2);
      for (const Corner at : {0u, 1u << k}) {
        to.face(std::array<Corner, 4>{at, at | u, at | u | v, at | v}, 2 * k + (at != 0 ? 1 : 0));
      }
    }
  }
}

template <class T, class Shape, class F>
void for_each_corner_of_box(const Shape& s, const F& f) {
  if constexpr (requires { s.min; }) {
    const arith::Vec<T> low = arith::vec<T>(s.min), high = arith::vec<T>(s.max);
    for (Corner i = 0; i < (1u << figure_dimension<Shape>); ++i)
      f({(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z});
  } else if constexpr (requires { s.edges; }) {
    const arith::Vec<T> at = arith::vec<T>(s.corner), u = arith::vec<T>(s.edges[0]), v = arith::vec<T>(s.edges[1]);
    for (const arith::Vec<T>& p : {at, at + u, at + v, at + u + v}) f(p);
  } else {
    const auto half = coordinates(s.half);
    const auto reach = [&](std::size_t k) { return arith::vec<T>(s.axes[k]) * T(std::fabs(half[k])); };
    const arith::Vec<T> center = arith::vec<T>(s.center), u = reach(0), v = reach(1);
    const arith::Vec<T> low = center - u, high = center + u;
    const auto tell = [&](const auto& ends) {
      for (const arith::Vec<T>& p : {low, high}) f(ends(p - v));
      for (const arith::Vec<T>& p : {low, high}) f(ends(p + v));
    };
    if constexpr (half.size() == 2) {
      tell([](const arith::Vec<T>& p) { return p; });
    } else {
      const arith::Vec<T> w = reach(2);
      tell([&](const arith::Vec<T>& p) { return p - w; });
      tell([&](const arith::Vec<T>& p) { return p + w; });
    }
  }
}

template <class To>
void tell_features_of_polyhedron(const ConvexPolyhedron3& s, To& to) {
  const PolygonMesh& mesh = s.mesh;
  const auto corners = [&](Corner f) {
    return std::span(mesh.corners).subspan(mesh.first[f], mesh.first[f + 1] - mesh.first[f]);
  };
  for (Corner f = 0; f + 1 < mesh.first.size(); ++f) {
    for (Corner c = mesh.first[f]; c < mesh.first[f + 1]; ++c) {
      // Each edge has two corners that leave it: that of the lower face is the lower.
      if (f < s.across[c]) to.edge(mesh.corners[c], mesh.corners[c + 1 < mesh.first[f + 1] ? c + 1 : mesh.first[f]], c);
    }
  }
  for (Corner f = 0; f + 1 < mesh.first.size(); ++f) to.face(corners(f), f);
}

}  // namespace boundary

template <class Shape>
inline constexpr bool has_boundary_of_box = is_one_of(figure_kind<Shape>, {FigureKind::aabb, FigureKind::obb,
                                                                           FigureKind::rectangle, FigureKind::lozenge});

/// Calls f(Vec<T>) with the corners in turn.
template <class T, class Shape, class F>
requires has_boundary<Shape>
void for_each_corner(const Shape& s, const F& f) {
  if constexpr (figure_kind<Shape> == FigureKind::convex_polyhedron) {
    for (const Point3& p : s.mesh.vertices) f(arith::vec<T>(p));
  } else if constexpr (has_boundary_of_box<Shape>) {
    boundary::for_each_corner_of_box<T>(s, f);
  } else {
    boundary::for_each_chain(
        s, [&](const auto& chain) { boundary::for_each_place(chain, [&](const auto& p) { f(arith::vec<T>(p)); }); });
  }
}

/// Calls to.corner(Vec<T>), to.edge(from, to, number) and to.face(span of corners, number).
template <class T, class Shape, class To>
requires has_boundary<Shape>
void tell_boundary(const Shape& s, To& to) {
  constexpr FigureKind kind = figure_kind<Shape>;
  for_each_corner<T>(s, [&to](const arith::Vec<T>& p) { to.corner(p); });
  if constexpr (kind == FigureKind::convex_polyhedron) {
    boundary::tell_features_of_polyhedron(s, to);
  } else if constexpr (has_boundary_of_box<Shape>) {
    constexpr bool is_solid = figure_dimension<Shape> == 3 && (kind == FigureKind::aabb || kind == FigureKind::obb);
    boundary::tell_features_of_box<is_solid ? 3 : 2>(to);
  } else if constexpr (kind == FigureKind::tetrahedron) {
    boundary::tell_features_of_tetrahedron(to);
  } else if constexpr (kind == FigureKind::segment || kind == FigureKind::capsule) {
    to.edge(0, 1, 0);
  } else if constexpr (kind == FigureKind::triangle || is_one_of(kind, polygon_kinds)) {
    boundary::tell_edges_of_chains(s, to);
    if constexpr (kind == FigureKind::triangle) to.face(std::array<boundary::Corner, 3>{0, 1, 2}, 0);
  }
}

}  // namespace plumb::query
