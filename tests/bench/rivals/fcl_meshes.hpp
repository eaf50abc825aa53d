// FCL's hierarchy of a mesh, and its transform for a pose; for files that FCL's headers are there for.
#pragma once

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>

#include <memory>
#include <vector>

#include "plumb/arith/pose.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb::bench {

using FclModel = fcl::BVHModel<fcl::OBBRSS<double>>;

inline std::unique_ptr<FclModel> fcl_model(const TriangleMesh& mesh) {
  auto model = std::make_unique<FclModel>();
  std::vector<fcl::Vector3d> vertices;
  for (const Point3& p : mesh.vertices) vertices.emplace_back(p.x, p.y, p.z);
  std::vector<fcl::Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(a, b, c);
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size()));
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

inline fcl::Transform3d fcl_transform(const Pose& pose) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  const auto& [u, v, w] = pose.columns;
  t.linear() << u.x, v.x, w.x, u.y, v.y, w.y, u.z, v.z, w.z;
  t.translation() << pose.translation.x, pose.translation.y, pose.translation.z;
  return t;
}

}  // namespace plumb::bench
