// How does a Delaunay triangulation get edges that must be there?  Segments are walked, what they cross is cut anew.
//
// Laws: with all segments in, no edge crosses one, and the triangulation is the constrained Delaunay triangulation:
// each edge that no segment covers is the one that should_flip keeps.  A vertex on a segment divides it; segments may
// overlap.  Two segments that cross between vertices are told, and the triangulation is of no use then.
// Source: RTCD 12.5.1; Anglada 1997 (cavities); Toussaint and Avis 1982 (a chain that is seen from an edge is cut by
// one scan); Shewchuk and Brown 2015 (why the segments are taken in random rounds); Chiba and Nishizeki 1985 (the sum
// of the lesser degrees over the edges of a planar graph is linear).
// Cost: linear where the segments are edges already; otherwise what they cross, and flips.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "surface/planar/delaunay_builder.hpp"
#include "surface/planar/insertion_order.hpp"

namespace plumb::surface {

/// The numbers of two constraints that cross.
using Crossing = std::array<std::uint32_t, 2>;

template <PointSource Points>
class ConstraintBuilder {
 public:
  ConstraintBuilder(const Points& points, Triangles& triangles)
      : points_(points), triangles_(triangles), leaving_(points.size(), none), degree_(points.size()) {
    triangles_.mark_edges();
    for (HalfEdge first = 0; first < triangles_.end(); first += 4) {
      for (HalfEdge e = first; e < first + 3; ++e) {
        if (triangles_.origin(e) == infinite) continue;
        leaving_[triangles_.origin(e)] = e;
        ++degree_[triangles_.origin(e)];
      }
    }
  }

  /// Segments between vertices; equal ends are none.
  std::optional<Crossing> run(std::span<const std::array<Vertex, 2>> segments) {
    std::vector<std::uint32_t> missing;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
      const auto& [a, b] = segments[i];
      if (a == b) continue;
      if (const HalfEdge e = edge_between(a, b); e != none)
        cover(e, i);
      else
        missing.push_back(i);
    }
    // In random rounds, the smallest first, and within a round as they were given: those of a path are neighbors.
    std::vector<std::vector<std::uint32_t>> rounds;
    for (const std::uint32_t i : missing) {
      const auto r = static_cast<std::size_t>(rounds_before_last(i));
      if (r >= rounds.size()) rounds.resize(r + 1);
      rounds[r].push_back(i);
    }
    for (std::size_t r = rounds.size(); r-- > 0;)
      for (const std::uint32_t i : rounds[r])
        if (const auto crossing = insert(segments[i][0], segments[i][1], i)) return crossing;
    return {};
  }

 private:
  HalfEdge edge_between(Vertex a, Vertex b) const {
    const bool swapped = degree_[b] < degree_[a];
    if (swapped) std::swap(a, b);
    const HalfEdge start = leaving_[a];
    HalfEdge e = start;
    do {
      if (triangles_.target(e) == b) return swapped ? triangles_.twin(e) : e;
      e = triangles_.turned(e);
    } while (e != start);
    return none;
  }

  // Segment i goes along e.
  void cover(HalfEdge e, std::uint32_t i) {
    for (const auto& [half, by] : {std::pair{e, 1}, std::pair{triangles_.twin(e), -1}}) {
      const EdgeMark mark = triangles_.mark(half);
      triangles_.set_mark(half, {std::min(mark.constraint, i), mark.weight + by});
    }
  }

  std::optional<Crossing> insert(Vertex a, Vertex b, std::uint32_t i) {
    const bool swapped = degree_[b] < degree_[a];
    if (swapped) std::swap(a, b);
    while (a != b) {
      const HalfEdge first = toward(a, b);
      HalfEdge piece = first;
      if (triangles_.origin(first) != a) {
        if (const auto crossed = cross(a, b, first)) return Crossing{*crossed, i};
        piece = retriangulate(a);
      }
      const Vertex reached = triangles_.target(piece);
      cover(swapped ? triangles_.twin(piece) : piece, i);
      settle();
      a = reached;
    }
    return {};
  }

