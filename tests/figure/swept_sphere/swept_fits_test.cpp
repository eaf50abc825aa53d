// How near are fitted capsules and lozenges to what the points lie on?
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "figure/basic/frame.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/figure/swept_sphere/swept_sphere.hpp"

namespace plumb {
namespace {

// Points of the surfaces of capsules and lozenges: a fit is not the smallest, but no more than twice as large.
TEST(SweptFits, AreNearWhatPointsLieOn) {
  double worst = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    Entropy entropy(605, i);
    const auto direction = [&] {
      const auto at = [&] { return signed_unit_coordinate(entropy); };
      return figure::frame::unit({at(), at(), at()});
    };
    const double length = 0.25 * static_cast<double>(entropy.below(17));
    const auto axes = figure::frame::orthonormal({direction(), direction(), Vector3{0, 0, 0}});
    using figure::frame::times, figure::frame::plus;
    std::vector<Point3> rod, plate;
    for (int k = 0; k < 200; ++k) {
      const Vector3 along = plus(direction(), times(axes[0], length * signed_unit_coordinate(entropy)));
      const Vector3 beside = plus(along, times(axes[1], length / 2 * signed_unit_coordinate(entropy)));
      rod.push_back({along.x, along.y, along.z});
      plate.push_back({beside.x, beside.y, beside.z});
    }
    const auto end = [&](double x, double y) {
      const Vector3 v = plus(times(axes[0], x), times(axes[1], y));
      return Point3{v.x, v.y, v.z};
    };
    const Capsule3 capsule{end(-length, 0), end(length, 0), 1};
    const Lozenge3 lozenge{end(-length, -length / 2), {times(axes[0], 2 * length), times(axes[1], length)}, 1};
    worst = std::max({worst, volume(fit_capsule(rod)) / volume(capsule), volume(fit_lozenge(plate)) / volume(lozenge)});
  }
  EXPECT_LE(worst, 2);
  EXPECT_GE(worst, 1.2);
}

}  // namespace
}  // namespace plumb
