// The order of axes of two boxes by pairs of doubles in lanes: is what is told what rational numbers tell, and is it told of
// boxes whose faces are all but parallel?
#include "query/penetration/near_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "plumb/degenerate/entropy.hpp"

namespace plumb::query::parting {
namespace {

struct Counts {
  int told = 0, open = 0, certain = 0;
};

/// What is told is exact; where nothing is told, it is counted.
void expect_exact(const GivenBox& a, const GivenBox& b, std::span<const NearAxes::Pair> pairs, Counts& counts,
                  std::uint64_t seed) {
  const NearAxisSigns told = near_axis_signs(a, b, pairs);
  ASSERT_LT(told.least, pairs.size());
  std::vector<Rational> overlap, length;
  RationalWorld world;
  const auto pick = [&](const auto& overlaps, const auto& lengths) {
    for (std::size_t k = 0; k < pairs.size(); ++k) overlap.push_back(*overlaps[k]), length.push_back(*lengths[k]);
    return told.least;
  };
  const NearAxes::Told exact = NearAxes{}(world, a, b, pairs, pick);
  const auto expect_sign = [&](Sign s, Sign wanted, const char* of) {
    if (s != Sign::zero) {
      EXPECT_EQ(s, wanted) << of << ", seed " << seed;
    }
    ++(s == wanted ? counts.told : counts.open);
    counts.certain += s == Sign::zero ? 0 : 1;
  };
  expect_sign(told.overlap, exact.overlap, "overlap"), expect_sign(told.middle, exact.middle, "middle");
  for (std::size_t k = 0; k < 6; ++k) {
    if (k != pairs[told.least][0] && k != pairs[told.least][1]) expect_sign(told.along[k], exact.along[k], "along");
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (k == told.least) continue;
    const Rational x = overlap[k] * length[told.least], y = overlap[told.least] * length[k];
    expect_sign(told.order[k], (x - y).sign(), "order");
  }
}

TEST(NearAxisSigns, AreThoseOfRationalNumbers) {
  Counts counts;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Entropy entropy(55, seed);
    const auto noise = [&](double size) { return size * (static_cast<double>(entropy.bits(53)) * 0x1p-52 - 1); };
    const double slope = noise(1), tilt = seed % 4 == 0 ? 0 : std::ldexp(noise(1), -static_cast<int>(entropy.bits(6)));
    const bool on_lattice = seed % 5 == 0;
    const auto box = [&](double height, double yaw, double pitch) {
      const double c = std::cos(yaw), s = std::sin(yaw), d = std::cos(pitch), t = std::sin(pitch);
      GivenBox b{{Vector3{c * d, c * t, -s}, Vector3{-t, d, 0}, Vector3{s * d, s * t, c}}, {}, {}};
      if (on_lattice) b.axes = {Vector3{1, 0, yaw > 0 ? 1.0 : 0}, Vector3{0, 1, 0}, Vector3{yaw > 0 ? -1.0 : 0, 0, 1}};
      for (std::size_t k = 0; k < 3; ++k) b.length[k] = {-0.5, on_lattice ? 0.5 : 0.5 + noise(0.25)};
      const Vector3 up = b.axes[1];
      b.middle = {{{-height * up.x, height * up.x}, {-height * up.y, height * up.y}, {0, noise(0x1p-4)}}};
      return b;
    };
    const GivenBox a = box(on_lattice ? 0.75 : 1 + noise(0x1p-6), noise(3), slope + tilt), b = box(0, noise(3), slope);
    std::vector<NearAxes::Pair> pairs;
    for (std::uint32_t p = 0; p < 6; ++p) {
      for (std::uint32_t q = p + 1; q < 6; ++q) {
        if (entropy.bits(2) != 0) pairs.push_back({p, q});
      }
    }
    if (pairs.empty()) pairs.push_back({0, 2});
    expect_exact(a, b, pairs, counts, seed);
  }
  std::printf("%d signs are told, or zero, and %d left open\n", counts.told, counts.open);
  if (counts.certain > 0) {  // this processor, as the library was compiled, has lanes
    EXPECT_GT(counts.told, 100 * counts.open);
  }
}

}  // namespace
}  // namespace plumb::query::parting
