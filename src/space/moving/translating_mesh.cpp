// A search of boxes as they stand (translating_search.hpp).
#include "plumb/space/moving/translating_mesh.hpp"

#include "figure/basic/finite_parts.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"
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

}  // namespace
}  // namespace space

std::optional<MeshContact> first_contact(const Bvh& a, const Vector3& by, const Bvh& b) {
  require_finite_parts("first_contact", {"by"}, by);
  const space::StandingMotion motion(a, by, b);
  const auto found = space::TranslatingSearch(motion).run();
  if (!found) return {};
  return MeshContact{found->a, found->b, *motion.contact(found->slot_a, found->slot_b)};
}

std::optional<Root> first_contact_time(const Bvh& a, const Vector3& by, const Bvh& b) {
  require_finite_parts("first_contact_time", {"by"}, by);
  const space::StandingMotion motion(a, by, b);
  const auto found = space::TranslatingSearch(motion).run();
  if (!found) return {};
  return motion.time(found->slot_a, found->slot_b);
}

}  // namespace plumb
