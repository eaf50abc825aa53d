// Nearer volumes first, by the parameters at which the ray may be in them; triangles exactly.
#include "plumb/space/ray/volume_ray.hpp"

#include "plumb/query/ray/hits.hpp"
#include "query/ray/numbers.hpp"
#include "query/ray/posed_triangle.hpp"
#include "space/ray/nearest_hit.hpp"
#include "space/ray/ray_through.hpp"

namespace plumb {
namespace space {
namespace {

/// A mesh's triangles, posed only where it has been moved.
class VolumeTriangles {
 public:
  VolumeTriangles(const AnyRay& ray, const PosedMesh& mesh, HitRule rule)
      : ray_(ray), mesh_(mesh), rule_(rule), stands_(mesh.pose == identity_pose) {}

  [[nodiscard]] std::optional<Hit> hit(std::uint32_t slot) const {
    return stands_ ? first_hit(ray_, mesh_.bvh.triangle(slot), rule_)
                   : query::first_hit(ray_, mesh_.triangle(slot), rule_);
  }
  [[nodiscard]] RayParameter parameter(std::uint32_t slot) const {
    return stands_ ? *first_hit_parameter(ray_, mesh_.bvh.triangle(slot), rule_)
                   : *query::first_hit_parameter(ray_, mesh_.triangle(slot), rule_);
  }
  [[nodiscard]] bool is_hit(std::uint32_t slot) const {
    return stands_ ? hits(ray_, mesh_.bvh.triangle(slot), rule_) : query::hits(ray_, mesh_.triangle(slot), rule_);
  }
  [[nodiscard]] std::uint32_t number(std::uint32_t slot) const { return mesh_.bvh.number(slot); }

 private:
  const AnyRay& ray_;
  const PosedMesh& mesh_;
  HitRule rule_;
  bool stands_;
};

template <class Volume>
void require_volume_shot(const char* function, const AnyRay& ray, const VolumeMesh<Volume>& mesh) {
  if (!query::is_sound(ray)) query::require_ray(function, ray);
  require_pose(function, "mesh", mesh.mesh.pose);
  require_tree_of(function, "mesh.volumes", mesh.mesh.bvh, mesh.volumes);
}

template <class Volume>
std::optional<NumberedHit> first_volume_hit(const AnyRay& ray, const VolumeMesh<Volume>& mesh, HitRule rule) {
  require_volume_shot("first_hit", ray, mesh);
  const RayThrough through(ray);
  const VolumeTriangles triangles(ray, mesh.mesh, rule);
  return nearest_hit(mesh.volumes, triangles, [&](const VolumeNode<Volume>& node) {
    const Interval at = through(node.volume);
    return at.lower > at.upper ? Interval::infinity : std::min(most_parameter, at.lower);
  });
}

template <class Volume>
bool any_volume_hit(const AnyRay& ray, const VolumeMesh<Volume>& mesh, HitRule rule) {
  require_volume_shot("any_hit", ray, mesh);
  const RayThrough through(ray);
  const VolumeTriangles triangles(ray, mesh.mesh, rule);
  const auto enters = [&](const VolumeNode<Volume>& node) {
    const Interval at = through(node.volume);
    return !(at.lower > at.upper);
  };
  return descend(mesh.volumes, enters, [&](std::uint32_t first, std::uint32_t count) {
           for (std::uint32_t slot = first; slot < first + count; ++slot) {
             if (triangles.is_hit(slot)) return Descent::stop;
           }
           return Descent::go_on;
         }) == Descent::stop;
}

}  // namespace
}  // namespace space

template <class Volume>
std::optional<NumberedHit> first_hit(const VolumeMesh<Volume>& mesh, const AnyRay& ray, HitRule rule) {
  return space::first_volume_hit(ray, mesh, rule);
}

template <class Volume>
bool any_hit(const VolumeMesh<Volume>& mesh, const AnyRay& ray, HitRule rule) {
  return space::any_volume_hit(ray, mesh, rule);
}

#define PLUMB_RAYS_OF(Volume)                                                                            \
  template std::optional<NumberedHit> first_hit(const VolumeMesh<Volume>&, const AnyRay&, HitRule rule); \
  template bool any_hit(const VolumeMesh<Volume>&, const AnyRay&, HitRule rule);
PLUMB_RAYS_OF(Sphere3)
PLUMB_RAYS_OF(Aabb3)
PLUMB_RAYS_OF(Obb3)
PLUMB_RAYS_OF(KDop3)
#undef PLUMB_RAYS_OF

}  // namespace plumb
