// Boxes in space against a linear program in rationals.
#include <cmath>
#include <cstring>

#include "figure/basic/powers_of_two.hpp"
#include "plumb/figure/obb/obb.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/overlap/relation_counts.hpp"

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
  using Second = typename TypeParam::Second;
  expect_as_oracle<typename TypeParam::First, Second>(53, std::is_same_v<Second, Obb3> ? 400 : 1000);
}

TYPED_TEST(OverlapBox, IsTheSameTimesPowersOfTwo) {
  powers_of_two::expect_same_relation<typename TypeParam::First, typename TypeParam::Second>(54, 300);
}

/// Each number of either made NaN or infinite, wherever the other one is.
TYPED_TEST(OverlapBox, RefusesEveryNumberThatIsNone) {
  using A = typename TypeParam::First;
  using B = typename TypeParam::Second;
  const auto spoil = [](auto& s, std::size_t k, double bad) {
    std::array<double, sizeof(s) / sizeof(double)> numbers;
    std::memcpy(numbers.data(), &s, sizeof(s));
    numbers.at(k) = bad;
    std::memcpy(&s, numbers.data(), sizeof(s));
  };
  shape_cases::on_shapes(55, 12, [&](shape_cases::Material& m) {
    const A a = m.shape<A>();
    const B b = m.shape<B>();
    for (const double bad : {std::nan(""), double{INFINITY}, -double{INFINITY}}) {
      for (std::size_t k = 0; k < sizeof(A) / sizeof(double); ++k) {
        A c = a;
        spoil(c, k, bad);
        EXPECT_THROW(relate(c, b), NonFinite) << k << m.about(c, b);
      }
      for (std::size_t k = 0; k < sizeof(B) / sizeof(double); ++k) {
        B d = b;
        spoil(d, k, bad);
        EXPECT_THROW(relate(a, d), NonFinite) << k << m.about(a, d);
      }
    }
  });
}

constexpr Aabb3 unit{{0, 0, 0}, {1, 1, 1}};

// RTCD figure 5.22: a ray whose spans in two slabs are apart, and one whose spans overlap.
TEST(OverlapBoxCases, RaysAndSlabs) {
  EXPECT_EQ(relate(Ray3{{-2, 0.5, 0.5}, {1, 1, 0}}, unit), Relation::disjoint);
  EXPECT_EQ(relate(Ray3{{-2, -1.5, 0.5}, {1, 1, 0}}, unit), Relation::overlapping);
  EXPECT_EQ(relate(Ray3{{-1, 0, 0.5}, {1, 1, 0}}, unit), Relation::touching);   // through the edge x = 0, y = 1
  EXPECT_EQ(relate(Ray3{{2, 0.5, 0.5}, {1, 0, 0}}, unit), Relation::disjoint);  // behind
  EXPECT_EQ(relate(Ray3{{1, 0.5, 0.5}, {1, 0, 0}}, unit), Relation::touching);  // origin on a face, away
  EXPECT_EQ(relate(Ray3{{1, 0.5, 0.5}, {-1, 0, 0}}, unit), Relation::overlapping);
  EXPECT_EQ(relate(Ray3{{-1, 1, 0.5}, {1, 0, 0}}, unit), Relation::touching);  // in the plane of a face
  EXPECT_EQ(relate(Ray3{{-1, 1, 1}, {1, 0, 0}}, unit), Relation::touching);    // along an edge
  EXPECT_EQ(relate(Ray3{{-1, 1.5, 1}, {1, 0, 0}}, unit), Relation::disjoint);
  EXPECT_EQ(relate(Ray3{{0.5, 0.5, 0.5}, {0, 0, 0}}, unit), Relation::overlapping);
  EXPECT_EQ(relate(Line3{{5, 0.5, 0.5}, {1, 0, 0}}, unit), Relation::overlapping);
  EXPECT_EQ(relate(Line3{{5, 0.5, 0.5}, {0, 0, 0}}, unit), Relation::disjoint);
  EXPECT_EQ(relate(Line3{{0.5, 0.5, 0.5}, {0, 0, 1}}, Aabb3{{0, 0, 1}, {1, 1, 0}}), Relation::disjoint);  // empty
}

