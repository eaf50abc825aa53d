// Reports about closest points and distances.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "docs/bugs_of_others/case.hpp"
#include "plumb/figure/basic/rigid_poses.hpp"
#include "plumb/query/certificate/verify.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "plumb/query/gjk/gjk.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed_distance.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/query/separation/posed.hpp"
#include "plumb/query/separation/separation.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"

namespace plumb::docs {
namespace {

/// The distance, which a verified certificate names as well.
template <class A, class B>
std::string proved_distance(const A& a, const B& b) {
  const DistanceCertificate proof = distance_with_proof(a, b);
  const auto verdict = verify(proof, a, b);
  EXPECT_TRUE(verdict) << verdict.flaw;
  EXPECT_EQ(proof.distance, distance(a, b));
  return told(proof.distance);
}

template <class A, class B>
std::string with_points(const A& a, const B& b) {
  const Closest c = closest_points(a, b);
  return proved_distance(a, b) + " from " + told(c.on_a) + " to " + told(c.on_b);
}

constexpr std::array cases{
    Case{"dimforge/parry#76",
         [] {
           const Point3 p{1.10000002F, -7.9000001F, 16.5879993F}, a{2.27699995F, -7.9000001F, 16.3180008F},
               b{-0.569999993F, -8.10000038F, 16.6070004F};
           EXPECT_EQ(distance(Triangle3{a, b, b}, p), distance(Segment3{a, b}, p));
           return proved_distance(p, Triangle3{a, b, b});
         }},
    Case{"dimforge/parry#310",
         [] {
           const Triangle2 t{{40, 0}, {0, 80}, {0, 80}};
           EXPECT_EQ(squared_distance_exact(t, Point2{0, 0}), Rational(1280));
           EXPECT_TRUE(intersects(t, Circle2{{0, 0}, 100}));
           return told(closest_point(t, {0, 0})) + " at " + told(distance(t, Point2{0, 0}));
         }},
    Case{"FEniCS/dolfinx#3653",
         [] {
           const std::vector<Point3> corners{{46.0659, 38.6251, 16.3637}, {44.2764, 42.3867, 18.239},
                                             {50.0397, 38.4649, 19.9843}, {47.1963, 40.4563, 19.1057},
                                             {48.0266, 38.5593, 18.2475}, {45.1735, 40.495, 17.3336},
                                             {48.0415, 40.4456, 18.1963}};
           const Point3 p{44.2919, 39.7508, 18.8208};
           const DistanceCertificate proof = distance_with_proof(p, VertexHull3{corners});
           EXPECT_TRUE(verify(proof, p, VertexHull3{corners}));
           EXPECT_EQ(gjk_distance(p, VertexHull3{corners}), proof.distance);
           return told(proof.distance);
         }},
    Case{"flexible-collision-library/fcl#275",
         [] {
           return with_points(Sphere3{{0, 0, 0}, 20}, Sphere3{{0, 40, 0}, 10});
         }},
    Case{"flexible-collision-library/fcl#127",
         [] {
           return with_points(Sphere3{{0, 0, 0}, 1}, Aabb3{{-5, 4, -2}, {5, 6, 8}});
         }},
    Case{
        "flexible-collision-library/fcl#293",
        [] {
          Pose pose = rounded_pose(RigidPose{{0.672811, 0.340674, 0.155066, 0.638138}});
          pose.translation = {0.192074, -0.27787, 0.273546};
          const Posed<Aabb3> small{{{-0.212, -0.075, -0.0843}, {0.212, 0.075, 0.0843}}, pose};
          const Posed<Aabb3> plate{{{-1.375, -3, -0.025}, {1.375, 3, 0.025}}, {identity_pose.columns, {1.625, 0, 0.5}}};
          return with_points(plate, small);
        }},
    Case{"dimforge/parry#431",
         [] {
           const double x = -5.573167F;
           const Aabb2 a{{-1, -1}, {1, 1}}, b{{x - 1, -2}, {x + 1, 2}};
           EXPECT_EQ(distance(a, b), distance(b, a));
           EXPECT_EQ(squared_distance_exact(a, b), (Rational(-1) - Rational(x + 1)) * (Rational(-1) - Rational(x + 1)));
           return told(distance(a, b));
         }},
    Case{"godotengine/godot#55383",
         [] {
           return proved_distance(Segment3{{0, -2.5, 0}, {0, 2.5, 0}},
                                  Segment3{{2.9888, -5.1938, 0}, {2.9888, 4.8062, 0}});
         }},
    Case{"godotengine/godot#55617",
         [] {
           return with_points(Segment3{{1, -2, 0}, {1, 2, 0}}, Segment3{{-1, 2, 0}, {-1, -2, 0}});
         }},
    Case{"sceneview/sceneview#1139",
         [] {
           return with_points(Segment3{{0, 0, 0}, {2, 0, 0}}, Segment3{{1, 1, 0}, {1, 3, 0}});
         }},
    Case{"RiSearcher/GeometRi.CSharp#16",
         [] {
           const Segment3 a{{399.83, 273.22, 0}, {399.83, 253.56, 0}}, b{{401.53, 283.1, 0}, {401.53, 272.6, 0}};
           const Rational across = Rational(401.53) - Rational(399.83);
           EXPECT_EQ(squared_distance_exact(a, b), across * across);
           return proved_distance(a, b);
         }},
    Case{"isl-org/Open3D#5105",
         [] {
           TriangleMesh cube;
           for (int i = 0; i < 8; ++i) cube.vertices.push_back({1.0 * (i & 1), 1.0 * (i >> 1 & 1), 1.0 * (i >> 2)});
           cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                             {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
           const Bvh bvh = build_bvh(cube);
           std::string all;
           for (const Point3& p : {Point3{-1, -1, 0}, {-1, -1, -1}, {0.5, 0.5, 0.5}}) {
             all +=
                 (all.empty() ? "" : ", ") + told(locate(cube, p)) + " at " + told(closest_on_mesh(bvh, p)->distance);
           }
           return all;
         }},
};

}  // namespace

std::span<const Case> distance_cases() { return cases; }

}  // namespace plumb::docs
