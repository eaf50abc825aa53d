#include "plumb/query/time_of_impact/translating_contact.hpp"

#include <algorithm>
#include <tuple>

#include "figure/basic/finite_parts.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/body/figure_input.hpp"
#include "query/time_of_impact/meeting_time.hpp"
#include "query/time_of_impact/moving_axes.hpp"
#include "query/time_of_impact/quick_motion.hpp"
#include "query/time_of_impact/time_judges.hpp"

namespace plumb {
namespace query {
namespace {

struct BodyMotion {
  BodyShape shape;
  const Vector3* by;
};

struct BodyMeeting {
  std::optional<Root> time;  // nothing: never
  Feature a, b;
};

/// Two bodies, and how the first moves, seen from the second.
template <class T>
struct MotionPair {
  MotionPair(const BodyMotion& of_a, const BodyMotion& of_b)
      : a(moving_body<T>(of_a.shape)),
        b(moving_body<T>(of_b.shape)),
        velocity(vector_of<T>(*of_a.by) - vector_of<T>(*of_b.by)) {}

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
  std::vector<Candidate> found;
  const auto ask = [&](MeetingPair kind, const std::vector<FeatureBox>& of_a, const std::vector<FeatureBox>& of_b) {
    for (std::uint32_t i = 0; i < of_a.size(); ++i) {
      for (std::uint32_t j = 0; j < of_b.size(); ++j) {
        const auto [enters, leaves] = slabs.times(of_a[i], of_b[j]);
        const double from = std::max(enters, window.from), to = std::min(leaves, window.to);
        if (!(from <= to)) continue;
        Candidate c{{kind, i, j}, QuickTime(from, to)};
        if (condition.tell(c.pair, c.time) && c.time.earliest() <= 1) found.push_back(c);
      }
    }
  };
  ask(MeetingPair::vertex_vertex, boxes_a.vertices, boxes_b.vertices);
  ask(MeetingPair::vertex_edge, boxes_a.vertices, boxes_b.edges);
  ask(MeetingPair::edge_vertex, boxes_a.edges, boxes_b.vertices);
  ask(MeetingPair::edge_edge, boxes_a.edges, boxes_b.edges);
  ask(MeetingPair::vertex_face, boxes_a.vertices, boxes_b.faces);
  ask(MeetingPair::face_vertex, boxes_a.faces, boxes_b.vertices);
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
  const auto rank = [](const Feature& a, const Feature& b) {
    return std::tuple(static_cast<int>(a.kind) + static_cast<int>(b.kind), a.kind, a.index, b.kind, b.index);
  };
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

template <class A, class B>
Relation relation_of(const A& a, const B& b) {
  return relate(a, b);
}
Relation relation_of(const Point3& p, const Point3& q) { return p == q ? Relation::overlapping : Relation::disjoint; }

/// How the shapes lie to one another at time 0.
using StartRelation = Relation (*)(const BodyShape& a, const BodyShape& b);

template <class A, class B>
Relation start_relation(const BodyShape& a, const BodyShape& b) {
  return relation_of(*std::get<const A*>(a), *std::get<const B*>(b));
}

/// Checked, and as far as running errors tell.
struct Outlook {
  bool overlap = false;  // at time 0
  std::vector<Candidate> found{};
};

Outlook outlook(std::string_view function, const BodyMotion& a, const BodyMotion& b, StartRelation at_start) {
  require_finite_parts(function, {"a.by", "b.by"}, *a.by, *b.by);
  const bool some_a = check_body(function, "a.shape", a.shape), some_b = check_body(function, "b.shape", b.shape);
  if (!some_a || !some_b) return {};
  const auto velocity = vector_of<Running>(*a.by) - vector_of<Running>(*b.by);
  if (const auto [from, to] = Slabs(velocity, Running(0.0)).times(bounding_box(a.shape), bounding_box(b.shape));
      !(from <= to))
    return {};
  const MotionPair<Running> quick(a, b);
  const TimeWindow window = time_window(quick.a, quick.b, velocity);
  if (window.empty()) return {};
  if (!(window.from > 0) && at_start(a.shape, b.shape) == Relation::overlapping) return {true};
  return {false, candidates(quick, window)};
}

BodyMeeting overlap_at_start() { return {Root(Rational(0)), {FeatureKind::interior, 0}, {FeatureKind::interior, 0}}; }

BodyMeeting meeting(const Outlook& out, const BodyMotion& a, const BodyMotion& b) {
  if (out.overlap) return overlap_at_start();
  if (out.found.empty()) return {};
  return first_of(out.found, MotionPair<BigDyadic>(a, b));
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

template <ContactWanted asked, class A, class B>
concept IsQuick = requires(const Translating<A>& a, const Translating<B>& b) {
  quick::contact<asked>(a, b);
};

/// Where doubles and pairs of them tell; invalid shapes are left to those who name what is wrong.
template <ContactWanted asked, class A, class B>
quick::Answer quick_answer(const Translating<A>& a, const Translating<B>& b) {
  if constexpr (IsQuick<asked, A, B>) {
    if (!(is_sound(a.shape) && is_sound(b.shape) && is_real(sum_of(a.by) + sum_of(b.by)))) return quick::unsure;
    return is_nothing(a.shape) || is_nothing(b.shape) ? quick::no : quick::contact<asked>(a, b);
  } else if constexpr (IsQuick<asked, B, A>) {
    const quick::Answer answer = quick_answer<asked>(b, a);
    return {answer.told, swapped(answer.contact)};
  } else {
    return quick::unsure;
  }
}

// What is not told quickly, out of the way of what is.
template <class A, class B>
[[gnu::noinline]] std::optional<Root> time_of(const Translating<A>& a, const Translating<B>& b) {
  const BodyMotion of_a{&a.shape, &a.by}, of_b{&b.shape, &b.by};
  return meeting(outlook("first_contact_time", of_a, of_b, start_relation<A, B>), of_a, of_b).time;
}
template <class A, class B>
[[gnu::noinline]] std::optional<Contact> contact_of(const Translating<A>& a, const Translating<B>& b) {
  const BodyMotion of_a{&a.shape, &a.by}, of_b{&b.shape, &b.by};
  const Outlook out = outlook("first_contact", of_a, of_b, start_relation<A, B>);
  if (const auto quick = quick_contact(out.found, of_a, of_b)) return quick;
  const BodyMeeting m = meeting(out, of_a, of_b);
  if (!m.time) return {};
  return Contact{m.time->rounded(Rounding::down), m.a, m.b};
}
template <class A, class B>
[[gnu::noinline]] bool meet(const Translating<A>& a, const Translating<B>& b) {
  const BodyMotion of_a{&a.shape, &a.by}, of_b{&b.shape, &b.by};
  const Outlook out = outlook("intersects", of_a, of_b, start_relation<A, B>);
  const auto surely = [](const Candidate& c) { return c.time.certain() && c.time.latest() <= 1; };
  return out.overlap || std::ranges::any_of(out.found, surely) || meeting(out, of_a, of_b).time.has_value();
}

}  // namespace
}  // namespace query

using query::quick::MotionVerdict;

template <class A, class B>
requires MovingPair<A, B> std::optional<Root> first_contact_time(const Translating<A>& a, const Translating<B>& b) {
  if (query::quick_answer<query::ContactWanted::whether>(a, b).told == MotionVerdict::no) return {};
  return query::time_of(a, b);
}

template <class A, class B>
requires MovingPair<A, B> std::optional<Contact> first_contact(const Translating<A>& a, const Translating<B>& b) {
  const auto [told, contact] = query::quick_answer<query::ContactWanted::when>(a, b);
  if (told == MotionVerdict::no) return {};
  if (told == MotionVerdict::yes) return contact;
  if (told == MotionVerdict::starts && query::relation_of(a.shape, b.shape) == Relation::overlapping)
    return query::quick::overlap.contact;
  return query::contact_of(a, b);
}

template <class A, class B>
requires MovingPair<A, B>
bool intersects(const Translating<A>& a, const Translating<B>& b) {
  const MotionVerdict told = query::quick_answer<query::ContactWanted::whether>(a, b).told;
  if (told == MotionVerdict::no || told == MotionVerdict::yes) return told == MotionVerdict::yes;
  if (told == MotionVerdict::starts && query::relation_of(a.shape, b.shape) != Relation::disjoint) return true;
  return query::meet(a, b);
}

#define PLUMB_MOVING_PAIR(A, B)                                                                  \
  template std::optional<Root> first_contact_time(const Translating<A>&, const Translating<B>&); \
  template std::optional<Contact> first_contact(const Translating<A>&, const Translating<B>&);   \
  template bool intersects(const Translating<A>&, const Translating<B>&);
#define PLUMB_MOVING_PAIRS(A)             \
  PLUMB_MOVING_PAIR(A, Point3)            \
  PLUMB_MOVING_PAIR(A, Segment3)          \
  PLUMB_MOVING_PAIR(A, Triangle3)         \
  PLUMB_MOVING_PAIR(A, Aabb3)             \
  PLUMB_MOVING_PAIR(A, Obb3)              \
  PLUMB_MOVING_PAIR(A, ConvexPolyhedron3) \
  PLUMB_MOVING_PAIR(A, Sphere3)           \
  PLUMB_MOVING_PAIR(A, Capsule3)          \
  PLUMB_MOVING_PAIR(A, Plane3)
PLUMB_MOVING_PAIRS(Point3)
PLUMB_MOVING_PAIRS(Segment3)
PLUMB_MOVING_PAIRS(Triangle3)
PLUMB_MOVING_PAIRS(Aabb3)
PLUMB_MOVING_PAIRS(Obb3)
PLUMB_MOVING_PAIRS(ConvexPolyhedron3)
PLUMB_MOVING_PAIRS(Sphere3)
PLUMB_MOVING_PAIRS(Capsule3)
PLUMB_MOVING_PAIR(Plane3, Point3)
PLUMB_MOVING_PAIR(Plane3, Segment3)
PLUMB_MOVING_PAIR(Plane3, Triangle3)
PLUMB_MOVING_PAIR(Plane3, Aabb3)
PLUMB_MOVING_PAIR(Plane3, Obb3)
PLUMB_MOVING_PAIR(Plane3, ConvexPolyhedron3)
PLUMB_MOVING_PAIR(Plane3, Sphere3)
PLUMB_MOVING_PAIR(Plane3, Capsule3)
#undef PLUMB_MOVING_PAIRS
#undef PLUMB_MOVING_PAIR

}  // namespace plumb
