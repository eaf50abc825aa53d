// A search of boxes as they stand or under poses (translating_search.hpp); under one regular pose the question without it.
#include "plumb/space/moving/translating_mesh.hpp"

#include <string>
#include <vector>

#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/basic/rigid_poses.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "query/time_of_impact/posed_contact.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/moving/translating_search.hpp"

namespace plumb {
namespace space {
namespace {

class StandingMotion {
 public:
  StandingMotion(const Bvh& a, const Vector3& by, const Bvh& b)
      : a_(a), b_(b), by_{by, identity_pose}, velocity_{{by.x, by.y, by.z}, {by.x, by.y, by.z}} {}

  [[nodiscard]] const PosedMesh& a() const { return a_; }
  [[nodiscard]] const PosedMesh& b() const { return b_; }
  [[nodiscard]] const Posed<Vector3>& by() const { return by_; }
  [[nodiscard]] const Aabb3& velocity() const { return velocity_; }
  [[nodiscard]] Aabb3 box_a(const BoxNode& n) const { return box_of(a_.bvh, n); }
  [[nodiscard]] Aabb3 box_b(const BoxNode& n) const { return box_of(b_.bvh, n); }
  [[nodiscard]] Aabb3 triangle_box_a(std::uint32_t slot) const { return triangle_box(a_.bvh, slot); }
  [[nodiscard]] Aabb3 triangle_box_b(std::uint32_t slot) const { return triangle_box(b_.bvh, slot); }
  [[nodiscard]] std::optional<std::array<Aabb3, 2>> exact_boxes(std::uint32_t slot_a, std::uint32_t slot_b) const {
    return std::array{triangle_box_a(slot_a), triangle_box_b(slot_b)};
  }
  template <class Take>
  void replace(NodePair pair, const Take& take) const {
    replace_pair(a_.bvh.tree.nodes.view(), b_.bvh.tree.nodes.view(), descend_larger{}, pair, take);
  }
  [[nodiscard]] Relation relate(std::uint32_t slot_a, std::uint32_t slot_b) const {
    return plumb::relate(a_.bvh.triangle(slot_a), b_.bvh.triangle(slot_b));
  }
  [[nodiscard]] std::optional<Contact> contact(std::uint32_t slot_a, std::uint32_t slot_b) const {
    return first_contact(Translating<Triangle3>{a_.bvh.triangle(slot_a), by_.shape}, b_.bvh.triangle(slot_b));
  }
  [[nodiscard]] std::optional<Root> time(std::uint32_t slot_a, std::uint32_t slot_b) const {
    return first_contact_time(Translating<Triangle3>{a_.bvh.triangle(slot_a), by_.shape}, b_.bvh.triangle(slot_b));
  }

 private:
  static Aabb3 box_of(const Bvh& mesh, const BoxNode& n) {
    if (mesh.tree.frame.exponent() != 0) return mesh.tree.frame.outside(n.box());
    return {{n.min[0], n.min[1], n.min[2]}, {n.max[0], n.max[1], n.max[2]}};
  }
  static Aabb3 triangle_box(const Bvh& mesh, std::uint32_t slot) {
    return box_around(mesh.triangles[slot], mesh.vertices.view());
  }

  PosedMesh a_, b_;
  Posed<Vector3> by_;
  Aabb3 velocity_;
};

class PosedMotion {
 public:
  PosedMotion(const PosedMesh& a, const Posed<Vector3>& by, const PosedMesh& b)
      : a_(a), b_(b), by_(by), velocity_(around(by.pose, Point3{by.shape.x, by.shape.y, by.shape.z})) {}

  [[nodiscard]] const PosedMesh& a() const { return a_; }
  [[nodiscard]] const PosedMesh& b() const { return b_; }
  [[nodiscard]] const Posed<Vector3>& by() const { return by_; }
  [[nodiscard]] const Aabb3& velocity() const { return velocity_; }
  [[nodiscard]] Aabb3 box_a(const BoxNode& n) const { return around(a_, n); }
  [[nodiscard]] Aabb3 box_b(const BoxNode& n) const { return around(b_, n); }
  [[nodiscard]] Aabb3 triangle_box_a(std::uint32_t slot) const { return around(a_.triangle(slot)); }
  [[nodiscard]] Aabb3 triangle_box_b(std::uint32_t slot) const { return around(b_.triangle(slot)); }
  [[nodiscard]] static std::optional<std::array<Aabb3, 2>> exact_boxes(std::uint32_t, std::uint32_t) { return {}; }
  template <class Take>
  void replace(NodePair pair, const Take& take) const {
    const auto larger = [&](const BoxNode& x, const BoxNode& y) { return larger_posed(box_a(x), box_b(y)); };
    replace_pair(a_.bvh.tree.nodes.view(), b_.bvh.tree.nodes.view(), larger, pair, take);
  }
  [[nodiscard]] Relation relate(std::uint32_t slot_a, std::uint32_t slot_b) const {
    return query::relate(a_.triangle(slot_a), b_.triangle(slot_b));
  }
  [[nodiscard]] std::optional<Contact> contact(std::uint32_t slot_a, std::uint32_t slot_b) const {
    return query::first_contact(a_.triangle(slot_a), by_, b_.triangle(slot_b));
  }
  [[nodiscard]] std::optional<Root> time(std::uint32_t slot_a, std::uint32_t slot_b) const {
    return query::first_contact_time(a_.triangle(slot_a), by_, b_.triangle(slot_b));
  }