  // Returns the half-edge from a along the segment, or the one opposite to a that the segment crosses first.
  HalfEdge toward(Vertex a, Vertex b) const {
    const Sign way = points_.order(a, b);
    HalfEdge e = leaving_[a];
    Sign last = Sign::positive;
    while (true) {
      const Vertex u = triangles_.target(e);
      Sign side = Sign::positive;  // the segment does not leave the hull
      if (u == b) return e;
      if (u != infinite) side = points_.orient(a, b, u);
      if (side == Sign::zero && points_.order(a, u) == way) return e;
      if (u != infinite && side == Sign::positive && last == Sign::negative)
        return triangles_.previous(triangles_.twin(e));
      last = side;
      e = triangles_.turned(e);
    }
  }

  // An edge of the hole, seen from inside: as it was, what lies beyond, and where it will be.
  struct Rim {
    HalfEdge old, beyond;
    EdgeMark mark, mark_beyond;
    HalfEdge now;
  };
  struct Chain {
    std::vector<Vertex> corners;
    std::vector<Rim> rim;  // rim[k] is between corners k and k + 1
  };

  void extend(Chain& chain, Vertex corner, HalfEdge e) {
    const HalfEdge beyond = triangles_.twin(e);
    chain.corners.push_back(corner);
    chain.rim.push_back({e, beyond, triangles_.mark(e), triangles_.mark(beyond), none});
  }

  void take_out(HalfEdge e) {
    triangles_.set_place(e, static_cast<std::uint32_t>(hole_.size()));
    hole_.push_back(Triangles::first_of(e));
  }

  // The number of a half-edge among those of the triangles that were taken out; `none` for another.
  std::size_t in_hole(HalfEdge e) const {
    const std::size_t place = triangles_.place(e);
    if (place >= hole_.size() || hole_[place] != Triangles::first_of(e)) return none;
    return 4 * place + (e & 3);
  }

  // Walks from a over e to the first vertex on the segment; returns the constraint that is in the way, if any.
  std::optional<std::uint32_t> cross(Vertex a, Vertex b, HalfEdge e) {
    left_.corners.assign(1, a);
    right_.corners.assign(1, a);
    left_.rim.clear();
    right_.rim.clear();
    hole_.clear();
    take_out(e);
    crossed_.clear();
    extend(right_, triangles_.origin(e), Triangles::previous(e));
    extend(left_, triangles_.target(e), Triangles::next(e));
    while (true) {
      if (triangles_.is_constrained(e)) return triangles_.mark(e).constraint;
      crossed_.push_back({triangles_.origin(e), triangles_.target(e)});
      const HalfEdge g = triangles_.twin(e);
      take_out(g);
      const Vertex w = triangles_.apex(g);
      const HalfEdge to_right = Triangles::next(g), to_left = Triangles::previous(g);
      const Sign side = w == b ? Sign::zero : points_.orient(a, b, w);
      if (side != Sign::negative) extend(left_, w, to_left);
      if (side != Sign::positive) extend(right_, w, to_right);
      if (side == Sign::zero) return {};
      e = side == Sign::positive ? to_right : to_left;
    }
  }

