#include "plumb/query/body/contact_pairs.hpp"
#include "plumb/query/time_of_impact/flat_contact.hpp"
#include "plumb/query/time_of_impact/posed.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/asked.hpp"

namespace plumb::query {
namespace {

/// As the questions of posed figures take it, which have `in_plane` for what moves in the plane.
PosedMotion posed_motion_of(const AnyMotion& m, const Vector2& in_plane) {
  if (m.figure.figure.dimension == 2) return {m.figure, nullptr, &in_plane};
  return {m.figure, &m.by};
}

/// By the types where first_contact has a method for them, else as any two figures under poses.
template <class Answer, class ByTypes, class AsPosed>
Answer asked_of_motion(std::string_view question, const AnyMotion& a, const AnyMotion& b, const ByTypes& by_types,
                       const AsPosed& as_posed) {
  const FigureView &of_a = a.figure.figure, &of_b = b.figure.figure;
  require_answer(translating_pairs, question, of_a, of_b);
  const Vector2 in_plane_a{a.by.x, a.by.y}, in_plane_b{b.by.x, b.by.y};
  if (of_a.dimension == 2 && !(a.by.z == 0 && b.by.z == 0)) {
    throw Unsupported(std::string(question) + ": a figure of the plane moves out of it; give a motion whose z is zero");
  }
  const auto posed = [&] { return as_posed(posed_motion_of(a, in_plane_a), posed_motion_of(b, in_plane_b)); };
  if (is_posed_view(a.figure) || is_posed_view(b.figure)) return posed();
  return asked_by_types<Answer>(question, of_a, of_b, [&]<class A, class B>(const A& x, const B& y) -> Answer {
    if constexpr (MovingPair<A, B>) {
      return by_types(Translating<A>{x, a.by}, Translating<B>{y, b.by});
    } else if constexpr (MovesInPlane<A> && MovesInPlane<B>) {
      return by_types(Translating<A>{x, in_plane_a}, Translating<B>{y, in_plane_b});
    } else {
      return posed();
    }
  });
}

bool is_posed_motion(const CornersInMotion& m) { return is_posed_view(m.from) || is_posed_view(m.to); }

template <class Answer, class ByTypes, class AsPosed>
Answer asked_of_corners(std::string_view question, const CornersInMotion& a, const CornersInMotion& b,
                        const ContactOptions& options, const ByTypes& by_types, const AsPosed& as_posed) {
  for (const CornersInMotion* m : {&a, &b}) {
    const FigureView &from = m->from.figure, &to = m->to.figure;
    if (from.kind != to.kind || from.dimension != to.dimension)
      refuse_pair(std::string(question) + " of what is Moving from one to the other", from, to);
  }
  require_answer(moving_pairs, question, a.from.figure, b.from.figure);
  if (is_posed_motion(a) || is_posed_motion(b)) return as_posed(a, b, options);
  return asked_by_types<Answer>(
      question, a.from.figure, b.from.figure,
      [&]<class A, class B>(const A& x, const B& y) requires requires {
        by_types(Moving<A>{x, x}, Moving<B>{y, y}, options);
      } {
        const Moving<A> from_to{x, *static_cast<const A*>(a.to.figure.shape)};
        return by_types(from_to, Moving<B>{y, *static_cast<const B*>(b.to.figure.shape)}, options);
      });
}

}  // namespace

bool any_corners_meet(const CornersInMotion& a, const CornersInMotion& b, const ContactOptions& options) {
  return asked_of_corners<bool>(
      "intersects", a, b, options, [](const auto& x, const auto& y, const auto& o) requires requires {
        intersects(x, y, o);
      } { return intersects(x, y, o); },
      corners_meet);
}
std::optional<Contact> any_corner_contact(const CornersInMotion& a, const CornersInMotion& b,
                                          const ContactOptions& options) {
  return asked_of_corners<std::optional<Contact>>(
      "first_contact", a, b, options, [](const auto& x, const auto& y, const auto& o) requires requires {
        first_contact(x, y, o);
      } { return first_contact(x, y, o); },
      corner_contact);
}
std::optional<Root> any_corner_contact_time(const CornersInMotion& a, const CornersInMotion& b,
                                            const ContactOptions& options) {
  return asked_of_corners<std::optional<Root>>(
      "first_contact_time", a, b, options, [](const auto& x, const auto& y, const auto& o) requires requires {
        first_contact_time(x, y, o);
      } { return first_contact_time(x, y, o); },
      corner_contact_time);
}
std::optional<Contact> any_first_contact(const AnyMotion& a, const AnyMotion& b) {
  return asked_of_motion<std::optional<Contact>>(
      "first_contact", a, b, [](const auto& x, const auto& y) { return first_contact(x, y); }, posed_contact);
}
std::optional<Root> any_first_contact_time(const AnyMotion& a, const AnyMotion& b) {
  return asked_of_motion<std::optional<Root>>(
      "first_contact_time", a, b, [](const auto& x, const auto& y) { return first_contact_time(x, y); },
      posed_contact_time);
}
bool any_meet(const AnyMotion& a, const AnyMotion& b) {
  return asked_of_motion<bool>(
      "intersects", a, b, [](const auto& x, const auto& y) { return intersects(x, y); }, posed_bodies_meet);
}

}  // namespace plumb::query
