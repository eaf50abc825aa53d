// The search of motion_search.hpp, where the mesh moves as it was given, and over posed boxes; under one regular pose the
// question without it.
#include "plumb/space/moving/motion_contacts.hpp"

#include <memory>
#include <vector>

#include "plumb/query/time_of_impact/continuous_contact.hpp"
#include "query/time_of_impact/posed_motion.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/posed_box.hpp"
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

/// Of a posed motion; a node's box has both places in it as given, so its images have both images.
class PosedNodesNear {
 public:
  PosedNodesNear(const MovingMeshView& posed, const BoxTree& a, const BoxTree& b, Execution execution,
                 double separation)
      : nodes_a_(a.nodes.view()),
        nodes_b_(b.nodes.view()),
        boxes_a_(boxes(posed, a, execution)),
        boxes_b_(&a == &b ? std::vector<Aabb3>() : boxes(posed, b, execution)),
        is_own_(&a == &b),
        separation_(separation) {}

  bool operator()(const BoxNode& a, const BoxNode& b) const {
    return come_near(boxes_a_[static_cast<std::size_t>(&a - nodes_a_.data())],
                     (is_own_ ? boxes_a_ : boxes_b_)[static_cast<std::size_t>(&b - nodes_b_.data())], separation_);
  }

 private:
  static std::vector<Aabb3> boxes(const MovingMeshView& posed, const BoxTree& tree, Execution execution) {
    const std::span<const BoxNode> nodes = tree.nodes.view();
    std::vector<Aabb3> all(nodes.size());
    for_blocks(execution, nodes.size(), 1 << 12, [&](std::size_t, std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        const Aabb3 given = tree.frame.outside(nodes[i].box());
        all[i] = around_both(around(posed.from, given), around(posed.to, given));
      }
    });
    return all;
  }

  std::span<const BoxNode> nodes_a_, nodes_b_;
  std::vector<Aabb3> boxes_a_, boxes_b_;
  bool is_own_;
  double separation_;
};

class MotionBetweenPoses {
 public:
  MotionBetweenPoses(const MovingMeshView& posed, Execution execution)
      : posed_(posed), mesh_(posed.mesh), execution_(execution), swept_(posed.mesh.from.size()) {
    for_blocks(execution, swept_.size(), 1 << 12, [&](std::size_t, std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i)
        swept_[i] = around_both(around(posed.from, mesh_.from[i]), around(posed.to, mesh_.to[i]));
    });
  }

  [[nodiscard]] const MovingMesh& mesh() const { return mesh_; }
  [[nodiscard]] PosedNodesNear nodes_near(const BoxTree& a, const BoxTree& b, double separation) const {
    return {posed_, a, b, execution_, separation};
  }
  [[nodiscard]] Aabb3 corner_box(std::uint32_t i) const { return swept_[mesh_.corners[i]]; }
  [[nodiscard]] Aabb3 edge_box(std::uint32_t i) const {
    const auto [a, b] = mesh_.edges[i];
    return around_both(swept_[a], swept_[b]);
  }
  [[nodiscard]] Aabb3 triangle_box(std::uint32_t i) const {
    const auto& [a, b, c] = mesh_.triangles[i];
    return around_both(around_both(swept_[a], swept_[b]), swept_[c]);
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
  [[nodiscard]] query::moving::PosedQuestion question(ContactPair pair, std::uint32_t a, std::uint32_t b) const {
    const bool edges = pair == ContactPair::edge_edge;
    const std::array<std::uint32_t, 4> v =
        edges ? std::array{mesh_.edges[a][0], mesh_.edges[a][1], mesh_.edges[b][0], mesh_.edges[b][1]}
              : std::array{a, mesh_.triangles[b][0], mesh_.triangles[b][1], mesh_.triangles[b][2]};
    const auto at = [&](const std::vector<Point3>& places) {
      return std::array{places[v[0]], places[v[1]], places[v[2]], places[v[3]]};
    };
    using query::moving::MovingKind;
    return {{edges ? MovingKind::edge_edge : MovingKind::vertex_triangle, at(mesh_.from), at(mesh_.to)},
            {posed_.from.any_view(), posed_.to.any_view()},
            {posed_.from.any_view(), posed_.to.any_view()}};
  }

  const MovingMeshView& posed_;
  const MovingMesh& mesh_;
  Execution execution_;
  std::vector<Aabb3> swept_;  // of vertices
};

/// Is it the question without poses?
bool moves_as_given(const char* function, const MovingMeshView& mesh, double separation) {
  require_finite_pose(function, "mesh.from", mesh.from);
  require_finite_pose(function, "mesh.to", mesh.to);
  require_separation(function, separation);
  if (!(mesh.from == mesh.to)) return false;
  const bool keeps_lengths = mesh.from.matrix() == nullptr || mesh.from == identity_pose;
  return keeps_lengths || (separation == 0 && is_regular(mesh.from));
}

/// ask(scene) of the motion.
template <class Ask>
auto with_motion(const char* function, const MovingMeshView& mesh, const MotionContactOptions& options,
                 const Ask& ask) {
  if (moves_as_given(function, mesh, options.separation)) return ask(GivenMotion(mesh.mesh));
  return ask(MotionBetweenPoses(mesh, options.execution));
}

}  // namespace
}  // namespace space

std::vector<MotionContact> contacts_in_motion(const MovingMeshView& mesh, const MotionContactOptions& options,
                                              std::vector<MotionContact> rows) {
  constexpr const char* function = "contacts_in_motion";
  return space::with_motion(function, mesh, options, [&](const auto& scene) {
    return space::all_contacts(function, scene, options, std::move(rows));
  });
}

std::vector<MotionContact> contacts_by_time(const MovingMeshView& mesh, const MotionContactOptions& options,
                                            std::vector<MotionContact> rows) {
  constexpr const char* function = "contacts_by_time";
  return space::with_motion(function, mesh, options, [&](const auto& scene) {
    return space::all_by_time(function, scene, options, std::move(rows));
  });
}

std::optional<MotionContact> first_contact(const MovingMeshView& mesh, const MotionContactOptions& options) {
  constexpr const char* function = "first_contact";
  return space::with_motion(function, mesh, options,
                            [&](const auto& scene) { return space::first_in_time(function, scene, options); });
}

}  // namespace plumb
