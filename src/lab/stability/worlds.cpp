// Worlds of bodies that rest, lie ulps apart, or are strewn: which pairs are missed, and which are told and do not meet?
// By GJK in floats, by the collision worlds of other libraries where the program has them, and by the library's.
#include <algorithm>
#include <cmath>

#include "lab/stability/float_ways.hpp"
#include "lab/trial/convex_tests.hpp"
#include "lab/trial/rational_judge.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/world/world.hpp"

namespace plumb::lab::stability {
namespace {

constexpr std::size_t body_numbers = 31, pair_numbers = 2 * body_numbers;  // corners, quaternion, translation

using Bodies = std::vector<WorldBody>;

// The judge, in rationals: the linear program of two hulls.

struct ExactBody {
  std::vector<trial::RationalVec> corners;
  trial::RationalVec min, max;
};

ExactBody exact_body(const WorldBody& body) {
  const mpq_class w = body.pose.turn.w, x = body.pose.turn.x, y = body.pose.turn.y, z = body.pose.turn.z;
  const mpq_class weight = w * w + x * x + y * y + z * z;
  const trial::RationalVec axis{x, y, z};
  const Vector3& t = body.pose.translation;
  ExactBody exact;
  for (const Point3& p : body.corners) {
    const trial::RationalVec v{p.x, p.y, p.z};
    // q v q^-1 = v + 2 (w (axis x v) + axis x (axis x v)) / |q|^2
    const trial::RationalVec across = trial::cross(axis, v), twice = trial::cross(axis, across);
    const trial::RationalVec turned = v + (across * w + twice) * mpq_class(2 / weight);
    exact.corners.push_back(turned + trial::RationalVec{t.x, t.y, t.z});
  }
  exact.min = exact.max = exact.corners[0];
  for (const trial::RationalVec& p : exact.corners) {
    exact.min = {std::min(exact.min.x, p.x), std::min(exact.min.y, p.y), std::min(exact.min.z, p.z)};
    exact.max = {std::max(exact.max.x, p.x), std::max(exact.max.y, p.y), std::max(exact.max.z, p.z)};
  }
  return exact;
}

/// Are their boxes at most 1 apart, so that they are worth asking about?
bool are_near(const ExactBody& a, const ExactBody& b) {
  const auto near = [](const mpq_class& min_a, const mpq_class& max_a, const mpq_class& min_b, const mpq_class& max_b) {
    return min_a <= max_b + 1 && min_b <= max_a + 1;
  };
  return near(a.min.x, a.max.x, b.min.x, b.max.x) && near(a.min.y, a.max.y, b.min.y, b.max.y) &&
         near(a.min.z, a.max.z, b.min.z, b.max.z);
}

struct JudgedWorld {
  Bodies bodies;
  BodyPairs near, meeting;
};

JudgedWorld judged_world(Bodies bodies) {
  std::vector<ExactBody> exact;
  for (const WorldBody& b : bodies) exact.push_back(exact_body(b));
  JudgedWorld world{std::move(bodies), {}, {}};
  for (std::uint32_t j = 0; j < exact.size(); ++j) {
    for (std::uint32_t i = 0; i < j; ++i) {
      if (!are_near(exact[i], exact[j])) continue;
      world.near.insert({i, j});
      if (trial::meet({exact[i].corners, {}}, {exact[j].corners, {}})) world.meeting.insert({i, j});
    }
  }
  return world;
}

// Who is asked.

std::array<double, pair_numbers> question_of(const WorldBody& a, const WorldBody& b) {
  std::array<double, pair_numbers> q{};
  double* to = q.data();
  for (const WorldBody* body : {&a, &b}) {
    for (const Point3& p : body->corners) *to++ = p.x, *to++ = p.y, *to++ = p.z;
    const auto& [turn, t] = body->pose;
    for (const double x : {turn.w, turn.x, turn.y, turn.z, t.x, t.y, t.z}) *to++ = x;
  }
  return q;
}

/// Corners are turned by the matrix of the quaternion of length 1, as scenes of float code store it.
struct PosedGjk {
  template <class T>
  bool operator()(const std::array<T, pair_numbers>& q, T epsilon) const {
    std::array<T, 48> corners{};
    for (std::size_t body = 0; body < 2; ++body) {
      const T* const from = &q[body_numbers * body];
      const T length =
          trial::square_root(T(from[24] * from[24] + from[25] * from[25] + from[26] * from[26] + from[27] * from[27]));
      const T w = from[24] / length, x = from[25] / length, y = from[26] / length, z = from[27] / length;
      const std::array<trial::Vec<T>, 3> rows{
          {{T(1 - 2 * (y * y + z * z)), T(2 * (x * y - w * z)), T(2 * (x * z + w * y))},
           {T(2 * (x * y + w * z)), T(1 - 2 * (x * x + z * z)), T(2 * (y * z - w * x))},
           {T(2 * (x * z - w * y)), T(2 * (y * z + w * x)), T(1 - 2 * (x * x + y * y))}}};
      for (std::size_t i = 0; i < 8; ++i) {
        const trial::Vec<T> p{from[3 * i], from[3 * i + 1], from[3 * i + 2]};
        for (std::size_t k = 0; k < 3; ++k) corners[24 * body + 3 * i + k] = T(trial::dot(rows[k], p) + from[28 + k]);
      }
    }
    return trial::ConvexMeeting{}(corners, epsilon);
  }
};

AnyBody any_body(const WorldBody& body) {
  if (body.half) {
    const auto& [x, y, z] = *body.half;
    return {Posed{Aabb3{{-x, -y, -z}, {x, y, z}}, body.pose}};
  }
  return {Posed{convex_polyhedron(convex_hull(body.corners), body.corners), body.pose}};
}

BodyPairs told_by_ours(std::span<const WorldBody> bodies) {
  CollisionWorld world;
  for (std::uint32_t i = 0; i < bodies.size(); ++i) world.add(any_body(bodies[i]), {.user_id = i});
  world.commit();
  BodyPairs told;
  for (const WorldPair& p : world.pairs())
    told.insert({static_cast<std::uint32_t>(p.id_a), static_cast<std::uint32_t>(p.id_b)});
  return told;
}

Findings tried(const JudgedWorld& world, const std::vector<WorldRival>& rivals) {
  const auto counts_of = [&](const BodyPairs& told) {
    Count missed{"pairs that meet and are not told", 0, world.meeting.size()};
    Count made_up{"pairs that are told and do not meet", 0, world.near.size() - world.meeting.size()};
    for (const auto& pair : world.meeting) missed.failures += told.contains(pair) ? 0 : 1;
    for (const auto& pair : told) {
      made_up.failures += world.meeting.contains(pair) ? 0 : 1;
      made_up.of += world.near.contains(pair) ? 0 : 1;
    }
    return std::vector<Count>{missed, made_up};
  };
  Findings findings;
  for (const auto& way : float_ways<pair_numbers>(PosedGjk{})) {
    BodyPairs told;
    for (const auto& pair : world.near) {
      if (way.ask(question_of(world.bodies[pair[0]], world.bodies[pair[1]]))) told.insert(pair);
    }
    findings.outcomes.push_back({way.name, counts_of(told)});
  }
  for (const WorldRival& rival : rivals) findings.outcomes.push_back({rival.name, counts_of(rival.ask(world.bodies))});
  findings.outcomes.push_back({"exact", counts_of(told_by_ours(world.bodies)), true});
  return findings;
}

// The scenes.

WorldBody box(const Vector3& half, const RigidPose& pose) {
  WorldBody body{{}, half, pose};
  for (std::size_t i = 0; i < 8; ++i)
    body.corners[i] = {i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
  return body;
}
/// A multiple of 2^-20 of at least 1 / 2, at most 2.
double some_half(Entropy& entropy) { return 0.5 + static_cast<double>(entropy.below((3U << 19) + 1)) * 0x1p-20; }

double off_by_ulps(double x, Entropy& entropy) {
  for (std::int64_t ulps = entropy.within(2); ulps != 0; ulps += ulps > 0 ? -1 : 1)
    x = std::nextafter(x, ulps > 0 ? HUGE_VAL : -HUGE_VAL);
  return x;
}

/// Groups of bodies stand 32 apart, and all of them as far away as said; none at 0, where ulps are nothing.
Vector3 cell(std::size_t group, double away) {
  const auto step = [&](std::size_t n) { return away + 16 + 32 * static_cast<double>(n); };
  return {step(group % 8), step(group / 8 % 8), step(group / 64)};
}

/// A quaternion of small integers: its matrix, whose columns are integers, over its weight.
struct SmallTurn {
  Rotation turn;
  double weight;
  Vector3 side, up;  // images of x and z times the weight
};
SmallTurn small_turn(Entropy& entropy) {
  Rotation q{static_cast<double>(1 + entropy.below(3)), static_cast<double>(entropy.within(3)),
             static_cast<double>(entropy.within(3)), static_cast<double>(entropy.within(3))};
  const auto& [w, x, y, z] = q;
  return {q,
          w * w + x * x + y * y + z * z,
          {w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
          {2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z}};
}

/// Stacks of three boxes, each of which rests on the one below; turned all alike, or not.
Bodies stacks(std::size_t count, std::uint64_t seed, double away, bool is_turned, bool is_off) {
  Bodies bodies;
  for (std::uint64_t group = 0; bodies.size() < count; ++group) {
    Entropy entropy(seed, group);
    const SmallTurn turn = is_turned ? small_turn(entropy) : SmallTurn{{}, 1, {1, 0, 0}, {0, 0, 1}};
    const auto height = [&] {  // over the weight, so that steps along the turned axes are doubles
      return is_turned ? static_cast<double>(1 + entropy.below(4)) / 64 : some_half(entropy);
    };
    Vector3 at = cell(group, away);
    double below = 0;
    for (int k = 0; k < 3; ++k) {
      const double half = height(), up = k == 0 ? 0 : below + half, aside = static_cast<double>(entropy.within(2)) / 64;
      at = {at.x + turn.up.x * up + turn.side.x * aside, at.y + turn.up.y * up + turn.side.y * aside,
            at.z + turn.up.z * up + turn.side.z * aside};
      if (is_off && k != 0) at = {off_by_ulps(at.x, entropy), off_by_ulps(at.y, entropy), off_by_ulps(at.z, entropy)};
      bodies.push_back(box({some_half(entropy), some_half(entropy), half * turn.weight}, {turn.turn, at}));
      below = half;
    }
  }
  return bodies;
}

/// Eight integer points with an inside.
std::array<Point3, 8> some_corners(Entropy& entropy) {
  std::array<Point3, 8> corners{};
  do {
    for (Point3& p : corners)
      p = {static_cast<double>(entropy.within(4)), static_cast<double>(entropy.within(4)),
           static_cast<double>(entropy.within(4))};
  } while (convex_hull(corners).dimension < 3);
  return corners;
}

/// A hull and its reflection in a point of a face, of an edge, or in a corner, where the two touch.
Bodies reflected_hulls(std::size_t count, std::uint64_t seed, double away, bool is_off) {
  Bodies bodies;
  for (std::uint64_t group = 0; bodies.size() < count; ++group) {
    Entropy entropy(seed, group);
    const std::array<Point3, 8> corners = some_corners(entropy);
    std::array<Point3, 8> reflected = corners;
    for (Point3& p : reflected) p = {-p.x, -p.y, -p.z};
    const Hull3 hull = convex_hull(corners, {.triangulate = true});
    const auto face = hull.face(entropy.below(hull.face_count()));
    constexpr std::array<std::array<double, 3>, 3> weights{{{2, 0, 0}, {1, 1, 0}, {1, 0.5, 0.5}}};
    const auto& weight = weights[entropy.below(3)];
    Vector3 to = cell(group, away);
    bodies.push_back({corners, {}, {{}, to}});
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& p = corners[face[i]];
      to = {to.x + weight[i] * p.x, to.y + weight[i] * p.y, to.z + weight[i] * p.z};
    }
    if (is_off) to = {off_by_ulps(to.x, entropy), off_by_ulps(to.y, entropy), off_by_ulps(to.z, entropy)};
    bodies.push_back({reflected, {}, {{}, to}});
  }
  return bodies;
}

/// Boxes and hulls anywhere, turned by quaternions of integers.
Bodies strewn(std::size_t count, std::uint64_t seed) {
  const double side = 6 * std::cbrt(static_cast<double>(count));
  Bodies bodies;
  for (std::uint64_t i = 0; bodies.size() < count; ++i) {
    Entropy entropy(seed, i);
    const auto part = [&] { return static_cast<double>(entropy.within(1 << 20)); };
    const RigidPose pose{{part() + 0x1p21, part(), part(), part()},
                         {part() * side * 0x1p-21, part() * side * 0x1p-21, part() * side * 0x1p-21}};
    if (i % 2 == 0)
      bodies.push_back(box({some_half(entropy), some_half(entropy), some_half(entropy)}, pose));
    else
      bodies.push_back({some_corners(entropy), {}, pose});
  }
  return bodies;
}

}  // namespace

Experiment world_experiment(std::vector<WorldRival> rivals) {
  return {
      "worlds", "which bodies of a world meet?", "RTCD 2.4.1, 9.5", [=](const Settings& settings) {
        std::vector<Scene> scenes;
        const std::size_t count = settings.quick ? 60 : 900;
        const auto add = [&](const std::string& name, const std::string& about, auto bodies) {
          scenes.push_back(
              {name, about, [=, seed = settings.seed] { return tried(judged_world(bodies(count, seed)), rivals); }});
        };
        const auto stacked = [](double away, bool is_turned, bool is_off) {
          return [=](std::size_t n, std::uint64_t seed) { return stacks(n, seed, away, is_turned, is_off); };
        };
        const auto hulls = [](double away, bool is_off) {
          return [=](std::size_t n, std::uint64_t seed) { return reflected_hulls(n, seed, away, is_off); };
        };
        add("resting", "boxes on one another, none turned", stacked(0, false, false));
        add("resting-off-by-ulps", "the same, each up to two ulps aside", stacked(0, false, true));
        add("turned", "boxes on one another, each stack turned by a quaternion of integers", stacked(0, true, false));
        add("turned-off-by-ulps", "the same, each up to two ulps aside", stacked(0, true, true));
        add("far-turned", "the same stacks, a hundred thousand units away", stacked(1e5, true, false));
        add("hulls", "hulls of integers that touch in a corner, an edge or a face", hulls(0, false));
        add("hulls-off-by-ulps", "the same, one of each two up to two ulps aside", hulls(0, true));
        add("far-hulls", "the same hulls, a hundred thousand units away", hulls(1e5, false));
        add("strewn", "boxes and hulls anywhere, turned by any quaternions", strewn);
        return scenes;
      }};
}

}  // namespace plumb::lab::stability
