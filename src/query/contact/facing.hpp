// Which feature of a body faces another one?  Its corners in order around the direction that leads out, the edges
// between them, and its name.
//
// Laws: exact where the signs are certain.  The feature holds all of the body that is farthest along the direction; of
// the faces that do, all but those seen edge on, it is the one whose normal makes the least angle with the direction,
// of several the first; where there is none, it is what is farthest.  Seen along the direction no three corners are on
// a line, and no two the same; they are counterclockwise seen from where the direction leads.
// Source: the features of query/separation/quick.hpp.
// Cost: of boxes some 100 operations; of polyhedra the faces about a vertex.
#pragma once

#include <algorithm>

#include "arith/approximate.hpp"
#include "arith/certain.hpp"
#include "arith/sparse_vec.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/contact/aim.hpp"
#include "query/convex/features.hpp"

namespace plumb::query::touching {

using arith::Vec, arith::sparse_cross, arith::sparse_difference, arith::sparse_dot, arith::sparse_product,
    arith::sparse_scaled, arith::sparse_sum;
using Index = std::uint32_t;
using Corners = parting::ShortList<Index, 8>;

/// A point, a segment, or a polygon.
struct Facing {
  Corners corners;
  parting::ShortList<Feature, 8> edges;  // edge i leaves corner i; of a segment there is one
  Feature face;                          // all of it, where it is a polygon
};

/// What is known of a body before it is looked at.
struct Seen {
  const BodyView& view;
  const CoreCorners& core;
  Index at;                          // a corner that is farthest
  const parting::KnownLevel& known;  // as far as that one
  const parting::SumLevel* level;    // all that is as far, where it is known: of a sum,
  const parting::LevelCorners* all;  // and of any other body
};

Feature surface_feature(const Seen& s, FeatureKind kind, std::size_t index);
/// Between two corners of the core.
Feature edge_between(const Seen& s, Index i, Index j);

/// The coplanar faces about one of a polyhedron, as one: its outline, and the lowest number.  Of a flat polyhedron no
/// outline.
struct Outline {
  parting::ShortList<std::size_t, 16> corners;  // of the mesh: each starts an edge
  Index lowest;
};
Outline outline_of(const ConvexPolyhedron3& solid, Index face);
/// The lower of the two corners that an edge leaves.
Index edge_number(const ConvexPolyhedron3& solid, std::size_t corner);
Index face_of_corner(const PolygonMesh& m, std::size_t corner);

template <class T>
class FacingSearch {
 public:
  FacingSearch(const Seen& seen, const Vec<T>& out, CertainSigns& ask)
      : s_(seen), c_(seen.core), out_(out), ask_(ask) {}

  Facing run() {
    if (c_.ways() == 3) {
      of_box();
    } else if (c_.ways() == 2) {
      of_rectangle();
    } else if (c_.polyhedron() != nullptr) {
      of_polyhedron();
    } else if (s_.view.is_hull()) {
      of_list(level());
    } else if (c_.size() == 4 && s_.view.figure.kind == FigureKind::tetrahedron) {
      of_tetrahedron();
    } else {
      of_polygon();
    }
    return f_;
  }

 private:
  [[nodiscard]] Vec<T> at(std::size_t i) const { return c_.at<T>(i); }
  static Vec<T> negative(const Vec<T>& v) { return Vec<T>{T(0.0), T(0.0), T(0.0)} - v; }

  /// Of a box: its corner without the ways that are level, and these.
  parting::SumLevel level_of_sum() {
    if (s_.level != nullptr) return *s_.level;
    parting::SumLevel l{s_.at, 0};
    for (std::size_t k = 0; k < c_.ways(); ++k) {
      const Index bit = Index{1} << k;
      const bool is_level =
          !c_.has_length(k) || s_.known.has(s_.at ^ bit) || ask_(sparse_dot(out_, c_.way<T>(k))) == Sign::zero;
      if (is_level) l.free |= bit;
    }
    l.first &= ~l.free;
    return l;
  }

  void take(std::initializer_list<Index> corners, bool in_order) {
    const auto n = corners.size();
    for (std::size_t i = 0; i < n; ++i)
      f_.corners.push_back(in_order ? corners.begin()[i] : corners.begin()[n - 1 - i]);
    for (std::size_t i = 0; i < n; ++i) f_.edges.push_back(edge_between(s_, f_.corners[i], f_.corners[(i + 1) % n]));
  }
  void take_segment(Index i, Index j) {
    f_.corners.push_back(i), f_.corners.push_back(j);
    f_.edges.push_back(edge_between(s_, i, j));
  }

