// The search of motion_search.hpp over posed boxes; under one regular pose the question without it.
#include "plumb/space/moving/posed_motion.hpp"

#include <memory>

#include "query/time_of_impact/posed_motion.hpp"
#include "space/bvh/alike_poses.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/moving/motion_search.hpp"
#include "space/moving/swept_boxes.hpp"

namespace plumb {
namespace space {
namespace {

class MotionBetweenPoses {
 public:
  explicit MotionBetweenPoses(const PosedMovingMesh& posed)
      : mesh_(posed.mesh), pose_0_(posed.from), pose_1_(posed.to) {}

  [[nodiscard]] const MovingMesh& mesh() const { return mesh_; }
  /// A node's box has both places in it as given, so its images have both images.
  [[nodiscard]] auto nodes_near(const BoxTree& a, const BoxTree& b, double separation) const {
    const auto box = [this](const BoxFrame& frame, const BoxNode& n) {
      const Aabb3 given = frame.outside(n.box());
      return around_both(around(pose_0_, given), around(pose_1_, given));
    };
    return [box, frame_a = a.frame, frame_b = b.frame, separation](const BoxNode& x, const BoxNode& y) {
      return come_near(box(frame_a, x), box(frame_b, y), separation);
    };
  }
  [[nodiscard]] Aabb3 corner_box(std::uint32_t i) const { return swept(mesh_.corners[i]); }
  [[nodiscard]] Aabb3 edge_box(std::uint32_t i) const {
    const auto [a, b] = mesh_.edges[i];
    return around_both(swept(a), swept(b));
  }
  [[nodiscard]] Aabb3 triangle_box(std::uint32_t i) const {
    const auto& [a, b, c] = mesh_.triangles[i];
    return around_both(around_both(swept(a), swept(b)), swept(c));
  }
  [[nodiscard]] std::optional<Contact> contact(ContactPair pair, std::uint32_t a, std::uint32_t b,
                                               double separation) const {
    const auto exact = query::moving::posed_first_contact(question(pair, a, b), separation);
    if (!exact) return {};
    return Contact{arith::rounded(Rounding::down, exact->time), exact->a, exact->b};
  }
  [[nodiscard]] Root time(const MotionContact& c, double separation) const {
    auto exact = query::moving::posed_first_contact(question(c.pair, c.a, c.b), separation);
    return Root(std::make_shared<const arith::IsolatedRoot>(std::move(exact->time)));
  }

 private:
  [[nodiscard]] Aabb3 swept(std::uint32_t vertex) const {
    return around_both(around(pose_0_, mesh_.from[vertex]), around(pose_1_, mesh_.to[vertex]));
  }
  [[nodiscard]] query::moving::PosedQuestion question(ContactPair pair, std::uint32_t a, std::uint32_t b) const {
    const bool edges = pair == ContactPair::edge_edge;
    const std::array<std::uint32_t, 4> v =
        edges ? std::array{mesh_.edges[a][0], mesh_.edges[a][1], mesh_.edges[b][0], mesh_.edges[b][1]}
              : std::array{a, mesh_.triangles[b][0], mesh_.triangles[b][1], mesh_.triangles[b][2]};
    const auto at = [&](const std::vector<Point3>& places) {
      return std::array{places[v[0]], places[v[1]], places[v[2]], places[v[3]]};
    };
    using query::moving::MovingKind;
    return {
        {edges ? MovingKind::edge_edge : MovingKind::vertex_triangle, at(mesh_.from), at(mesh_.to)}, pose_0_, pose_1_};
  }

  const MovingMesh& mesh_;
  Pose pose_0_, pose_1_;
};

/// Is it the question without poses?
bool moves_as_given(const char* function, const PosedMovingMesh& mesh, double separation) {
  require_finite_pose(function, "mesh.from", mesh.from);
  require_finite_pose(function, "mesh.to", mesh.to);
  require_separation(function, separation);
  if (!(mesh.from == mesh.to)) return false;
  return mesh.from == identity_pose || (separation == 0 && is_regular(mesh.from));
}

}  // namespace
}  // namespace space

std::vector<MotionContact> contacts_in_motion(const PosedMovingMesh& mesh, const MotionContactOptions& options) {
  constexpr const char* function = "contacts_in_motion";
  return space::moves_as_given(function, mesh, options.separation)
             ? contacts_in_motion(mesh.mesh, options)
             : space::all_contacts(function, space::MotionBetweenPoses(mesh), options);
}

std::vector<MotionContact> contacts_by_time(const PosedMovingMesh& mesh, const MotionContactOptions& options) {
  constexpr const char* function = "contacts_by_time";
  return space::moves_as_given(function, mesh, options.separation)
             ? contacts_by_time(mesh.mesh, options)
             : space::all_by_time(function, space::MotionBetweenPoses(mesh), options);
}

std::optional<MotionContact> first_contact(const PosedMovingMesh& mesh, const MotionContactOptions& options) {
  constexpr const char* function = "first_contact";
  return space::moves_as_given(function, mesh, options.separation)
             ? first_contact(mesh.mesh, options)
             : space::first_in_time(function, space::MotionBetweenPoses(mesh), options);
}

}  // namespace plumb
