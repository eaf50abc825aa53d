// Reports about boxes, tetrahedra and flat figures: do they meet?
#include <gtest/gtest.h>

#include <array>

#include "docs/bugs_of_others/case.hpp"
#include "docs/bugs_of_others/proved.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/rounded_points.hpp"
#include "plumb/query/penetration/penetration.hpp"
#include "plumb/query/penetration/penetration_bounds.hpp"
#include "plumb/query/section/intersection.hpp"
#include "plumb/query/section/intersection2.hpp"
#include "plumb/query/section/intersection_result.hpp"

namespace plumb::docs {
namespace {

/// A cube of that side around the origin, under a matrix given by its rows.
Posed<Aabb3> cube(double side, const std::array<Vector3, 3>& rows, const Vector3& by) {
  const double h = side / 2;
  const auto& [x, y, z] = rows;
  return {{{-h, -h, -h}, {h, h, h}}, {{{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}}, by}};
}

constexpr std::array cases{
    Case{"CGAL/cgal#6777",
         [] {
           const Triangle3 t{{0.19163, -0.33163, -0.37}, {-0.124185, -0.385815, -0.185}, {-0.07, -0.07, 0}};
           const Tetrahedron3 corner{{0, -1, 0}, {-1, 0, 0}, {0, 0, 0}, {0, 0, -1}};
           const Intersection3 common = intersection(t, corner);
           EXPECT_EQ(common.kind, IntersectionKind::polygon);
           for (const ExactPoint3& v : common.vertices) {  // in the tetrahedron's four halfspaces, and in the plane
             const RationalPoint3 p = rational_point(v);
             EXPECT_LE(p.x, Rational(0));
             EXPECT_LE(p.y, Rational(0));
             EXPECT_LE(p.z, Rational(0));
             EXPECT_GE(p.x + p.y + p.z, Rational(-1));
             EXPECT_EQ(orient3d(t.a, t.b, t.c, v), Sign::zero);
           }
           return proved(t, corner) + ", a polygon of " + std::to_string(common.vertices.size()) + " corners";
         }},
    Case{"CGAL/cgal#8146",
         [] {
           const Triangle2 t{{-1, 0}, {0, 0}, {1, 7}};
           EXPECT_EQ(proved_flat(t, Segment2{{0.5, -1}, {0.5, -1}}), proved_flat(t, Point2{0.5, -1}));
           EXPECT_EQ(proved_flat(t, Segment2{{0.5, -1}, {0.5, 2}}), "disjoint");
           return proved_flat(t, Segment2{{0.5, -1}, {0.5, -1}});
         }},
    Case{"CGAL/cgal#6808",
         [] {
           return proved(
               Triangle3{{-34.1128, -4.00842, 39.5061}, {-36.0938, -3.6615, 36.87}, {-34.5781, -3.61804, 39.9716}},
               Aabb3{{-52.3586, -14.3376, 25.3037}, {-38.021, 0, 39.6414}});
         }},
    Case{"CGAL/cgal#165",
         [] {
           std::string corners;
           const Triangle2 t{{150, 50}, {250, 170}, {50, 170}};
           for (const ExactPoint2& v : intersection(t, Aabb2{{100, 100}, {200, 200}}).vertices) {
             const RationalPoint2 p = rational_point(v);
             corners += (corners.empty() ? "(" : " (") + p.x.text() + ", " + p.y.text() + ")";
           }
           return corners;
         }},
    Case{"JuliaGeometry/Meshes.jl#809",
         [] {
           return proved(Triangle3{{-60, -35, 55}, {-68.75, -33.43333, 54.90143}, {-68.75, -35, 55}},
                         Aabb3{{-77.5, -35, 54.6073}, {-68.75, -31.8914, 55}});
         }},
    Case{"juj/MathGeoLib#51",
         [] {
           return proved(Triangle3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Aabb3{{-2, -2, -2}, {2, 2, 2}});
         }},
    Case{"juj/MathGeoLib#12",
         [] {
           const double sine = 0.86602540378444F;
           const Pose turned{{{{0, -0.5, -sine}, {0, sine, -0.5}, {1, 0, 0}}}, {0, 0, 0}};
           return proved(Aabb3{{0, 0, 0}, {1, 1, 1}}, Posed{Aabb3{{0, 0, 0}, {2, 2, 2}}, turned});
         }},
    Case{"erincatto/box2d#883",
         [] {
           const double half = 0.4F;
           const Aabb3 large{{2.5, 4.5, 0}, {3.5, 5.5, 0}}, small{{3 - half, 5 - half, 0}, {3 + half, 5 + half, 0}};
           EXPECT_EQ(told(relate(Aabb2{{2.5, 4.5}, {3.5, 5.5}}, Aabb2{{3 - half, 5 - half}, {3 + half, 5 + half}})),
                     "overlapping");
           return proved(large, small);
         }},
    Case{"dimforge/parry#70",
         [] {
           const Aabb3 ground{{-50, -100, -50}, {50, 0, 50}};
           int met = 0;
           for (int step = 0; step < 200; ++step) {
             const double y = -0.5 + 0.005 * step;
             met += intersects(Capsule3{{0, y - 0.5, 0}, {0, y + 0.5, 0}, 0.5}, ground) ? 1 : 0;
           }
           EXPECT_EQ(proved(Capsule3{{0, 0.5, 0}, {0, 1.5, 0}, 0.5}, ground), "touching");
           return std::to_string(met) + " of 200 meet";
         }},
    Case{"dimforge/parry#34",
         [] {
           const Circle2 ball{{1, 1}, 1};
           EXPECT_EQ(proved(Sphere3{{1, 1, 0}, 1}, Aabb3{{-1, -1, 0}, {1, 1, 0}}), "overlapping");
           return told(relate(ball, Aabb2{{-1, -1}, {1, 1}}));
         }},
    Case{"dimforge/parry#415",
         [] {
           const Segment2 s{{60, 10}, {10, 0}};
           EXPECT_EQ(proved(in_space(s), Aabb3{{40, -50, 0}, {60, 150, 0}}), "overlapping");
           return told(relate(s, Aabb2{{40, -50}, {60, 150}}));
         }},
    Case{"dimforge/parry#315",
         [] {
           const Aabb3 left{{0, 0, 0}, {1, 1, 1}}, right{{1, 0, 0}, {2, 1, 1}};
           const std::optional<Penetration> p = penetration(left, right);
           return proved(left, right) + ", " + told(p->depth) + " deep along " +
                  told(Point3{p->direction.x, p->direction.y, p->direction.z});
         }},
    Case{"dimforge/parry#396",
         [] {
           const PenetrationBounds p =
               penetration(Cylinder3{{0, -50, 0}, {0, 50, 0}, 100}, Cylinder3{{0, -1.5, 0}, {0, 1.5, 0}, 1});
           EXPECT_LE(p.lower, 51.5);
           EXPECT_LT(51.5 - p.lower, 1e-12);
           EXPECT_GE(p.upper, 51.5);
           EXPECT_LT(p.upper - 51.5, 1e-12);
           return std::string(p.lower > 0 ? "they meet" : "undecided");
         }},
    Case{"davideberly/GeometricTools#29",
         [] {
           const double h = 0.203217 / 2;
           const Point3 o{0.490062, 0.516011, 0.705511};
           const Vector3 d{0.357778, 0.00360225, 0.9338};
           const Cylinder3 can{
               {o.x - h * d.x, o.y - h * d.y, o.z - h * d.z}, {o.x + h * d.x, o.y + h * d.y, o.z + h * d.z}, 0.130149};
           EXPECT_EQ(proved(Capsule3{can.a, can.b, can.radius},
                            Aabb3{{0.168216, 0.389476, 0.0822103}, {0.291133, 0.452832, 0.194713}}),
                     "disjoint");  // which holds the cylinder
           return told(relate(can, Aabb3{{0.168216, 0.389476, 0.0822103}, {0.291133, 0.452832, 0.194713}}));
         }},
    Case{"danfis/libccd#25",
         [] {
           const Aabb3 lower{{-1, -1, -1}, {1, 1, 1}}, upper{{-1, -1, 0.9}, {1, 1, 2.9}};
           const std::optional<Penetration> p = penetration(lower, upper);
           EXPECT_EQ(exact_penetration(lower, upper)->core_translation.z, Rational(0.9) - Rational(1));
           return proved(lower, upper) + ", " + told(p->depth) + " deep along (0, 0, -1)" +
                  (p->direction == Vector3{0, 0, -1} ? "" : "?");
         }},
    Case{"flexible-collision-library/fcl#493",
         [] {
           const std::array<Vector3, 3> rows{
               {{0.96193976625564348026, 0.15401279915737359216, 0.22572537250328919556},
                {-0.19134171618254486313, 0.96936494951283913579, 0.15401279915737359216},
                {-0.19509032201612822033, -0.19134171618254486313, 0.96193976625564348026}}};
           return proved(cube(0.5, rows, {2.0770063995786869349, 0.48468247475641951239, 1.1543291419087275962}),
                         cube(0.5, rows, {2, 0, 1.25}));
         }},
    Case{"flexible-collision-library/fcl#495",
         [] {
           const std::array<Vector3, 3> rows{
               {{0.94096063217417758029, 0.29296840037289501035, 0.16959541586174811667},
                {-0.23569836841299879326, 0.92661523595848427348, -0.29296840037289506586},
                {-0.2429801799032638987, 0.23569836841299884878, 0.94096063217417758029}}};
           return proved(cube(0.25, rows, {0.073242100093223821977, 0.2316538089896212349, 1.3089245921032497399}),
                         cube(0.25, rows, {0, 0, 1.25}));
         }},
    Case{"godotengine/godot#69455",
         [] {
           const Aabb3 two_wide{{-1, -1, -1}, {1, 1, 1}};
           return proved(two_wide, Segment3{{2, 2, 0}, {2, 0, 0}}) + ", " +
                  proved(two_wide, Segment3{{0, 0, 0}, {0, 2, 0}});
         }},
};

}  // namespace

std::span<const Case> box_cases() { return cases; }

}  // namespace plumb::docs
