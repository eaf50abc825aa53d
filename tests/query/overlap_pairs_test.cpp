// Every pair of figures with straight edges in space, against brute force in rationals, both ways round; and all that
// CGAL has.
#include "query/pair_laws.hpp"

namespace plumb::pair_cases {
namespace {

TEST(OverlapPairs, AllFlatFiguresOfSpaceAsBruteForce) { expect_all_as_oracle(Space{}, 501, 16); }
TEST(OverlapPairs, AllThatCgalHasOfSpace) { expect_all_as_cgal(Space{}, 1501, 40); }

}  // namespace
}  // namespace plumb::pair_cases
