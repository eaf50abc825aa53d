// FCL's hierarchies of two meshes: all contacts, and the distance.  A common pose is its transform.
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "bench/rivals/chart_rival.hpp"
#include "bench/rivals/fcl_meshes.hpp"
#include "lab/trial/mesh_questions.hpp"

namespace plumb::bench {
namespace {

using namespace lab::trial;
using Model = FclModel;

Pairs contacts(const std::unique_ptr<Model>& a, const std::unique_ptr<Model>& b, const Pose& pose) {
  const fcl::Transform3d place = fcl_transform(pose);
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
  const fcl::Transform3d place = fcl_transform(pose);
  const fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  fcl::distance(a.get(), place, b.get(), place, request, result);
  return result.min_distance;
}

}  // namespace

void add_fcl_meshes(Rivals& all) {
  all.push_back({"mesh-pairs", of_two_meshes("fcl", "FCL's collide() of two BVHModels of OBBRSS, all contacts",
                                             fcl_model, contacts)});
  all.push_back(
      {"mesh-distance", of_two_meshes("fcl", "FCL's distance() of two BVHModels of OBBRSS", fcl_model, apart)});
}

}  // namespace plumb::bench
