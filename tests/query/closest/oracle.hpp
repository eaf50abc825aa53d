// Which point of a shape is nearest to p, by brute force over rationals?  Independent of the library's formulas.
//
// A shape is the list of its features, each the hull of a few corners, and whether it contains p otherwise.  The
// nearest point of a hull is the least over all of its simplices.  Of features equally near the first is told: vertices
// before edges before faces, each by number.
// Laws: exact for all finite doubles.
// Cost: 20 us to 5 ms.
#pragma once

#include <algorithm>
#include <cmath>

#include "figure/basic/rationals.hpp"
#include "plumb/figure.hpp"

namespace plumb::closest_oracle {

using rationals::dot, rationals::exact, rationals::Vector;
using rationals::operator+, rationals::operator-, rationals::operator*;
using Corners = std::vector<Vector>;

struct Nearest {
  Vector point;
  mpq_class square;
  Feature feature{FeatureKind::vertex, 0};
};

inline mpq_class square_of(const Vector& v) { return dot(v, v); }

/// Keeps the nearest simplex of up to four of the corners from `next` on, together with those chosen.
inline void try_simplices(const Corners& all, std::size_t next, Corners& chosen, const Vector& p,
                          std::optional<Nearest>& best) {
  if (!chosen.empty()) {
    const auto weights = chosen.size() == 1 ? std::optional(Vector{1}) : rationals::weights_of(chosen, p);
    if (!weights) return;  // dependent, and so is what contains them
    if (std::ranges::all_of(*weights, [](const mpq_class& w) { return w >= 0; })) {
      Vector q(p.size());
      for (std::size_t i = 0; i < chosen.size(); ++i) q = q + (*weights)[i] * chosen[i];
      const mpq_class square = square_of(q - p);
      if (!best || square < best->square) best = Nearest{q, square};
    }
  }
  for (std::size_t i = next; i < all.size() && chosen.size() < 4; ++i) {
    chosen.push_back(all[i]);
    try_simplices(all, i + 1, chosen, p, best);
    chosen.pop_back();
  }
}
inline Nearest nearest_of_hull(const Corners& corners, const Vector& p) {
  std::optional<Nearest> best;
  Corners chosen;
  try_simplices(corners, 0, chosen, p, best);
  return *best;
}

struct FeatureOfShape {
  Feature feature;
  Corners corners;
};

/// Features in their order; what p is in, where no feature is as near.
struct Shape {
  std::vector<FeatureOfShape> features;
  Corners solid;  // of which p may be inside
  Feature inside{FeatureKind::interior, 0};
};

inline Nearest nearest_of(const Shape& shape, const Vector& p) {
  std::optional<Nearest> best;
  for (const FeatureOfShape& f : shape.features) {
    Nearest n = nearest_of_hull(f.corners, p);
    n.feature = f.feature;
    if (!best || n.square < best->square) best = n;
  }
  if (best->square != 0 && !shape.solid.empty() && nearest_of_hull(shape.solid, p).square == 0)
    return {p, 0, shape.inside};
  return *best;
}

constexpr Feature vertex(std::size_t i) { return {FeatureKind::vertex, static_cast<std::uint32_t>(i)}; }
constexpr Feature edge(std::size_t i) { return {FeatureKind::edge, static_cast<std::uint32_t>(i)}; }
constexpr Feature face(std::size_t i) { return {FeatureKind::face, static_cast<std::uint32_t>(i)}; }

/// The corners by number, edges and faces by the numbers of their corners.
using Numbers = std::vector<std::vector<std::size_t>>;
inline Shape shape_of(const Corners& corners, const Numbers& edges, const Numbers& faces) {
  Shape s;
  const auto add = [&](Feature f, const std::vector<std::size_t>& numbers) {
    FeatureOfShape part{f, {}};
    for (const std::size_t i : numbers) part.corners.push_back(corners[i]);
    s.features.push_back(part);
  };
  for (std::size_t i = 0; i < corners.size(); ++i) add(vertex(i), {i});
  for (std::size_t i = 0; i < edges.size(); ++i) add(edge(i), edges[i]);
  for (std::size_t i = 0; i < faces.size(); ++i) add(face(i), faces[i]);
  return s;
}

inline Shape shape_of(const Segment2& s) { return shape_of({exact(s.a), exact(s.b)}, {{0, 1}}, {}); }
inline Shape shape_of(const Segment3& s) { return shape_of({exact(s.a), exact(s.b)}, {{0, 1}}, {}); }
inline Shape shape_of(const Triangle2& t) {
  return shape_of({exact(t.a), exact(t.b), exact(t.c)}, {{0, 1}, {1, 2}, {2, 0}}, {{0, 1, 2}});
}
inline Shape shape_of(const Triangle3& t) {
  return shape_of({exact(t.a), exact(t.b), exact(t.c)}, {{0, 1}, {1, 2}, {2, 0}}, {{0, 1, 2}});
}
inline Shape shape_of(const Tetrahedron3& t) {
  const Corners corners{exact(t.a), exact(t.b), exact(t.c), exact(t.d)};
  Shape s =
      shape_of(corners, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}, {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}});
  s.solid = corners;
  return s;
}

