// Does what a cache holds change an answer?  Of boxes, polyhedra and all other kinds, whatever frames it is of, and
// whatever is in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/contact/contact.hpp"
#include "query/contact/turned_box.hpp"
#include "query/penetration/kept_answer.hpp"

namespace plumb {
namespace {

/// Boxes, as they stand and under a rigid pose, that tremble, jump, touch and part.
TEST(ContactCache, OfOtherFramesChangesNothing) {
  std::array<int, 3> seen{};
  for (std::uint64_t i = 0; i < (battery::sanitized ? 10U : 400U); ++i) {
    Entropy entropy(46, i);
    const auto noise = [&](double size) { return size * (static_cast<double>(entropy.bits(53)) * 0x1p-52 - 1); };
    const double tremor = std::ldexp(1.0, -static_cast<int>(entropy.bits(6))), turn = noise(3);
    const Vector3 half{0.5, 0.25 + 0.25 * static_cast<double>(entropy.bits(1)), 0.5};
    const Obb3 under = turned_box({0, 0, 0}, noise(3), i % 3 == 0 ? noise(1) : 0, {1 + noise(0.5), 0.5, 1});
    const Vector3 up = under.axes[1];
    ContactCache cache;
    for (int frame = 0; frame < 6; ++frame) {
      const double height = 0.5 + half.y + (frame == 3 ? noise(1) : noise(tremor));
      Obb3 box = i % 2 == 0 ? turned_box({0, 0, 0}, turn + noise(tremor), noise(tremor), half) : under;
      if (i % 2 != 0) box.half = half;  // its edges are parallel to those of the other
      box.center = {up.x * height + noise(tremor), up.y * height, up.z * height + noise(tremor)};
      const ContactManifoldOptions options{.margin = 0.5};
      const auto m = contact(box, under, options, &cache);
      EXPECT_EQ(m, contact(box, under, options)) << i << " frame " << frame;
      if (m) ++seen[static_cast<std::size_t>(static_cast<int>(m->relation) + 1)];
      const RigidPose pose{{1, noise(tremor), 0.25, 0}, {0.1, 0, 0}};
      if (i % 5 == 0) {
        const Posed posed{box, pose};
        EXPECT_EQ(contact(posed, under, options, &cache), contact(posed, under, options)) << i << " frame " << frame;
      }
    }
  }
  std::printf("apart %d, touching %d, overlapping %d\n", seen[0], seen[1], seen[2]);
  EXPECT_GT(std::min(seen[0], seen[2]), 0);
}

/// Polyhedra that move by little, jump, touch and part; the cache is that of the frame before, of another question, or
/// filled with anything.
TEST(ContactCache, OfPolyhedraChangesNoDepthAndNoContact) {
  std::array<int, 4> seen{};
  for (std::uint64_t i = 0; i < (battery::sanitized ? 4U : 150U); ++i) {
    Entropy entropy(47, i);
    const auto noise = [&](double size) { return size * (static_cast<double>(entropy.bits(53)) * 0x1p-52 - 1); };
    const bool is_on_grid = i % 3 == 0;
    const auto number = [&] { return is_on_grid ? static_cast<double>(entropy.bits(2)) - 1.5 : noise(1); };
    const auto points = [&] {
      std::vector<Point3> p{{-0.5, -0.5, -0.5}, {0.5, -0.5, -0.5}, {-0.5, 0.5, -0.5}, {-0.5, -0.5, 0.5}};
      const std::size_t size = 5 + entropy.bits(4);
      while (p.size() < size) p.push_back({number(), number(), number()});
      return p;
    };
    const auto of_a = points(), of_b = points();
    const auto b = convex_polyhedron(convex_hull(of_b), of_b);
    ContactCache cache, of_depth;
    for (int frame = 0; frame < 6; ++frame) {
      const double jump = frame == 3 ? 2 : 1, tremor = is_on_grid ? 0 : 0x1p-6;
      std::vector<Point3> moved;
      const Vector3 by{jump + noise(tremor), noise(tremor), frame == 4 ? noise(1) : 0};
      for (const Point3& p : of_a) moved.push_back({p.x + by.x, p.y + by.y, p.z + by.z});
      const auto a = convex_polyhedron(convex_hull(moved), moved);
      if (frame == 5) {
        for (auto& e : cache.corners)
          e = {static_cast<std::uint32_t>(entropy.bits(4)), static_cast<std::uint32_t>(entropy.bits(3))};
        cache.size = 4, of_depth = cache;
      }
      const auto m = contact(a, b, {.margin = 0.5});
      EXPECT_EQ(m, contact(a, b, {.margin = 0.5}, &cache)) << i << " frame " << frame;
      const auto p = penetration(a, b);
      EXPECT_EQ(p, penetration(a, b, &of_depth)) << i << " frame " << frame;
      EXPECT_EQ(p, penetration(a, b, &cache)) << i << " frame " << frame;
      ++seen[m ? static_cast<std::size_t>(static_cast<int>(m->relation) + 1) : 3];
    }
  }
  std::printf("apart %d, touching %d, overlapping %d, no contact %d\n", seen[0], seen[1], seen[2], seen[3]);
  EXPECT_GT(std::ranges::min(seen), 0);
}

/// Of any kind: numbers that can be moved one by one.
struct Drawn {
  int kind, pose;
  std::array<double, 24> number;
  std::array<double, 14> place;

