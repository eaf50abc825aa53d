// Two segments: do they meet, and is the point where they cross on them?  Segments that share an end, and one through
// it.  Judged in GMP's rationals.
#include <fmt/format.h>
#include <gmpxx.h>

#include <cmath>
#include <limits>
#include <set>

#include "lab/stability/experiment.hpp"
#include "lab/stability/segment_methods.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/query.hpp"

namespace plumb::lab::stability {
namespace {

using Exact = trial::Segment<mpq_class>;

Exact exact(const Segment2& s) { return converted<mpq_class>(s); }
bool truly_meet(const Segment2& s, const Segment2& t) { return meet_by_signs(exact(s), exact(t), mpq_class(0)); }

/// One in the inside of both, neither along the other.
bool truly_cross(const Segment2& s, const Segment2& t) {
  const Exact a = exact(s), b = exact(t);
  const mpq_class zero(0);
  return side(a, b.a, zero) * side(a, b.b, zero) < 0 && side(b, a.a, zero) * side(b, a.b, zero) < 0;
}

enum class SegmentWay { signs, parameters };

bool said_to_meet(std::string_view method, SegmentWay way, const Segment2& s, const Segment2& t) {
  if (method == "exact") return intersects(s, t);
  const std::array both{s, t};
  return in_numbers_of(method, both, [&](auto epsilon) {
    using T = decltype(epsilon);
    const trial::Segment<T> a = converted<T>(s), b = converted<T>(t);
    return way == SegmentWay::signs ? meet_by_signs(a, b, epsilon) : meet_by_parameters(a, b, epsilon);
  });
}

/// Where two segments cross, as a method says it: the point itself, and as doubles.
struct Crossing {
  trial::Place<mpq_class> point;
  Point2 rounded;
};

std::optional<Crossing> said_to_cross(std::string_view method, const Segment2& s, const Segment2& t) {
  if (method == "exact") {
    const Intersection2 common = intersection(s, t);
    if (common.kind != IntersectionKind::point) return std::nullopt;
    const RationalPoint2 p = rational_point(common.vertices[0]);
    return Crossing{{mpq_class(p.x.text()), mpq_class(p.y.text())}, approximate(common.vertices[0])};
  }
  const std::array both{s, t};
  return in_numbers_of(method, both, [&](auto epsilon) -> std::optional<Crossing> {
    using T = decltype(epsilon);
    if constexpr (std::is_floating_point_v<T>) {
      const auto p = crossing(converted<T>(s), converted<T>(t), epsilon);
      if (!p) return std::nullopt;
      const Point2 q{static_cast<double>(p->x), static_cast<double>(p->y)};
      if (!std::isfinite(q.x) || !std::isfinite(q.y)) return std::nullopt;
      return Crossing{{mpq_class(q.x), mpq_class(q.y)}, q};
    } else {
      return std::nullopt;
    }
  });
}

bool is_nearest(double x, const mpq_class& truth) {
  const auto off = [&truth](double d) { return mpq_class(abs(mpq_class(d) - truth)); };
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double end : {infinity, -infinity}) {
    const double other = std::nextafter(x, end);
    if (std::isfinite(other) && off(other) < off(x)) return false;
  }
  return true;
}

Segment2 reversed(const Segment2& s) { return {s.b, s.a}; }

std::vector<MethodOutcome> outcomes_of(const std::vector<std::string>& failures) {
  std::vector<Count> none;
  for (const std::string& f : failures) none.push_back({f});
  std::vector<MethodOutcome> outcomes;
  for (const std::string_view m : float_method_names) outcomes.push_back({std::string(m), none});
  outcomes.push_back({"exact", none, true});
  return outcomes;
}

void count(Count& c, bool failed) {
  ++c.of;
  c.failures += failed;
}

Findings run_pairs(SegmentWay way, std::size_t rounds, std::uint64_t start) {
  Findings findings{
      outcomes_of({"pairs that meet and are said not to", "pairs that do not meet and are said to",
                   "pairs answered otherwise when swapped or reversed", "crossing points that lie on neither segment",
                   "crossing points that are not the nearest doubles"}),
      {}};
  for (const FamilyInfo& f : families) {
    for (std::size_t i = 0; i < rounds; ++i) {
      Entropy entropy(start, i);
      const std::vector<Point2> p = points2(f.family, Degeneracy::collinear, 4, entropy);
      const Segment2 s{p[0], p[1]}, t{p[2], p[3]};
      const bool meet = truly_meet(s, t), cross = truly_cross(s, t);
      const auto truth = crossing(exact(s), exact(t), mpq_class(0));
      for (MethodOutcome& o : findings.outcomes) {
        const bool said = said_to_meet(o.method, way, s, t);
        count(o.counts[meet ? 0 : 1], said != meet);
        count(o.counts[2], said_to_meet(o.method, way, t, s) != said ||
                               said_to_meet(o.method, way, reversed(s), t) != said ||
                               said_to_meet(o.method, way, s, reversed(t)) != said);
        if (!cross) continue;
        const std::optional<Crossing> at = said_to_cross(o.method, s, t);
        const mpq_class zero(0);
        count(o.counts[3], !at || (side(exact(s), at->point, zero) != 0 && side(exact(t), at->point, zero) != 0));
        count(o.counts[4], !at || !is_nearest(at->rounded.x, truth->x) || !is_nearest(at->rounded.y, truth->y));
      }
    }
  }
  return findings;
}

/// Three points of a line, the second between the others, all three different; none where chance made no such.
std::optional<std::array<Point2, 3>> through_middle(Family family, Entropy& entropy) {
  std::vector<Point2> p = points2(family, Degeneracy::collinear, 3, entropy);
  std::ranges::sort(p, [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  if (p[0] == p[1] || p[1] == p[2]) return std::nullopt;
  return std::array{p[0], p[1], p[2]};
}

Findings run_shared_ends(SegmentWay way, std::size_t rounds, std::uint64_t start) {
  Findings findings{outcomes_of({"segments through the shared end that are said to miss both",
                                 "segments through the shared end that are said to meet one and miss the other",
                                 "pairs that share an end and are said not to meet"}),
                    {}};
  for (const Family family : {Family::degenerate_short, Family::degenerate_long}) {
    for (std::size_t i = 0; i < rounds; ++i) {
      Entropy entropy(start, i);
      const auto line = through_middle(family, entropy), one = through_middle(family, entropy);
      if (!line || !one) continue;
      const Point2 shared = (*line)[1];
      const Segment2 through{(*line)[0], (*line)[2]}, s{(*one)[0], shared}, t{shared, (*one)[2]};
      for (MethodOutcome& o : findings.outcomes) {
        const bool first = said_to_meet(o.method, way, through, s), second = said_to_meet(o.method, way, through, t);
        count(o.counts[0], !first && !second);
        count(o.counts[1], first != second);
        count(o.counts[2], !said_to_meet(o.method, way, s, t));
      }
    }
  }
  return findings;
}

std::vector<Scene> segment_scenes(const Settings& settings) {
  const std::size_t rounds = settings.quick ? 40 : 2000;
  std::vector<Scene> scenes;
  const auto add = [&](SegmentWay way, const std::string& name) {
    scenes.push_back({fmt::format("pairs, {}", name), "two segments between points of every family of hard inputs",
                      [=, start = settings.seed] { return run_pairs(way, rounds, start); }});
    scenes.push_back({fmt::format("shared ends, {}", name),
                      "two segments that share an end, and a third one that goes exactly through it",
                      [=, start = settings.seed] { return run_shared_ends(way, 2 * rounds, start); }});
  };
  add(SegmentWay::signs, "by signs");
  add(SegmentWay::parameters, "by parameters");
  return scenes;
}

}  // namespace

Experiment segment_experiment() {
  return {"segments", "do two segments meet, and where do they cross?", "RTCD 5.1.9.1", segment_scenes};
}

}  // namespace plumb::lab::stability
