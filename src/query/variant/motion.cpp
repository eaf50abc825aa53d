#include "plumb/query/body/contact_pairs.hpp"
#include "plumb/query/time_of_impact/posed.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/asked.hpp"
#include "query/variant/recorded.hpp"

namespace plumb::query {
namespace {

void require_motion(std::string_view question, const PosedMotion& a, const PosedMotion& b) {
  require_answer(translating_pairs, question, a.figure.figure, b.figure.figure);
  if (a.figure.figure.dimension == 3 || (a.by.z == 0 && b.by.z == 0)) return;
  throw Unsupported(std::string(question) + ": a figure of the plane moves out of it; give a motion whose z is zero");
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
  return asked_by_types<PairsOf<moving_pairs>, Answer>(
      question, a.from.figure, b.from.figure,
      [&]<class A, class B>(const A& x, const B& y) requires requires {
        by_types(Moving<A>{x, x}, Moving<B>{y, y}, options);
      } {
        const Moving<A> from_to{x, *static_cast<const A*>(a.to.figure.shape)};
        return by_types(from_to, Moving<B>{y, *static_cast<const B*>(b.to.figure.shape)}, options);
      });
}

template <class Ask>
auto recorded_corners(std::string_view question, const CornersInMotion& a, const CornersInMotion& b,
                      const ContactOptions& options, const Ask& ask) {
  return recorded(question, {a.from, a.to, b.from, b.to}, {options.separation}, ask);
}
template <class Ask>
auto recorded_translations(std::string_view question, const PosedMotion& a, const PosedMotion& b, const Ask& ask) {
  return recorded(question, {a.figure, b.figure}, {a.by.x, a.by.y, a.by.z, b.by.x, b.by.y, b.by.z}, [&] {
    require_motion(question, a, b);
    return ask();
  });
}

}  // namespace

bool any_corners_meet(const CornersInMotion& a, const CornersInMotion& b, const ContactOptions& options) {
  return recorded_corners("intersects", a, b, options, [&] {
    return asked_of_corners<bool>(
        "intersects", a, b, options, [](const auto& x, const auto& y, const auto& o) requires requires {
          intersects(x, y, o);
        } { return intersects(x, y, o); },
        corners_meet);
  });
}
std::optional<Contact> any_corner_contact(const CornersInMotion& a, const CornersInMotion& b,
                                          const ContactOptions& options) {
  return recorded_corners("first_contact", a, b, options, [&] {
    return asked_of_corners<std::optional<Contact>>(
        "first_contact", a, b, options, [](const auto& x, const auto& y, const auto& o) requires requires {
          first_contact(x, y, o);
        } { return first_contact(x, y, o); },
        corner_contact);
  });
}
std::optional<Root> any_corner_contact_time(const CornersInMotion& a, const CornersInMotion& b,
                                            const ContactOptions& options) {
  return recorded_corners("first_contact_time", a, b, options, [&] {
    return asked_of_corners<std::optional<Root>>(
        "first_contact_time", a, b, options, [](const auto& x, const auto& y, const auto& o) requires requires {
          first_contact_time(x, y, o);
        } { return first_contact_time(x, y, o); },
        corner_contact_time);
  });
}
std::optional<Contact> any_first_contact(const PosedMotion& a, const PosedMotion& b) {
  return recorded_translations("first_contact", a, b, [&] { return posed_contact(a, b); });
}
std::optional<Root> any_first_contact_time(const PosedMotion& a, const PosedMotion& b) {
  return recorded_translations("first_contact_time", a, b, [&] { return posed_contact_time(a, b); });
}
bool any_meet(const PosedMotion& a, const PosedMotion& b) {
  return recorded_translations("intersects", a, b, [&] { return posed_bodies_meet(a, b); });
}

}  // namespace plumb::query
