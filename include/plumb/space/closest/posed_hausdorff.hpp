// Hausdorff distance of meshes that have been moved: how far is the farthest point of one from the other?
//
//   const HausdorffDistance h = hausdorff_distance({a, pose_a}, {b, pose_b});    // h.least <= the distance <= h.most
//
// Laws: (1) those of hausdorff.hpp but (5), of the exact images (plumb/space/bvh/posed_mesh.hpp).  (2) Vertices are
// rounded, and the interval is widened by how far that can have moved them; under identity_pose by nothing.  So most -
// least is as small as is asked for where that is more than this rounding.  (3) Of one tree under one pose both numbers
// are 0.  (4) point is one of the rounded image; it and the numbers are infinite beyond the largest double.
// A pose that is NaN or infinite throws NonFinite ("hausdorff_from: a.pose.translation.x is nan, ...").
// Source: RTCD 3.2, 6.3.2; that the distance moves by no more than the farthest point does is the triangle inequality.
// Cost: a copy of each tree, fitted to the images; then that of hausdorff.hpp.  Bounded by n^2 log n operations for
// the vertices, as hausdorff.hpp says.
#pragma once

#include "plumb/space/bvh/posed_mesh.hpp"
#include "plumb/space/closest/hausdorff.hpp"

namespace plumb {

HausdorffDistance hausdorff_from(const PosedMesh& a, const PosedMesh& b, const HausdorffOptions& options = {});

HausdorffDistance hausdorff_distance(const PosedMesh& a, const PosedMesh& b, const HausdorffOptions& options = {});

}  // namespace plumb
