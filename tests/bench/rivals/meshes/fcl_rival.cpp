// FCL's hierarchies of two meshes: all contacts, and the distance.  A common pose is its transform.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "bench/rivals/chart_rival.hpp"
#include "lab/trial/mesh_questions.hpp"

namespace plumb::bench {
namespace {

using namespace lab::trial;
using Model = fcl::BVHModel<fcl::OBBRSS<double>>;

std::unique_ptr<Model> model_of(const TriangleMesh& mesh) {
  auto model = std::make_unique<Model>();
  std::vector<fcl::Vector3d> vertices;
  for (const Point3& p : mesh.vertices) vertices.emplace_back(p.x, p.y, p.z);
  std::vector<fcl::Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(a, b, c);
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size()));
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

fcl::Transform3d transform_of(const Pose& pose) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  const auto& [u, v, w] = pose.columns;
  t.linear() << u.x, v.x, w.x, u.y, v.y, w.y, u.z, v.z, w.z;
  t.translation() << pose.translation.x, pose.translation.y, pose.translation.z;
  return t;
}

Pairs contacts(const std::unique_ptr<Model>& a, const std::unique_ptr<Model>& b, const Pose& pose) {
  const fcl::Transform3d place = transform_of(pose);
  const fcl::CollisionRequestd request(std::size_t{1} << 30, false);
  fcl::CollisionResultd result;
  fcl::collide(a.get(), place, b.get(), place, request, result);
  Pairs pairs;
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    const fcl::Contactd& c = result.getContact(i);
    pairs.push_back({static_cast<std::uint32_t>(c.b1), static_cast<std::uint32_t>(c.b2)});
  }
  return pairs;
}

double apart(const std::unique_ptr<Model>& a, const std::unique_ptr<Model>& b, const Pose& pose) {
  const fcl::Transform3d place = transform_of(pose);
  const fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  fcl::distance(a.get(), place, b.get(), place, request, result);
  return result.min_distance;
}

}  // namespace

void add_fcl_meshes(Rivals& all) {
  all.push_back({"mesh-pairs",
                 of_two_meshes("fcl", "FCL's collide() of two BVHModels of OBBRSS, all contacts", model_of, contacts)});
  all.push_back(
      {"mesh-distance", of_two_meshes("fcl", "FCL's distance() of two BVHModels of OBBRSS", model_of, apart)});
}

}  // namespace plumb::bench
