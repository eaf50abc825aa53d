// Which triangle lies over which edge?  Triangles of the whole plane by half-edges, ready to be changed.
//
// Laws: half-edge 4 t + k goes from corner k of triangle t to the next, with the triangle on its left; the twin of its
// twin is itself.  What lies beyond the hull is triangles too, with `infinite` for a corner, so that every edge has two
// sides.  Numbers of triangles are never given back.
// Source: Guibas and Stolfi 1985; ghost triangles are Shewchuk's.
// Cost: 32 bytes a triangle, and as many for marks of its edges where there are constraints.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace plumb::surface {

inline constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
inline constexpr std::uint32_t infinite = none;  // the corner beyond the hull

using Vertex = std::uint32_t;
using HalfEdge = std::uint32_t;

/// What covers an edge: the least number of a constraint, and how many go along the half-edge less those that go back.
struct EdgeMark {
  std::uint32_t constraint = none;
  std::int32_t weight = 0;
};

class Triangles {
 public:
  static constexpr HalfEdge next(HalfEdge e) { return (e & 3) == 2 ? e - 2 : e + 1; }
  static constexpr HalfEdge previous(HalfEdge e) { return (e & 3) == 0 ? e + 2 : e - 1; }
  static constexpr HalfEdge first_of(HalfEdge e) { return e & ~HalfEdge{3}; }

  void clear() {
    all_.clear();
    marks_.reset();
  }
  void reserve(std::size_t triangles) { all_.reserve(triangles); }

  [[nodiscard]] HalfEdge end() const { return static_cast<HalfEdge>(4 * all_.size()); }
  [[nodiscard]] Vertex origin(HalfEdge e) const { return all_[e >> 2].origin[e & 3]; }
  [[nodiscard]] Vertex target(HalfEdge e) const { return origin(next(e)); }
  [[nodiscard]] Vertex apex(HalfEdge e) const { return origin(previous(e)); }
  [[nodiscard]] HalfEdge twin(HalfEdge e) const { return all_[e >> 2].twin[e & 3]; }
  /// The next half-edge counterclockwise from the same corner.
  [[nodiscard]] HalfEdge turned(HalfEdge e) const { return twin(previous(e)); }
  [[nodiscard]] bool is_ghost(HalfEdge e) const {
    const auto& o = all_[e >> 2].origin;
    return o[0] == infinite || o[1] == infinite || o[2] == infinite;
  }

  /// The first half-edge of a new triangle.
  HalfEdge add() {
    all_.emplace_back();
    return static_cast<HalfEdge>(4 * (all_.size() - 1));
  }
  void set(HalfEdge first, Vertex a, Vertex b, Vertex c) { all_[first >> 2].origin = {a, b, c}; }
  void join(HalfEdge e, HalfEdge g) {
    all_[e >> 2].twin[e & 3] = g;
    all_[g >> 2].twin[g & 3] = e;
  }

  /// The edge between a and b, seen from p and d, becomes that between p and d.  Afterwards e goes from d to b with
  /// apex p, the next half-edge of the former twin from a to d, also with apex p; the new edge comes before e.
  void flip(HalfEdge e) {
    const HalfEdge g = twin(e), e2 = previous(e), g2 = previous(g);
    const Vertex p = origin(e2), d = origin(g2);
    const HalfEdge beyond_e2 = twin(e2), beyond_g2 = twin(g2);
    all_[e >> 2].origin[e & 3] = d;
    all_[g >> 2].origin[g & 3] = p;
    join(e, beyond_g2);
    join(g, beyond_e2);
    join(e2, g2);
    if (has_marks()) {
      set_mark(e, mark(g2));
      set_mark(g, mark(e2));
      set_mark(e2, {});
      set_mark(g2, {});
    }
  }

  /// A number for the triangle, 0 at first.
  [[nodiscard]] std::uint32_t place(HalfEdge e) const { return all_[e >> 2].place; }
  void set_place(HalfEdge e, std::uint32_t place) { all_[e >> 2].place = place; }

  /// From here on edges have marks; no triangle is added any more.
  void mark_edges() { marks_ = std::make_unique_for_overwrite<EdgeMark[]>(end()); }
  [[nodiscard]] bool has_marks() const { return marks_ != nullptr; }
  [[nodiscard]] bool is_constrained(HalfEdge e) const { return (all_[e >> 2].constrained >> (e & 3) & 1) != 0; }
  [[nodiscard]] EdgeMark mark(HalfEdge e) const { return is_constrained(e) ? marks_[e] : EdgeMark{}; }
  void set_mark(HalfEdge e, const EdgeMark& to) {
    std::uint32_t& bits = all_[e >> 2].constrained;
    bits &= ~(1U << (e & 3));
    if (to.constraint == none) return;
    bits |= 1U << (e & 3);
    marks_[e] = to;
  }

 private:
  struct Triangle {
    std::array<Vertex, 3> origin;
    std::uint32_t constrained;  // bit k is that of half-edge k; only then it has a mark
    std::array<HalfEdge, 3> twin;
    std::uint32_t place;
  };
  std::vector<Triangle> all_;
  std::unique_ptr<EdgeMark[]> marks_;  // written before they are read: one for each half-edge that is constrained
};

}  // namespace plumb::surface
