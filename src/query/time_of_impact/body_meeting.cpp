// All pairs of features that may meet, by running errors; then those that may be first, exactly.
#include "query/time_of_impact/body_meeting.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "figure/basic/finite_parts.hpp"
#include "query/time_of_impact/meeting_time.hpp"
#include "query/time_of_impact/moving_axes.hpp"
#include "query/time_of_impact/time_judges.hpp"

namespace plumb::query {
namespace {

struct BodyMeeting {
  std::optional<Root> time;  // nothing: never
  Feature a, b;
};

template <class T>
Vec3<T> velocity_of(const BodyMotion& m) {
  if (m.columns == nullptr) return vector_of<T>(*m.by);
  const auto& c = *m.columns;
  return vector_of<T>(c[0]) * T(m.by->x) + vector_of<T>(c[1]) * T(m.by->y) + vector_of<T>(c[2]) * T(m.by->z);
}

template <class T>
MovingBody<T> body_of(const BodyMotion& m) {
  MovingBody<T> body = moving_body<T>(m.shape);
  if (m.radius > 0) {
    body.reach = body.reach + (body.has_weight ? T(m.radius) * body.weight : T(m.radius));
    body.swept = true;
  }
  return body;
}

/// Two bodies, and how the first moves, seen from the second.
template <class T>
struct MotionPair {
  MotionPair(const BodyMotion& of_a, const BodyMotion& of_b)
      : a(body_of<T>(of_a)),
        b(body_of<T>(of_b)),
        velocity(bring_to_one_weight(a, b, velocity_of<T>(of_a) - velocity_of<T>(of_b))) {}

  template <class Judge>
  bool tell(PairIndex pair, Judge& judge) const {
    return MeetingCondition<T>(a, b, velocity).tell(pair, judge);
  }
  [[nodiscard]] Feature feature_of_a(PairIndex pair) const {
    if (pair.kind == MeetingPair::edge_vertex || pair.kind == MeetingPair::edge_edge) return a.edges[pair.a].feature;
    return pair.kind == MeetingPair::face_vertex ? a.faces[pair.a].feature : a.vertex_features[pair.a];
  }
  [[nodiscard]] Feature feature_of_b(PairIndex pair) const {
    if (pair.kind == MeetingPair::vertex_edge || pair.kind == MeetingPair::edge_edge) return b.edges[pair.b].feature;
    return pair.kind == MeetingPair::vertex_face ? b.faces[pair.b].feature : b.vertex_features[pair.b];
  }

