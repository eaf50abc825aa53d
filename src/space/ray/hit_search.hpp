// What is looked for along a ray: the first hit, any, or all?  Visitors of the triangles that a ray may hit.
//
//   FirstHit search(ray, slabs.keys(), bvh, rule);     // of a posed mesh (ray, seen, mesh, rule)
//   const RayTask task = search.task(slabs);
//   visit_triangles(bvh, {&task, 1});
//   search.slot()
//
// Law: what they answer is what first_hit and hits say of each triangle alone; parameters that doubles cannot tell apart
// are compared exactly, and equal ones go by the triangles' numbers.
// Source: RTCD 5.3.6.
// Cost: an exact question for triangles that doubles leave in doubt, and for parameters that they do.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "plumb/query/ray/hits.hpp"
#include "plumb/space/ray/mesh_ray.hpp"
#include "plumb/space/ray/ray_slabs.hpp"
#include "query/ray/triangle_hit.hpp"
#include "space/bvh/slot_triangles.hpp"
#include "space/ray/seen_ray.hpp"
#include "space/ray/wide_rays.hpp"

namespace plumb::space {

class HitSearch : public TriangleVisitor {
 public:
  /// Of a Bvh or a CompactBvh.
  template <class Mesh>
  HitSearch(const AnyRay& ray, const RaySlabs::Keys& keys, const Mesh& mesh, HitRule rule)
      : ray_(&ray), triangles_(mesh), rule_(rule), keys_(keys), limit_(keys.limit) {}
  /// Along the ray, which the mesh sees so.
  template <class Mesh>
  HitSearch(const AnyRay& ray, const SeenRay& seen, const PosedMeshOf<Mesh>& mesh, HitRule rule)
      : HitSearch(ray, seen.slabs.keys(), mesh.bvh, rule) {
    seen_ = &seen, pose_ = &mesh.pose;
  }
  /// Along a ray that the mesh does not see: limits are parameters.
  template <class Mesh>
  HitSearch(const AnyRay& ray, const PosedMeshOf<Mesh>& mesh, HitRule rule)
      : HitSearch(ray, RaySlabs::Keys(), mesh.bvh, rule) {
    pose_ = &mesh.pose;
  }

  /// What the limits leave out is no hit.  To be called before a task is asked for; the limits must outlive the search.
  void keep_within(const HitLimits& limits) {
    limits_ = &limits;
    limit_ = std::min(limit_, keys_.limit_at(limits.most));
  }
  /// The key up to which the search has begun to look.
  [[nodiscard]] double limit() const { return limit_; }

  [[nodiscard]] AskedRay asked() {
    if (pose_ != nullptr) return {seen_->ray, this, seen_->doubts};
    return {query::batch_ray(*ray_), this};
  }
  /// The same of a mesh without a pose, number by number: a copy would wait for what was just written.
  void ask(AskedRay& asked) {
    query::put_batch_ray(*ray_, asked.ray);
    asked.visitor = this;
    asked.doubts.are_given = false;
  }
  /// By slabs whose keys were given.
  [[nodiscard]] RayTask task(const RaySlabs& slabs) { return {asked(), slabs.planes(), limit_}; }

 protected:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// A triangle that is hit, between these parameters.  What is decided is kept, where it is known.
  struct SlotHit {
    std::uint32_t slot;
    double least, most;
    bool is_crossed = true;  // its plane, by the ray
    std::optional<query::Decided> decided{};
  };

  ~HitSearch() = default;

  [[nodiscard]] std::uint32_t number(std::uint32_t slot) const { return triangles_.number(slot); }
  [[nodiscard]] bool is_hit(std::uint32_t slot) const;
  /// And within the limits.
  [[nodiscard]] bool counts(std::uint32_t slot, bool certain, double least, double most) const {
    return limits_ != nullptr ? between(slot, certain, least, most).has_value() : certain || is_hit(slot);
  }
  [[nodiscard]] NumberedHit numbered(const SlotHit& hit) const;
  /// Nothing where it is not hit, or not within the limits.
  [[nodiscard]] std::optional<SlotHit> between(std::uint32_t slot, bool certain, double least, double most) const;
  [[nodiscard]] bool is_before(const SlotHit& a, const SlotHit& b) const;

  [[nodiscard]] std::optional<SlotHit> hit_between(std::uint32_t slot, bool certain, double least, double most) const;
  [[nodiscard]] query::DecidedTriangle decided(const SlotHit& hit) const;
  [[nodiscard]] std::optional<SlotHit> posed_between(std::uint32_t slot, double least, double most) const;
  [[nodiscard]] bool is_left_out(const SlotHit& hit) const;

  [[nodiscard]] PosedTriangle posed(std::uint32_t slot) const { return {triangles_.triangle(slot), *pose_}; }

  const AnyRay* ray_;
  const SeenRay* seen_ = nullptr;
  const MeshPose* pose_ = nullptr;  // of a mesh that has one
  const HitLimits* limits_ = nullptr;
  SlotTriangles triangles_;
  HitRule rule_;
  RaySlabs::Keys keys_;
  double limit_;
};

class FirstHit final : public HitSearch {
 public:
  using HitSearch::HitSearch;
  double visit(std::uint32_t slot, bool certain, double least, double most) override;

  /// When all are visited.
  [[nodiscard]] std::optional<std::uint32_t> first_number() const;
  [[nodiscard]] std::optional<NumberedHit> first() const;

 private:
  [[nodiscard]] std::optional<SlotHit> earliest() const;

  SlotHit best_{0, infinity, infinity};
  bool found_ = false;
  std::vector<SlotHit> others_;  // which may be before the best
};

class AnyHit final : public HitSearch {
 public:
  using HitSearch::HitSearch;
  double visit(std::uint32_t slot, bool certain, double least, double most) override;
  [[nodiscard]] bool found() const { return found_; }
  /// Of what was found.
  [[nodiscard]] std::uint32_t slot() const { return slot_; }

 private:
  bool found_ = false;
  std::uint32_t slot_ = no_triangle;
};

class CountedHits final : public HitSearch {
 public:
  using HitSearch::HitSearch;
  double visit(std::uint32_t slot, bool certain, double least, double most) override;
  [[nodiscard]] std::size_t count();

 private:
  std::vector<std::uint32_t> numbers_;  // an item may be in several slots
};

class OrderedHits final : public HitSearch {
 public:
  using HitSearch::HitSearch;
  double visit(std::uint32_t slot, bool certain, double least, double most) override;
  [[nodiscard]] std::vector<NumberedHit> in_order(std::vector<NumberedHit> hits = {});

 private:
  std::vector<SlotHit> all_;
};

/// A triangle by its number, where the ray may hit it.
class PassedTriangles final : public HitSearch {
 public:
  using HitSearch::HitSearch;
  double visit(std::uint32_t slot, bool certain, double least, double most) override;
  [[nodiscard]] std::optional<HitBarycentric> barycentric(std::uint32_t triangle) const;
  [[nodiscard]] std::optional<ExactHitBarycentric> exact_barycentric(std::uint32_t triangle) const;

 private:
  [[nodiscard]] std::optional<std::uint32_t> slot_of(std::uint32_t triangle) const;

  std::vector<std::uint32_t> slots_;
};

}  // namespace plumb::space
