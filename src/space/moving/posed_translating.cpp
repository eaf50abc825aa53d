// A search of posed boxes (translating_search.hpp); under one regular pose the question without it.
#include "plumb/space/moving/posed_translating.hpp"

#include "figure/basic/finite_parts.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "query/time_of_impact/posed_contact.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/moving/translating_search.hpp"

namespace plumb {
namespace space {
namespace {

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
  return {by, {along == MotionAlong::world ? identity_pose.columns : a.pose.columns, {0, 0, 0}}};
}

/// Is it the question without poses?
bool is_posed_alike(const char* function, const PosedMesh& a, const Vector3& by, const PosedMesh& b,
                    MotionAlong along) {
  const bool alike = are_moved_alike(function, a, b);
  require_finite_parts(function, {"by"}, by);
  return alike && (along == MotionAlong::mesh_a || a.pose.columns == identity_pose.columns);
}

}  // namespace
}  // namespace space

std::optional<MeshContact> first_contact(const PosedMesh& a, const Vector3& by, const PosedMesh& b, MotionAlong along) {
  if (space::is_posed_alike("first_contact", a, by, b, along)) return first_contact(a.bvh, by, b.bvh);
  const space::PosedMotion motion(a, space::way_of(a, by, along), b);
  const auto found = space::TranslatingSearch(motion).run();
  if (!found) return {};
  return MeshContact{found->a, found->b, *motion.contact(found->slot_a, found->slot_b)};
}

std::optional<Root> first_contact_time(const PosedMesh& a, const Vector3& by, const PosedMesh& b, MotionAlong along) {
  if (space::is_posed_alike("first_contact_time", a, by, b, along)) return first_contact_time(a.bvh, by, b.bvh);
  const space::PosedMotion motion(a, space::way_of(a, by, along), b);
  const auto found = space::TranslatingSearch(motion).run();
  if (!found) return {};
  return motion.time(found->slot_a, found->slot_b);
}

}  // namespace plumb
