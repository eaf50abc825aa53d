// Triangles, tetrahedra and what is straight in space against a linear program in rationals.
#include "plumb/query/overlap_triangle.hpp"

#include "query/relation_counts.hpp"

namespace plumb {
namespace {

template <class Pair>
struct OverlapTriangle : testing::Test {};
template <class A, class B>
struct Of {
  using First = A;
  using Second = B;
};
using Pairs = testing::Types<Of<Line3, Triangle3>, Of<Ray3, Triangle3>, Of<Segment3, Triangle3>,
                             Of<Triangle3, Triangle3>, Of<Line3, Line3>, Of<Line3, Ray3>, Of<Line3, Segment3>,
                             Of<Ray3, Ray3>, Of<Ray3, Segment3>, Of<Segment3, Segment3>, Of<Segment3, Tetrahedron3>,
                             Of<Triangle3, Tetrahedron3>, Of<Tetrahedron3, Tetrahedron3>>;
TYPED_TEST_SUITE(OverlapTriangle, Pairs);

TYPED_TEST(OverlapTriangle, AgreesWithTheOracle) {
  expect_as_oracle<typename TypeParam::First, typename TypeParam::Second>(52, 1000);
}

}  // namespace
}  // namespace plumb
