// Figures of the plane against a linear program in rationals.
#include "plumb/query/overlap2.hpp"

#include "query/relation_counts.hpp"

namespace plumb {
namespace {

template <class Pair>
struct Overlap2 : testing::Test {};
template <class A, class B>
struct Of {
  using First = A;
  using Second = B;
};
using Pairs =
    testing::Types<Of<Line2, Line2>, Of<Line2, Ray2>, Of<Line2, Segment2>, Of<Line2, Triangle2>, Of<Line2, Aabb2>,
                   Of<Ray2, Ray2>, Of<Ray2, Segment2>, Of<Ray2, Triangle2>, Of<Ray2, Aabb2>, Of<Segment2, Segment2>,
                   Of<Segment2, Triangle2>, Of<Segment2, Aabb2>, Of<Triangle2, Triangle2>, Of<Triangle2, Aabb2>>;
TYPED_TEST_SUITE(Overlap2, Pairs);

TYPED_TEST(Overlap2, AgreesWithTheOracle) {
  expect_as_oracle<typename TypeParam::First, typename TypeParam::Second>(51, 1000);
}

}  // namespace
}  // namespace plumb
