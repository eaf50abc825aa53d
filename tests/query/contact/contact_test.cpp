// Contacts of bodies of every kind against exact sets: the direction, the distance, the features that face each other
// and what they have in common; rounding, swapping, caches, motion.
#include "plumb/query/contact/contact.hpp"

#include <gmock/gmock.h>

#include <cstdio>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/query/gjk/gjk.hpp"
#include "plumb/query/penetration/penetration.hpp"
#include "query/body/rigid_cases.hpp"
#include "query/contact/facing.hpp"
#include "query/contact/rounded_contact.hpp"
#include "query/contact/turned_box.hpp"
#include "query/convex/nearest_pair.hpp"
#include "query/gjk/any_body.hpp"
#include "query/penetration/told_checks.hpp"
#include "query/section/meet_halfspaces.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb {
namespace {

using namespace drawn_body;
using query::cross, query::dot, query::is_zero;
using query::operator+, query::operator-, query::operator*;
using told_checks::big, told_checks::gmp, told_checks::is_nearest_to;

Exact3 exact(const RationalPoint3& p) { return {gmp(p.x), gmp(p.y), gmp(p.z)}; }
Exact3 negative(const Exact3& v) { return mpq_class(-1) * v; }

struct Counts {
  int apart = 0, touching = 0, overlapping = 0, points = 0, several = 0, refused = 0;
};

/// The feature of a body that faces along a direction, by its exact corners: checked to hold all that is farthest.
std::vector<Exact3> facing(const BodyView& view, const query::Body& body, const Exact3& out, const std::string& about) {
  const std::vector<Exact3> all = core_of(body).points;
  std::uint32_t at = 0;
  for (std::uint32_t i = 1; i < all.size(); ++i) at = dot(out, all[i] - all[at]) > 0 ? i : at;
  const query::parting::KnownLevel known(body.corners, at);
  const query::touching::Seen seen{view, body.corners, at, known, nullptr, nullptr};
  CertainSigns ask;
  const auto number = [](const mpq_class& x) { return BigDyadic(mpz_class(x.get_num())); };  // directions are whole
  const query::Vec<BigDyadic> n{number(out[0]), number(out[1]), number(out[2])};
  const query::touching::Facing f = query::touching::FacingSearch<BigDyadic>(seen, n, ask).run();
  std::vector<Exact3> corners;
  for (const std::uint32_t i : f.corners) corners.push_back(all[i]);
  for (const Exact3& p : all) {
    EXPECT_LE(dot(out, p - all[at]), 0) << about;
    if (dot(out, p - all[at]) == 0) {
      EXPECT_EQ(*query::squared_distance(FlatSet{{p}, {}, {}}, FlatSet{corners, {}, {}}), 0) << about;
    }
  }
  return corners;
}

std::vector<Exact3> seen_along(const Exact3& n, std::vector<Exact3> points) {
  for (Exact3& p : points) p = p - mpq_class(dot(n, p) / dot(n, n)) * n;
  return points;
}

/// Without a margin that cuts anything off.
void expect_common_part(const ExactContact& c, const Exact3& n, const std::array<std::vector<Exact3>, 2>& faces,
                        const std::string& about) {
  std::vector<query::ExactHalfspace> sides;
  for (const std::vector<Exact3>& face : faces) {
    for (query::ExactHalfspace& h : halfspaces_of(FlatSet{seen_along(n, face), {}, {}})) sides.push_back(std::move(h));
  }
  const SolidIntersection3 wanted = query::meeting::meet_halfspaces(sides);
  std::vector<Exact3> told, corners;
  for (const ExactContactCorner& k : c.corners) told.push_back(seen_along(n, {exact(k.on_a)})[0]);
  for (const ExactPoint3& p : wanted.vertices) corners.push_back(exact(rational_point(p)));
  std::ranges::sort(told), std::ranges::sort(corners);
  EXPECT_EQ(told, corners) << about;
}

/// Turned round.
ContactManifold swapped(const ContactManifold& m) {
  std::vector<ContactCorner> all;
  for (const ContactCorner& c : m.corners) all.push_back({c.on_b, c.on_a, c.distance, {c.id.b, c.id.a}});
  std::ranges::sort(all, {}, &ContactCorner::id);
  ContactManifold s{m.relation, {0.0 - m.normal.x, 0.0 - m.normal.y, 0.0 - m.normal.z}, m.distance, {}};
  for (const ContactCorner& c : all) s.corners.push_back(c);
  return s;
}

constexpr double far = 0x1p1000;

void expect_contact(const AnyBody& va, const AnyBody& vb, Material& draw, Counts& counts, const std::string& about) {
  const BodyView &a = va.view, &b = vb.view;
  std::optional<std::array<query::Body, 2>> bodies;
  try {
    bodies = query::bodies_of("asked", a, b);
  } catch (const Error&) {
    EXPECT_THROW((void)query::contact_of(a, b, {}, nullptr), Error) << about;
    ++counts.refused;
    return;
  }
  const auto e = query::exact_contact_of(a, b, far);
  const FlatSet core_a = core_of((*bodies)[0]), core_b = core_of((*bodies)[1]);
  const mpq_class radii = (*bodies)[0].radius + (*bodies)[1].radius;
  const mpq_class square = *query::squared_distance(core_a, core_b);
  if (!e) {
    EXPECT_GT(square, mpq_class(far) * mpq_class(far)) << about;
    return;
  }
  const Exact3 n = gmp(e->direction);
  EXPECT_EQ(gmp(e->radius_a) + gmp(e->radius_b), radii) << about;
  const mpq_class along = gmp(e->along), length = dot(n, n);
  // What is known otherwise: the distance of the cores, or the least translation.
  const auto p = query::exact_penetration_of(a, b);
  EXPECT_EQ(p.has_value(), e->relation != Relation::disjoint || along * along * length <= radii * radii) << about;
  if (sgn(square) > 0) {
    EXPECT_EQ(along * along * length, square) << about;
    EXPECT_GT(sgn(along), 0) << about;
  } else {
    ASSERT_TRUE(p) << about;
    EXPECT_LE(sgn(along), 0) << about;
    EXPECT_EQ(along * along * length, gmp(p->core_square)) << about;
  }
  if (p) {
    EXPECT_EQ(gmp(p->direction), negative(n)) << about;
  }
  const int sign = sgn(along) > 0 ? cmp(along * along * length, radii * radii) : sgn(along) < 0 ? -1 : -sgn(radii);
  EXPECT_EQ(static_cast<int>(e->relation), -(sign > 0 ? 1 : sign < 0 ? -1 : 0)) << about;
  (sign > 0 ? counts.apart : sign < 0 ? counts.overlapping : counts.touching) += 1;
  // The corners: within both bodies, straight ahead, and all of what the features have in common.
  ASSERT_FALSE(e->corners.empty()) << about;
  (e->corners.size() == 1 ? counts.points : counts.several) += 1;
  mpq_class least = gmp(e->corners[0].along);
  for (const ExactContactCorner& k : e->corners) {
    const Exact3 on_a = exact(k.on_a), on_b = exact(k.on_b);
    EXPECT_EQ(on_b - on_a, gmp(k.along) * n) << about;
    least = std::min(least, gmp(k.along));
    EXPECT_EQ(*query::squared_distance(FlatSet{{on_a}, {}, {}}, core_a), 0) << about;
    EXPECT_EQ(*query::squared_distance(FlatSet{{on_b}, {}, {}}, core_b), 0) << about;
  }
  EXPECT_EQ(least, along) << about;
  expect_common_part(*e, n, {facing(a, (*bodies)[0], n, about), facing(b, (*bodies)[1], negative(n), about)}, about);
  // Rounded once; whatever is in the cache; turned round; and with a margin.
  ContactCache cache;
  const auto m = query::contact_of(a, b, {.margin = far}, &cache);
  ASSERT_TRUE(m) << about;
  expect_rounded(*m, *e, about);
  EXPECT_EQ(m, query::contact_of(a, b, {.margin = far}, &cache)) << about;
  cache = {};
  cache.size = 4;
  for (auto& ends : cache.corners)
    ends = {static_cast<std::uint32_t>(draw.below(9)), static_cast<std::uint32_t>(draw.below(9))};
  EXPECT_EQ(m, query::contact_of(a, b, {.margin = far}, &cache)) << about;
  if (!p || p->is_unique) {
    EXPECT_EQ(query::contact_of(b, a, {.margin = far}, nullptr), swapped(*m)) << about;
  }
  const double margin = std::max(0.0, m->corners[draw.below(m->corners.size())].distance);
  const auto part = query::contact_of(a, b, {.margin = margin}, nullptr);
  const auto exact_part = query::exact_contact_of(a, b, margin);
  EXPECT_EQ(part.has_value(), exact_part.has_value()) << about;
  if (part) expect_rounded(*part, *exact_part, about);
  std::size_t near = 0;
  for (const ContactCorner& c : m->corners) near += c.distance < margin ? 1 : 0;
  if (near > 0) {
    ASSERT_TRUE(part) << about;
    EXPECT_GE(part->corners.size(), near) << about;
  }
  for (std::size_t i = 0; part && i < part->corners.size(); ++i) EXPECT_LE(part->corners[i].distance, margin) << about;
}

AnyBody under_rigid(AnyBody body, const RigidPose& by) {
  const auto pose = std::make_shared<const RigidPose>(by);
  body.shape = std::make_shared<const std::pair<std::shared_ptr<const void>, std::shared_ptr<const RigidPose>>>(
      body.shape, pose);
  body.view.pose = pose.get();
  return body;
}

TEST(Contact, OfEveryKindIsWhatExactSetsHaveInCommon) {
  Counts counts;
  std::uint64_t start = 44'000;
  for (const Make& first : makers()) {
    for (const Make& second : makers()) {
      if (++start % 4 != 0 && battery::sanitized) continue;
      shape_cases::on_shapes(start, 1, [&](Material& m) {
        AnyBody a = first(m), b = second(m);
        if (m.below(4) == 0) a = under(a, pair_cases::whole_pose(m));
        if (m.below(4) == 0) b = under(b, pair_cases::regular_pose(m));
        if (m.below(4) == 0) a = under_rigid(a, pair_cases::rigid_pose(m));
        if (m.below(4) == 0) b = under_rigid(b, pair_cases::rigid_pose(m));
        expect_contact(a, b, m, counts, name_of(a.view) + " and " + name_of(b.view) + " " + m.about());
      });
    }
  }
  std::printf("apart %d, touching %d, overlapping %d; one corner %d, several %d; refused %d\n", counts.apart,
              counts.touching, counts.overlapping, counts.points, counts.several, counts.refused);
  if (battery::sanitized) return;
  EXPECT_GE(std::min({counts.apart, counts.touching, counts.overlapping, counts.points, counts.several}), 10);
}

/// Boxes, rectangles, triangles and what they are the hull of, on a grid: parallel faces, flush edges, ties.
TEST(Contact, OfFlushBodiesOfAGrid) {
  Counts counts;
  shape_cases::on_shapes(44'900, battery::sanitized ? 20 : 600, [&](Material& m) {
    const auto at = [&] { return static_cast<double>(m.below(4)); };
    const auto body = [&]() -> AnyBody {
      const Point3 low{at(), at(), at()}, high{low.x + at(), low.y + at(), low.z + at()};
      switch (m.below(6)) {
        case 0:
          return any(Obb3{low, {Vector3{0, 1, 0}, Vector3{-1, 0, 0}, Vector3{0, 0, 1}}, {at(), at(), at()}});
        case 1:
          return any(Obb3{low, {Vector3{1, 1, 0}, Vector3{1, -1, 0}, Vector3{0, 0, 1}}, {at(), at(), at()}});
        case 2:
          return any(Triangle3{low, high, {at(), at(), at()}});
        case 3: {
          std::vector<Point3> corners;
          for (unsigned i = 0; i < 8; ++i) {
            corners.push_back({(i & 1) != 0 ? high.x + 1 : low.x, (i & 2) != 0 ? high.y + 1 : low.y,
                               (i & 4) != 0 ? high.z + 1 : low.z});
          }
          return any(convex_polyhedron(convex_hull(corners), corners));  // of triangles
        }
        case 4:
          return any(Capsule3{low, high, at()});
        default:
          return any(Aabb3{low, high});
      }
    };
    AnyBody a = body(), b = body();
    if (m.below(4) == 0) {
      const Pose pose{{{{0, 3, 4}, {5, 0, 0}, {0, 4, -3}}}, {1, 2, 3}};  // a similarity
      a = under(a, pose), b = under(b, pose);
    }
    expect_contact(a, b, m, counts, name_of(a.view) + " and " + name_of(b.view) + " " + m.about());
  });
  std::printf("apart %d, touching %d, overlapping %d; one corner %d, several %d\n", counts.apart, counts.touching,
              counts.overlapping, counts.points, counts.several);
  if (battery::sanitized) return;
  EXPECT_GE(std::min({counts.apart, counts.touching, counts.overlapping, counts.points, counts.several}), 40);
}

