// Points and segments become triangles: the steps of every triangulation, over any source of points.
//
//   auto made = triangulator_of(points);                // points as given, or exact ones
//   if (const auto crossing = made.constrain(segments)) ...
//   made.windings()                                     // how often the segments wind around each triangle
//
// Laws: those of delaunay.hpp, for vertices numbered in the order of insertion; `vertex(i)` is that of point i.
// Cost: that of the builders; windings are linear.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "surface/planar/constraint_builder.hpp"
#include "surface/planar/insertion_order.hpp"

namespace plumb::surface {

template <PointSource Points>
class Triangulator {
 public:
  /// The labels of the points are 0 up to their number, in any order.
  explicit Triangulator(Points points) : points_(std::move(points)), vertex_(points_.size()) {
    for (Vertex v = 0; v < points_.size(); ++v) vertex_[points_.label(v)] = v;
    DelaunayBuilder(points_, triangles_).run(same_);
  }

  [[nodiscard]] const Points& points() const { return points_; }
  [[nodiscard]] const Triangles& triangles() const { return triangles_; }
  /// The lowest index among the points that equal point i.
  [[nodiscard]] std::uint32_t same(std::uint32_t i) const { return points_.label(vertex(i)); }
  [[nodiscard]] Vertex vertex(std::uint32_t i) const { return same_[vertex_[i]]; }

  std::optional<Crossing> constrain(std::span<const std::array<std::uint32_t, 2>> segments) {
    if (triangles_.end() == 0) return {};
    std::vector<std::array<Vertex, 2>> between;
    between.reserve(segments.size());
    for (const auto& [a, b] : segments) between.push_back({vertex(a), vertex(b)});
    return ConstraintBuilder(points_, triangles_).run(between);
  }

  /// One for each triangle by its number, ghosts included; of them those are 0.
  [[nodiscard]] std::vector<std::int32_t> windings() const {
    constexpr auto unknown = std::numeric_limits<std::int32_t>::min();
    std::vector<std::int32_t> around(triangles_.end() / 4, unknown);
    std::vector<HalfEdge> pending;
    for (HalfEdge first = 0; first < triangles_.end() && pending.empty(); first += 4)
      if (triangles_.is_ghost(first)) pending.push_back(first);
    if (!pending.empty()) around[pending[0] / 4] = 0;
    while (!pending.empty()) {
      const HalfEdge first = pending.back();
      pending.pop_back();
      for (HalfEdge e = first; e < first + 3; ++e) {
        std::int32_t& beyond = around[triangles_.twin(e) / 4];
        if (beyond != unknown) continue;
        beyond = around[first / 4] - triangles_.mark(e).weight;
        pending.push_back(Triangles::first_of(triangles_.twin(e)));
      }
    }
    return around;
  }

 private:
  Points points_;
  std::vector<Vertex> vertex_, same_;  // of a point; the one that has a vertex's point
  Triangles triangles_;
};

/// Of points of which no two are equal; `lines` as ExactPoints takes them, and as long as the triangulator is asked.
inline Triangulator<ExactPoints> triangulator_of(std::span<const ExactPoint2> points,
                                                 std::span<const KnownLines> lines = {}) {
  std::vector<Point2> near;
  near.reserve(points.size());
  for (const ExactPoint2& p : points) near.push_back(approximate(p));
  return Triangulator(ExactPoints(points, insertion_order(near), lines));
}

inline Triangulator<GivenPoints> triangulator_of(std::span<const Point2> points) {
  return Triangulator(GivenPoints(points, insertion_order(points)));
}

}  // namespace plumb::surface
