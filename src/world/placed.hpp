// What is one part of a body where it stands, and how do two of them lie?
//
// Laws: answers are those of the figures, and of a mesh those of its triangles' exact images: two parts touch or overlap as
// the pair of triangles does that does most.  What stands under one exact pose is asked without it.
// Source: RTCD 2.4.
// Cost: that of the questions; of a mesh those of the triangles whose boxes meet the other's.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/query/variant/questions.hpp"
#include "plumb/space/bvh/mesh_view.hpp"
#include "plumb/world/any_body.hpp"

namespace plumb::world {

class PlacedMesh {
 public:
  PlacedMesh(SharedMesh mesh, const AnyPose& pose);

  [[nodiscard]] const SharedMesh& mesh() const { return mesh_; }
  [[nodiscard]] MeshView view() const { return posed_ ? MeshView(*posed_) : MeshView(mesh_.bvh()); }
  [[nodiscard]] BvhView bvh_view() const { return posed_ ? BvhView(*posed_) : BvhView(mesh_.bvh()); }
  [[nodiscard]] AnyFigure triangle(std::uint32_t number) const {
    const AnyFigure t(mesh_.triangle(number));
    return posed_ ? t.under(pose_) : t;
  }
  [[nodiscard]] Aabb3 box() const;
  [[nodiscard]] const AnyPose& pose() const { return pose_; }
  /// The triangles whose boxes meet it, by number; perhaps some more.
  [[nodiscard]] std::vector<std::uint32_t> near(const Aabb3& box) const;

 private:
  SharedMesh mesh_;
  AnyPose pose_;
  std::shared_ptr<const PosedMesh> posed_;
};

using Placed = std::variant<AnyFigure, PlacedMesh>;

/// Refuses what no world takes: figures of the plane, without an end or under a matrix.
Placed placed(const AnyBody::Part& part, const AnyPose& body);

/// Tight; of a point as well.
Aabb3 box_of_figure(const AnyFigure& figure);
Aabb3 box_of(const Placed& part);

Relation relation(const Placed& a, const Placed& b);
/// The most that two parts of them say.
Relation relation_of_parts(std::span<const Placed> a, std::span<const Placed> b);
bool meet(const Placed& part, const AnyFigure& figure);

}  // namespace plumb::world