  /// Of the normals of faces, none of which is seen edge on: which makes the least angle with the direction?
  struct Normal {
    Vec<T> normal;
    T along, along_square, square;

    Normal(const Vec<T>& n, const Vec<T>& out)
        : normal(n), along(sparse_dot(n, out)), along_square(along * along), square(sparse_dot(n, n)) {}
  };
  struct Best {
    std::optional<T> along, square;
    std::size_t which = 0;
    Sign side = Sign::zero;
  };
  bool is_better(Best& best, const Normal& n) {
    if (best.along && ask_(n.along_square * *best.square - *best.along * n.square) != Sign::positive) return false;
    best.along = n.along_square, best.square = n.square;
    return true;
  }
  /// For certain: so that nothing need be known of the side it is on.
  static bool is_worse(const Normal& n, const Normal& best) {
    CertainSigns ask;
    const Sign order = ask(n.along_square * best.square - best.along_square * n.square);
    return ask.certain() && order == Sign::negative;
  }
  static constexpr bool can_guess =
      std::is_same_v<T, Approximate> || std::is_same_v<T, Running> || std::is_same_v<T, Ball>;
  static double rough(const T& x) {
    if constexpr (requires { x.value; }) {
      return x.value;
    } else {
      return x.high;
    }
  }

  void of_box() {
    const parting::SumLevel l = level_of_sum();
    Index lengths = 0;
    for (std::size_t k = 0; k < 3; ++k) lengths |= c_.has_length(k) ? Index{1} << k : 0U;
    const std::array w{c_.way<T>(0), c_.way<T>(1), c_.way<T>(2)};
    std::optional<Sign> turn;  // of the three ways
    std::array<Index, 3> may{};
    std::size_t count = 0;
    for (Index k = 0; k < 3; ++k) {
      const Index i = (k + 1) % 3, j = (k + 2) % 3;
      if ((lengths >> i & lengths >> j & 1) == 0) continue;
      if ((lengths >> k & l.free >> k & 1) != 0) continue;  // what is level leads off that face
      may[count++] = k;
    }
    std::array<std::optional<Normal>, 3> of;
    for (std::size_t m = 0; m < count; ++m) of[m].emplace(sparse_cross(w[(may[m] + 1) % 3], w[(may[m] + 2) % 3]), out_);
    const auto upper = [&](Index k) { return (l.first >> k & 1) != 0 ? Sign::positive : Sign::negative; };
    const auto turn_of = [&](std::size_t m) {
      if (!turn) turn = lengths == 7 ? ask_(sparse_dot(of[m]->normal, w[may[m]])) : Sign::zero;
      return *turn;
    };
    // A guess, or `count` for none: others are left out where this one is better for certain.
    std::size_t likely = count;
    if constexpr (can_guess) {
      for (std::size_t m = 0; m < count && count > 1; ++m) {
        if (likely == count || rough(of[m]->along_square) * rough(of[likely]->square) >
                                   rough(of[likely]->along_square) * rough(of[m]->square)) {
          likely = m;
        }
      }
    }
    if (likely != count) {
      CertainSigns ask;
      const Sign side = ask(of[likely]->along), turned = turn_of(likely);
      const bool is_out = side != Sign::zero && (turned == Sign::zero || side * turned == upper(may[likely]));
      if (!ask.certain() || !is_out) likely = count;
    }
    Best best;
    for (std::size_t m = 0; m < count; ++m) {
      const Index k = may[m];
      const Normal& n = *of[m];
      if (likely != count && m != likely && is_worse(n, *of[likely])) continue;
      const Sign side = ask_(n.along);
      if (side == Sign::zero || (turn_of(m) != Sign::zero && side * *turn != upper(k))) continue;
      if (count > 1 && !is_better(best, n)) continue;
      best.which = k, best.side = side;
    }
    if (best.side == Sign::zero) return of_list(level());
    const auto k = static_cast<Index>(best.which);
    const Index base = l.first & Index{1} << k, i = Index{1} << (k + 1) % 3, j = Index{1} << (k + 2) % 3;
    take({base, base | i, base | i | j, base | j}, best.side == Sign::positive);
    f_.face = surface_feature(s_, FeatureKind::face, 2 * k + (base != 0 ? 1 : 0));
  }

  void of_rectangle() {
    const Sign side = c_.has_length(0) && c_.has_length(1)
                          ? ask_(sparse_dot(sparse_cross(c_.way<T>(0), c_.way<T>(1)), out_))
                          : Sign::zero;
    if (side == Sign::zero) return of_list(level());
    take({0, 1, 3, 2}, side == Sign::positive);
    f_.face = surface_feature(s_, FeatureKind::face, 0);
  }