std::vector<ContactId> ids_of(const ContactManifold& m) {
  std::vector<ContactId> ids;
  for (const ContactCorner& c : m.corners) ids.push_back(c.id);
  return ids;
}

/// Frame by frame, with the noise of a solver: the box sinks in and comes out, slides, spins and is tilted.
TEST(Contact, IdsPersistAndNormalsDoNotFlip) {
  const Obb3 slope = turned_box({0, 0, 0}, 0.4, 0.3, {20, 0.5, 20});
  const Aabb3 ground{{-20, -1, -20}, {20, 0, 20}};
  std::array<int, 3> seen{};  // apart, touching, overlapping
  Entropy entropy(44, 1);
  const auto noise = [&](double size) { return size * (static_cast<double>(entropy.bits(53)) * 0x1p-52 - 1); };
  const auto run = [&](const auto& on, const auto& box_at, const Vector3& down, int frames, const char* what) {
    ContactCache cache;
    std::optional<std::vector<ContactId>> ids;
    int changes = 0;
    for (int frame = 0; frame < frames; ++frame) {
      const Obb3 box = box_at(frame);
      const auto m = contact(box, on, {.margin = 0.01}, &cache);
      ASSERT_TRUE(m) << what << frame;
      EXPECT_EQ(m, contact(box, on, {.margin = 0.01})) << what << frame;
      ++seen[static_cast<std::size_t>(static_cast<int>(m->relation) + 1)];
      EXPECT_GT(m->normal.x * down.x + m->normal.y * down.y + m->normal.z * down.z, 0.999) << what << frame;
      EXPECT_EQ(m->corners.size(), 4U) << what << frame;
      if (ids && ids_of(*m) != *ids) ++changes;
      ids = ids_of(*m);
    }
    EXPECT_EQ(changes, 0) << what;
  };
  const int frames = battery::sanitized ? 20 : 200;
  const Vector3 half{0.5, 0.5, 0.5}, straight{0, -1, 0};
  run(
      ground,
      [&](int) {
        return turned_box({0.3, 0.5, 0.2}, 0.7, 0, half);
      },
      straight, 3, "resting exactly ");
  run(
      ground,
      [&](int) {
        return turned_box({0.3, 0.5 + noise(1e-3), 0.2}, 0.7, noise(1e-4), half);
      },
      straight, frames, "trembling ");
  run(
      ground,
      [&](int k) {
        return turned_box({0.05 * k - 5, 0.5 + noise(1e-9), 0.2}, 0.7, noise(1e-12), half);
      },
      straight, frames, "sliding ");
  run(
      ground,
      [&](int k) {
        return turned_box({0.3, 0.499 + noise(1e-5), 0.2}, 0.1 * k, noise(1e-6), half);
      },
      straight, frames, "spinning ");
  const Vector3 up = slope.axes[1], into{-up.x, -up.y, -up.z};
  const auto on_slope = [&](double yaw, double along, double height) {
    Obb3 box = turned_box({0, 0, 0}, 0.4, 0.3, half);
    const Vector3 u = box.axes[0], w = box.axes[2];
    const double c = std::cos(yaw), s = std::sin(yaw);
    box.axes[0] = {c * u.x - s * w.x, c * u.y - s * w.y, c * u.z - s * w.z};
    box.axes[2] = {s * u.x + c * w.x, s * u.y + c * w.y, s * u.z + c * w.z};
    box.center = {up.x * height + u.x * along, up.y * height + u.y * along, up.z * height + u.z * along};
    return box;
  };
  run(
      slope, [&](int k) { return on_slope(0, 0.02 * k, 1 + noise(1e-3)); }, into, frames, "down the slope ");
  run(
      slope, [&](int k) { return on_slope(0.05 * k, 0, 1 + noise(1e-6)); }, into, frames, "spinning on the slope ");
  EXPECT_GT(std::min({seen[0], seen[1], seen[2]}), 0);
}

