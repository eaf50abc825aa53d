// The search of motion_search.hpp, where the mesh moves as it was given.
#include "plumb/space/moving/motion_contacts.hpp"

#include "plumb/query/time_of_impact/continuous_contact.hpp"
#include "space/moving/motion_search.hpp"
#include "space/moving/swept_boxes.hpp"

namespace plumb {
namespace space {
namespace {

/// Nodes of two trees, whatever their frames.
class NodesNear {
 public:
  NodesNear(const BoxTree& a, const BoxTree& b, double separation)
      : a_(a.frame),
        b_(b.frame),
        one_frame_(a_ == b_),
        separation_(one_frame_ ? static_cast<double>(a_.above(separation)) : separation) {}

  bool operator()(const BoxNode& a, const BoxNode& b) const {
    return one_frame_ ? come_near(a, b, separation_) : come_near(a_.outside(a.box()), b_.outside(b.box()), separation_);
  }

 private:
  BoxFrame a_, b_;
  bool one_frame_;
  double separation_;
};

class GivenMotion {
 public:
  explicit GivenMotion(const MovingMesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] const MovingMesh& mesh() const { return mesh_; }
  [[nodiscard]] static NodesNear nodes_near(const BoxTree& a, const BoxTree& b, double separation) {
    return {a, b, separation};
  }
  [[nodiscard]] Aabb3 corner_box(std::uint32_t i) const { return swept_corner(mesh_, i); }
  [[nodiscard]] Aabb3 edge_box(std::uint32_t i) const { return swept_edge(mesh_, i); }
  [[nodiscard]] Aabb3 triangle_box(std::uint32_t i) const { return swept_triangle(mesh_, i); }
  [[nodiscard]] std::optional<Contact> contact(ContactPair pair, std::uint32_t a, std::uint32_t b,
                                               double separation) const {
    const ContactOptions options{separation};
    return pair == ContactPair::vertex_triangle ? first_contact(mesh_.vertex(a), mesh_.triangle(b), options)
                                                : first_contact(mesh_.edge(a), mesh_.edge(b), options);
  }
  [[nodiscard]] Root time(const MotionContact& c, double separation) const {
    const ContactOptions options{separation};
    return c.pair == ContactPair::vertex_triangle ? *first_contact_time(mesh_.vertex(c.a), mesh_.triangle(c.b), options)
                                                  : *first_contact_time(mesh_.edge(c.a), mesh_.edge(c.b), options);
  }

 private:
  const MovingMesh& mesh_;
};

}  // namespace
}  // namespace space

std::vector<MotionContact> contacts_in_motion(const MovingMesh& mesh, const MotionContactOptions& options,
                                              std::vector<MotionContact> rows) {
  return space::all_contacts("contacts_in_motion", space::GivenMotion(mesh), options, std::move(rows));
}

std::vector<MotionContact> contacts_by_time(const MovingMesh& mesh, const MotionContactOptions& options,
                                            std::vector<MotionContact> rows) {
  return space::all_by_time("contacts_by_time", space::GivenMotion(mesh), options, std::move(rows));
}

std::optional<MotionContact> first_contact(const MovingMesh& mesh, const MotionContactOptions& options) {
  return space::first_in_time("first_contact", space::GivenMotion(mesh), options);
}

}  // namespace plumb