// RTCD figure 5.23: a segment whose box meets the box, past an edge.
TEST(OverlapBoxCases, SegmentsPastAnEdge) {
  EXPECT_EQ(relate(Segment3{{0.5, 1.75, 0.5}, {1.75, 0.5, 0.5}}, unit), Relation::disjoint);
  EXPECT_EQ(relate(Segment3{{0.5, 1.5, 0.5}, {1.5, 0.5, 0.5}}, unit), Relation::touching);
  EXPECT_EQ(relate(Segment3{{0.5, 1.5, 0.5}, {1.5, 0x1.fffffffffffffp-2, 0.5}}, unit), Relation::overlapping);
  EXPECT_EQ(relate(Segment3{{0.5, 1.5, 0.5}, {1.5, 0x1.0000000000001p-1, 0.5}}, unit), Relation::disjoint);
  EXPECT_EQ(relate(Segment3{{1, 1, 1}, {2, 2, 2}}, unit), Relation::touching);
  const Obb3 turned{{0, 0, 0}, {Vector3{1, 1, 0}, Vector3{-1, 1, 0}, Vector3{0, 0, 1}}, {1, 1, 1}};
  EXPECT_EQ(relate(Segment3{{1, 1, 0}, {2, 0, 0}}, turned), Relation::touching);
  EXPECT_EQ(relate(Segment3{{1, 1, 0}, {2, -1, 0}}, turned), Relation::overlapping);
  EXPECT_EQ(relate(Aabb3{{1, 1, 0}, {3, 3, 3}}, turned), Relation::touching);
}

// A triangle that only the cross product of an edge and an axis separates, and one that only its normal does.
TEST(OverlapBoxCases, TrianglesByEachKindOfAxis) {
  EXPECT_EQ(relate(Triangle3{{2, 0.5, 0}, {0.5, 2, 0}, {2, 2, 1}}, unit), Relation::disjoint);
  EXPECT_EQ(relate(Triangle3{{2, 0, 0}, {0, 2, 0}, {2, 2, 1}}, unit), Relation::touching);
  EXPECT_EQ(relate(Triangle3{{3.5, 0, 0}, {0, 3.5, 0}, {0, 0, 3.5}}, unit), Relation::disjoint);
  EXPECT_EQ(relate(Triangle3{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}, unit), Relation::touching);
  EXPECT_EQ(relate(Triangle3{{2.5, 0, 0}, {0, 2.5, 0}, {0, 0, 2.5}}, unit), Relation::overlapping);
  EXPECT_EQ(relate(Triangle3{{0, 0, 1}, {9, 0, 1}, {0, 9, 1}}, unit), Relation::touching);  // in the plane of a face
  EXPECT_EQ(relate(Triangle3{{0, 0, 1}, {9, 0, 1}, {0, 9, 1}}, Aabb3{{0, 0, 1}, {1, 1, 1}}), Relation::overlapping);
}

// RTCD figures 5.13 and 5.14: a plane between two boxes whose spans along x, y and z all overlap; where the distance of
// the centers along its normal is the sum of the two radii, the boxes touch, and any less leaves no plane between them.
TEST(OverlapBoxCases, PlanesThatSeparate) {
  const Obb3 diamond{{0, 0, 0}, {Vector3{1, 1, 0}, Vector3{-1, 1, 0}, Vector3{0, 0, 1}}, {1, 1, 1}};  // |x| + |y| <= 2
  EXPECT_EQ(relate(Aabb3{{1.5, 1.5, 0}, {3, 3, 3}}, diamond), Relation::disjoint);
  EXPECT_EQ(relate(Aabb3{{0.5, 0.5, 0}, {3, 3, 3}}, diamond), Relation::overlapping);
  for (const auto& [c, expected] : {std::pair{2.0, Relation::touching},
                                    {0x1.0000000000001p+1, Relation::disjoint},
                                    {0x1.fffffffffffffp+0, Relation::overlapping}}) {
    const Aabb3 box{{c - 1, c - 1, 0}, {c + 1, c + 1, 3}};  // c is the center, exactly
    EXPECT_EQ(relate(box, diamond), expected) << c;
    EXPECT_EQ(relate(Obb3{{c, c, 1}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {1, 1, 1}}, diamond),
              expected)
        << c;
  }
}

TEST(OverlapBoxCases, NamesWhatIsNoNumber) {
  const double nan = std::nan("");
  try {
    relate(Segment3{{9, 9, 9}, {9, 9, nan}}, unit);
    FAIL();
  } catch (const NonFinite& e) {
    EXPECT_EQ(std::string(e.what()).rfind("relate: segment.b.z is nan", 0), 0u) << e.what();
  }
  EXPECT_THROW(relate(Triangle3{{9, 9, 9}, {9, 9, 8}, {8, nan, 9}}, unit), NonFinite);
  EXPECT_THROW(relate(Triangle3{{9, 9, 9}, {9, 9, 8}, {8, 9, 9}}, Aabb3{{0, 0, 0}, {1, INFINITY, 1}}), NonFinite);
  EXPECT_THROW(relate(Ray3{{0.5, 0.5, 0.5}, {nan, 0, 1}}, unit), NonFinite);
  EXPECT_THROW(relate(Line3{{0.5, 0.5, 0.5}, {INFINITY, 0, 1}}, unit), NonFinite);
}

}  // namespace
}  // namespace plumb
