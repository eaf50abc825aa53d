// Which pairs of triangles are surely no nearer than the nearest pair as yet?
//
// The way from one closest point to the other keeps the two triangles apart, and with them all pairs of which one lies
// behind the first point along it and the other ahead of the second.
// Law: what a wall stops is no nearer than the pair that it was built for.
// Source: RTCD 5.1.10, 9.5.
// Cost: the closest points exactly, and a sign a vertex, which is kept.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "plumb/space/bvh/posed_mesh.hpp"
#include "query/closest/posed_triangle.hpp"
#include "space/closest/vertex_sides.hpp"

namespace plumb::space {

class NearWall {
 public:
  NearWall(const PosedMesh& a, const PosedMesh& b) : a_(a), b_(b) {}

  [[nodiscard]] bool is_built() const { return wall_.has_value(); }
  void clear() { wall_.reset(); }
  void build(std::uint32_t slot_a, std::uint32_t slot_b) {
    const PosedTriangle s = a_.triangle(slot_a), t = b_.triangle(slot_b);
    const auto quick = query::quick_closest_points(s, t);
    wall_ = Wall{quick ? std::optional(Slab<Ball>(*quick)) : std::nullopt,
                 Slab<BigDyadic>(query::exact_closest_points(s, t)), VertexSides(a_.bvh.vertices.size()),
                 VertexSides(b_.bvh.vertices.size())};
  }

  [[nodiscard]] bool stops(std::uint32_t slot_a, std::uint32_t slot_b) {
    if (!wall_) return false;
    return std::ranges::all_of(a_.bvh.triangles[slot_a], [&](std::uint32_t v) { return is_behind(v); }) &&
           std::ranges::all_of(b_.bvh.triangles[slot_b], [&](std::uint32_t v) { return is_ahead(v); });
  }

 private:
  template <class T>
  struct Slab {
    query::Vec3<T> way;  // from the closest point of a to that of b, of any length
    T weight_a, weight_b, from, to;

    explicit Slab(const query::WeightedPair<T>& p)
        : way(p[1].at * p[0].weight - p[0].at * p[1].weight),
          weight_a(p[0].weight),
          weight_b(p[1].weight),
          from(dot(p[0].at, way)),
          to(dot(p[1].at, way)) {}
    /// Of a point times a weight.
    [[nodiscard]] T beyond_from(const query::Vec3<T>& p, const T& weight) const {
      return dot(p, way) * weight_a - from * weight;
    }
    [[nodiscard]] T before_to(const query::Vec3<T>& p, const T& weight) const {
      return to * weight - dot(p, way) * weight_b;
    }
  };
  struct Wall {
    std::optional<Slab<Ball>> quick;
    Slab<BigDyadic> exact;
    VertexSides sides_a, sides_b;
  };

  static Ball nothing() { return {0, 0, Ball::infinity}; }

  bool is_behind(std::uint32_t vertex) {
    const auto at = [&]<class T>(const Slab<T>& slab) {
      const auto by = query::weighted_pose<T>(a_.pose.any_view());
      return slab.beyond_from(by.image(query::vector_of<T>(a_.bvh.vertices[vertex])), by.weight);
    };
    return !wall_->sides_a.is_beyond(
        vertex, [&] { return wall_->quick ? at(*wall_->quick) : nothing(); }, [&] { return at(wall_->exact); });
  }
  bool is_ahead(std::uint32_t vertex) {
    const auto at = [&]<class T>(const Slab<T>& slab) {
      const auto by = query::weighted_pose<T>(b_.pose.any_view());
      return slab.before_to(by.image(query::vector_of<T>(b_.bvh.vertices[vertex])), by.weight);
    };
    return !wall_->sides_b.is_beyond(
        vertex, [&] { return wall_->quick ? at(*wall_->quick) : nothing(); }, [&] { return at(wall_->exact); });
  }

  const PosedMesh &a_, &b_;
  std::optional<Wall> wall_;
};

}  // namespace plumb::space