 private:
  const PosedMesh &a_, &b_;
  Posed<Vector3> by_;
  Aabb3 velocity_;  // between its corners
};

Posed<Vector3> way_of(const PosedMesh& a, const Vector3& by, MotionAlong along) {
  const bool is_mapped = along == MotionAlong::mesh_a && a.pose.matrix() != nullptr;
  return {by, {is_mapped ? a.pose.matrix()->columns : identity_pose.columns, {0, 0, 0}}};
}

/// Is it the question without poses?
bool is_posed_alike(const char* function, const PosedMesh& a, const Vector3& by, const PosedMesh& b,
                    MotionAlong along) {
  const bool alike = are_moved_alike(function, a, b);
  require_finite_parts(function, {"by"}, by);
  const bool keeps_ways = a.pose.matrix() != nullptr && a.pose.matrix()->columns == identity_pose.columns;
  return alike && (along == MotionAlong::mesh_a || keeps_ways);
}

/// What undoes all turns of a rigid pose.
std::vector<RigidPose> turns_back(const MeshPose& pose) {
  std::vector<RigidPose> back;
  const auto add = [&](const RigidPose& link) { back.insert(back.begin(), {inverse(link.turn), {0, 0, 0}}); };
  pose.visit([&]<class By>(const By& by) {
    if constexpr (std::is_same_v<By, RigidPose>) {
      add(by);
    } else if constexpr (std::is_same_v<By, RigidChain>) {
      for (const RigidPose& link : by.links) add(link);
    }
  });
  return back;
}

/// Under the turns, a rigid pose or the identity.
MeshPose turned(const char* function, RigidChain turns, const MeshPose& pose) {
  pose.visit([&]<class By>(const By& by) {
    if constexpr (std::is_same_v<By, RigidPose>) {
      turns.links.push_back(by);
    } else if constexpr (std::is_same_v<By, RigidChain>) {
      turns.links.insert(turns.links.end(), by.links.begin(), by.links.end());
    } else if (!(by == identity_pose)) {
      throw InvalidShape(std::string(function) +
                         ": a moves along its own rigid pose, but b is under a matrix; give b a rigid pose as well");
    }
  });
  return turns;
}

/// ask(motion) of two meshes where they are.
template <class Ask>
auto with_motion_of(const char* function, const BvhView& view_a, const Vector3& by, const BvhView& view_b,
                    MotionAlong along, const Ask& ask) {
  const auto posed = [](const BvhView& view) {
    return view.visit(
        [&](const Bvh& bvh) { return view.pose() == nullptr ? PosedMesh(bvh) : PosedMesh(bvh, *view.pose()); });
  };
  const PosedMesh a = posed(view_a), b = posed(view_b);
  if (is_posed_alike(function, a, by, b, along)) return ask(StandingMotion(a.bvh, by, b.bvh));
  // By a vector of the world, or one that a's matrix maps; along a rigid pose all is turned back by it.
  if (along == MotionAlong::world || a.pose.matrix() != nullptr) return ask(PosedMotion(a, way_of(a, by, along), b));
  const RigidChain back{turns_back(a.pose)};
  const PosedMesh own(a.bvh, turned(function, back, a.pose)), other(b.bvh, turned(function, back, b.pose));
  return ask(PosedMotion(own, {by, identity_pose}, other));
}

}  // namespace
}  // namespace space

std::optional<MeshContact> first_contact(const BvhView& a, const Vector3& by, const BvhView& b, MotionAlong along) {
  const auto ask = [](const auto& motion) -> std::optional<MeshContact> {
    const auto found = space::TranslatingSearch(motion).run();
    if (!found) return {};
    return MeshContact{found->a, found->b, *motion.contact(found->slot_a, found->slot_b)};
  };
  return space::with_motion_of("first_contact", a, by, b, along, ask);
}

std::optional<Root> first_contact_time(const BvhView& a, const Vector3& by, const BvhView& b, MotionAlong along) {
  const auto ask = [](const auto& motion) -> std::optional<Root> {
    const auto found = space::TranslatingSearch(motion).run();
    if (!found) return {};
    return motion.time(found->slot_a, found->slot_b);
  };
  return space::with_motion_of("first_contact_time", a, by, b, along, ask);
}

}  // namespace plumb
