#include "lab/stability/space_hull_ways.hpp"

#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "lab/stability/hull_ways.hpp"

namespace plumb::lab::stability {
namespace {

using Index = std::uint32_t;
using Indices = std::vector<Index>;
using SpaceSigns = HullSigns<3>;
using Corners3 = SpaceSigns::Facet;  // counterclockwise seen from outside
using Edge = std::pair<Index, Index>;

std::array<Edge, 3> edges_of(const Corners3& f) { return {{{f[0], f[1]}, {f[1], f[2]}, {f[2], f[0]}}}; }

/// The faces of four points that span space, the first and the last of the order among them; none of points in a plane.
std::vector<Corners3> first_simplex(const SpaceSigns& s, const Indices& order) {
  for (const Index c : order) {
    for (const Index d : order) {
      const Index a = order.front(), b = order.back();
      const int side = s.side({a, b, c}, d);
      if (side < 0) return {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
      if (side > 0) return {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
    }
  }
  return {};
}

/// Those that are no corner of the simplex, in the order in which they are given.
Indices others(Indices order, const std::vector<Corners3>& simplex) {
  std::erase_if(order, [&](Index p) {
    return std::ranges::any_of(simplex, [p](const Corners3& f) { return std::ranges::find(f, p) != f.end(); });
  });
  std::ranges::sort(order);
  return order;
}

Faces listed(const std::vector<Corners3>& triangles) {
  Faces faces;
  for (const Corners3& t : triangles) faces.emplace_back(t.begin(), t.end());
  return faces;
}

/// The edges of these faces that none of them has on its other side.
std::vector<Edge> rim_of(const std::vector<Corners3>& faces) {
  std::set<Edge> edges;
  for (const Corners3& f : faces) {
    for (const Edge& e : edges_of(f)) edges.insert(e);
  }
  std::vector<Edge> rim;
  std::ranges::copy_if(edges, std::back_inserter(rim), [&](const Edge& e) {
    return !edges.contains({e.second, e.first});
  });
  return rim;
}

/// Point after point: the faces that see it give way to those that join it to their rim.
std::optional<Faces> incremental(const SpaceSigns& s) {
  const Indices order = s.in_order();
  std::vector<Corners3> faces = first_simplex(s, order);
  if (faces.empty()) return Faces{};
  for (const Index p : others(order, faces)) {
    const auto seeing =
        std::partition(faces.begin(), faces.end(), [&](const Corners3& f) { return s.side(f, p) <= 0; });
    const std::vector<Edge> rim = rim_of({seeing, faces.end()});
    faces.erase(seeing, faces.end());
    for (const auto& [a, b] : rim) faces.push_back({a, b, p});
    if (faces.size() > order.size() * order.size()) return std::nullopt;  // a torn surface may grow without end
  }
  return listed(faces);
}

/// The farthest point of a face's own, again and again; the rim of what sees it is walked from edge to edge.
class Quickhull {
 public:
  explicit Quickhull(const SpaceSigns& s) : s_(s) {}

  std::optional<Faces> run() {
    const Indices order = s_.in_order();
    const std::vector<Corners3> simplex = first_simplex(s_, order);
    if (simplex.empty()) return Faces{};
    for (const Corners3& f : simplex) add(f);
    hand_out(others(order, simplex), 0);
    for (std::size_t at = 0; at < faces_.size(); ++at) {  // new faces come last: each is looked at
      if (faces_[at].gone || faces_[at].outside.empty()) continue;
      if (!take_farthest(at)) return std::nullopt;
    }
    std::vector<Corners3> left;
    for (const Face& f : faces_) {
      if (!f.gone) left.push_back(f.corners);
    }
    return listed(left);
  }

 private:
  struct Face {
    Corners3 corners;
    Indices outside;  // points that see it, each of them kept by one face
    bool gone = false;
  };

  void add(const Corners3& corners) {
    for (const Edge& e : edges_of(corners)) left_of_[e] = faces_.size();
    faces_.push_back({corners, {}});
  }

  /// To each point the first that it sees of the faces from `first` on.
  void hand_out(const Indices& points, std::size_t first) {
    for (const Index p : points) {
      const auto sees = [&](const Face& f) { return s_.side(f.corners, p) > 0; };
      const auto face = std::find_if(faces_.begin() + static_cast<std::ptrdiff_t>(first), faces_.end(), sees);
      if (face != faces_.end()) face->outside.push_back(p);
    }
  }

  bool take_farthest(std::size_t face) {
    Index p = faces_[face].outside.front();
    for (const Index q : faces_[face].outside) {
      if (s_.farther(faces_[face].corners, q, p) > 0) p = q;
    }
    std::vector<std::size_t> seeing{face};  // from neighbor to neighbor
    faces_[face].gone = true;
    for (std::size_t i = 0; i < seeing.size(); ++i) {
      for (const auto& [a, b] : edges_of(faces_[seeing[i]].corners)) {
        const auto across = left_of_.find({b, a});
        if (across == left_of_.end()) continue;
        Face& neighbor = faces_[across->second];
        if (neighbor.gone || s_.side(neighbor.corners, p) <= 0) continue;
        neighbor.gone = true;
        seeing.push_back(across->second);
      }
    }
    std::vector<Corners3> lost;
    Indices homeless;
    for (const std::size_t f : seeing) {
      lost.push_back(faces_[f].corners);
      std::ranges::copy_if(faces_[f].outside, std::back_inserter(homeless), [p](Index q) { return q != p; });
    }
    const std::vector<Edge> rim = rim_of(lost);
    if (rim.empty()) return true;
    const std::size_t first = faces_.size();
    Edge at = rim.front();
    do {
      if (faces_.size() - first == rim.size()) return false;  // it is not back where it began
      add({at.first, at.second, p});
      const auto next = std::ranges::find(rim, at.second, &Edge::first);
      if (next == rim.end()) return false;  // a search that goes round and round
      at = *next;
    } while (at != rim.front());
    hand_out(homeless, first);
    return true;
  }

  const SpaceSigns& s_;
  std::vector<Face> faces_;
  std::map<Edge, std::size_t> left_of_;
};

/// From a face over each of its edges to the next, which all points in its plane belong to.
class GiftWrapping {
 public:
  explicit GiftWrapping(const SpaceSigns& s) : s_(s), order_(s.in_order()) {}

  std::optional<Faces> run() {
    const std::optional<Corners3> first = any_face();
    if (!first) return Faces{};
    if (!add(*first)) return std::nullopt;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Indices face = faces_[f];
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Index a = face[i], b = face[(i + 1) % face.size()];
        if (edges_.contains({b, a})) continue;
        const std::optional<Index> next = turned_about(a, b, face[(i + 2) % face.size()]);
        if (next && !add({b, a, *next})) return std::nullopt;
        if (faces_.size() > 2 * order_.size()) return std::nullopt;
      }
    }
    return faces_;
  }

 private:
  /// Through the first point, which is a corner, and two others: nothing is outside, and something inside.
  std::optional<Corners3> any_face() const {
    for (const Index b : order_) {
      for (const Index c : order_) {
        bool outside = false, inside = false;
        for (std::size_t i = 0; i < order_.size() && !outside; ++i) {
          const int side = s_.side({order_.front(), b, c}, order_[i]);
          outside = side > 0;
          inside = inside || side < 0;
        }
        if (inside && !outside) return Corners3{order_.front(), b, c};
      }
    }
    return {};
  }

  /// The face that all points in the plane make; false where wrapping them does not end.
  bool add(const Corners3& plane) {
    Indices within;
    Index below = plane[0];
    for (const Index p : order_) {
      const int side = s_.side(plane, p);
      if (side == 0 || std::ranges::find(plane, p) != plane.end()) within.push_back(p);
      if (side < 0) below = p;
    }
    const Corners corners = wrapped(s_, within, [&](Index a, Index b, Index c) { return -s_.side({a, b, c}, below); });
    if (!corners) return false;
    if (corners->size() < 3) return true;
    faces_.push_back(*corners);
    for (std::size_t i = 0; i < corners->size(); ++i)
      edges_.insert({(*corners)[i], (*corners)[(i + 1) % corners->size()]});
    return true;
  }

  /// The outermost of the points below the plane of a, b and c, seen about the edge from a to b.
  std::optional<Index> turned_about(Index a, Index b, Index c) const {
    std::optional<Index> next;
    for (const Index p : order_) {
      if (s_.side({a, b, c}, p) < 0 && (!next || s_.side({b, a, *next}, p) > 0)) next = p;
    }
    return next;
  }

  const SpaceSigns& s_;
  Indices order_;
  Faces faces_;
  std::set<Edge> edges_;
};

}  // namespace

const std::vector<SpaceHullWay>& space_hull_ways() {
  static const std::vector<SpaceHullWay> all{
      {"quickhull", "adds the farthest point outside of a face, again and again",
       [](const SpaceSigns& s) { return Quickhull(s).run(); }},
      {"incremental", "adds a point after the other, in the order in which they come", incremental},
      {"gift wrapping", "turns about the edges of a face until it finds the next",
       [](const SpaceSigns& s) { return GiftWrapping(s).run(); }}};
  return all;
}

}  // namespace plumb::lab::stability
