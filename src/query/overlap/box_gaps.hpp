// Separating axis test, error bounds: how far off may doubles be that tell how a box lies to a triangle, or to what is
// straight?
//
// A box with the axes of space is seen from its center, twice as large: p' = (p - min) + (p - max), and |x'| <= max -
// min.  An oriented one is mapped to such a box by the matrix of its cofactors, whose rows are its face normals n_i:
// |n_i . 2 (p - c)| <= 2 half_i volume.  Along the cross product of axis k and the edge e of a triangle with normal n
// the gap is
//   |e x p' + n|_k - (|n_k| + reach of the box),
// for the third corner is 2 n_k farther than the edge.
// Laws: what is computed of such a gap in doubles, its sums in whatever order, is off by no more than its bound: a
// constant that is derived from the formula (certify/formula.hpp), times powers of the largest numbers.  The formulas
// have absolute values resolved, for | |v| - |V| | <= |v - V|.
// Source: docs/proof.md, "Filter B".
// Cost: none; query/overlap/box_quick.cpp computes them.
#pragma once

#include "plumb/certify/detail/filter_stage.hpp"
#include "plumb/predicates/cross.hpp"

namespace plumb::query::box_gaps {

using predicates::cross, predicates::difference, predicates::dot, predicates::Triple;

/// Points a, b, c, min, max; what is straight is ab.
struct BesideBox {
  static constexpr std::string_view name = "relate";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  static constexpr auto seen(const std::array<T, 15>& p, std::size_t i) {
    return (p[i] - p[9 + i % 3]) + (p[i] - p[12 + i % 3]);
  }
};
/// The same, in another order: the center of one box serves many points.
struct BesideCenter : BesideBox {
  template <class T>
  static constexpr auto seen(const std::array<T, 15>& p, std::size_t i) {
    return (p[i] + p[i]) - (p[9 + i % 3] + p[12 + i % 3]);
  }
};
template <class Beside = BesideBox>
struct EdgeBesideBox : Beside {
  using Beside::seen;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    const auto y = p[4] - p[1], z = p[5] - p[2];
    const auto across = y * (p[8] - p[5]) - z * (p[7] - p[4]);
    return ((y * seen(p, 2) - z * seen(p, 1)) + across) - (across + (y * (p[14] - p[11]) + z * (p[13] - p[10])));
  }
};
template <class Beside = BesideBox>
struct NormalBesideBox : Beside {
  using Beside::seen;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    const auto n = cross(difference(p, 0, 1), difference(p, 1, 2));
    return dot(n, Triple{seen(p, 0), seen(p, 1), seen(p, 2)}) - dot(n, difference(p, 3, 4));
  }
};

/// Center, a, b, c, axes, half extents.
struct BesideObb {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3, 3, 3};
  static constexpr bool homogeneous = false;

  template <class T>
  struct Frame {
    const std::array<T, 24>& p;
    constexpr auto normal(std::size_t i) const {
      return cross(predicates::argument(p, 4 + (i + 1) % 3), predicates::argument(p, 4 + (i + 2) % 3));
    }
    constexpr auto half(std::size_t i) const {
      return (p[21 + i] + p[21 + i]) * dot(predicates::argument(p, 4), normal(0));
    }
    constexpr auto at(std::size_t point, std::size_t i) const { return dot(difference(p, 0, point), normal(i)); }
    constexpr auto twice_at(std::size_t point, std::size_t i) const { return at(point, i) + at(point, i); }
    constexpr auto edge(std::size_t from, std::size_t to, std::size_t i) const { return at(to, i) - at(from, i); }
    /// Of what is straight: the sum of two ways, and their difference.
    constexpr auto middle(std::size_t i) const {
      const auto a = difference(p, 0, 1), b = difference(p, 0, 2);
      return dot(Triple{a.x + b.x, a.y + b.y, a.z + b.z}, normal(i));
    }
    constexpr auto way(std::size_t i) const { return dot(difference(p, 1, 2), normal(i)); }
    constexpr auto cross_of_edges(std::size_t i) const {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      return edge(1, 2, j) * edge(2, 3, k) - edge(1, 2, k) * edge(2, 3, j);
    }
  };
};
struct StraightBesideFace : BesideObb {
  template <class T>
  constexpr auto operator()(const std::array<T, 24>& p) const {
    const Frame<T> f{p};
    return f.middle(0) - (f.half(0) + f.way(0));
  }
};
struct StraightBesideEdge : BesideObb {
  template <class T>
  constexpr auto operator()(const std::array<T, 24>& p) const {
    const Frame<T> f{p};
    return (f.middle(1) * f.way(2) - f.middle(2) * f.way(1)) - (f.half(1) * f.way(2) + f.half(2) * f.way(1));
  }
};
struct CornerBesideFace : BesideObb {
  template <class T>
  constexpr auto operator()(const std::array<T, 24>& p) const {
    const Frame<T> f{p};
    return f.twice_at(1, 0) - f.half(0);
  }
};
struct EdgeBesideEdge : BesideObb {
  template <class T>
  constexpr auto operator()(const std::array<T, 24>& p) const {
    const Frame<T> f{p};
    const auto y = f.edge(1, 2, 1), z = f.edge(1, 2, 2), n = f.cross_of_edges(0);
    return ((y * f.twice_at(1, 2) - z * f.twice_at(1, 1)) + n) - (n + (y * f.half(2) + z * f.half(1)));
  }
};
struct NormalBesideObb : BesideObb {
  template <class T>
  constexpr auto operator()(const std::array<T, 24>& p) const {
    const Frame<T> f{p};
    const Triple n{f.cross_of_edges(0), f.cross_of_edges(1), f.cross_of_edges(2)};
    return dot(n, Triple{f.twice_at(1, 0), f.twice_at(1, 1), f.twice_at(1, 2)}) -
           dot(n, Triple{f.half(0), f.half(1), f.half(2)});
  }
};

/// Let S_i be the sum of the sizes of axis i's coordinates, P no less than that of a point's seen from the center (and
/// of the way's, which is added).  Then a normal's coordinates are products of up to S_j S_k in sum, G_i = S_j S_k P
/// bounds what is seen of a vector in the frame, 2 half_i S_i S_j S_k a doubled half extent, and F_i is both together.
/// The magnitudes of the gaps are at most
///   2 G + G + (F - G)                                         along a face, of what is straight, and 2 F of corners,
///   4 G_j G_k + (F_j - G_j) G_k + G_j (F_k - G_k)             along an edge, of what is straight,
///   (8 + 8 + 8) G_j G_k
///     + 2 ((F_j - G_j) G_k + G_j (F_k - G_k))                 along an edge, of an edge,
///   8 G_j G_k (2 G_i + F_i - G_i), three times                along the normal.
/// Each constant below goes with F_i, F_j G_k + G_j F_k, and the sum of G_j G_k F_i.  Twice the filter's constant pays
/// for another order of the sums, for products that are not rounded, and for the roundings of the bound.
inline constexpr double straight_face_error = 2 * 3 * filter_constant<StraightBesideFace>(),
                        straight_edge_error = 2 * 2 * filter_constant<StraightBesideEdge>(),
                        corner_error = 2 * 2 * filter_constant<CornerBesideFace>(),
                        edge_error = 2 * 12 * filter_constant<EdgeBesideEdge>(),
                        normal_error = 2 * 16 * filter_constant<NormalBesideObb>();

}  // namespace plumb::query::box_gaps
