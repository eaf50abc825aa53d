// Do contacts of boxes that move from frame to frame stay exact, and does the cache of the frame before change nothing?
// Stacks that tremble, slide, spin and jump on a lattice, as they stand and under rigid poses.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/query/contact/contact.hpp"
#include "query/contact/rounded_contact.hpp"
#include "query/contact/turned_box.hpp"

namespace plumb {
namespace {

enum class Motion : unsigned char { on_lattice, trembling, sliding, spinning, tumbling };
constexpr std::array motions{Motion::on_lattice, Motion::trembling, Motion::sliding, Motion::spinning,
                             Motion::tumbling};

/// A stack of boxes, each upon the one before; the last ones may be flat.
struct Stack {
  Motion motion;
  Entropy entropy;
  std::vector<Vector3> half{};
  std::vector<double> turn{}, sunk{};
  double slope = 0;

  Stack(std::uint64_t seed, Motion m) : motion(m), entropy(53, seed) {
    const bool on_lattice = motion == Motion::on_lattice;
    slope = on_lattice || seed % 3 == 0 ? 0 : noise(0.5);
    for (int level = 0; level < 4; ++level) {
      const auto size = [&] { return on_lattice || seed % 2 == 0 ? 0.5 : 0.75 + noise(0.25); };
      half.push_back({level == 0 ? 4 : size(), seed % 11 == 0 && level == 3 ? 0 : size(), level == 0 ? 4 : size()});
      turn.push_back(on_lattice ? 0 : noise(3)), sunk.push_back(on_lattice ? 0 : 1e-3 * noise(1));
    }
  }
  double noise(double size) { return size * (static_cast<double>(entropy.bits(53)) * 0x1p-52 - 1); }

  /// The stack of one frame.
  std::vector<Obb3> boxes(int frame) {
    std::vector<Obb3> all;
    double top = 0;
    for (std::size_t level = 0; level < half.size(); ++level) {
      const bool on_lattice = motion == Motion::on_lattice, on_ground = level == 0;
      const double tremor = motion == Motion::trembling || motion == Motion::tumbling ? 1e-6 : 0;
      const double spin = motion == Motion::spinning || motion == Motion::tumbling ? 0.01 * frame : 0;
      const double yaw = turn[level] + (on_ground ? 0 : spin * static_cast<double>(level) + noise(tremor));
      Obb3 box = turned_box({0, 0, 0}, yaw, on_ground ? slope : slope + noise(tremor), half[level]);
      const Obb3 frame_of = turned_box({0, 0, 0}, turn[0], slope, half[0]);
      const double quarter = on_lattice ? 0.25 * static_cast<double>(entropy.bits(2)) - 0.25 : 0;
      const double x = on_lattice ? quarter : motion == Motion::sliding ? 0.003 * frame : 0.02 + noise(tremor);
      const double y = top + half[level].y - sunk[level] + (on_lattice && frame % 3 == 1 && level % 2 == 1 ? 0.25 : 0) +
                       noise(tremor);
      const auto& [u, v, w] = frame_of.axes;
      const double z = on_lattice ? 0.25 * static_cast<double>(entropy.bits(1)) : noise(tremor);
      box.center = {x * u.x + y * v.x + z * w.x, x * u.y + y * v.y + z * w.y, x * u.z + y * v.z + z * w.z};
      top += 2 * half[level].y - sunk[level];
      all.push_back(box);
    }
    return all;
  }
};

struct Seen {
  int frames = 0, corners = 0;
  std::array<int, 4> relation{};  // apart, touching, overlapping, and none
};

template <class A, class B>
void expect_same(const A& a, const B& b, ContactCache& cache, Seen& seen, const std::string& about) {
  const ContactManifoldOptions options{.margin = 0.02};
  const auto cold = contact(a, b, options);
  EXPECT_EQ(contact(a, b, options, &cache), cold) << about;
  ++seen.relation[cold ? static_cast<std::size_t>(static_cast<int>(cold->relation) + 1) : 3];
  seen.corners += cold ? static_cast<int>(cold->corners.size()) : 0;
}

TEST(ContactFrames, OfStacksAreExactWithACacheAndWithout) {
  Seen seen;
  for (std::uint64_t seed = 0; seed < (battery::sanitized ? 10U : 100U); ++seed) {
    Stack stack(seed, motions[seed % motions.size()]);
    std::array<ContactCache, 3> caches, posed;
    for (int frame = 0; frame < 30; ++frame, ++seen.frames) {
      const std::vector<Obb3> boxes = stack.boxes(frame);
      for (std::size_t level = 1; level < boxes.size(); ++level) {
        const Obb3 &upper = boxes[level], &lower = boxes[level - 1];
        const std::string about =
            "seed " + std::to_string(seed) + " frame " + std::to_string(frame) + " level " + std::to_string(level);
        expect_same(upper, lower, caches[level - 1], seen, about);
        if (frame % 10 == 0) {
          const RigidPose pose{{1, 0.25, 0.125 * frame, 0}, {0.5, 0, 0.25}};
          expect_same(Posed{upper, pose}, Posed{lower, pose}, posed[level - 1], seen, about);
        }
        if (frame % 6 != 1) continue;
        const auto m = contact(upper, lower, {.margin = 0x1p100});
        const auto e = exact_contact(upper, lower, 0x1p100);
        ASSERT_TRUE(m && e) << about;
        expect_rounded(*m, *e, about);
        const Aabb3 ground{{-4, -1, -4}, {4, 0, 4}};
        const auto on_ground = contact(ground, upper, {.margin = 0x1p100});
        expect_rounded(*on_ground, *exact_contact(ground, upper, 0x1p100), about + " from below");
      }
    }
  }
  std::printf("%d frames, %d corners: apart %d, touching %d, overlapping %d, no contact %d\n", seen.frames,
              seen.corners, seen.relation[0], seen.relation[1], seen.relation[2], seen.relation[3]);
  for (const int count : seen.relation) EXPECT_GT(count, battery::sanitized ? 5 : 100);
}

}  // namespace
}  // namespace plumb