/// What rests exactly, nearly rests, lies within or is a needle; and a box in itself.  Every number against the exact one.
TEST(Contact, OfCratesIsExactThenRounded) {
  std::array<int, 3> seen{};
  int level = 0;  // corners as far apart as the bodies
  const auto expect = [&](const auto& a, const auto& b, const std::string& about) {
    const auto m = contact(a, b, {.margin = 0.01});
    const auto e = exact_contact(a, b, 0.01);
    ASSERT_EQ(m.has_value(), e.has_value()) << about;
    if (!m) return;
    expect_rounded(*m, *e, about);
    ++seen[static_cast<std::size_t>(static_cast<int>(m->relation) + 1)];
    for (const ContactCorner& c : m->corners) {
      EXPECT_GE(c.distance, m->distance) << about;
      level += c.distance == m->distance ? 1 : 0;
    }
    EXPECT_TRUE(std::ranges::any_of(m->corners, [&](const auto& c) { return c.distance == m->distance; })) << about;
  };
  for (const double pitch : {0.0, 0.3}) {
    for (const Vector3& half : {Vector3{0.5, 0.5, 0.5}, Vector3{0x1p-30, 0.5, 4}, Vector3{0.5, 0, 0.5}}) {
      for (int i = 0; i < (battery::sanitized ? 2 : 12); ++i) {
        const Obb3 ground = turned_box({0, 0, 0}, 0, pitch, {8, 0.5, 8});
        Obb3 crate = turned_box({0, 0, 0}, 0.3 * i, pitch, half);
        if (i % 3 != 0) {  // about the very same axis
          const double c = std::cos(0.3 * i), s = std::sin(0.3 * i);
          const Vector3 u = ground.axes[0], v = ground.axes[2];
          crate.axes = {Vector3{c * u.x - s * v.x, c * u.y - s * v.y, c * u.z - s * v.z}, ground.axes[1],
                        Vector3{s * u.x + c * v.x, s * u.y + c * v.y, s * u.z + c * v.z}};
        }
        const Vector3 up = ground.axes[1];
        for (const double lift : {0x1p-7, 0x1p-50, 0.0, -0x1p-50, -0x1p-7}) {
          const double h = 0.5 + half.y + lift;
          crate.center = {h * up.x, h * up.y, h * up.z};
          const std::string about = std::to_string(pitch) + " " + std::to_string(half.x) + " crate " +
                                    std::to_string(i) + " lift " + std::to_string(lift);
          expect(crate, ground, about), expect(ground, crate, about + " swapped");
          if (pitch == 0) expect(crate, Aabb3{{-8, -0.5, -8}, {8, 0.5, 8}}, about + " on an aligned one");
        }
        expect(crate, crate, "in itself");
      }
    }
  }
  std::printf("apart %d, touching %d, overlapping %d; level corners %d\n", seen[0], seen[1], seen[2], level);
  EXPECT_GT(std::min({seen[0], seen[1], seen[2], level}), 0);
}

