// Reports about rays: hits that are missed, and hits that are none.
#include <gtest/gtest.h>

#include <array>

#include "docs/bugs_of_others/case.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/query/ray/batch.hpp"
#include "plumb/query/ray/hits.hpp"
#include "plumb/query/ray/ray.hpp"
#include "plumb/query/ray/ray2.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/ray/mesh_ray.hpp"

namespace plumb::docs {
namespace {

template <class AnyHit>
std::string told_hit(const std::optional<AnyHit>& hit) {
  return hit ? "t " + told(hit->t) + " at " + told(hit->point) : "no hit";
}

/// The hits of a mesh in order, by parameter; triangles that share an edge or a corner there are hit together.
std::string in_order(const Ray3& ray, const TriangleMesh& mesh) {
  std::string all;
  for (const NumberedHit& hit : hits(build_bvh(mesh), ray))
    all += (all.empty() ? "t " : ", ") + told(hit.hit.t) + " on triangle " + std::to_string(hit.index);
  return all.empty() ? "no hit" : all;
}

const TriangleMesh& igl_box() {
  static const TriangleMesh box{
      {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}},
      {{0, 6, 4},
       {0, 2, 6},
       {0, 3, 2},
       {0, 1, 3},
       {2, 7, 6},
       {2, 3, 7},
       {4, 6, 7},
       {4, 7, 5},
       {0, 4, 5},
       {0, 5, 1},
       {1, 5, 7},
       {1, 7, 3}}};
  return box;
}

constexpr std::array cases{
    Case{"erincatto/box2d#64",
         [] {
           return told_hit(first_hit(Segment2{{8, 4}, {13, 15}}, Segment2{{0, 0}, {10, 10}}));
         }},
    Case{"rustgd/collision-rs#25",
         [] {
           return told_hit(first_hit(Ray2{{6, 0}, {0, 1}}, Aabb2{{21, 14}, {23, 16}}));
         }},
    Case{"dimforge/parry#31",
         [] {
           return told_hit(first_hit(Ray2{{0, 0}, {1, 0}}, Segment2{{10, 10}, {10, 10}}));
         }},
    Case{"libgdx/libgdx#4901",
         [] {
           const Triangle3 thin{{100, 200, 300}, {400, 500, 600}, {400, 500, 600}};
           EXPECT_EQ(told_hit(first_hit(Ray3{{10, 20, 30}, {90, 180, 270}}, thin)), "t 1 at (100, 200, 300)");
           return told_hit(first_hit(Ray3{{10, 20, 30}, {0, -1, 0}}, thin));
         }},
    Case{"svenstaro/bvh#140",
         [] {
           const double least = 5.693442e-39F, slope = 0.70710677F;
           const Aabb3 point{{least, -5000, 5000}, {least, -5000, 5000}};
           const Ray3 skew{{-5000, -5000, 5000}, {slope, slope, 0}};
           EXPECT_FALSE(hits(skew, point));
           EXPECT_TRUE(hits(Ray3{skew.origin, {1, 0, 0}}, point));  // along the line that both are on
           return told_hit(first_hit(skew, point));
         }},
    Case{"mikedh/trimesh#1766",
         [] {
           const TriangleMesh square{{{-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}}, {{0, 1, 2}, {2, 3, 0}}};
           const Ray3 down{{0, 0, 1}, {0, 0, -1}};
           EXPECT_EQ(count_hits(build_bvh(square), down, HitRule::half_open), 1u);
           return in_order(down, square);
         }},
    Case{"libigl/libigl-python-bindings#78",
         [] {
           return in_order({{0.5, 0.1, 10}, {0, 0, -1}}, igl_box());
         }},
    Case{"bepu/bepuphysics2#253",
         [] {
           const Cylinder3 can{{0, -2, 0}, {0, 2, 0}, 3};
           EXPECT_EQ(told_hit(first_hit(Ray3{{0, -9, 0}, {0, 1, 0}}, can)), "t 7 at (0, -2, 0)");
           return told_hit(first_hit(Ray3{{0, 0, 0}, {0, 1, 0}}, can)) + "; " +
                  told_hit(first_hit(Ray3{{0, 0, 0}, {0, 0, 1}}, can));
         }},
    Case{"NVIDIAGameWorks/PhysX#487",
         [] {
           const Capsule3 post{{0, 0, 0}, {0, 0, 4}, 1};
           EXPECT_EQ(told_hit(first_hit(Ray3{{1.25, 0, 2}, {-1, 0, 0}}, post)), "t 0.25 at (1, 0, 2)");
           return told_hit(first_hit(Ray3{{1.25, 0, 2}, {1, 0.5, 0}}, post));
         }},
    Case{"turanszkij/WickedEngine#1695",
         [] {
           return told_hit(first_hit(Ray3{{0, 0, 0}, {0, 0, 1}}, Sphere3{{0, 0, 0}, 2}));
         }},
    Case{"RayTracing/raytracing.github.io#927",
         [] {
           return told_hit(first_hit(Ray3{{0, 0, -1}, {0, 0, 1}}, Aabb3{{0, 0, 0}, {1, 1, 1}}));
         }},
};

}  // namespace

std::span<const Case> ray_cases() { return cases; }

}  // namespace plumb::docs
