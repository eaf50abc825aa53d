#include "world/placed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/space/range/range_search.hpp"
#include "query/body/upright_box.hpp"
#include "space/bvh/posed_box.hpp"
#include "world/rigid_links.hpp"

namespace plumb::world {
namespace {

std::shared_ptr<const PosedMesh> posed_mesh(const Bvh& bvh, const AnyPose& pose) {
  if (const auto* rigid = std::get_if<RigidPose>(&pose)) return std::make_shared<const PosedMesh>(bvh, *rigid);
  if (const auto* chain = std::get_if<RigidChain>(&pose)) return std::make_shared<const PosedMesh>(bvh, *chain);
  return nullptr;
}

/// Rounded outward.
Aabb3 box_of_upright(const query::UprightBox& box) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto low = [&](std::size_t k) {
    const query::FacePlace& p = box.low[k];
    return p.rest < 0 ? std::nextafter(p.nearest, -infinity) : p.nearest;
  };
  const auto high = [&](std::size_t k) {
    const query::FacePlace& p = box.high[k];
    return p.rest > 0 ? std::nextafter(p.nearest, infinity) : p.nearest;
  };
  return {{low(0), low(1), low(2)}, {high(0), high(1), high(2)}};
}

/// Tells a box some bits wider than the least one, which would ask rational numbers; that one where doubles know no bound.
Aabb3 box_around(const MeshPose& pose, const Aabb3& box) {
  const Aabb3 quick = space::around(pose, box);
  return !is_empty(box) && space::is_bounded(quick) ? quick : transform(box, pose.view());
}

bool is_one_pose(const AnyPose& a, const AnyPose& b) { return a.index() != 0 && a == b; }

Relation relation_of_figures(const AnyFigure& a, const AnyFigure& b) {
  if (is_one_pose(a.pose(), b.pose())) return query::any_relate({a.figure()}, {b.figure()});
  return relate(a, b);
}

Relation relation_to_mesh(const AnyFigure& figure, const PlacedMesh& mesh) {
  if (is_one_pose(figure.pose(), mesh.pose())) {
    return relation_to_mesh(figure.under({}), PlacedMesh(mesh.mesh(), {}));
  }
  Relation most = Relation::disjoint;
  for (const std::uint32_t t : mesh.near(box_of_figure(figure))) {
    most = std::max(most, relate(figure, mesh.triangle(t)));
    if (most == Relation::overlapping) break;
  }
  return most;
}

Relation relation_of_meshes(const PlacedMesh& a, const PlacedMesh& b) {
  if (any_intersecting_pair(a.view(), b.view(), {.touching = false, .execution = Execution::serial})) {
    return Relation::overlapping;
  }
  return any_intersecting_pair(a.view(), b.view(), {.execution = Execution::serial}) ? Relation::touching
                                                                                     : Relation::disjoint;
}

}  // namespace

Aabb3 box_of_figure(const AnyFigure& figure) {
  if (const auto upright = query::upright_box(figure.view())) return box_of_upright(*upright);
  if (const auto* box = get_if<Aabb3>(figure)) {
    if (const auto* rigid = std::get_if<RigidPose>(&figure.pose())) return box_around(MeshPose(*rigid), *box);
    if (const auto* chain = std::get_if<RigidChain>(&figure.pose())) return box_around(MeshPose(*chain), *box);
  }
  if (const auto* p = get_if<Point3>(figure))
    return query::any_fit_aabb(AnyFigure(Segment3{*p, *p}).under(figure.pose()));
  return query::any_fit_aabb(figure);
}

PlacedMesh::PlacedMesh(SharedMesh mesh, const AnyPose& pose)
    : mesh_(std::move(mesh)), pose_(pose), posed_(posed_mesh(mesh_.bvh(), pose_)) {}

Aabb3 PlacedMesh::box() const {
  if (!posed_) return mesh_.box();
  return box_around(posed_->pose, mesh_.box());
}

std::vector<std::uint32_t> PlacedMesh::near(const Aabb3& box) const { return meeting(view(), box); }

Placed placed(const AnyBody::Part& part, const AnyPose& body) {
  if (const auto* mesh = std::get_if<SharedMesh>(&part.shape)) {
    return PlacedMesh(*mesh, pose_of_links(links_of("a mesh", composed("a mesh", body, part.pose))));
  }
  const AnyFigure& figure = std::get<AnyFigure>(part.shape);
  if (figure.dimension() != 3) throw Unsupported("a figure of the plane; a world is of figures of space");
  if (std::holds_alternative<Pose>(body) || std::holds_alternative<Pose>(figure.pose())) {
    throw UnevenPose("a figure under a matrix; a world takes a RigidPose or a RigidChain");
  }
  return figure.under(composed("a figure", body, figure.pose()));
}

Aabb3 box_of(const Placed& part) {
  const auto* mesh = std::get_if<PlacedMesh>(&part);
  return mesh != nullptr ? mesh->box() : box_of_figure(std::get<AnyFigure>(part));
}

Relation relation(const Placed& a, const Placed& b) {
  const auto *p = std::get_if<AnyFigure>(&a), *q = std::get_if<AnyFigure>(&b);
  if (p != nullptr && q != nullptr) return relation_of_figures(*p, *q);
  if (p != nullptr) return relation_to_mesh(*p, std::get<PlacedMesh>(b));
  if (q != nullptr) return relation_to_mesh(*q, std::get<PlacedMesh>(a));
  return relation_of_meshes(std::get<PlacedMesh>(a), std::get<PlacedMesh>(b));
}

Relation relation_of_parts(std::span<const Placed> a, std::span<const Placed> b) {
  Relation most = Relation::disjoint;
  for (const Placed& p : a) {
    for (const Placed& q : b) {
      if (most == Relation::overlapping) return most;
      most = std::max(most, relation(p, q));
    }
  }
  return most;
}

bool meet(const Placed& part, const AnyFigure& figure) {
  if (const auto* own = std::get_if<AnyFigure>(&part)) return intersects(*own, figure);
  const PlacedMesh& mesh = std::get<PlacedMesh>(part);
  const std::vector<std::uint32_t> near = mesh.near(box_of_figure(figure));
  return std::ranges::any_of(near, [&](std::uint32_t t) { return intersects(mesh.triangle(t), figure); });
}

}  // namespace plumb::world