  static Drawn of(Entropy& e) {
    const auto noise = [&] { return static_cast<double>(e.bits(53)) * 0x1p-52 - 1; };
    Drawn d{static_cast<int>(e.below(8)), static_cast<int>(e.below(4)), {}, {}};
    for (double& x : d.number) x = noise();
    for (double& x : d.place) x = 0.5 * noise();
    return d;
  }
  /// The next number above, or zero with the other sign.
  void nudge(Entropy& e) {
    double& x = e.coin() ? number[e.below(number.size())] : place[e.below(place.size())];
    x = x == 0 ? -x : e.below(4) == 0 ? 0 : std::nextafter(x, 4.0);
  }
  [[nodiscard]] AnyFigure figure() const {
    const auto& n = number;
    const auto point = [&](std::size_t i) { return Point3{n[3 * i], n[3 * i + 1], n[3 * i + 2]}; };
    const auto size = [&](std::size_t i) { return std::fabs(n[i]); };
    switch (kind) {
      case 0: {
        const Obb3 turned = turned_box(point(0), n[3], n[4], {size(5), size(6), size(7)});
        return under(turned);
      }
      case 1:
        return under(Aabb3{point(0), {n[0] + size(3), n[1] + size(4), n[2] + size(5)}});
      case 2:
        return under(Tetrahedron3{point(0), point(1), point(2), point(3)});
      case 3:
        return under(Triangle3{point(0), point(1), point(2)});
      case 4:
        return under(Segment3{point(0), point(1)});
      case 5: {
        std::vector<Point3> corners;
        for (std::size_t i = 0; i < 8; ++i) corners.push_back(point(i));
        return under(convex_polyhedron(convex_hull(corners), corners));
      }
      case 6:
        return under(Capsule3{point(0), point(1), 0.25 * size(6)});
      default:
        return under(Sphere3{point(0), 0.5 * size(3)});
    }
  }
  template <class Shape>
  [[nodiscard]] AnyFigure under(const Shape& s) const {
    const auto link = [&](std::size_t i) {
      return RigidPose{{1, place[i], place[i + 1], place[i + 2]}, {place[i + 3], place[i + 4], place[i + 5]}};
    };
    if (pose == 1) return Posed{s, link(0)};
    if (pose == 2) return Posed{s, RigidChain{{link(0), link(7)}}};
    if (pose == 3 && kind < 6) {  // a ball under it is none
      return Posed{s, Pose{{{{1, place[0], place[1]}, {place[2], 1, place[3]}, {place[4], place[5], 1}}},
                           {place[6], place[7], place[8]}}};
    }
    return s;
  }
};

/// One cache for pairs of all kinds, asked again, with other options, the other way round, nudged and moved back.
TEST(ContactCache, OfTheSameBitsTellsTheSameAgain) {
  using query::AskedContact, query::KeptBytes, query::KeptQuestion, query::body_view;
  int again = 0, contacts = 0, changed = 0;
  const int runs = battery::sanitized ? 40 : 1000;
  ContactCache cache;
  for (int i = 0; i < runs; ++i) {
    Entropy entropy(48, static_cast<std::uint64_t>(i));
    const std::string replay = "replay: Entropy(48, " + std::to_string(i) + ")";
    std::array<Drawn, 2> drawn{Drawn::of(entropy), Drawn::of(entropy)};
    ContactManifoldOptions options{.margin = 0.5};
    const auto expect_same = [&]() {
      const AnyFigure a = drawn[0].figure(), b = drawn[1].figure();
      const auto m = contact(a, b, options);
      const AskedContact asked{
          KeptQuestion::contact, body_view(a), body_view(b), {options.margin, static_cast<double>(options.at_most)}};
      again += KeptBytes::answer(cache, asked).empty() ? 0 : 1;
      EXPECT_EQ(contact(a, b, options, &cache), m) << replay;
      EXPECT_FALSE(KeptBytes::answer(cache, asked).empty()) << replay;
      EXPECT_EQ(contact(a, b, options, &cache), m) << replay;
      contacts += m ? 1 : 0;
      return m;
    };
    const auto first = expect_same();
    const ContactCache of_first = cache;
    const std::array<Drawn, 2> before = drawn;
    drawn[entropy.below(2)].nudge(entropy);
    changed += expect_same() != first ? 1 : 0;
    drawn = before;
    EXPECT_EQ(expect_same(), first) << replay;
    cache = of_first;
    EXPECT_EQ(expect_same(), first) << replay;
    switch (entropy.below(4)) {
      case 0:
        options.margin = std::nextafter(first && first->distance > 0 ? first->distance : 0.5, 0);
        break;
      case 1:
        options.at_most = 1;
        break;
      case 2:
        std::swap(drawn[0], drawn[1]);
        break;
      default: {
        const AnyFigure a = drawn[0].figure(), b = drawn[1].figure();
        const auto p = penetration(a, b);
        EXPECT_EQ(penetration(a, b, &cache), p) << replay;
        EXPECT_EQ(penetration(a, b, &cache), p) << replay;
      }
    }
    (void)expect_same();
    if (::testing::Test::HasFailure()) return;
  }
  std::printf("%d told again, %d contacts, %d changed by a nudge\n", again, contacts, changed);
  EXPECT_GT(std::min(again, contacts), runs);
  EXPECT_GT(10 * changed, runs);  // not all numbers are those of every kind
}

/// What is at an address may have changed, and what is elsewhere may be the same.
TEST(ContactCache, ComparesNumbersAndNoAddresses) {
  std::vector<Point3> cube;
  for (int i = 0; i < 8; ++i) cube.push_back({i % 2 * 1.0, i / 2 % 2 * 1.0, i / 4 * 1.0});
  const Aabb3 ground{{-4, -4, -1}, {4, 4, 0}};
  ContactCache cache;
  const auto ask = [&](const std::vector<Point3>& points) {
    const VertexHull3 hull{points};
    const auto m = contact(hull, ground, {.margin = 1});
    EXPECT_EQ(contact(hull, ground, {.margin = 1}, &cache), m);
    EXPECT_EQ(contact(hull, ground, {.margin = 1}, &cache), m);
    return m;
  };
  const auto resting = ask(cube);
  const std::vector<Point3> elsewhere = cube;
  for (Point3& p : cube) p.z += 0.25;
  EXPECT_NE(ask(cube), resting);
  EXPECT_EQ(ask(elsewhere), resting);
  cube.push_back({2, 2, 2});
  ask(cube);
  std::vector<Point3> many(1000, cube[0]);  // longer than what is kept
  ask(many);
  EXPECT_EQ(ask(elsewhere), resting);
}

}  // namespace
}  // namespace plumb
