// What do questions about one figure and about two of them cost?
#pragma once

#include <array>

#include "space/cost_row.hpp"

namespace plumb::cost {

inline const CostRow rows_of_figures[]{
    {"real_roots", "arith/root.hpp", fixed, 300,
     [](const Cloud& c) {
       std::vector<Rational> coefficients;
       for (std::size_t i = 0; i < 5; ++i) coefficients.emplace_back(c.a[i].x);
       for (const Root& r : real_roots(coefficients)) (void)r.rounded();
     },
     72, 1},
    // figure
    {"convex_hull, plane", "figure/hull/hull2.hpp", sorting, 1, [](const Cloud& c) { (void)convex_hull(c.flat); }},
    {"convex_hull, plane, quickhull", "figure/hull/hull2.hpp", quadratic, 1,
     [](const Cloud& c) { (void)convex_hull(c.flat, {.method = Hull2Method::quickhull}); }},
    {"convex_hull", "figure/hull/hull3.hpp", cubic, 10, [](const Cloud& c) { (void)convex_hull(c.a); }},
    {"convex_hull, incremental", "figure/hull/hull3.hpp", cubic, 10,
     [](const Cloud& c) { (void)convex_hull(c.a, {.method = HullMethod::incremental}); }},
    {"Hull3Builder", "figure/hull/hull3.hpp", cubic, 10,
     [](const Cloud& c) {
       Hull3Builder builder;
       for (const Point3& p : c.a) (void)builder.insert(p);
       (void)builder.hull();
     }},
    {"verify_hull", "figure/hull/verify_hull.hpp", quadratic, 10,
     [](const Cloud& c) { (void)verify_hull(convex_hull(c.a), c.a); }},
    {"minimum_circle", "figure/sphere/minimum_sphere.hpp", linear, 5,
     [](const Cloud& c) { (void)minimum_circle(c.flat); }},
    {"minimum_sphere", "figure/sphere/minimum_sphere.hpp", linear, 50,
     [](const Cloud& c) { (void)minimum_sphere(c.a); }},
    {"minimum_sphere of balls", "figure/sphere/minimum_sphere.hpp", linear, 200,
     [](const Cloud& c) { (void)minimum_sphere(balls(c.a)); }},
    {"fit_sphere_iterated_ritter", "figure/sphere/fits.hpp", linear, 5,
     [](const Cloud& c) { (void)fit_sphere_iterated_ritter(c.a); }},
    {"minimum_obb, plane", "figure/obb/minimum_obb.hpp", quadratic, 5,
     [](const Cloud& c) { (void)minimum_obb(c.flat); }},
    {"minimum_obb", "figure/obb/minimum_obb.hpp", quadratic, 150, [](const Cloud& c) { (void)minimum_obb(c.a); }},
    {"fit_obb_brute_force", "figure/obb/fits.hpp", linear, 100, [](const Cloud& c) { (void)fit_obb_brute_force(c.a); }},
    {"fit_capsule", "figure/swept_sphere/swept_sphere.hpp", linear, 20, [](const Cloud& c) { (void)fit_capsule(c.a); }},
    {"fit_lozenge", "figure/swept_sphere/swept_sphere.hpp", linear, 50, [](const Cloud& c) { (void)fit_lozenge(c.a); }},
    {"fit_cylinder", "figure/swept_sphere/swept_sphere.hpp", linear, 5,
     [](const Cloud& c) { (void)fit_cylinder(c.a); }},
    {"merge of capsules", "figure/swept_sphere/swept_sphere.hpp", linear, 5,
     [](const Cloud& c) { (void)merge(capsule(c.a), capsule(c.b)); }},
    {"merge of boxes", "figure/obb/obb.hpp", fixed, 20, [](const Cloud& c) { (void)merge(box(c.a), box(c.b)); }},
    {"choose_bound", "figure/bound/choose_bound.hpp", quadratic, 200,
     [](const Cloud& c) { (void)choose_bound(c.a, {}, {.placements = 4}); }, 72, 1},
    {"hull_proxy", "figure/bound/proxy.hpp", cubic, 20, [](const Cloud& c) { (void)hull_proxy(c.mesh); }},
    {"relate of k-DOPs", "figure/k_dop/k_dop.hpp", linear, 1,
     [](const Cloud& c) { (void)relate(fit_k_dop(c.a, 14), fit_k_dop(c.b, 14)); }},
    {"tighten", "figure/k_dop/k_dop.hpp", linear, 50, [](const Cloud& c) { (void)tighten(fit_k_dop(c.a, 14)); }},
    {"minkowski_sum", "figure/minkowski/minkowski.hpp", quadratic_log, 100,
     [](const Cloud& c) { (void)minkowski_sum(c.p, c.q); }},
    {"locate, polyhedron", "figure/basic/polyhedron.hpp", linear, 5,
     [](const Cloud& c) {
       for (const Point3& p : asked_points(c)) (void)locate(c.p, p);
     }},
    {"check_polyhedron", "figure/basic/polyhedron.hpp", sorting, 20, [](const Cloud& c) { check_polyhedron(c.p); }},
    {"locate, polygon", "figure/containment/polygon_location.hpp", linear, 1,
     [](const Cloud& c) {
       (void)locate(chain(c), Point2{c.b[0].x, c.b[0].y});
     }},
    {"voronoi_region", "figure/containment/voronoi_region.hpp", linear, 50,
     [](const Cloud& c) { (void)voronoi_region(c.p, c.b[0]); }},
    {"is_convex", "figure/basic/convexity.hpp", linear, 5, [](const Cloud& c) { (void)is_convex(chain(c)); }},
    {"support_point", "figure/support/support.hpp", linear, 1,
     [](const Cloud& c) { (void)support_point(c.p, vector(c.b[0])); }},
    {"ClimbingAabb", "figure/aabb/climbing_aabb.hpp", linear, 5,
     [](const Cloud& c) {
       ClimbingAabb climbing(c.p);
       (void)climbing(pose(c.a)), (void)climbing(pose(c.b));
     }},
    {"surface_area, mesh", "figure/measures/measures.hpp", sorting, 20,
     [](const Cloud& c) { (void)surface_area(c.mesh); }},
    // query
    {"relate, ellipsoid and triangle", "query/overlap/ellipsoid.hpp", linear, 50,
     [](const Cloud& c) { (void)relate(ellipsoid(c.a), triangle(c.b)); }},
    {"relate, ellipsoids", "query/overlap/ellipsoid.hpp", fixed, 500,
     [](const Cloud& c) { (void)relate(ellipsoid(c.a), ellipsoid(c.b)); }, 72, 1},
    {"relate, triangles", "query/overlap/overlap.hpp", quadratic, 5,
     [](const Cloud& c) { (void)relate(triangle(c.a), triangle(c.b)); }},
    {"relate, polyhedra", "query/overlap/overlap.hpp", quadratic, 100, [](const Cloud& c) { (void)relate(c.p, c.q); }},
    {"relate, polygons of space", "query/overlap/overlap.hpp", quadratic, 300,
     [](const Cloud& c) {
       (void)relate(Polygon3{{c.a[0], c.a[1], c.a[2]}}, Polygon3{{c.b[0], c.b[1], c.b[2]}});
     }},
    {"relate, posed boxes", "query/overlap/posed.hpp", quadratic, 100,
     [](const Cloud& c) {
       (void)relate(Posed{box(c.a), pose(c.b)}, Posed{box(c.b), pose(c.a)});
     }},
    {"relate, posed polyhedra", "query/overlap/posed.hpp", quadratic, 500,
     [](const Cloud& c) {
       (void)relate(Posed{c.p, pose(c.b)}, Posed{c.q, pose(c.a)});
     }},
    {"distance, posed triangles", "query/overlap/posed_distance.hpp", quadratic, 100,
     [](const Cloud& c) {
       (void)distance(Posed{triangle(c.a), pose(c.b)}, triangle(c.b));
     }},
    {"distance, triangles", "query/closest/closest.hpp", quadratic, 20,
     [](const Cloud& c) { (void)distance(triangle(c.a), triangle(c.b)); }},
    {"closest_points, triangles", "query/closest/pairs.hpp", quadratic, 20,
     [](const Cloud& c) { (void)closest_points(triangle(c.a), triangle(c.b)); }, 72, 2},
    {"nearest of a batch", "query/closest/batch.hpp", linear, 20,
     [](const Cloud& c) { (void)nearest(TriangleBatch(c.triangles), c.b[0]); }},
    {"gjk, first pair", "query/closest/which_pair.hpp", quadratic, 200,
     [](const Cloud& c) { (void)gjk(c.p, c.q, {.pair = WhichPair::first}); }, 72, 2},
    {"closest_points, posed boxes", "query/separation/posed.hpp", quadratic, 50,
     [](const Cloud& c) {
       (void)closest_points(Posed{box(c.a), pose(c.b)}, box(c.b));
     },
     72, 1},
    {"exact_distance, capsules", "query/separation/separation.hpp", quadratic, 50,
     [](const Cloud& c) { (void)exact_distance(capsule(c.a), capsule(c.b)); }},
    {"distance", "query/separation/separation.hpp", quadratic, 50, [](const Cloud& c) { (void)distance(c.p, c.q); }},
    {"relate_with_proof", "query/certificate/certificate.hpp", quadratic, 200,
     [](const Cloud& c) { (void)relate_with_proof(c.p, c.q); }},
    {"intersection, triangles", "query/section/intersection.hpp", quadratic, 20,
     [](const Cloud& c) { (void)intersection(triangle(c.a), triangle(c.b)); }},
    {"intersection, polygons of space", "query/section/intersection.hpp", quadratic, 20,
     [](const Cloud& c) {
       (void)intersection(Polygon3{{c.a[0], c.a[1], c.a[2]}}, triangle(c.b));
     }},
    {"intersection, plane", "query/section/intersection2.hpp", quadratic, 5,
     [](const Cloud& c) {
       (void)intersection(Triangle2{c.flat[0], c.flat[1], c.flat[2]}, Triangle2{c.flat[3], c.flat[4], c.flat[5]});
     }},
    {"intersection, posed triangles", "query/section/posed.hpp", quadratic, 50,
     [](const Cloud& c) {
       (void)intersection(Posed{triangle(c.a), pose(c.b)}, triangle(c.b));
     },
     72, 1},
    {"intersection, polyhedra", "query/section/solid.hpp", quadratic, 500,
     [](const Cloud& c) { (void)intersection(c.p, c.q); }},
    {"separating_face", "query/convex/separating_face.hpp", quadratic, 50,
     [](const Cloud& c) { (void)separating_face(c.p, c.q); }},
    {"contains, polyhedra", "query/convex/containment.hpp", quadratic, 50,
     [](const Cloud& c) { (void)contains(c.p, c.q); }},
    {"side_of a thick plane", "query/convex/thick_plane.hpp", linear, 50,
     [](const Cloud& c) {
       (void)side_of(ThickPlane3{vector(c.b[0]), c.b[1].x, std::fabs(c.b[2].x)}, c.p);
     }},
    {"support_value under a pose", "query/convex/posed_support.hpp", linear, 50,
     [](const Cloud& c) {
       (void)support_value(Posed{c.p, pose(c.b)}, vector(c.a[4]));
     }},
    {"ConvexLocator2", "query/convex/location.hpp", linear, 5,
     [](const Cloud& c) {
       const Hull2 hull = convex_hull(c.flat);
       Polygon2 polygon;
       for (const std::uint32_t v : hull.vertices) polygon.vertices.push_back(c.flat[v]);
       (void)ConvexLocator2(polygon).locate({c.b[0].x, c.b[0].y});
     }},
    {"first_hit, polyhedron", "query/ray/ray.hpp", linear, 20,
     [](const Cloud& c) {
       (void)first_hit(Ray3{c.b[0], vector(c.b[1])}, c.p);
     }},
    {"first_hit, posed box", "query/ray/posed.hpp", linear, 200,
     [](const Cloud& c) {
       (void)first_hit(Ray3{c.b[0], vector(c.b[1])}, Posed{box(c.a), pose(c.b)});
     },
     72, 1},
    {"first_hit, polygon", "query/ray/ray2.hpp", linear, 20,
     [](const Cloud& c) {
       (void)first_hit(Ray2{{c.b[0].x, c.b[0].y}, {c.b[1].x, c.b[1].y}}, chain(c));
     }},
    {"first_hit, csg", "query/ray/csg.hpp", quadratic, 20,
     [](const Cloud& c) {
       (void)first_hit(Ray3{c.b[0], vector(c.b[1])}, csg(tetrahedron(c.a)) - csg(balls(c.b)[2]));
     }},
    {"locate, mesh", "query/ray/parity.hpp", linear, 5, [](const Cloud& c) { (void)winding_number(c.mesh, c.b[0]); }},
    {"gjk_intersects", "query/gjk/gjk.hpp", quadratic, 50, [](const Cloud& c) { (void)gjk_intersects(c.p, c.q); }},
    {"gjk", "query/gjk/gjk.hpp", quadratic, 200, [](const Cloud& c) { (void)gjk(c.p, c.q); }},
    {"gjk of many pairs", "query/gjk/batch.hpp", quadratic, 100,
     [](const Cloud& c) {
       const std::vector<AnyBody3> bodies{any_body(c.p), any_body(c.q)};
       const std::vector<BodyPair> pairs{{0, 1}, {1, 0}};
       std::vector<std::uint8_t> meet(2);
       gjk_intersects(bodies, pairs, meet);
     },
     72, 2},
    {"gjk_intersects_moving", "query/gjk/swept.hpp", quadratic, 100,
     [](const Cloud& c) { (void)gjk_intersects_moving(c.p, vector(c.a[0]), c.q); }, 72, 2},
    {"gjk_bounds of mappings", "query/gjk/support_mapping.hpp", quadratic, 100,
     [](const Cloud& c) {
       (void)gjk_bounds([&](const Vector3& d) { return support_point(c.a, d).point; },
                        [&](const Vector3& d) { return support_point(c.b, d).point; });
     },
     72, 2},
    {"gjk_bounds", "query/gjk/figure_support.hpp", linear, 65,
     [](const Cloud& c) { (void)gjk_bounds(cone(c.a), cone(c.b)); }},
    {"vclip", "query/vclip/vclip.hpp", quadratic, 20, [](const Cloud& c) { (void)vclip(c.p, c.q); }},
    {"separating_vector", "query/vclip/separating_vector.hpp", quadratic, 50,
     [](const Cloud& c) { (void)separating_vector(c.p, c.q); }},
    {"separating_axis", "query/vclip/separating_axis.hpp", cubic, 100,
     [](const Cloud& c) { (void)separating_axis(c.p, c.q); }},
    {"build_polytope_hierarchy", "query/polytope_hierarchy/polytope_hierarchy.hpp", quadratic, 50,
     [](const Cloud& c) { (void)distance(build_polytope_hierarchy(c.p), build_polytope_hierarchy(c.q)); }},
    {"penetration", "query/penetration/penetration.hpp", quadratic_log, 200,
     [](const Cloud& c) { (void)penetration(c.p, c.q); }},
    {"exact_penetration", "query/penetration/penetration.hpp", quadratic_log, 500,
     [](const Cloud& c) { (void)exact_penetration(c.p, c.q); }},
    {"penetration_along", "query/penetration/along.hpp", quadratic_log, 500,
     [](const Cloud& c) { (void)penetration_along(c.p, c.q, vector(c.a[0])); }},
    {"penetration of cones", "query/penetration/penetration_bounds.hpp", linear, 100,
     [](const Cloud& c) { (void)penetration(cone(c.a), cone(c.b)); }},
    {"contact", "query/contact/contact.hpp", quadratic_log, 200,
     [](const Cloud& c) { (void)contact(c.p, c.q, {.margin = 100}); }},
    {"maximize, plane", "query/lp/linear_program.hpp", linear, 1,
     [](const Cloud& c) {
       (void)maximize(Vector2{c.b[0].x, c.b[0].y}, halfplanes(c.a));
     }},
    {"maximize", "query/lp/linear_program.hpp", linear, 2,
     [](const Cloud& c) { (void)maximize(vector(c.b[0]), halfspaces(c.a)); }},
    {"maximize, simplex", "query/lp/simplex.hpp", quartic, 50,
     [](const Cloud& c) {
       const std::vector<Rational> objective{c.b[0].x, c.b[0].y, c.b[0].z};
       (void)maximize(objective, linear_system(halfspaces(c.a)));
     }},
    {"solve_by_elimination", "query/lp/elimination.hpp", quartic, 100,
     [](const Cloud& c) { (void)solve_by_elimination(linear_system(halfspaces(c.a))); }, 18, 4, 18, 4},
    {"nearest_feasible", "query/lp/nearest_feasible.hpp", linear, 100,
     [](const Cloud& c) { (void)nearest_feasible(c.b[0], halfspaces(c.a)); }},
    {"greatest_margin", "query/lp/greatest_margin.hpp", quadratic, 50,
     [](const Cloud& c) { (void)greatest_margin(c.a, c.b); }},
    // query/time_of_impact
    {"first_contact, point and triangle", "query/time_of_impact/continuous_contact.hpp", fixed, 50,
     [](const Cloud& c) {
       (void)first_contact(Moving<Point3>{c.a[0], c.a[1]}, Moving<Triangle3>{triangle(c.b), triangle(c.b, 3)});
     }},
    {"first_contact, segments", "query/time_of_impact/continuous_contact.hpp", fixed, 50,
     [](const Cloud& c) {
       (void)first_contact(Moving<Segment3>{{c.a[0], c.a[1]}, {c.a[2], c.a[3]}},
                           Moving<Segment3>{{c.b[0], c.b[1]}, {c.b[2], c.b[3]}});
     }},
    {"first_contact within a separation", "query/time_of_impact/continuous_contact.hpp", fixed, 400,
     [](const Cloud& c) {
       (void)first_contact(Moving<Point3>{c.a[0], c.a[1]}, Moving<Triangle3>{triangle(c.b), triangle(c.b, 3)},
                           {.separation = std::fabs(c.a[2].x)});
     },
     72, 1},
    {"first_contact_time", "query/time_of_impact/continuous_contact.hpp", fixed, 50,
     [](const Cloud& c) {
       (void)first_contact_time(Moving<Point3>{c.a[0], c.a[1]}, Moving<Triangle3>{triangle(c.b), triangle(c.b, 3)});
     }},
    {"first_contact, translating", "query/time_of_impact/translating_contact.hpp", quadratic, 100,
     [](const Cloud& c) {
       (void)first_contact(Translating<Tetrahedron3>{tetrahedron(c.a), vector(c.a[4])}, tetrahedron(c.b));
     }},
    {"first_contact, translating polyhedra", "query/time_of_impact/translating_contact.hpp", quadratic, 500,
     [](const Cloud& c) {
       (void)first_contact(Translating<ConvexPolyhedron3>{c.p, vector(c.a[4])}, c.q);
     }},
    {"first_contact, flat", "query/time_of_impact/posed.hpp", quadratic, 200,
     [](const Cloud& c) {
       (void)first_contact(Translating<Polygon3>{{{c.a[0], c.a[1], c.a[2]}}, vector(c.a[4])}, tetrahedron(c.b));
     },
     72, 1},
    {"first_contact, posed", "query/time_of_impact/posed.hpp", quadratic, 500,
     [](const Cloud& c) {
       (void)first_contact(Translating<Posed<Obb3>>{{box(c.a), pose(c.b)}, vector(c.a[4])}, box(c.b));
     },
     72, 1},
    {"first_contact_span, moving", "query/time_of_impact/moving_distance.hpp", fixed, 5000,
     [](const Cloud& c) {
       (void)first_contact_span(Moving<Triangle3>{triangle(c.a), triangle(c.a, 3)},
                                Moving<Triangle3>{triangle(c.b), triangle(c.b, 3)}, {.resolution = 0x1p-10});
     }},
    {"first_contact_span of a motion", "query/time_of_impact/interval_halving.hpp", fixed, 1,
     [](const Cloud& c) {
       struct Motion {
         double from, speed;
         [[nodiscard]] double distance_at(double t) const { return std::fabs(from - t) / 2; }
         [[nodiscard]] double speed_between(double, double) const { return speed; }
       };
       (void)first_contact_span(Motion{std::fabs(c.a[0].x), std::fabs(c.a[1].x)}, {.resolution = 0x1p-10});
     }},
};

}  // namespace plumb::cost