  void of_tetrahedron() {
    const Corners l = level();
    Best best;
    for (Index k = 0; k < 4; ++k) {
      if (std::ranges::find(l, k) != l.end()) continue;
      const auto [p, q, r] = others(k);
      const Normal n(sparse_cross(at(q) - at(p), at(r) - at(p)), out_);
      const Sign side = ask_(n.along), inner = ask_(sparse_dot(n.normal, at(k) - at(p)));
      if (side == Sign::zero || inner == side || !is_better(best, n)) continue;
      best.which = k, best.side = side;
    }
    if (best.side == Sign::zero) return of_list(l);
    const auto [p, q, r] = others(static_cast<Index>(best.which));
    take({p, q, r}, best.side == Sign::positive);
    f_.face = surface_feature(s_, FeatureKind::face, best.which);
  }
  static std::array<Index, 3> others(Index k) { return {k == 0 ? 1U : 0U, k < 2 ? 2U : 1U, k < 3 ? 3U : 2U}; }

  /// And of segments and points.
  void of_polygon() {
    if (c_.size() == 1) return of_list(level());
    if (c_.size() == 2) {
      const bool is_level = s_.known.has(0) && s_.known.has(1);
      if (is_level || !is_none(sparse_cross(at(1) - at(0), out_))) return take_segment(0, 1);
      return of_list(level());
    }
    if (c_.size() == 3) {
      const Sign side = ask_(sparse_dot(sparse_cross(at(1) - at(0), at(2) - at(0)), out_));
      if (side == Sign::zero) return of_list(level());
      take({0, 1, 2}, side == Sign::positive);
      f_.face = surface_feature(s_, FeatureKind::face, 0);
      return;
    }
    of_list(every_corner());
    if (f_.corners.size() < 3) f_ = {}, of_list(level());  // seen edge on
  }

