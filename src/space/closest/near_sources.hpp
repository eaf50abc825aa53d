// Where do the triangles of a search for the closest pair stand?  As given, or under a pose: a source says it.
//
// A source has places (descend_pairs.hpp) whose nodes have boxes of doubles; the triangle in each slot, exactly; where its
// vertices are in boxes of doubles, and how far apart points of such a box can be; and the questions that two exact triangles are asked.
// Law: a node's box contains what is below it; off() is no less than the diagonal of any box that was made of a vertex.
// Source: RTCD 3.2, 4.2.6.
// Cost: of a node a conversion, where it has been moved a posed box, once.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "plumb/query/closest/closest.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/bvh/mesh_view.hpp"
#include "query/closest/posed_triangle.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/closest/nearby_triangle.hpp"
#include "space/closest/posed_places.hpp"

namespace plumb::space {

/// The nodes of a tree in boxes of doubles.
class StandingPlaces {
 public:
  explicit StandingPlaces(const BoxTree& tree) : frame_(tree.frame), nodes_(tree.nodes.view()) {}
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] BoxedNode operator[](std::uint32_t i) const {
    const BoxNode& n = nodes_[i];
    const auto wide = [](const std::array<float, 3>& p) {
      return Point3{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    };
    return {frame_.exponent() == 0 ? Aabb3{wide(n.min), wide(n.max)} : frame_.outside(n.box()), n.link, n.count};
  }
  template <class Take>
  friend void for_children(const StandingPlaces& places, std::uint32_t i, const Take& take) {
    for_children(places.nodes_, i, take);
  }

 private:
  BoxFrame frame_;
  std::span<const BoxNode> nodes_;
};

class StandingSource {
 public:
  using Triangle = Triangle3;
  /// Guesses of what pays: so many pairs wait before they are compared exactly, so many before a wall is built.
  static constexpr std::size_t most_waiting = 8, offers_before_wall = 64;
  static constexpr bool has_exact_boxes = true;

  explicit StandingSource(const Bvh& bvh) : bvh_(bvh), places_(bvh.tree) {}
  [[nodiscard]] const Bvh& bvh() const { return bvh_; }
  [[nodiscard]] const StandingPlaces& places() const { return places_; }
  [[nodiscard]] Triangle3 triangle(std::uint32_t slot) const { return bvh_.triangle(slot); }
  [[nodiscard]] Aabb3 around_vertex(std::uint32_t i) const { return {bvh_.vertices[i], bvh_.vertices[i]}; }
  [[nodiscard]] static double off() { return 0; }
  [[nodiscard]] static AnyPoseView pose() { return {}; }
  [[nodiscard]] static const Triangle3& as_given(const Triangle3& t) { return t; }

  /// Says yes only of triangles that are farther apart.
  static bool are_beyond(const Triangle3& s, const Triangle3& t, double distance) {
    return query::quick_comparison(s, t, distance) == Sign::positive;
  }
  static bool meet(const Triangle3& s, const Triangle3& t) { return relate(s, t) != Relation::disjoint; }
  static double distance(const Triangle3& s, const Triangle3& t) { return plumb::distance(s, t); }
  static Rational square(const Triangle3& s, const Triangle3& t) { return squared_distance_exact(s, t); }
  static Closest closest(const Triangle3& s, const Triangle3& t) { return closest_points(s, t); }
  /// These are as far apart as the triangles, where that is known at once.
  static std::optional<std::array<Feature, 2>> features(const Triangle3& s, const Triangle3& t) {
    const Closest c = closest_points(s, t);
    return std::array{c.feature_a, c.feature_b};
  }

 private:
  const Bvh& bvh_;
  StandingPlaces places_;
};

class PosedSource {
 public:
  using Triangle = PosedTriangle;
  static constexpr std::size_t most_waiting = 64, offers_before_wall = 3;
  static constexpr bool has_exact_boxes = false;

  explicit PosedSource(const PosedMesh& mesh) : mesh_(mesh), places_(mesh) {}
  [[nodiscard]] const Bvh& bvh() const { return mesh_.bvh; }
  [[nodiscard]] const PosedPlaces<Bvh>& places() const { return places_; }
  [[nodiscard]] Triangle triangle(std::uint32_t slot) const { return mesh_.triangle(slot); }
  [[nodiscard]] Aabb3 around_vertex(std::uint32_t i) {
    const Aabb3 box = around(mesh_.pose, mesh_.bvh.vertices[i]);
    off_ = std::max(off_, far_within(box));
    return box;
  }
  [[nodiscard]] double off() const { return off_; }
  [[nodiscard]] AnyPoseView pose() const { return mesh_.pose.any_view(); }
  /// What is one feature before the pose is one under it.
  [[nodiscard]] static const Triangle3& as_given(const Triangle& t) { return t.shape; }

  static bool are_beyond(const Triangle& s, const Triangle& t, double distance) {
    return distance_below(NearbyTriangle(s), NearbyTriangle(t)) > distance;
  }
  static bool meet(const Triangle& s, const Triangle& t) { return query::relate(s, t) != Relation::disjoint; }
  static double distance(const Triangle& s, const Triangle& t) { return query::distance(s, t); }
  static Rational square(const Triangle& s, const Triangle& t) { return query::squared_distance_exact(s, t); }
  static Closest closest(const Triangle& s, const Triangle& t) { return query::closest_points(s, t); }
  static std::optional<std::array<Feature, 2>> features(const Triangle& s, const Triangle& t) {
    return query::quick_features(s, t);
  }

 private:
  const PosedMesh& mesh_;
  PosedPlaces<Bvh> places_;
  double off_ = 0;
};

/// Two meshes that are asked how near they are.
struct AskedPair {
  PosedMesh a, b;

  AskedPair(const char* function, const BvhView& x, const BvhView& y)
      : a(under_pose(function, "a", x)), b(under_pose(function, "b", y)) {}
  [[nodiscard]] bool stand() const { return a.pose == MeshPose(identity_pose) && b.pose == MeshPose(identity_pose); }
  /// Under one rigid pose no distance changes.
  [[nodiscard]] bool are_moved_as_one() const { return a.pose.matrix() == nullptr && a.pose == b.pose; }

 private:
  static PosedMesh under_pose(const char* function, const char* name, const BvhView& view) {
    const MeshPose* const pose = view.pose();
    if (pose != nullptr) require_pose(function, name, *pose);
    return view.visit([&](const Bvh& bvh) { return pose != nullptr ? PosedMesh(bvh, *pose) : PosedMesh(bvh); });
  }
};

}  // namespace plumb::space
