#include "tool/manual/meanings.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace plumb::tool {
namespace {

using Meaning = std::pair<std::string_view, std::string_view>;

constexpr std::array kMeanings{
    Meaning{"orient2d", "'+' when a, b, c turn counterclockwise, '0' when collinear."},
    Meaning{"orient3d",
            "'+' when d lies below the plane of a, b, c, where above is the side that sees them counterclockwise; '0' "
            "when coplanar."},
    Meaning{"incircle", "For counterclockwise a, b, c: '+' when d is inside their circle."},
    Meaning{"insphere", "For orient3d(a, b, c, d) = '+': '+' when e is inside their sphere."},

    Meaning{"order_on_axis", "'+' when a is the larger number."},
    Meaning{"order_along_direction2d", "'+' when a lies farther along the vector c than b."},
    Meaning{"order_along_direction3d", "'+' when a lies farther along the vector c than b."},
    Meaning{"order_along_line2d", "'+' when a lies farther along the line from c to d than b."},
    Meaning{"order_along_line3d", "'+' when a lies farther along the line from c to d than b."},
    Meaning{"dot2d", "'+' when the vectors a, b enclose an acute angle, '0' a right one."},
    Meaning{"dot3d", "'+' when the vectors a, b enclose an acute angle, '0' a right one."},
    Meaning{"angle2d", "'+' when the angle at b, between a and c, is acute, '0' when it is right."},
    Meaning{"angle3d", "'+' when the angle at b, between a and c, is acute, '0' when it is right."},
    Meaning{"cross2d", "'+' when the vector b points to the left of a, '0' when they are parallel."},
    Meaning{"cross_x", "The x of the cross product of the vectors a and b."},
    Meaning{"cross_y", "The y of the cross product of the vectors a and b."},
    Meaning{"cross_z", "The z of the cross product of the vectors a and b."},
    Meaning{"orient_x", "'+' when a, b, c turn counterclockwise, seen from the far end of the x axis."},
    Meaning{"orient_y", "'+' when a, b, c turn counterclockwise, seen from the far end of the y axis."},
    Meaning{"orient_z", "'+' when a, b, c turn counterclockwise, seen from the far end of the z axis."},

    Meaning{"compare_distance2d", "|ab| against |cd|."},
    Meaning{"compare_distance3d", "|ab| against |cd|."},
    Meaning{"compare_distance_from2d", "|ab| against |ac|."},
    Meaning{"compare_distance_from3d", "|ab| against |ac|."},
    Meaning{"distance_against2d", "|ab| against the magnitude of c."},
    Meaning{"distance_against3d", "|ab| against the magnitude of c."},
    Meaning{"signed_line_distance",
            "Signed distances from the line ab, positive to its left: that of c against that of d."},
    Meaning{"line_distance_sum", "The sum of these signed distances of c and d."},
    Meaning{"compare_line_distance", "Distances from the line ab: that of c against that of d."},
    Meaning{"line_distance_against2d", "The distance of c from the line ab against the magnitude of d."},
    Meaning{"line_distance_against3d", "The distance of c from the line ab against the magnitude of d."},
    Meaning{"compare_point_line2d", "|ab| against the distance of e from the line cd."},
    Meaning{"compare_point_line3d", "|ab| against the distance of e from the line cd."},
    Meaning{"compare_line_line2d", "The distance of c from the line ab against that of f from the line de."},
    Meaning{"compare_line_line3d", "The distance of c from the line ab against that of f from the line de."},
    Meaning{"side_of_line", "'+' when c lies on the side of the line a.x = b to which its normal a points."},
    Meaning{"side_of_plane", "'+' when c lies on the side of the plane a.x = b to which its normal a points."},
    Meaning{"normal_distance_against2d", "The distance of c from the line a.x = b against the magnitude of d."},
    Meaning{"normal_distance_against3d", "The distance of c from the plane a.x = b against the magnitude of d."},
    Meaning{"signed_plane_distance",
            "Signed distances from the plane abc, positive where a, b, c are seen counterclockwise: that of d against "
            "that of e."},
    Meaning{"plane_distance_sum", "The sum of these signed distances of d and e."},
    Meaning{"plane_distance_against", "The distance of d from the plane abc against the magnitude of e."},
    Meaning{"compare_point_plane", "|ab| against the distance of f from the plane cde."},
    Meaning{"compare_line_plane", "The distance of c from the line ab against that of g from the plane def."},
    Meaning{"compare_plane_plane", "The distance of d from the plane abc against that of h from the plane efg."},

    Meaning{"in_smallest_circle", "'+' when c is inside the circle with diameter ab."},
    Meaning{"in_smallest_sphere2", "'+' when c is inside the sphere with diameter ab."},
    Meaning{"in_smallest_sphere3", "'+' when d is inside the smallest sphere through a, b, c."},
    Meaning{"power_circle",
            "For counterclockwise a, b, c: '+' when d, of weight w, lies below the power circle of a, b, c."},
    Meaning{"power_sphere",
            "For orient3d(a, b, c, d) = '+': '+' when e, of weight w, lies below the power sphere of a, b, c, d."},
    Meaning{"compare_power2d", "The power |ab|^2 - w of a from b against that from c."},
    Meaning{"compare_power3d", "The power |ab|^2 - w of a from b against that from c."},
    Meaning{"power_product2d", "|ab|^2 against the sum of both weights; '0' when the circles are orthogonal."},
    Meaning{"power_product3d", "|ab|^2 against the sum of both weights; '0' when the spheres are orthogonal."},
    Meaning{"determinant2", "The determinant of the rows a, b."},
    Meaning{"determinant3", "The determinant of the rows a, b, c."},
    Meaning{"determinant4", "The determinant of the rows a, b, c, d."},
    Meaning{"determinant5", "The determinant of the rows a, b, c, d, e."},

    Meaning{"line_edge",
            "'+' when the line from a in direction b passes the edge from c to d on its left, seen from where it "
            "comes."},
    Meaning{"orient_seen_from", "'+' when b, c, d turn counterclockwise for an eye far away in direction a."},
    Meaning{"orient_seen_along", "'+' when c, d, e turn counterclockwise for an eye far away in direction ab."},
    Meaning{"ray_order",
            "N1 D2 - N2 D1, where the line from a in direction b meets the planes cde and fgh at N1 / D1 and N2 / D2."},
    Meaning{"segment_order", "N1 D2 - N2 D1, where the line from a to b meets the planes cde and fgh."},
    Meaning{"ray_against", "'+' when the point a + f b lies below the plane cde."},
    Meaning{"segment_against", "'+' when the point a + f (b - a) lies below the plane cde."},
    Meaning{"dot_of_crosses", "(a x b) . (c x d) of four vectors."},
    Meaning{"coplanar_side", "'+' when c and d lie on the same side of the line ab, in their common plane."},
    Meaning{"order_along_cross", "'+' when d lies farther than c along a x b."},
    Meaning{"box_gap",
            "(b - a) . L less the products of e, f, g, h with L, taken i, j, k, l times, for L = c x d: '+' when L "
            "separates two boxes whose signs are resolved."},
    Meaning{"coplanarity_middle",
            "Three times the second Bernstein coefficient of orient3d of points that move from a, b, c, d to e, f, g, "
            "h."},
    Meaning{"radical_norm", "a^2 - b^2 c."},
    Meaning{"radical_pair_part", "a^2 + b^2 c - d^2 e."},
    Meaning{"radical_pair_norm", "(a^2 + b^2 c - d^2 e)^2 - 4 a^2 b^2 c."},
};

}  // namespace

std::string_view meaning_of(std::string_view predicate) {
  const auto found = std::ranges::find(kMeanings, predicate, &Meaning::first);
  return found == kMeanings.end() ? std::string_view{} : found->second;
}

}  // namespace plumb::tool
