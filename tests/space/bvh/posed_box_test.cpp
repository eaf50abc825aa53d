// Do posed boxes hold all that is in them, exactly?
#include "space/bvh/posed_box.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using namespace poses;

bool holds(double low, const mpq_class& x, double high) {
  return (low < -std::numeric_limits<double>::max() || mpq_class(low) <= x) &&
         (high > std::numeric_limits<double>::max() || x <= mpq_class(high));
}
bool holds(const Aabb3& box, const RationalPoint& p) {
  return holds(box.min.x, p[0], box.max.x) && holds(box.min.y, p[1], box.max.y) && holds(box.min.z, p[2], box.max.z);
}

TEST(PosedBox, HoldsItsCornersAndNoNumberIsNone) {
  long bounded = 0, unbounded = 0;
  shape_cases::on_shapes(1741, battery::fitting(3000), [&](Material& m) {
    const auto box = m.shape<Aabb3>();
    if (is_empty(box)) return;
    const Pose pose = any_pose(m);
    const Aabb3 around = space::around(pose, box);
    for (int corner = 0; corner < 8; ++corner) {
      const Point3 p{(corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                     (corner & 4) != 0 ? box.max.z : box.min.z};
      ASSERT_TRUE(holds(around, image(p, pose))) << m.about(box, pose);
    }
    const auto t = m.shape<Triangle3>();
    for (const Point3& p : {t.a, t.b, t.c})
      ASSERT_TRUE(holds(space::around(PosedTriangle{t, MeshPose(pose)}), image(p, pose))) << m.about(t, pose);
    ++(space::is_bounded(around) ? bounded : unbounded);
  });
  EXPECT_GT(bounded, battery::fitting(1000));
  if (battery::reaches_rare) {
    EXPECT_GT(unbounded, 5);
  }
}

TEST(PosedBox, GoesOneDoubleOutward) {
  EXPECT_EQ(space::lowered(1), 0x1.fffffffffffffp-1);
  EXPECT_EQ(space::raised(1), 0x1.0000000000001p0);
  EXPECT_LE(space::lowered(0.0), 0);
  EXPECT_GT(space::raised(0.0), 0);
  EXPECT_EQ(space::lowered(-INFINITY), -INFINITY);
  EXPECT_EQ(space::lowered(INFINITY), 0x1.fffffffffffffp1023);
  EXPECT_EQ(space::raised(-INFINITY), -0x1.fffffffffffffp1023);
}

}  // namespace
}  // namespace plumb