/// A capsule that rolls keeps its two corners, a ball its one.
TEST(Contact, OfWhatRolls) {
  const Aabb3 ground{{-20, -1, -20}, {20, 0, 20}};
  ContactCache cache;
  for (int k = 0; k < 100; ++k) {
    const double x = 0.05 * k;
    const auto m = contact(Capsule3{{x, 0.25, -1}, {x, 0.25, 1}, 0.25}, ground, {}, &cache);
    ASSERT_TRUE(m);
    EXPECT_EQ(m->relation, Relation::touching);
    EXPECT_EQ(m->normal, (Vector3{0, -1, 0}));
    EXPECT_THAT(ids_of(*m), testing::ElementsAre(ContactId{{FeatureKind::face, 1}, {FeatureKind::face, 3}},
                                                 ContactId{{FeatureKind::face, 2}, {FeatureKind::face, 3}}));
    const auto ball = contact(Sphere3{{x, 0.25, 0}, 0.5}, ground, {});
    ASSERT_TRUE(ball);
    EXPECT_EQ(ball->distance, -0.25);
    EXPECT_EQ(ball->corners[0].on_a, (Point3{x, -0.25, 0}));
    EXPECT_EQ(ball->corners[0].on_b, (Point3{x, 0, 0}));
  }
}

