// Every pair of figures with straight edges in the plane, against brute force in rationals, both ways round; and all
// that CGAL has.
#include "query/overlap/all_pairs.hpp"

namespace plumb::pair_cases {
namespace {

TEST(OverlapPairs, AllFlatFiguresOfThePlaneAsBruteForce) { expect_all_as_oracle(Plane{}, 601); }
TEST(OverlapPairs, AllThatCgalHasOfThePlane) { expect_all_as_cgal(Plane{}, 1601); }

}  // namespace
}  // namespace plumb::pair_cases