/// All corner + sums of edges; the features of a box of one to three edges, by the numbers that their headers give.
inline Shape box_of(const Vector& lowest, const std::vector<Vector>& edges) {
  const std::size_t n = edges.size();
  Corners corners(std::size_t{1} << n, lowest);
  Numbers on_edge(n << (n - 1)), on_face(n == 3 ? 6 : 1);
  for (std::size_t v = 0; v < corners.size(); ++v) {
    for (std::size_t i = 0; i < n; ++i) {
      if ((v >> i & 1) != 0) corners[v] = corners[v] + edges[i];
      std::size_t others = 0, place = 0;
      for (std::size_t k = 0; k < n; ++k) {
        if (k != i) others |= (v >> k & 1) << place++;
      }
      on_edge[(i << (n - 1)) + others].push_back(v);
      if (n == 3) on_face[2 * i + (v >> i & 1)].push_back(v);
    }
    if (n == 2) on_face[0].push_back(v);
  }
  Shape s = shape_of(corners, on_edge, on_face);
  if (n == 3) s.solid = corners;
  return s;
}
template <class Box>
Shape parallelepiped(const Box& box) {
  const auto half = coordinates(box.half);
  Vector lowest = exact(box.center);
  std::vector<Vector> edges;
  for (std::size_t i = 0; i < half.size(); ++i) {
    const mpq_class h(std::fabs(half[i]));
    lowest = lowest - h * exact(box.axes[i]);
    edges.push_back(mpq_class(2 * h) * exact(box.axes[i]));
  }
  return box_of(lowest, edges);
}
inline Shape shape_of(const Obb2& box) { return parallelepiped(box); }
inline Shape shape_of(const Obb3& box) { return parallelepiped(box); }
inline Shape shape_of(const Rectangle3& box) { return parallelepiped(box); }
template <class Box>
Shape aligned(const Box& box) {
  const Vector min = exact(box.min), max = exact(box.max);
  std::vector<Vector> edges;
  for (std::size_t i = 0; i < min.size(); ++i) {
    Vector e(min.size());
    e[i] = max[i] - min[i];
    edges.push_back(e);
  }
  return box_of(min, edges);
}
inline Shape shape_of(const Aabb2& box) { return aligned(box); }
inline Shape shape_of(const Aabb3& box) { return aligned(box); }

inline Shape shape_of(const ConvexPolyhedron3& polyhedron) {
  const PolygonMesh& m = polyhedron.mesh;
  Corners corners;
  for (const Point3& p : m.vertices) corners.push_back(exact(p));
  Shape s = shape_of(corners, {}, {});
  std::vector<FeatureOfShape> faces;
  std::vector<std::vector<std::size_t>> seen;
  for (std::uint32_t f = 0; f + 1 < m.first.size(); ++f) {
    faces.push_back({face(f), {}});
    for (std::uint32_t c = m.first[f]; c < m.first[f + 1]; ++c) {
      const std::size_t v = m.corners[c], w = m.corners[c + 1 == m.first[f + 1] ? m.first[f] : c + 1];
      faces.back().corners.push_back(corners[v]);
      if (std::ranges::find(seen, std::vector{w, v}) != seen.end()) continue;
      seen.push_back({v, w});
      s.features.push_back({edge(c), {corners[v], corners[w]}});
    }
  }
  for (const FeatureOfShape& f : faces) s.features.push_back(f);
  s.solid = corners;
  return s;
}

}  // namespace plumb::closest_oracle