  // Fills the hole; returns the half-edge from a to where the walk has ended.
  HalfEdge retriangulate(Vertex a) {
    for (const auto& [u, v] : crossed_) {
      --degree_[u];
      --degree_[v];
    }
    next_place_ = 0;
    const HalfEdge along = scan(left_, Sign::negative), back = scan(right_, Sign::positive);
    triangles_.join(along, back);
    for (const HalfEdge e : {along, back}) triangles_.set_mark(e, {});
    const Vertex end = left_.corners.back();
    ++degree_[a];
    ++degree_[end];
    leaving_[a] = along;
    leaving_[end] = back;
    // An edge may have the hole on both sides.
    renamed_.resize(std::max(renamed_.size(), 4 * hole_.size()));
    for (const Chain* chain : {&left_, &right_})
      for (const Rim& r : chain->rim) renamed_[in_hole(r.old)] = r.now;
    for (const Chain* chain : {&left_, &right_}) {
      for (const Rim& r : chain->rim) {
        const std::size_t inside = in_hole(r.beyond);
        const HalfEdge beyond = inside == none ? r.beyond : renamed_[inside];
        triangles_.join(r.now, beyond);
        triangles_.set_mark(r.now, r.mark);
        triangles_.set_mark(beyond, r.mark_beyond);
      }
    }
    return along;
  }

  struct Kept {
    Vertex corner;
    bool is_rim;
    std::uint32_t edge;  // between the corner before and this one: its place in the rim, or the half-edge over it
  };

  // Cuts what is between a chain and the segment: wherever the chain bulges, a triangle goes off.  The half-edge of the
  // segment is given.  `bulge` is the turn of three corners between which a triangle fits.
  HalfEdge scan(Chain& chain, Sign bulge) {
    kept_.assign(1, {chain.corners[0], true, 0});
    const auto close = [&](HalfEdge e, const Kept& by) {
      if (by.is_rim) {
        chain.rim[by.edge].now = e;
      } else {
        triangles_.join(e, by.edge);
        pending_.push_back(e);
        for (const HalfEdge half : {e, by.edge}) triangles_.set_mark(half, {});
        ++degree_[triangles_.origin(e)];
        ++degree_[triangles_.target(e)];
      }
    };
    for (std::uint32_t k = 1; k < chain.corners.size(); ++k) {
      Kept now{chain.corners[k], true, k - 1};
      while (kept_.size() > 1) {
        const Kept tip = kept_.back();
        const Vertex before = kept_[kept_.size() - 2].corner;
        if (points_.orient(before, tip.corner, now.corner) != bulge) break;
        const HalfEdge e = hole_[next_place_++];
        if (bulge == Sign::negative) {
          triangles_.set(e, before, now.corner, tip.corner);
          close(e + 1, now);
          close(e + 2, tip);
          now.edge = e;
        } else {
          triangles_.set(e, before, tip.corner, now.corner);
          close(e, tip);
          close(e + 1, now);
          now.edge = e + 2;
        }
        for (HalfEdge h = e; h < e + 3; ++h) leaving_[triangles_.origin(h)] = h;
        now.is_rim = false;
        kept_.pop_back();
      }
      kept_.push_back(now);
    }
    return kept_.back().edge;
  }

  void settle() {
    while (!pending_.empty()) {
      const HalfEdge e = pending_.back();
      pending_.pop_back();
      if (triangles_.is_constrained(e) || !should_flip(points_, triangles_, e)) continue;
      const HalfEdge g = triangles_.twin(e);
      --degree_[triangles_.origin(e)];
      --degree_[triangles_.origin(g)];
      triangles_.flip(e);
      for (const HalfEdge around : {e, Triangles::next(e), g, Triangles::next(g)}) {
        leaving_[triangles_.origin(around)] = around;
        pending_.push_back(around);
      }
      ++degree_[triangles_.origin(e)];
      ++degree_[triangles_.origin(g)];
    }
  }

  const Points& points_;
  Triangles& triangles_;
  std::vector<HalfEdge> leaving_;  // one half-edge of each vertex
  std::vector<std::uint32_t> degree_;
  Chain left_, right_;
  std::vector<HalfEdge> hole_;  // triangles that are taken out
  std::vector<std::array<Vertex, 2>> crossed_;
  std::size_t next_place_ = 0;  // in the hole
  std::vector<Kept> kept_;
  std::vector<HalfEdge> pending_;
  std::vector<HalfEdge> renamed_;  // by in_hole
};

}  // namespace plumb::surface
