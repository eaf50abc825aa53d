// Nearest faces of sums of edges: what is told is what rational numbers tell, whatever face is guessed; most of what is in
// general position is told, and nothing of numbers that are none.
#include "query/separation/edge_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "query/body/rigid_cases.hpp"
#include "query/convex/posed_radius.hpp"
#include "query/separation/cores.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb::pair_cases {
namespace {

using Shape = std::variant<Point3, Segment3, Rectangle3, Sphere3, Aabb3, Obb3, Capsule3>;

query::PosedView seen(const Shape& shape, const RigidCase* by) {
  const auto view = std::visit([](const auto& s) { return query::view_of(s); }, shape);
  return {view, by == nullptr ? AnyPoseView() : by->view(3)};
}

/// By the search in rational numbers.
Closest judged(const query::PosedView& a, const query::PosedView& b) {
  const query::PosedSet p = posed_set(a), q = posed_set(b);
  query::SeenFigure on_a{a.figure, radius_of_image("judged", a, p)}, on_b{b.figure, radius_of_image("judged", b, q)};
  if (!a.pose.stands()) on_a.map = &p.map;
  if (!b.pose.stands()) on_b.map = &q.map;
  return told_pair(*query::nearest_of_cores({a.figure, p.map}, {b.figure, q.map}, query::WhichPair::first), on_a, on_b);
}

template <class Kind>
Shape drawn_as(Material& m) {
  if constexpr (std::is_same_v<Kind, Point3>) {
    return m.point3();
  } else {
    return m.shape<Kind>();
  }
}
template <class... Kinds>
Shape drawn(Material& m, std::type_identity<std::variant<Kinds...>>) {
  const std::array<Shape (*)(Material&), sizeof...(Kinds)> all{drawn_as<Kinds>...};
  return all[m.below(all.size())](m);
}
Shape degenerate_shape(Material& m) { return drawn(m, std::type_identity<Shape>()); }
bool is_some(const Shape& s) {
  const auto* box = std::get_if<Aabb3>(&s);
  return box == nullptr || !is_empty(*box);
}

/// A tenth of them capsules that are points, flat boxes, and radii of zero.
Shape random_shape(Material& m) {
  const auto number = [&] { return static_cast<double>(m.below(1 << 20)) * 0x1p-19 - 1; };
  const auto point = [&] { return Point3{number(), number(), number()}; };
  const auto axis = [&] { return Vector3{number(), number(), number()}; };
  const auto half = [&] { return m.below(10) == 0 ? 0 : std::fabs(number()); };
  const Point3 p = point();
  switch (m.below(7)) {
    case 0:
      return p;
    case 1:
      return Segment3{p, point()};
    case 2:
      return Rectangle3{p, {axis(), axis()}, {half(), half()}};
    case 3:
      return Sphere3{p, half() / 4};
    case 4:
      return Aabb3{p, {p.x + half(), p.y + half(), p.z + half()}};
    case 5:
      return Obb3{p, {axis(), axis(), axis()}, {half(), half(), half()}};
    default:
      return Capsule3{p, m.below(10) == 0 ? p : point(), half() / 4};
  }
}
RigidCase random_pose(Material& m, double far) {
  const auto number = [&] { return static_cast<double>(m.below(1 << 26)) * 0x1p-25 - 1; };
  const RigidPose pose{{number(), number(), number(), number()},
                       {far + 2 * number(), 2 * number() - far, 2 * number()}};
  if (far > 1e6 || m.below(2) != 0) return {pose, flat_of(pose)};
  RigidChain chain{{pose}};
  for (auto n = m.below(4); n > 0; --n) chain.links.push_back({{0.1, number(), number(), 0.3}, {number(), 0, 0}});
  return {chain, RigidChain2{}};
}

struct ToldCounts {
  int asked = 0, told = 0;
};

void expect_exact(const query::PosedView& a, const query::PosedView& b, ToldCounts& counts, const std::string& about) {
  const auto c = query::closest_of_sums(a, b);
  const auto d = query::distance_of_sums(a, b);
  ++counts.asked, counts.told += c ? 1 : 0;
  if (!c && !d) return;
  const Closest exact = judged(a, b);
  if (c) {
    EXPECT_EQ(*c, exact) << about;
  }
  if (d) {
    EXPECT_EQ(*d, exact.distance) << about;
  }
}

TEST(EdgeSums, WhatIsToldOfDegenerateOnesIsExact) {
  ToldCounts counts;
  shape_cases::on_shapes(7101, battery::sanitized ? 300 : 4'000, [&](Material& m) {
    const Shape s = degenerate_shape(m), t = degenerate_shape(m);
    if (!is_some(s) || !is_some(t)) return;
    const RigidCase by_s = rigid_case(m), by_t = rigid_case(m);
    const bool is_posed = m.below(3) != 0;
    expect_exact(seen(s, is_posed ? &by_s : nullptr), seen(t, m.below(3) != 0 ? &by_t : nullptr), counts, m.about());
  });
  EXPECT_GT(counts.told * 20, counts.asked);
}