  MovingBody<T> a, b;
  Vec3<T> velocity;
};

/// Two features that may meet, and when.
struct Candidate {
  PairIndex pair;
  QuickTime time;
};

/// The pairs of features that may meet, by their earliest times.
std::vector<Candidate> candidates(const MotionPair<Running>& pair, const TimeWindow& window) {
  const auto& [a, b, velocity] = pair;
  const MeetingCondition<Running> condition(a, b, velocity);
  const FeatureBoxes boxes_a(a), boxes_b(b);
  const Slabs slabs(velocity, a.reach + b.reach);
  const FeatureBoxes swept(a, SweptBox(velocity, (a.reach + b.reach).upper(), window.from, window.to));
  std::vector<Candidate> found;
  const auto ask = [&](MeetingPair kind, auto FeatureBoxes::*kind_a, auto FeatureBoxes::*kind_b) {
    const auto &of_a = boxes_a.*kind_a, &of_b = boxes_b.*kind_b, &passed = swept.*kind_a;
    for (std::uint32_t i = 0; i < of_a.size(); ++i) {
      for (std::uint32_t j = 0; j < of_b.size(); ++j) {
        if (!boxes_meet(passed[i], of_b[j])) continue;
        const auto [enters, leaves] = slabs.times(of_a[i], of_b[j]);
        const double from = std::max(enters, window.from), to = std::min(leaves, window.to);
        if (!(from <= to)) continue;
        Candidate c{{kind, i, j}, QuickTime(from, to)};
        if (condition.tell(c.pair, c.time) && c.time.earliest() <= 1) found.push_back(c);
      }
    }
  };
  ask(MeetingPair::vertex_vertex, &FeatureBoxes::vertices, &FeatureBoxes::vertices);
  ask(MeetingPair::vertex_edge, &FeatureBoxes::vertices, &FeatureBoxes::edges);
  ask(MeetingPair::edge_vertex, &FeatureBoxes::edges, &FeatureBoxes::vertices);
  ask(MeetingPair::edge_edge, &FeatureBoxes::edges, &FeatureBoxes::edges);
  ask(MeetingPair::vertex_face, &FeatureBoxes::vertices, &FeatureBoxes::faces);
  ask(MeetingPair::face_vertex, &FeatureBoxes::faces, &FeatureBoxes::vertices);
  std::ranges::stable_sort(found, {}, [](const Candidate& c) { return c.time.earliest(); });
  return found;
}

/// Is the first the only pair that can be first, and sure to meet?
bool one_is_first(const std::vector<Candidate>& found) {
  const QuickTime& first = found[0].time;
  return first.certain() && first.latest() <= 1 && (found.size() == 1 || found[1].time.earliest() > first.latest());
}

/// The first time at which two features meet, and which.
BodyMeeting first_of(const std::vector<Candidate>& found, const MotionPair<BigDyadic>& exact) {
  BodyMeeting best;
  double latest = 1;  // no earlier than the best
  for (const Candidate& c : found) {
    if (c.time.earliest() > latest) break;
    ExactTime time;
    if (!exact.tell(c.pair, time) || !time.first()) continue;
    const Feature a = exact.feature_of_a(c.pair), b = exact.feature_of_b(c.pair);
    if (best.time) {
      const auto order = *time.first() <=> *best.time;
      if (order > 0 || (order == 0 && rank(best.a, best.b) < rank(a, b))) continue;
    }
    best = {time.first(), a, b};
    latest = best.time->rounded(Rounding::up);
  }
  return best;
}

/// Where some features meet when the bodies' extents along one axis do, which is no later: those that come first.  What
/// lands face on face, or starts in touch, meets in many at once, and does so then.
std::optional<BodyMeeting> first_on_axis(const std::vector<Candidate>& found, const TimeAxis& axis,
                                         const MotionPair<BigDyadic>& exact) {
  if ((exact.a.swept || exact.b.swept) && axis.kind != TimeAxis::Kind::start) return {};
  const auto entry = exact_entry(exact.a, exact.b, exact.velocity, axis);
  if (!entry) return {};
  if ((entry->way - entry->speed).sign() == Sign::positive) return BodyMeeting{};  // after time 1
  const double latest = entry->rounded(Rounding::up);
  struct Waiting {
    PairIndex pair;
    Feature a, b;
  };
  std::vector<Waiting> waiting;
  for (const Candidate& c : found) {
    if (c.time.earliest() > latest) break;
    waiting.push_back({c.pair, exact.feature_of_a(c.pair), exact.feature_of_b(c.pair)});
  }
  std::ranges::sort(waiting, {}, [](const Waiting& w) { return rank(w.a, w.b); });
  for (const Waiting& w : waiting) {
    HoldsAt holds(entry->way, entry->speed);
    if (exact.tell(w.pair, holds) && holds.holds()) return BodyMeeting{Root(entry->time()), w.a, w.b};
  }
  return {};
}

/// Checked, and as far as running errors tell.
struct Outlook {
  bool overlap = false;  // at time 0
  TimeAxis axis{};       // on which they meet last
  std::vector<Candidate> found{};
};

Outlook outlook(std::string_view function, const BodyMotion& a, const BodyMotion& b, StartRelation at_start) {
  require_finite_parts(function, {"a.by", "b.by"}, *a.by, *b.by);
  const bool some_a = check_body(function, "a.shape", a.shape), some_b = check_body(function, "b.shape", b.shape);
  if (!some_a || !some_b) return {};
  const auto velocity = velocity_of<Running>(a) - velocity_of<Running>(b);
  if (const auto [from, to] =
          Slabs(velocity, Running(a.radius) + Running(b.radius)).times(bounding_box(a.shape), bounding_box(b.shape));
      !(from <= to))
    return {};
  const MotionPair<Running> quick(a, b);
  const TimeWindow window = time_window(quick.a, quick.b, quick.velocity);
  if (window.empty()) return {};
  if (!(window.from > 0) && at_start(a, b) == Relation::overlapping) return {true};
  return {false, window.axis, candidates(quick, window)};
}

BodyMeeting overlap_at_start() { return {Root(Rational(0)), {FeatureKind::interior, 0}, {FeatureKind::interior, 0}}; }

BodyMeeting meeting(const Outlook& out, const BodyMotion& a, const BodyMotion& b) {
  if (out.overlap) return overlap_at_start();
  if (out.found.empty()) return {};
  const MotionPair<BigDyadic> exact(a, b);
  if (auto first = first_on_axis(out.found, out.axis, exact)) return std::move(*first);
  return first_of(out.found, exact);
}

/// Where one pair of features is sure to be first and pairs of doubles tell the time.
std::optional<Contact> quick_contact(const std::vector<Candidate>& found, const BodyMotion& a, const BodyMotion& b) {
  if (found.empty() || !one_is_first(found)) return {};
  const MotionPair<Ball> precise(a, b);
  PreciseTime time;
  precise.tell(found[0].pair, time);
  const std::optional<double> down = time.rounded(Rounding::down);
  if (!down) return {};
  return Contact{*down, precise.feature_of_a(found[0].pair), precise.feature_of_b(found[0].pair)};
}

}  // namespace

std::optional<Root> body_contact_time(std::string_view function, const BodyMotion& a, const BodyMotion& b,
                                      StartRelation at_start) {
  return meeting(outlook(function, a, b, at_start), a, b).time;
}

std::optional<Contact> body_contact(std::string_view function, const BodyMotion& a, const BodyMotion& b,
                                    StartRelation at_start) {
  const Outlook out = outlook(function, a, b, at_start);
  if (const auto quick = quick_contact(out.found, a, b)) return quick;
  const BodyMeeting m = meeting(out, a, b);
  if (!m.time) return {};
  return Contact{m.time->rounded(Rounding::down), m.a, m.b};
}

std::optional<FirstMeeting> first_meeting(std::string_view function, const BodyMotion& a, const BodyMotion& b,
                                          StartRelation at_start) {
  BodyMeeting m = meeting(outlook(function, a, b, at_start), a, b);
  if (!m.time) return {};
  return FirstMeeting{std::move(*m.time), m.a, m.b};
}

bool bodies_meet(std::string_view function, const BodyMotion& a, const BodyMotion& b, StartRelation at_start) {
  const Outlook out = outlook(function, a, b, at_start);
  const auto surely = [](const Candidate& c) { return c.time.certain() && c.time.latest() <= 1; };
  return out.overlap || std::ranges::any_of(out.found, surely) || meeting(out, a, b).time.has_value();
}

}  // namespace plumb::query
