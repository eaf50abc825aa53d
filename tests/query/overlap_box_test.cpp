// Boxes in space against a linear program in rationals.
#include "plumb/query/overlap_box.hpp"

#include "query/relation_counts.hpp"

namespace plumb {
namespace {

template <class Pair>
struct OverlapBox : testing::Test {};
template <class A, class B>
struct Of {
  using First = A;
  using Second = B;
};
using Pairs = testing::Types<Of<Line3, Aabb3>, Of<Ray3, Aabb3>, Of<Segment3, Aabb3>, Of<Triangle3, Aabb3>,
                             Of<Line3, Obb3>, Of<Ray3, Obb3>, Of<Segment3, Obb3>, Of<Triangle3, Obb3>, Of<Aabb3, Obb3>>;
TYPED_TEST_SUITE(OverlapBox, Pairs);

TYPED_TEST(OverlapBox, AgreesWithTheOracle) {
  expect_as_oracle<typename TypeParam::First, typename TypeParam::Second>(53, 1000);
}

}  // namespace
}  // namespace plumb
