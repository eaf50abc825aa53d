// Gauss map of a Minkowski difference: which pairs of edges of two convex solids may span a face of it?
//
// The cross product of an edge of each bounds a solid at its edge where the solid's two faces there lie on one side of
// it: where the arc between their normals holds it.  Seen from an edge of one solid, both faces are half planes, and
// the edges of the other lie to them as one product of a vector and a cross product says, which is made once.
// Laws: a pair is left out where it is certain that it spans none: where both faces of one of the two edges lie
// strictly on different sides.  Pairs come in the order of the first edge, then of the second.
// Source: RTCD 5.2.1; Gottschalk 1996; Gregorius, "The separating axis test between convex polyhedra", 2013 (arcs that
// cross).
// Cost: 10 operations a pair, of solids as given; under poses four times that.
#pragma once

#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "plumb/certify/certainly.hpp"
#include "query/vclip/voronoi_planes.hpp"

namespace plumb::query::vclipping {

/// An edge, by the corners that it leaves on either side, and a corner of both faces off its line.
struct SolidEdge {
  std::uint32_t corner, twin;
  std::uint32_t off, off_twin;
};

/// Each but once, by the lower of its two corners.
inline std::vector<SolidEdge> edges_of(const Solid& s) {
  std::vector<SolidEdge> all;
  const auto corners = static_cast<std::uint32_t>(s.mesh().corners.size());
  all.reserve(corners / 2);
  for (std::uint32_t face = 0; face + 1 < s.mesh().first.size(); ++face) {
    for (std::uint32_t c = s.mesh().first[face]; c < s.mesh().first[face + 1]; ++c) {
      const std::uint32_t twin = s.twin(c);
      if (c < twin) all.push_back({c, twin, s.corner_off_line(c, face), s.corner_off_line(twin, s.face_of(twin))});
    }
  }
  return all;
}

/// Where an edge leads, and what it is multiplied by: the sides of its two faces, of the other edge's way.
template <class N>
struct EdgeSides {
  std::array<N, 3> way;
  decltype(std::declval<N>() * std::declval<N>() - std::declval<N>() * std::declval<N>()) x, y, z, twin_x, twin_y,
      twin_z;
};

/// Calls take(i, j) for pairs of edges that may span a face, until it says true.  Of solids as given, whose numbers are
/// finite; where the world is not certain nothing is called.
struct SpanningPairs {
  static constexpr int highest = 3;
  static constexpr Scales scales{.count = 2, .maxima = 3};

  template <std::size_t scale, class W>
  static auto sides_of(W& w, const Solid& s, const std::vector<SolidEdge>& edges) {
    const auto place = [&](std::uint32_t corner) -> const Point3& { return s.at(corner); };
    const auto between = [&](std::uint32_t from, std::uint32_t to) {
      const Point3 &p = place(from), &q = place(to);
      return std::array{w.template difference<scale>(q.x, p.x), w.template difference<scale>(q.y, p.y),
                        w.template difference<scale>(q.z, p.z)};
    };
    using N = std::remove_cvref_t<decltype(between(0, 0)[0])>;
    std::vector<EdgeSides<N>> all;
    all.reserve(edges.size());
    for (const SolidEdge& e : edges) {
      const auto way = between(e.corner, e.twin), side = between(e.corner, e.off), other = between(e.twin, e.off_twin);
      const auto crossed = [&](const auto& v, std::size_t i, std::size_t j) { return v[i] * way[j] - v[j] * way[i]; };
      all.push_back({way, crossed(side, 1, 2), crossed(side, 2, 0), crossed(side, 0, 1), crossed(other, 1, 2),
                     crossed(other, 2, 0), crossed(other, 0, 1)});
    }
    return all;
  }

  template <class W, class Take>
  bool operator()(W& w, const Solid& a, const std::vector<SolidEdge>& edges_a, const Solid& b,
                  const std::vector<SolidEdge>& edges_b, const Take& take) const {
    const auto sides_a = sides_of<0>(w, a, edges_a);
    const auto sides_b = sides_of<1>(w, b, edges_b);
    const auto are_parted = [&](const auto& of, const auto& way) {
      const auto s = of.x * way[0] + of.y * way[1] + of.z * way[2],
                 t = of.twin_x * way[0] + of.twin_y * way[1] + of.twin_z * way[2];
      return w.positive(larger(s, t)) && w.negative(smaller(s, t));
    };
    if (!w.certain()) return false;  // all leaves are known by now
    for (std::size_t i = 0; i < sides_a.size(); ++i) {
      for (std::size_t j = 0; j < sides_b.size(); ++j) {
        if (are_parted(sides_a[i], sides_b[j].way) || are_parted(sides_b[j], sides_a[i].way)) continue;
        if (take(i, j)) return true;
      }
    }
    return false;
  }
};

/// The same of solids under poses, by numbers that carry their errors.
template <class Take>
void each_spanning_pair(const Solid& a, const std::vector<SolidEdge>& edges_a, const Solid& b,
                        const std::vector<SolidEdge>& edges_b, const Take& take) {
  struct Sides {
    Vec<Running> way, side, twin_side;
  };
  const auto sides_of = [](const Solid& s, const std::vector<SolidEdge>& edges) {
    std::vector<Sides> all;
    all.reserve(edges.size());
    for (const SolidEdge& e : edges) {
      const Vec<Running> from = s.place<Running>(e.corner), to = s.place<Running>(e.twin), way = to - from;
      all.push_back({way, cross(s.place<Running>(e.off) - from, way), cross(s.place<Running>(e.off_twin) - to, way)});
    }
    return all;
  };
  const auto are_parted = [](const Sides& of, const Vec<Running>& way) {
    const int side = certain_sign(dot(of.side, way));
    return side != 0 && certain_sign(dot(of.twin_side, way)) == -side;
  };
  const std::vector<Sides> sides_a = sides_of(a, edges_a), sides_b = sides_of(b, edges_b);
  for (std::size_t i = 0; i < sides_a.size(); ++i) {
    for (std::size_t j = 0; j < sides_b.size(); ++j) {
      if (are_parted(sides_a[i], sides_b[j].way) || are_parted(sides_b[j], sides_a[i].way)) continue;
      if (take(i, j)) return;
    }
  }
}

}  // namespace plumb::query::vclipping