  void of_polyhedron() {
    const ConvexPolyhedron3& solid = *c_.polyhedron();
    const PolygonMesh& m = solid.mesh;
    Sign handed = Sign::positive;
    if (!c_.pose().stands()) {
      const auto [u, v, w] = weighted_pose<T>(c_.pose()).columns;
      handed = ask_(sparse_dot(u, sparse_cross(v, w)));
    }
    const Corners l = level();
    const auto is_level = [&](Index v) { return std::ranges::find(l, v) != l.end(); };
    int most = 0;  // of a face's corners beside this one that are level
    Best best;
    for (std::size_t at_corner = 0; at_corner < m.corners.size() && handed != Sign::zero; ++at_corner) {
      if (m.corners[at_corner] != s_.at) continue;
      const Index face = face_of_corner(m, at_corner);
      const std::size_t first = m.first[face], last = m.first[face + 1] - 1;
      const Index before = m.corners[at_corner == first ? last : at_corner - 1],
                  after = m.corners[at_corner == last ? first : at_corner + 1];
      const int also = l.size() < 2 ? 0 : (is_level(before) ? 1 : 0) + (is_level(after) ? 1 : 0);
      if (also < most || (also == 0 && l.size() > 1)) continue;
      const Normal n(face_normal(m, face), out_);
      if (ask_(n.along) != handed) continue;
      if (also > most) best = {}, most = also;
      if (!is_better(best, n)) continue;
      best.which = face, best.side = Sign::positive;
    }
    if (best.side == Sign::zero) return of_list(l);
    const Outline outline = outline_of(solid, static_cast<Index>(best.which));
    const std::size_t n = outline.corners.size();
    if (n == 0) return of_list(every_corner());
    f_.face = surface_feature(s_, FeatureKind::face, outline.lowest);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = handed == Sign::positive ? i : n - 1 - i;
      f_.corners.push_back(m.corners[outline.corners[k]]);
      f_.edges.push_back(surface_feature(
          s_, FeatureKind::edge, edge_number(solid, outline.corners[handed == Sign::positive ? k : (k + n - 1) % n])));
    }
    if (n > 3) straighten();
  }
  Vec<T> face_normal(const PolygonMesh& m, Index face) {
    const auto of = std::span(m.corners).subspan(m.first[face], m.first[face + 1] - m.first[face]);
    const Vec<T> p = at(of[0]);
    Vec<T> u = at(of[1]) - p, v = at(of[2]) - p, sum = sparse_cross(u, v);
    for (std::size_t i = 3; i < of.size(); ++i) {
      u = v, v = at(of[i]) - p;
      sum = sum + sparse_cross(u, v);
    }
    return sum;
  }
  /// Leaves out corners within a straight edge.
  void straighten() {
    const Facing all = f_;
    const std::size_t n = all.corners.size();
    f_.corners.clear(), f_.edges.clear();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec<T> p = at(all.corners[(i + n - 1) % n]), q = at(all.corners[i]), r = at(all.corners[(i + 1) % n]);
      if (ask_(sparse_dot(out_, sparse_cross(q - p, r - q))) == Sign::zero) continue;
      f_.corners.push_back(all.corners[i]), f_.edges.push_back(all.edges[i]);
    }
  }

  [[nodiscard]] Corners every_corner() const {
    Corners every;
    for (Index i = 0; i < c_.size(); ++i) every.push_back(i);
    return every;
  }
  /// The corners that are as far as the first.
  Corners level() {
    Corners l;
    if (c_.ways() > 0) {
      const parting::SumLevel sum = level_of_sum();
      for (Index i = 0; i < c_.size(); ++i) {
        if ((i & ~sum.free) == sum.first) l.push_back(i);
      }
      return l;
    }
    if (s_.all != nullptr) {
      for (const Index i : *s_.all) l.push_back(i);
      return l;
    }
    if (s_.level != nullptr) {  // of a segment or a point
      for (Index i = 0; i < c_.size(); ++i) {
        if ((i & ~s_.level->free) == s_.level->first) l.push_back(i);
      }
      return l;
    }
    const Vec<T> from = at(s_.at);
    const auto judge = [&](Index i) {
      if (i == s_.at || s_.known.has(i) || ask_(sparse_dot(out_, at(i) - from)) == Sign::zero) l.push_back(i);
    };
    if (c_.polyhedron() == nullptr) {
      for (Index i = 0; i < c_.size(); ++i) judge(i);
    } else {
      l.push_back(s_.at);
      for (const Index i : c_.polyhedron()->neighbors_of(s_.at)) judge(i);
    }
    return l;
  }

  bool is_none(const Vec<T>& v) {
    // One number that is certainly none is enough; where none is, all have to be certain.
    for (const T* x : {&v.x, &v.y, &v.z}) {
      CertainSigns ask;
      if (ask(*x) != Sign::zero && ask.certain()) return false;
    }
    for (const T* x : {&v.x, &v.y, &v.z}) (void)ask_(*x);
    return true;
  }
  [[nodiscard]] bool is_before(Index i, Index j) {
    const Vec<T> way = at(j) - at(i);
    for (const T* x : {&way.x, &way.y, &way.z}) {
      if (const Sign s = ask_(*x); s != Sign::zero) return s == Sign::positive;
    }
    return i < j;
  }

  /// The hull of some corners in one plane that is not seen edge on, or on one line, or at one point.
  void of_list(const Corners& of) {
    Index first = of[0];
    for (const Index i : of) first = is_before(i, first) ? i : first;
    Index from = first;
    do {  // gift wrapping
      f_.corners.push_back(from);
      std::optional<Index> next;
      for (const Index i : of) {
        if (i == from || is_none(at(i) - at(from))) continue;
        if (!next) {
          next = i;
          continue;
        }
        const Vec<T> way = at(*next) - at(from);
        const Sign turn = ask_(sparse_dot(out_, sparse_cross(way, at(i) - at(from))));
        if (turn == Sign::negative ||
            (turn == Sign::zero && ask_(sparse_dot(way, at(i) - at(*next))) == Sign::positive))
          next = i;
      }
      if (!next || !ask_.certain()) break;
      from = *next;
    } while (!is_none(at(from) - at(first)) && f_.corners.size() <= of.size());
    const std::size_t n = f_.corners.size();
    std::size_t descents = 0;  // of a polygon's corners as they are numbered there is one
    for (std::size_t i = 0; i < n; ++i) descents += f_.corners[(i + 1) % n] < f_.corners[i] ? 1 : 0;
    for (std::size_t i = 0; n > 1 && i < (n == 2 ? 1 : n); ++i) {
      const Index p = f_.corners[i], q = f_.corners[(i + 1) % n];
      const bool is_outline = n > 2 && c_.ways() == 0 && c_.polyhedron() == nullptr && !s_.view.is_hull();
      f_.edges.push_back(is_outline ? surface_feature(s_, FeatureKind::edge, descents == 1 ? p : q)
                                    : edge_between(s_, p, q));
    }
    f_.face = surface_feature(s_, FeatureKind::face, s_.view.is_hull() ? *std::ranges::min_element(of) : 0);
  }

  const Seen& s_;
  const CoreCorners& c_;
  const Vec<T>& out_;
  CertainSigns& ask_;
  Facing f_{};
};

}  // namespace plumb::query::touching
