#include "plumb/query/time_of_impact/continuous_contact.hpp"

#include <memory>

#include "query/body/figure_input.hpp"
#include "query/time_of_impact/brief_contact.hpp"
#include "query/time_of_impact/contact_filter.hpp"
#include "query/time_of_impact/exact_contact.hpp"
#include "query/time_of_impact/separation_filter.hpp"

namespace plumb {
namespace {

using query::moving::TimedContact, query::moving::MovingKind, query::moving::ContactVerdict;
using Motion = query::moving::ContactQuestion;

Motion motion_of(const Moving<Point3>& a, const Moving<Triangle3>& b) {
  return {MovingKind::vertex_triangle, {a.from, b.from.a, b.from.b, b.from.c}, {a.to, b.to.a, b.to.b, b.to.c}};
}
Motion motion_of(const Moving<Triangle3>& a, const Moving<Point3>& b) { return motion_of(b, a); }
Motion motion_of(const Moving<Segment3>& a, const Moving<Segment3>& b) {
  return {MovingKind::edge_edge, {a.from.a, a.from.b, b.from.a, b.from.b}, {a.to.a, a.to.b, b.to.a, b.to.b}};
}

template <class A, class B>
void require_valid(std::string_view function, const Moving<A>& a, const Moving<B>& b, const ContactOptions& options) {
  query::require_figure(function, "a.from", a.from), query::require_figure(function, "a.to", a.to);
  query::require_figure(function, "b.from", b.from), query::require_figure(function, "b.to", b.to);
  query::moving::require_separation(function, options.separation);
}

std::optional<TimedContact> exact_first_contact(const Motion& m, double separation) {
  if (separation > 0 && query::moving::separation_filter(m, separation) == ContactVerdict::no) return {};
  return query::moving::exact_first_contact(m.kind, m.at_0, m.at_1, separation);
}

/// Are all coordinates and the separation as they should be?  Looked at without naming them.
bool valid(const Motion& m, double separation) {
  double x = 0, y = 0, z = separation - separation;  // become NaN, and stay it
  for (std::size_t i = 0; i < 4; ++i) {
    x += (m.at_0[i].x - m.at_0[i].x) + (m.at_1[i].x - m.at_1[i].x);
    y += (m.at_0[i].y - m.at_0[i].y) + (m.at_1[i].y - m.at_1[i].y);
    z += (m.at_0[i].z - m.at_0[i].z) + (m.at_1[i].z - m.at_1[i].z);
  }
  return x + y + z == 0 && separation >= 0;
}

template <class A, class B>
Motion valid_motion(std::string_view function, const A& a, const B& b, const ContactOptions& options) {
  const Motion m = motion_of(a, b);
  if (!valid(m, options.separation)) [[unlikely]]
    require_valid(function, a, b, options);
  return m;
}

template <class A, class B>
bool meet(const A& a, const B& b, const ContactOptions& options) {
  const Motion m = valid_motion("intersects", a, b, options);
  const ContactVerdict verdict = query::moving::contact_filter(m);
  if (verdict == ContactVerdict::yes) return true;
  if (verdict == ContactVerdict::no && options.separation == 0) [[likely]]
    return false;
  if (options.separation > 0) {
    const ContactVerdict near = query::moving::separation_filter(m, options.separation);
    if (near != ContactVerdict::unsure) return near == ContactVerdict::yes;
  } else {
    const ContactVerdict brief = query::moving::brief_contact(m, query::ContactWanted::whether).verdict;
    if (brief != ContactVerdict::unsure) return brief == ContactVerdict::yes;
  }
  return query::moving::exact_first_contact(m.kind, m.at_0, m.at_1, options.separation).has_value();
}

template <class A, class B>
std::optional<Contact> contact(const A& a, const B& b, const ContactOptions& options) {
  const Motion m = valid_motion("first_contact", a, b, options);
  if (options.separation == 0) {
    const auto [verdict, time] = query::moving::first_contact_filter(m);
    if (verdict == ContactVerdict::no) return {};
    if (const auto down = verdict == ContactVerdict::yes ? time->rounded(Rounding::down) : std::nullopt) {
      const bool edges = m.kind == MovingKind::edge_edge;
      return Contact{*down,
                     {edges ? FeatureKind::edge : FeatureKind::vertex, 0},
                     {edges ? FeatureKind::edge : FeatureKind::face, 0}};
    }
    const auto [brief, found] = query::moving::brief_contact(m, query::ContactWanted::when);
    if (brief != ContactVerdict::unsure) return brief == ContactVerdict::yes ? std::optional(found) : std::nullopt;
  }
  if (options.separation > 0) {
    const auto [verdict, near] = query::moving::first_near_contact(m, options.separation);
    if (verdict != ContactVerdict::unsure) return verdict == ContactVerdict::yes ? std::optional(near) : std::nullopt;
  }
  const auto exact = query::moving::exact_first_contact(m.kind, m.at_0, m.at_1, options.separation);
  if (!exact) return {};
  return Contact{arith::rounded(Rounding::down, exact->time), exact->a, exact->b};
}

template <class A, class B>
std::optional<Root> contact_time(const A& a, const B& b, const ContactOptions& options) {
  const Motion m = valid_motion("first_contact_time", a, b, options);
  if (options.separation == 0 && query::moving::contact_filter(m) == ContactVerdict::no) return {};
  auto exact = exact_first_contact(m, options.separation);
  if (!exact) return {};
  return Root(std::make_shared<const arith::IsolatedRoot>(std::move(exact->time)));
}

}  // namespace

bool intersects(const Moving<Point3>& a, const Moving<Triangle3>& b, const ContactOptions& options) {
  return meet(a, b, options);
}
bool intersects(const Moving<Triangle3>& a, const Moving<Point3>& b, const ContactOptions& options) {
  return meet(a, b, options);
}
bool intersects(const Moving<Segment3>& a, const Moving<Segment3>& b, const ContactOptions& options) {
  return meet(a, b, options);
}

std::optional<Contact> first_contact(const Moving<Point3>& a, const Moving<Triangle3>& b,
                                     const ContactOptions& options) {
  return contact(a, b, options);
}
std::optional<Contact> first_contact(const Moving<Triangle3>& a, const Moving<Point3>& b,
                                     const ContactOptions& options) {
  const std::optional<Contact> c = contact(a, b, options);
  return c ? std::optional(swapped(*c)) : c;
}
std::optional<Contact> first_contact(const Moving<Segment3>& a, const Moving<Segment3>& b,
                                     const ContactOptions& options) {
  return contact(a, b, options);
}

std::optional<Root> first_contact_time(const Moving<Point3>& a, const Moving<Triangle3>& b,
                                       const ContactOptions& options) {
  return contact_time(a, b, options);
}
std::optional<Root> first_contact_time(const Moving<Triangle3>& a, const Moving<Point3>& b,
                                       const ContactOptions& options) {
  return contact_time(a, b, options);
}
std::optional<Root> first_contact_time(const Moving<Segment3>& a, const Moving<Segment3>& b,
                                       const ContactOptions& options) {
  return contact_time(a, b, options);
}

}  // namespace plumb
