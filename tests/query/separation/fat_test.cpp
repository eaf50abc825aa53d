// Fat figures against the shapes that some of them are, and against distances; faces that part polyhedra against relate.
#include "plumb/query/separation/fat.hpp"

#include <gmock/gmock.h>

#include "plumb/query/convex/separating_face.hpp"
#include "query/body/pair_laws.hpp"

namespace plumb::pair_cases {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

template <class Shape>
void expect_as_swept(Answers& all, std::uint64_t start) {
  shape_cases::on_shapes(start, battery::sanitized ? 4 : 16, [&](Material& m) {
    const Segment3 s = m.shape<Segment3>();
    const Sphere3 ball = m.shape<Sphere3>();
    const double r = m.below(4) == 0 ? 0 : ball.radius;
    const Shape other = near_figure<Shape>(m);
    Relation wanted{};
    try {
      wanted = relate(Capsule3{s.a, s.b, r}, other);
      static_cast<void>(exact_distance(s, other));
    } catch (const InvalidShape&) {
      return;
    }
    all.add(wanted);
    const std::string about = std::string(name_of(figure_kind<Shape>)) + m.about(s, other);
    EXPECT_EQ(relate(Fat{s, r}, other), wanted) << about;
    EXPECT_EQ(relate(other, Fat{s, r}), wanted) << about;
    EXPECT_EQ(intersects(Fat{s, r}, other), wanted != Relation::disjoint) << about;
    EXPECT_EQ(relate(Fat{ball.center, ball.radius}, other), relate(ball, other)) << about;
    if (r > 0) {  // the radius may be on either side
      EXPECT_EQ(relate(s, Fat{other, r}), wanted) << about;
      EXPECT_EQ(relate(Fat{s, r}, Fat{other, 0.0}), wanted) << about;
    }
  });
}

TEST(FatFigures, SegmentsAreCapsules) {
  Answers all;
  expect_as_swept<Triangle3>(all, 6101);
  expect_as_swept<Aabb3>(all, 6102);
  expect_as_swept<Rectangle3>(all, 6103);
  expect_as_swept<Halfspace3>(all, 6104);
  expect_as_swept<Sphere3>(all, 6105);
  expect_as_swept<ConvexPolyhedron3>(all, 6106);
  EXPECT_GT(all.of(Relation::overlapping), 5);
  EXPECT_GT(all.of(Relation::disjoint), 5);
}

TEST(FatFigures, RadiiAddUpExactly) {
  const Aabb3 a{{0, 0, 0}, {1, 1, 1}};
  const auto apart = [](double x) { return Aabb3{{1 + x, 0, 0}, {3, 1, 1}}; };
  EXPECT_EQ(relate(Fat{a, 0.25}, Fat{apart(0.5), 0.25}), Relation::touching);
  EXPECT_EQ(relate(Fat{a, 0.25}, Fat{apart(std::nextafter(1.5, 2) - 1), 0.25}), Relation::disjoint);
  EXPECT_EQ(relate(Fat{a, 0.25}, Fat{apart(std::nextafter(1.5, 1) - 1), 0.25}), Relation::overlapping);
  EXPECT_EQ(relate(Fat{a, 0x1p-60}, Fat{apart(0x1p-52), 0x1p-52}), Relation::overlapping);  // by the lesser alone
  EXPECT_EQ(relate(Fat{a, 0.0}, apart(0)), Relation::touching);
  const Triangle3 left{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(contains(Fat{left, 0.5}, Point3{0.25, 0.25, 0.5}));
  EXPECT_FALSE(contains(Fat{left, 0.5}, Point3{0.25, 0.25, std::nextafter(0.5, 1)}));
  EXPECT_EQ(relate(Fat{Segment2{{0, 0}, {4, 0}}, 1}, Circle2{{2, 3}, 2}), Relation::touching);
  EXPECT_THAT([&] { (void)relate(Fat{left, -1.0}, a); }, ThrowsMessage<InvalidShape>(HasSubstr("relate: fat.radius")));
  EXPECT_THAT(
      [&] {
        (void)contains(Fat{left, NAN}, Point3{});
      },
      ThrowsMessage<NonFinite>(HasSubstr("contains: fat.radius")));
}

TEST(FaceTest, PartsWhatIsDisjointAlone) {
  int parted = 0, apart = 0;
  shape_cases::on_shapes(6111, battery::sanitized ? 60 : 400, [&](Material& m) {
    const auto a = figure<ConvexPolyhedron3>(m), b = near_figure<ConvexPolyhedron3>(m);
    const auto face = separating_face(a, b);
    const bool disjoint = relate(a, b) == Relation::disjoint;
    apart += disjoint ? 1 : 0, parted += face ? 1 : 0;
    if (!face) return;
    EXPECT_TRUE(disjoint) << m.about();
    EXPECT_EQ(separating_face(a, b, *face), face) << m.about();
    EXPECT_EQ(separating_face(b, a, {!face->of_second, face->face}), (SeparatingFace{!face->of_second, face->face}))
        << m.about();
  });
  EXPECT_GT(parted * 3, apart);
  EXPECT_GT(parted, 5);
}

}  // namespace
}  // namespace plumb::pair_cases
