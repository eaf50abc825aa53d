// Every pair of figures with straight edges in the plane, against brute force in rationals, both ways round.
#include "query/pair_laws.hpp"

namespace plumb::pair_cases {
namespace {

using Flat2 = Types<Point2, Line2, Ray2, Segment2, Halfspace2, Triangle2, Quadrilateral2, Polygon2, HoledPolygon2,
                    Aabb2, Obb2, KDop2, HalfspaceIntersection2>;

TEST(OverlapPairs, AllFlatFiguresOfThePlaneAsBruteForce) { expect_all_as_oracle(Flat2{}, 601, 60); }

}  // namespace
}  // namespace plumb::pair_cases
