#include <algorithm>

#include "bench/rivals/chart_rival.hpp"
#include "bench/rivals/fcl_calls.hpp"

namespace plumb::bench {
namespace {

using namespace fcl_calls;

template <std::size_t N>
std::array<Vec, N / 3> points_of(const std::array<double, N>& q) {
  std::array<Vec, N / 3> p;
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = Vec(&q[3 * i]);
  return p;
}

/// Of coordinates whose products of three overflow nothing is asked: of NaNs FCL would halve the time millions of
/// times.
double within_range(const std::array<Vec, 8>& p, bool (*ask)(const std::array<Vec, 8>&)) {
  const auto huge = [](const Vec& v) { return v.cwiseAbs().maxCoeff() >= 0x1p300; };
  return std::ranges::any_of(p, huge) ? lab::trial::unsure : lab::trial::as_answer(ask(p));
}

}  // namespace

void add_fcl(Rivals& all) {
  join<18>(all, "triangle-triangle", "fcl", "FCL's Intersect::intersect_Triangle, as its meshes ask", points_of<18>,
           [](const std::array<Vec, 6>& p) { return triangles_meet(p.data()); });
  join<12>(
      all, "box-box", "fcl", "FCL's AABB::overlap",
      [](const std::array<double, 12>& q) {
        return std::pair{fcl::AABBd(Vec(&q[0]), Vec(&q[3])), fcl::AABBd(Vec(&q[6]), Vec(&q[9]))};
      },
      [](const std::pair<fcl::AABBd, fcl::AABBd>& q) { return q.first.overlap(q.second); });
  join<30>(
      all, "obb-obb", "fcl", "FCL's OBB::overlap, of its hierarchies",
      [](const std::array<double, 30>& q) {
        return std::pair{bound(&q[0]), bound(&q[15])};
      },
      [](const std::pair<fcl::OBBd, fcl::OBBd>& q) { return q.first.overlap(q.second); });
  join<30>(
      all, "obb-obb", "fcl-collide", "FCL's collide() of two Boxes",
      [](const std::array<double, 30>& q) {
        return std::pair{Box(&q[0]), Box(&q[15])};
      },
      [](const std::pair<Box, Box>& q) { return meet(q.first, q.second); });
  struct PointAndTriangle {
    fcl::Sphered point;
    fcl::Transform3d place;
    std::array<Vec, 3> corners;
  };
  join<12>(
      all, "point-triangle-distance", "fcl", "FCL's sphereTriangleDistance, a sphere of radius 0",
      [](const std::array<double, 12>& q) {
        return PointAndTriangle{
            fcl::Sphered(0), fcl::Transform3d(fcl::Translation3d(Vec(q.data()))), {Vec(&q[3]), Vec(&q[6]), Vec(&q[9])}};
      },
      [](const PointAndTriangle& q) {
        double far = 0;
        const auto& [a, b, c] = q.corners;
        return fcl::detail::sphereTriangleDistance(q.point, q.place, a, b, c, &far) ? far : 0;
      });
  join<12>(
      all, "segment-segment-distance", "fcl", "FCL's TriangleDistance::segPoints",
      [](const std::array<double, 12>& q) {
        const Vec a(&q[0]), b(&q[3]), c(&q[6]), d(&q[9]);
        return std::array<Vec, 4>{a, b - a, c, d - c};
      },
      [](const std::array<Vec, 4>& p) {
        Vec between, x, y;
        fcl::detail::TriangleDistance<double>::segPoints(p[0], p[1], p[2], p[3], between, x, y);
        return (x - y).norm();
      });
  join<24>(all, "vertex-face-motion", "fcl", "FCL's Intersect::intersect_VF", points_of<24>,
           [](const std::array<Vec, 8>& moving) {
             return within_range(moving, [](const std::array<Vec, 8>& p) {
               double time = 0;
               Vec at;
               return OfMeshes::intersect_VF(p[1], p[2], p[3], p[0], p[5], p[6], p[7], p[4], &time, &at);
             });
           });
  join<24>(all, "edge-edge-motion", "fcl", "FCL's Intersect::intersect_EE", points_of<24>,
           [](const std::array<Vec, 8>& moving) {
             return within_range(moving, [](const std::array<Vec, 8>& p) {
               double time = 0;
               Vec at;
               return OfMeshes::intersect_EE(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], &time, &at);
             });
           });
}

}  // namespace plumb::bench