TEST(EdgeSums, MostInGeneralPositionAreTold) {
  for (const double far : {0.0, 1e3, 1e9}) {
    ToldCounts counts;
    shape_cases::on_shapes(7102, battery::sanitized ? 100 : 2'000, [&](Material& m) {
      const Shape s = random_shape(m), t = random_shape(m);
      const RigidCase by_s = random_pose(m, far), by_t = random_pose(m, far);
      const bool stands = far == 0 && m.below(4) == 0;
      expect_exact(seen(s, stands ? nullptr : &by_s), seen(t, stands ? nullptr : &by_t), counts, m.about());
    });
    EXPECT_GT(counts.told * 20, counts.asked * 19) << far;  // many of the others meet
  }
}

/// f of every face: each edge of both at one end, at the other, or free.
template <class F>
void on_faces(const query::EdgeSum& a, const query::EdgeSum& b, const F& f) {
  const auto on_bits = [](std::uint32_t edges, const auto& g) {
    for (std::uint32_t along = 0; along < 1U << edges; ++along) {
      for (std::uint32_t upper = 0; upper < 1U << edges; ++upper) {
        if ((along & upper) == 0) g(along, upper);
      }
    }
  };
  on_bits(a.size, [&](std::uint32_t along_a, std::uint32_t upper_a) {
    on_bits(b.size, [&](std::uint32_t along_b, std::uint32_t upper_b) {
      f(query::EdgeFace{{along_a, along_b}, {upper_a, upper_b}});
    });
  });
}

TEST(EdgeSums, AnyFaceMayBeGuessed) {
  int pairs = 0, told = 0;
  shape_cases::on_shapes(7103, battery::sanitized ? 20 : 300, [&](Material& m) {
    const bool is_random = m.below(2) == 0;
    const Shape s = is_random ? random_shape(m) : degenerate_shape(m),
                t = is_random ? random_shape(m) : degenerate_shape(m);
    if (!is_some(s) || !is_some(t)) return;
    const RigidCase by_s = random_pose(m, 0), by_t = random_pose(m, 0);
    const query::PosedView a = seen(s, &by_s), b = seen(t, &by_t);
    query::EdgeSum p, q;
    if (!p.set(a) || !q.set(b)) return;
    const Closest exact = judged(a, b);
    int faces = 0;
    on_faces(p, q, [&](const query::EdgeFace& face) {
      const auto n = query::nearest_on(p, q, face, true);
      if (!n) return;
      ++faces;
      EXPECT_EQ(n->distance, exact.distance) << m.about();
      EXPECT_EQ(n->on_a, exact.on_a) << m.about();
      EXPECT_EQ(n->on_b, exact.on_b) << m.about();
    });
    EXPECT_LE(faces, 1) << m.about();
    ++pairs, told += faces;
  });
  EXPECT_GT(told * 3, pairs);
}

TEST(EdgeSums, NothingIsToldOfNumbersThatAreNone) {
  Capsule3 capsule{{0, 0.5, -0.5}, {0.25, 0.1, 0.5}, 0.2};
  Obb3 box{{0.1, 0.2, 0.3}, {{{1, 0.1, 0}, {0, 1, 0.2}, {0.3, 0, 1}}}, {0.5, 0.3, 0.2}};
  RigidPose by{{1, 0.5, 0.25, 0.125}, {1, 0.2, 0.1}}, other{{0.5, 0.25, 1, -0.5}, {4, 0.2, 0.1}};
  ASSERT_TRUE(query::closest_of_sums(query::posed_view(Posed{capsule, by}), query::posed_view(Posed{box, other})));
  const auto each_number = [](auto& of, const auto& f) {
    std::array<double, sizeof(of) / sizeof(double)> numbers{};
    std::memcpy(numbers.data(), &of, sizeof(of));
    const auto as_given = numbers;
    for (double& x : numbers) {
      for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        const double before = x;
        x = bad;
        std::memcpy(static_cast<void*>(&of), numbers.data(), sizeof(of));
        f();
        x = before;
      }
    }
    std::memcpy(static_cast<void*>(&of), as_given.data(), sizeof(of));
  };
  const auto expect_nothing = [&] {
    const Posed<Capsule3, RigidPose> p{capsule, by};
    const Posed<Capsule3, RigidChain> chained{capsule, {{other, by}}};
    const Posed<Obb3, RigidPose> q{box, other};
    for (const query::PosedView& a : {query::posed_view(p), query::posed_view(chained)}) {
      const query::PosedView b = query::posed_view(q);
      EXPECT_FALSE(query::closest_of_sums(a, b) || query::closest_of_sums(b, a));
      EXPECT_FALSE(query::distance_of_sums(a, b) || query::distance_of_sums(b, a));
    }
  };
  each_number(capsule, expect_nothing), each_number(box, expect_nothing);
  each_number(by, expect_nothing), each_number(other, expect_nothing);
  capsule.radius = -0.2, expect_nothing();
}

}  // namespace
}  // namespace plumb::pair_cases
