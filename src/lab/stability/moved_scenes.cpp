// One scene far from the origin, very large and very small, and turned: answers that change though nothing happened.
#include <algorithm>
#include <cmath>

#include "lab/stability/float_ways.hpp"
#include "lab/stability/question_figures.hpp"
#include "lab/stability/share_curves.hpp"
#include "lab/trial/location_tests.hpp"
#include "lab/trial/triangle_tests.hpp"
#include "plumb/degenerate/exact.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/ray/hits.hpp"

namespace plumb::lab::stability {
namespace {

/// Turned about the third axis, scaled, shifted: x' = c x - s y + shift and so on, and w z + shift.
struct Move {
  double size;  // what the picture shows it at
  double c = 1, s = 0, w = 1, shift = 0;
};
Vector3 turned(const Move& m, double x, double y, double z) { return {m.c * x - m.s * y, m.s * x + m.c * y, m.w * z}; }
Pose pose_of(const Move& m) { return {{{{m.c, m.s, 0}, {-m.s, m.c, 0}, {0, 0, m.w}}}, {m.shift, m.shift, m.shift}}; }
Pose2 flat_pose_of(const Move& m) { return {{{{m.c, m.s}, {-m.s, m.c}}}, {m.shift, m.shift}}; }

/// Two triangles; a ray and a triangle; a point and a polygon of the plane.
using Pair = std::array<double, 18>;
using Shot = std::array<double, 15>;
using Spot = trial::PolygonNumbers;

Pair moved_pair(const Move& m, const Pair& q) {
  Pair r{};
  for (std::size_t i = 0; i < q.size(); i += 3) {
    const Vector3 v = turned(m, q[i], q[i + 1], q[i + 2]);
    r[i] = v.x + m.shift, r[i + 1] = v.y + m.shift, r[i + 2] = v.z + m.shift;
  }
  return r;
}
Shot moved_shot(const Move& m, const Shot& q) {
  Shot r{};
  for (std::size_t i = 0; i < q.size(); i += 3) {
    const Vector3 v = turned(m, q[i], q[i + 1], q[i + 2]);
    const double by = i == 3 ? 0 : m.shift;  // a direction stays what it is
    r[i] = v.x + by, r[i + 1] = v.y + by, r[i + 2] = v.z + by;
  }
  return r;
}
Spot moved_spot(const Move& m, const Spot& q) {
  Spot r{};
  for (std::size_t i = 0; i < q.size(); i += 2) {
    const Vector3 v = turned(m, q[i], q[i + 1], 0);
    r[i] = v.x + m.shift, r[i + 1] = v.y + m.shift;
  }
  return r;
}

std::vector<Point2> corners_of(const Spot& q) {
  std::vector<Point2> corners;
  for (std::size_t i = 2; i < q.size(); i += 2) corners.push_back({q[i], q[i + 1]});
  return corners;
}

bool meet_exactly(const Pair& q) { return intersects(triangle_at(q.data()), triangle_at(&q[9])); }
bool hit_exactly(const Shot& q) { return hits(ray_at(q.data()), triangle_at(&q[6])); }
bool held_exactly(const Spot& q) { return contains(Polygon2{corners_of(q)}, Point2{q[0], q[1]}); }

/// In space all in one plane or on small integers, so that touching is frequent; on a lattice of 2^-8 within 4.
struct Scenery {
  std::vector<Pair> pairs;
  std::vector<Shot> shots;
  std::vector<Spot> spots;
};

template <std::size_t N>
void fill(std::array<double, N>& q, std::size_t dimension, Entropy& entropy) {
  if (entropy.coin()) {
    for (double& x : q) x = static_cast<double>(entropy.within(4));
  } else {
    fill_exact(dimension == 2 ? Degeneracy::collinear : Degeneracy::coplanar, static_cast<int>(dimension), 10, q,
               entropy);
    for (double& x : q) x = std::ldexp(x, -8);
  }
}

Scenery scenery(const Settings& settings, std::size_t count) {
  Scenery all{std::vector<Pair>(count), std::vector<Shot>(count), std::vector<Spot>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    Entropy entropy(settings.seed, i);
    fill(all.pairs[i], 3, entropy);
    fill(all.shots[i], 3, entropy);
    for (const std::size_t k : {3U, 4U, 5U}) all.shots[i][k] -= all.shots[i][k - 3];  // toward the second point
    fill(all.spots[i], 2, entropy);
  }
  return all;
}

/// How many answers about the moved scene are not those about the scene itself, for each move.
template <class Question>
std::vector<Count> changes(const std::vector<Move>& moves, const std::vector<Question>& questions,
                           const std::function<bool(const Question&)>& still,
                           const std::function<bool(const Question&, const Move&)>& in_motion) {
  std::vector<bool> before;
  for (const Question& q : questions) before.push_back(still(q));
  std::vector<Count> counts;
  for (const Move& m : moves) {
    Count count;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      ++count.of;
      if (in_motion(questions[i], m) != before[i]) ++count.failures;
    }
    counts.push_back(count);
  }
  return counts;
}

/// The three kinds of questions, asked by one method.
struct Asker {
  std::string name;
  bool exact = false;
  std::array<std::vector<Count>, 3> counts;  // for each kind and move
};

Asker asker(const std::string& name, bool exact, const Scenery& scene, const std::vector<Move>& moves,
            const Ask<18>& meet, const Ask<15>& hit, const Ask<std::tuple_size_v<Spot>>& held) {
  const auto by = [](const auto& ask, auto move) {
    return [&ask, move](const auto& q, const Move& m) { return ask(move(m, q)); };
  };
  return {name,
          exact,
          {changes<Pair>(moves, scene.pairs, meet, by(meet, moved_pair)),
           changes<Shot>(moves, scene.shots, hit, by(hit, moved_shot)),
           changes<Spot>(moves, scene.spots, held, by(held, moved_spot))}};
}

/// Ours, of the points as the pose moves them: nothing is rounded, whatever the pose.
Asker posed_asker(const Scenery& scene, const std::vector<Move>& moves) {
  const auto meet = [](const Pair& q, const Move& m) {
    const Pose pose = pose_of(m);
    return intersects(Posed{triangle_at(q.data()), pose}, Posed{triangle_at(&q[9]), pose});
  };
  const auto hit = [](const Shot& q, const Move& m) {
    const Pose pose = pose_of(m);
    return intersects(Posed{ray_at(q.data()), pose}, Posed{triangle_at(&q[6]), pose});
  };
  const auto held = [](const Spot& q, const Move& m) {
    const Pose2 pose = flat_pose_of(m);
    return contains(Posed{Polygon2{corners_of(q)}, pose}, Posed{Point2{q[0], q[1]}, pose});
  };
  return {"exact, posed",
          true,
          {changes<Pair>(moves, scene.pairs, meet_exactly, meet), changes<Shot>(moves, scene.shots, hit_exactly, hit),
           changes<Spot>(moves, scene.spots, held_exactly, held)}};
}

/// How a scene is told of: what it does, and what its axis counts.
struct Telling {
  std::string name, title, subtitle, axis;
};

Findings findings_of(const std::vector<Asker>& askers, const std::vector<Move>& moves, const Telling& telling) {
  static const std::array<std::string, 3> kinds{"triangle against triangle", "ray against triangle",
                                                "point in polygon"};
  static const std::array<std::string, 3> failures{"pairs of triangles that no longer meet, or now do",
                                                   "rays that no longer hit, or now do",
                                                   "points that changed to the other side of a polygon's edge"};
  Findings findings;
  std::array<SharePanel, 3> panels;
  for (std::size_t kind = 0; kind < 3; ++kind) panels[kind] = {kinds[kind], telling.axis, {}};
  for (const Asker& asker : askers) {
    MethodOutcome outcome{asker.name, {}, asker.exact};
    for (std::size_t kind = 0; kind < 3; ++kind) {
      Count sum{failures[kind]};
      ShareCurve curve{asker.name, {}};
      for (std::size_t i = 0; i < moves.size(); ++i) {
        const Count& count = asker.counts[kind][i];
        sum.failures += count.failures, sum.of += count.of;
        curve.points.push_back({moves[i].size, static_cast<double>(count.failures) / static_cast<double>(count.of)});
      }
      outcome.counts.push_back(sum);
      panels[kind].curves.push_back(curve);
    }
    findings.outcomes.push_back(outcome);
  }
  findings.pictures.push_back({"scene-" + telling.name, telling.title + ": " + telling.subtitle,
                               share_curves(telling.title, telling.subtitle, panels)});
  return findings;
}

std::vector<Asker> float_askers(const Scenery& scene, const std::vector<Move>& moves) {
  const auto meet = float_ways<18>(trial::TriangleAgainstTriangle{});
  const auto hit = float_ways<15>(trial::RayAgainstTriangle<false>{});
  const auto held = float_ways<std::tuple_size_v<Spot>>(trial::PointInPolygon{});
  std::vector<Asker> askers;
  for (std::size_t i = 0; i < meet.size(); ++i)
    askers.push_back(asker(meet[i].name, false, scene, moves, meet[i].ask, hit[i].ask, held[i].ask));
  return askers;
}

/// Moves that round nothing: the exact way has no excuse.
Findings moved_exactly(const std::vector<Move>& moves, const Settings& settings, const Telling& telling) {
  const Scenery scene = scenery(settings, settings.quick ? 300 : 10'000);
  std::vector<Asker> askers = float_askers(scene, moves);
  askers.push_back(asker("exact", true, scene, moves, meet_exactly, hit_exactly, held_exactly));
  return findings_of(askers, moves, telling);
}

Findings translated(const Settings& settings) {
  std::vector<Move> moves;
  for (double by = 1e3; by <= 1e9; by *= 10) moves.push_back({by, 1, 0, 1, by});
  return moved_exactly(
      moves, settings,
      {"translated", "The same scene, farther and farther away",
       "share of answers that changed; every translated coordinate is exact in double", "units from the origin"});
}

Findings scaled(const Settings& settings) {
  std::vector<Move> moves;
  for (int decades = -150; decades <= 150; decades += 30) {
    // The power of two that is nearest to the power of ten: log2(10) is 3.3219.
    const double scale = std::ldexp(1, static_cast<int>(std::lround(decades * std::log2(10.0))));
    moves.push_back({scale, scale, 0, scale, 0});
  }
  return moved_exactly(
      moves, settings,
      {"scaled", "The same scene, in other units",
       "share of answers that changed; scaled by powers of two, which round nothing in double", "scale"});
}

Findings turned_exactly(const Settings& settings) {
  std::vector<Move> moves;
  for (int k = 1; k <= 19; k += 3) {  // (1 - t^2, 2 t, 1 + t^2) for t = 2^-k: a turn, and a scale of 1 + t^2
    const double t = std::ldexp(1, -k);
    moves.push_back({2 * t, 1 - t * t, 2 * t, 1 + t * t, 0});
  }
  return moved_exactly(moves, settings,
                       {"turned", "The same scene, turned a little",
                        "share of answers that changed; turned exactly, by Pythagorean triples", "angle, in radians"});
}

Findings turned_and_rounded(const Settings& settings) {
  std::vector<Move> moves;
  double angle = 0.1;
  for (int i = 0; i < 7; ++i, angle /= 100) {
    const double t = angle / 2, whole = 1 + t * t;
    moves.push_back({angle, (1 - t * t) / whole, 2 * t / whole, 1, 0});
  }
  const Scenery scene = scenery(settings, settings.quick ? 40 : 500);
  std::vector<Asker> askers = float_askers(scene, moves);
  askers.push_back(asker("exact, rounded points", false, scene, moves, meet_exactly, hit_exactly, held_exactly));
  askers.push_back(posed_asker(scene, moves));
  return findings_of(
      askers, moves,
      {"turned-and-rounded", "The same scene, turned and rounded",
       "share of answers that changed; asked about the posed points as they are, none does", "angle, in radians"});
}

}  // namespace

Experiment move_experiment() {
  return {"moved-scenes", "does an answer change when all figures move alike?", "RTCD 11.2, 3.2",
          [](const Settings& settings) {
            return std::vector<Scene>{
                {"translated", "by 10^3 to 10^9; no coordinate of a double is rounded",
                 [settings] { return translated(settings); }},
                {"scaled", "by powers of two near 10^-150 to 10^150; no coordinate of a double is rounded",
                 [settings] { return scaled(settings); }},
                {"turned", "by angles of 1 down to 4e-6; no coordinate of a double is rounded",
                 [settings] { return turned_exactly(settings); }},
                {"turned-and-rounded", "by angles of 0.1 down to 1e-13, rounded to doubles, or posed and not rounded",
                 [settings] { return turned_and_rounded(settings); }},
            };
          }};
}

}  // namespace plumb::lab::stability