TEST(Contact, AtMostKeepsTheDeepestAndTheWidest) {
  const Obb3 box = turned_box({0.3, 0.25, 0.2}, 0.7, 0.01, {2, 0.25, 1});
  const Aabb3 ground{{-20, -1, -20}, {20, 0, 20}};
  const auto all = contact(box, ground, {.margin = 1});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->corners.size(), 4U);
  std::size_t before = 0;
  for (std::size_t n = 1; n <= 5; ++n) {
    const auto some = contact(box, ground, {.margin = 1, .at_most = n});
    ASSERT_TRUE(some);
    EXPECT_EQ(some->corners.size(), std::min<std::size_t>(n, 4));
    EXPECT_EQ(some->distance, std::ranges::min(some->corners, {}, &ContactCorner::distance).distance);
    EXPECT_GE(some->corners.size(), before);
    before = some->corners.size();
    for (const ContactCorner& c : some->corners) EXPECT_NE(std::ranges::find(all->corners, c), all->corners.end());
  }
  // The two are the ends of the longer diagonal.
  const auto two = contact(box, ground, {.margin = 1, .at_most = 2});
  EXPECT_EQ(two->corners[0].id.a.index ^ two->corners[1].id.a.index, 5U);
}

TEST(Contact, AMoveOrAPowerOfTwoChangesNoId) {
  Counts counts;
  shape_cases::on_shapes(45'500, battery::sanitized ? 5 : 60, [&](Material& m) {
    const auto at = [&] { return static_cast<double>(m.below(64)) / 16; };
    const Obb3 a{{at(), at(), at()}, {Vector3{at(), 1, 0}, Vector3{-1, at(), 0}, Vector3{0, 0, 1}}, {at(), at(), at()}};
    const Aabb3 b{{0, 0, 0}, {at(), at(), at()}};
    const auto here = contact(a, b, {.margin = 64});
    const double x = 1024 * at(), y = 1024 * at(), s = 0x1p-40;
    const auto there = contact(Obb3{{a.center.x + x, a.center.y + y, a.center.z}, a.axes, a.half},
                               Aabb3{{x, y, 0}, {b.max.x + x, b.max.y + y, b.max.z}}, {.margin = 64});
    const auto small = contact(
        Obb3{{s * a.center.x, s * a.center.y, s * a.center.z}, a.axes, {s * a.half.x, s * a.half.y, s * a.half.z}},
        Aabb3{{0, 0, 0}, {s * b.max.x, s * b.max.y, s * b.max.z}}, {.margin = 64 * s});
    ASSERT_TRUE(here && there && small) << m.about();
    EXPECT_EQ(ids_of(*here), ids_of(*there)) << m.about();
    EXPECT_EQ(ids_of(*here), ids_of(*small)) << m.about();
    EXPECT_EQ(here->normal, there->normal) << m.about();
    EXPECT_EQ(here->normal, small->normal) << m.about();
    EXPECT_EQ(here->distance, there->distance) << m.about();
    EXPECT_EQ(s * here->distance, small->distance) << m.about();
    (here->relation == Relation::overlapping ? counts.overlapping : counts.apart) += 1;
  });
  EXPECT_GT(std::min(counts.overlapping, counts.apart), 0);
}

TEST(Contact, RefusesByName) {
  const Aabb3 box{{0, 0, 0}, {1, 1, 1}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using testing::HasSubstr, testing::ThrowsMessage;
  EXPECT_THAT([&] { (void)contact(box, box, {.margin = -1}); },
              ThrowsMessage<InvalidShape>(HasSubstr("contact: margin is negative")));
  EXPECT_THAT([&] { (void)exact_contact(box, box, nan); },
              ThrowsMessage<NonFinite>(HasSubstr("exact_contact: margin")));
  EXPECT_THAT([&] { (void)contact(Sphere3{{0, 0, 0}, -1}, box); }, ThrowsMessage<InvalidShape>(HasSubstr("contact: ")));
  EXPECT_THAT([&] { (void)contact(Point3{nan, 0, 0}, box); }, ThrowsMessage<NonFinite>(HasSubstr("contact: ")));
  EXPECT_THAT(
      [&] {
        (void)contact(Aabb3{{1, 1, 1}, {0, 0, 0}}, box);
      },
      ThrowsMessage<InvalidShape>(HasSubstr("empty")));
}

}  // namespace
}  // namespace plumb
