// Do the floats of a frame lie on the right side of every double, and as near as floats can?  Against rationals.
#include "plumb/space/bvh/box_frame.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "space/bvh/tree_laws.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;
using tree_laws::compare;

constexpr double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();

float next(float f, float to) { return std::nextafter(f, to); }

void expect_nearest(const BoxFrame& frame, double x) {
  const float below = frame.below(x), above = frame.above(x);
  const std::string about = std::to_string(x) + " in the frame of " + std::to_string(frame.exponent());
  EXPECT_LE(compare(frame, below, x), 0) << about;
  EXPECT_GE(compare(frame, above, x), 0) << about;
  // The next float is on the other side, but where the double that is rounded was rounded itself.
  if (frame.exponent() > 0 && std::abs(std::ldexp(x, -frame.exponent())) < 0x1p-1021) return;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  EXPECT_GT(compare(frame, next(below, infinity), x), 0) << about;
  EXPECT_LT(compare(frame, next(above, -infinity), x), 0) << about;
}

TEST(BoxFrame, RoundsOutwardAndNearest) {
  Entropy entropy(41, 0);
  std::vector<double> numbers{0.0,      -0.0,  1,      -1,        0.1,     -0.1,    largest,
                              -largest, least, -least, 0x1p-1022, 0x1p128, -0x1p128};
  for (int i = 0; i < 3000; ++i) {
    const double mantissa = 1 + static_cast<double>(entropy.bits(52)) * 0x1p-52;
    numbers.push_back(std::ldexp(entropy.coin() ? mantissa : -mantissa, static_cast<int>(entropy.within(1020))));
    numbers.push_back(static_cast<float>(std::ldexp(mantissa, static_cast<int>(entropy.within(150)))));
  }
  for (const int exponent : {0, 1, -1, 40, -40, 961, 1000, -961, -1000}) {
    const BoxFrame frame = BoxFrame::of_exponent(exponent);
    for (const double x : numbers) {
      if (std::isfinite(x)) expect_nearest(frame, x);
    }
  }
}

TEST(BoxFrame, IsOneWhereFloatsSuffice) {
  for (const double m : {0.0, 1.0, 1e-5, 1e12}) EXPECT_EQ(BoxFrame::for_magnitude(m).exponent(), 0) << m;
  for (const double m : {1e13, 1e300, largest, 1e-7, 1e-300, 1e-310}) {
    const BoxFrame frame = BoxFrame::for_magnitude(m);
    EXPECT_NE(frame.exponent(), 0) << m;
    EXPECT_LE(frame.above(m), 0x1p41F) << m;
    EXPECT_GE(frame.below(m), m < 1e-308 ? 0x1p-74F : 0.5F) << m;
  }
}

TEST(BoxFrame, ComesBackOutward) {
  shape_cases::on_shapes(42, 2000, [](shape_cases::Material& m) {
    const Point3 a = m.point3(), b = m.point3();
    const Aabb3 box{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                    {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
    const BoxFrame frame = BoxFrame::of_exponent(static_cast<int>(m.entropy().within(1000)));
    const Aabb3 back = frame.outside(frame.around(box));
    for (const auto& [outer, inner] : {std::pair(back.min, box.min), std::pair(box.max, back.max)}) {
      EXPECT_LE(outer.x, inner.x) << m.about(box);
      EXPECT_LE(outer.y, inner.y) << m.about(box);
      EXPECT_LE(outer.z, inner.z) << m.about(box);
    }
  });
}

TEST(BoxFrame, RefusesOtherExponents) {
  EXPECT_THAT(text_of<InvalidShape>([] { (void)BoxFrame::of_exponent(1001); }), HasSubstr("exponent is 1001"));
  EXPECT_THAT(text_of<InvalidShape>([] { (void)BoxFrame::of_exponent(-1001); }), HasSubstr("-1000 to 1000"));
}

}  // namespace
}  // namespace plumb
