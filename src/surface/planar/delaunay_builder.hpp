// How is the Delaunay triangulation of points built?  Points are inserted one after the other, edges flipped.
//
// Laws: the triangles are those whose circles hold no other point, under the perturbation of point_source.hpp where
// points lie on one circle: so they are the same for every order of insertion.  Equal points are one vertex, which gets
// the lowest of their labels.  Points that are all on one line have no triangle.
// Source: RTCD 12.5.1; Lawson 1977 (flips); Devillers, Pion and Teillaud 2002 (walks end in Delaunay triangulations).
// Cost: n log n expected over the rounds of insertion_order.hpp: a walk of some triangles and three flips a point.
#pragma once

#include <utility>
#include <vector>

#include "surface/planar/point_source.hpp"
#include "surface/planar/triangles.hpp"

namespace plumb::surface {

/// Is the edge to be flipped, so that its circle is empty?
template <PointSource Points>
bool should_flip(const Points& points, const Triangles& t, HalfEdge e) {
  const HalfEdge g = t.twin(e);
  const Vertex a = t.origin(e), b = t.origin(g), p = t.apex(e), d = t.apex(g);
  if (p == infinite || d == infinite) return false;
  if (a == infinite) return points.orient(d, b, p) == Sign::positive;
  if (b == infinite) return points.orient(a, d, p) == Sign::positive;
  const Sign inside = points.in_circle(a, b, p, d);
  return inside == Sign::positive || (inside == Sign::zero && is_lowered(points, a, b, p, d));
}

template <PointSource Points>
class DelaunayBuilder {
 public:
  DelaunayBuilder(Points& points, Triangles& triangles) : points_(points), triangles_(triangles) {}

  /// `same` gets for each vertex itself, or the vertex that has its point.
  void run(std::vector<Vertex>& same) {
    const auto n = static_cast<Vertex>(points_.size());
    same.resize(n);
    for (Vertex v = 0; v < n; ++v) same[v] = v;
    triangles_.clear();
    if (!begin()) return collect_line(same);
    triangles_.reserve(2 * std::size_t{n});
    for (Vertex v = 0; v < n; ++v) {
      if (v == corners_[0] || v == corners_[1] || v == corners_[2]) continue;
      same[v] = insert(v);
      if (same[v] != v) merge(same[v], v);
    }
    if (relabeled_) mend_ties();
  }

 private:
  // Makes a triangle in three ghosts of the first three points that are no line.
  bool begin() {
    const auto n = static_cast<Vertex>(points_.size());
    Vertex b = 1;
    while (b < n && points_.order(0, b) == Sign::zero) ++b;
    Vertex c = b + 1;
    Sign turn = Sign::zero;
    while (c < n && (turn = points_.orient(0, b, c)) == Sign::zero) ++c;
    if (c >= n) return false;
    if (turn == Sign::negative) std::swap(b, c);
    corners_ = {0, b, c};
    const HalfEdge inner = triangles_.add();
    triangles_.set(inner, 0, b, c);
    std::array<HalfEdge, 3> ghosts{};
    for (HalfEdge k = 0; k < 3; ++k) {
      ghosts[k] = triangles_.add();
      triangles_.set(ghosts[k], corners_[(k + 1) % 3], corners_[k], infinite);
      triangles_.join(inner + k, ghosts[k]);
    }
    // The ghost's second edge leaves corner k, as the third edge of the ghost before it comes to it.
    for (std::size_t k = 0; k < 3; ++k) triangles_.join(ghosts[k] + 1, ghosts[(k + 2) % 3] + 2);
    last_ = inner;
    return true;
  }

  struct Place {
    HalfEdge at;  // a half-edge of the triangle; that on which the point lies, or the one that leaves it
    int on;       // 0 inside, 1 on the half-edge, 2 at its origin
  };

  Place locate(Vertex p) const {
    HalfEdge at = last_, entered = none;
    while (true) {
      HalfEdge zero = none, beyond = none;
      int zeros = 0;
      for (HalfEdge k = 0; k < 3 && beyond == none; ++k) {
        const HalfEdge e = at + k;
        if (e == entered) continue;
        const Sign side = points_.orient(triangles_.origin(e), triangles_.target(e), p);
        if (side == Sign::negative) beyond = triangles_.twin(e);
        if (side != Sign::zero) continue;
        zero = zeros == 1 && triangles_.next(e) == zero ? zero : e;
        ++zeros;
      }
      if (beyond == none) return {zeros == 0 ? at : zero, zeros};
      entered = beyond;
      at = triangles_.first_of(beyond);
      if (triangles_.apex(beyond) == infinite) return {at, 0};
    }
  }

