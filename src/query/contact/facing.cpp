#include "query/contact/facing.hpp"

#include <algorithm>
#include <bit>

#include "plumb/certify/direction.hpp"
#include "plumb/predicates.hpp"
#include "query/separation/quick.hpp"

namespace plumb::query::touching {
namespace {

Index bit_of(Index corner, Index k) { return corner >> k & 1; }

Index box_edge(Index i, Index j) {
  const auto u = static_cast<Index>(std::countr_zero(i ^ j)), v = u == 0 ? 1U : 0U, w = 3 - u - v;
  return 4 * u + bit_of(i, v) + 2 * bit_of(i, w);
}
Index rectangle_edge(Index i, Index j) { return (i ^ j) == 1 ? bit_of(i, 1) : 2 + bit_of(i, 0); }
Index tetrahedron_edge(Index i, Index j) {
  const Index low = std::min(i, j), high = std::max(i, j);
  return low == 0 ? high - 1 : low + high;
}
Index polygon_edge(std::size_t n, Index i, Index j) {
  const auto size = static_cast<Index>(n);
  return size == 2 ? 0 : (i + 1) % size == j ? i : j;
}

std::size_t next_corner(const PolygonMesh& m, Index face, std::size_t corner) {
  return corner + 1 == m.first[face + 1] ? m.first[face] : corner + 1;
}

/// The corner from which the same edge leads the other way.
std::size_t twin_of(const ConvexPolyhedron3& s, std::size_t corner) {
  const PolygonMesh& m = s.mesh;
  const Index face = face_of_corner(m, corner), beyond = s.across[corner];
  const Index end = m.corners[next_corner(m, face, corner)];
  for (std::size_t c = m.first[beyond]; c < m.first[beyond + 1]; ++c) {
    if (m.corners[c] == end && m.corners[next_corner(m, beyond, c)] == m.corners[corner]) return c;
  }
  return corner;
}

bool are_in_one_plane(const ConvexPolyhedron3& s, Index face, Index other) {
  const PolygonMesh& m = s.mesh;
  const auto corners = [&](Index f) { return std::span(m.corners).subspan(m.first[f], m.first[f + 1] - m.first[f]); };
  const auto at = [&](Index v) { return m.vertices[v]; };
  const auto of = corners(face);
  for (std::size_t k = 2; k < of.size(); ++k) {
    const bool are_in = std::ranges::all_of(corners(other), [&](Index v) {
      return std::ranges::find(of, v) != of.end() || orient3d(at(of[0]), at(of[1]), at(of[k]), at(v)) == Sign::zero;
    });
    if (!are_in || !collinear(at(of[0]), at(of[1]), at(of[k]))) return are_in;  // else nothing is told of a plane
  }
  return false;
}

}  // namespace

Feature surface_feature(const Seen& s, FeatureKind kind, std::size_t index) {
  const Feature core{kind, static_cast<Index>(index)};
  return s.view.is_hull() ? core : on_surface(s.view.figure, core);
}

Feature edge_between(const Seen& s, Index i, Index j) {
  const CoreCorners& c = s.core;
  Index number = std::min(i, j);
  const Index bits = i ^ j;
  const bool is_edge = bits != 0 && (bits & (bits - 1)) == 0;  // has_single_bit calls a function of the compiler's
  if (c.polyhedron() != nullptr) {
    const std::array of{i, j};
    number = feature_of_mesh(*c.polyhedron(), of).value_or(Feature{FeatureKind::edge, number}).index;
  } else if (c.ways() == 3) {
    number = is_edge ? box_edge(i, j) : number;
  } else if (c.ways() == 2) {
    number = is_edge ? rectangle_edge(i, j) : number;
  } else if (!s.view.is_hull()) {
    number = s.view.figure.kind == FigureKind::tetrahedron ? tetrahedron_edge(i, j) : polygon_edge(c.size(), i, j);
  }
  return surface_feature(s, FeatureKind::edge, number);
}

Index face_of_corner(const PolygonMesh& m, std::size_t corner) {
  const std::size_t f = corner / 3;  // of triangles alone
  if (f + 1 < m.first.size() && m.first[f] <= corner && corner < m.first[f + 1]) return static_cast<Index>(f);
  return static_cast<Index>(std::ranges::upper_bound(m.first, corner) - m.first.begin() - 1);
}

Index edge_number(const ConvexPolyhedron3& solid, std::size_t corner) {
  return static_cast<Index>(std::min(corner, twin_of(solid, corner)));
}

Outline outline_of(const ConvexPolyhedron3& solid, Index face) {
  const PolygonMesh& m = solid.mesh;
  parting::ShortList<Index, 16> faces;
  faces.push_back(face);
  Outline o{{}, face};
  for (std::size_t k = 0; k < faces.size(); ++k) {
    o.lowest = std::min(o.lowest, faces[k]);
    for (std::size_t c = m.first[faces[k]]; c < m.first[faces[k] + 1]; ++c) {
      const Index beyond = solid.across[c];
      if (std::ranges::find(faces, beyond) != faces.end()) continue;
      if (are_in_one_plane(solid, face, beyond)) faces.push_back(beyond);
    }
  }
  if (faces.size() + 1 == m.first.size()) return {{}, o.lowest};  // flat, and no face is another's inside
  // Around the outline: along each face, and past edges that are within.
  const auto is_within = [&](std::size_t c) { return std::ranges::find(faces, solid.across[c]) != faces.end(); };
  std::size_t start = m.first[face];
  for (std::size_t k = 0; k < faces.size() && is_within(start); ++k) {
    for (start = m.first[faces[k]]; start + 1 < m.first[faces[k] + 1] && is_within(start);) ++start;
  }
  std::size_t c = start;
  do {
    o.corners.push_back(c);
    c = next_corner(m, face_of_corner(m, c), c);
    while (is_within(c)) {
      const std::size_t twin = twin_of(solid, c);
      c = next_corner(m, solid.across[c], twin);
    }
  } while (c != start && o.corners.size() <= m.corners.size());
  return o;
}

}  // namespace plumb::query::touching
