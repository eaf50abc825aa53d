// Every pair of figures with straight edges in space, against brute force in rationals, both ways round.
#include "query/pair_laws.hpp"

namespace plumb::pair_cases {
namespace {

using Flat3 =
    Types<Point3, Line3, Ray3, Segment3, Plane3, ThreePointPlane3, Halfspace3, Triangle3, Quadrilateral3, Polygon3,
          HoledPolygon3, Rectangle3, Tetrahedron3, Aabb3, Obb3, KDop3, HalfspaceIntersection3, ConvexPolyhedron3>;

TEST(OverlapPairs, AllFlatFiguresOfSpaceAsBruteForce) { expect_all_as_oracle(Flat3{}, 501, 16); }

}  // namespace
}  // namespace plumb::pair_cases