  /// The vertex itself, or the one that is there.
  Vertex insert(Vertex p) {
    const auto [at, on] = locate(p);
    if (on == 2) return triangles_.origin(at);
    std::array<HalfEdge, 4> rim{}, place{};
    std::size_t sides = 0;
    if (on == 0) {
      const HalfEdge first = triangles_.first_of(at);
      rim = {first, first + 1, first + 2};
      place = {first, triangles_.add(), triangles_.add()};
      sides = 3;
    } else {
      const HalfEdge back = triangles_.twin(at);
      rim = {triangles_.next(at), triangles_.previous(at), triangles_.next(back), triangles_.previous(back)};
      place = {triangles_.first_of(at), triangles_.add(), triangles_.first_of(back), triangles_.add()};
      sides = 4;
    }
    star(p, std::span(rim).first(sides), std::span(place).first(sides));
    last_ = place[0];
    for (std::size_t k = 0; triangles_.is_ghost(last_); ++k) last_ = place[k];
    return p;
  }

  // Triangles from p over the half-edges of a rim, the k-th at place[k]; then flips.
  void star(Vertex p, std::span<const HalfEdge> rim, std::span<const HalfEdge> place) {
    std::array<Vertex, 4> from{};
    std::array<HalfEdge, 4> beyond{};
    const std::size_t n = rim.size();
    for (std::size_t k = 0; k < n; ++k) {
      from[k] = triangles_.origin(rim[k]);
      beyond[k] = triangles_.twin(rim[k]);
    }
    for (std::size_t k = 0; k < n; ++k) triangles_.set(place[k], from[k], from[(k + 1) % n], p);
    for (std::size_t k = 0; k < n; ++k) {
      triangles_.join(place[k], beyond[k]);
      triangles_.join(place[k] + 1, place[(k + 1) % n] + 2);
      pending_.push_back(place[k]);
    }
    flip_pending(false);
  }

  // Around a point that was just inserted only the edges opposite to it can be wrong; else any edge can.
  void flip_pending(bool all_around) {
    while (!pending_.empty()) {
      const HalfEdge e = pending_.back();
      pending_.pop_back();
      if (!should_flip(points_, triangles_, e)) continue;
      const HalfEdge g = triangles_.twin(e);
      triangles_.flip(e);
      for (const HalfEdge opposite : {e, triangles_.next(g)}) pending_.push_back(opposite);
      if (!all_around) continue;
      for (const HalfEdge other : {triangles_.next(e), g}) pending_.push_back(other);
    }
  }

  void merge(Vertex kept, Vertex other) {
    if (points_.label(kept) < points_.label(other)) return;
    const std::uint32_t lower = points_.label(other);
    points_.relabel(other, points_.label(kept));
    points_.relabel(kept, lower);
    relabeled_ = true;
  }

  // Diagonals of four points on a circle, of which one has got a lower label since.
  void mend_ties() {
    for (HalfEdge first = 0; first < triangles_.end(); first += 4)
      for (HalfEdge k = 0; k < 3; ++k) pending_.push_back(first + k);
    flip_pending(true);
  }

  void collect_line(std::vector<Vertex>& same) {
    std::vector<Vertex> sorted = same;
    std::sort(sorted.begin(), sorted.end(), [&](Vertex l, Vertex r) {
      const Sign s = points_.order(l, r);
      return s == Sign::negative || (s == Sign::zero && points_.label(l) < points_.label(r));
    });
    for (std::size_t k = 1; k < sorted.size(); ++k)
      if (points_.order(sorted[k - 1], sorted[k]) == Sign::zero) same[sorted[k]] = same[sorted[k - 1]];
  }

  Points& points_;
  Triangles& triangles_;
  std::array<Vertex, 3> corners_{};
  HalfEdge last_ = 0;  // the first of a triangle that is no ghost
  std::vector<HalfEdge> pending_;
  bool relabeled_ = false;
};

}  // namespace plumb::surface
