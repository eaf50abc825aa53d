#include "plumb/query/contact/contact.hpp"

#include "query/variant/recorded.hpp"

namespace plumb::query {
namespace {

/// A hull of points alone is no figure, and has no line.
bool are_figures(const BodyView& a, const BodyView& b) { return !a.is_hull() && !b.is_hull(); }
PosedView posed_of(const BodyView& body) { return {body.figure, body.pose}; }

}  // namespace

std::optional<ContactManifold> any_contact_of(const BodyView& a, const BodyView& b,
                                              const ContactManifoldOptions& options, ContactCache* cache) {
  const auto ask = [&] { return contact_of(a, b, options, cache); };
  if (!are_figures(a, b)) return ask();
  return recorded("contact", {posed_of(a), posed_of(b)}, {options.margin, static_cast<double>(options.at_most)}, ask);
}
std::optional<Penetration> any_penetration_of(const BodyView& a, const BodyView& b, ContactCache* cache) {
  const auto ask = [&] { return penetration_of(a, b, cache); };
  if (!are_figures(a, b)) return ask();
  return recorded("penetration", {posed_of(a), posed_of(b)}, {}, ask);
}

}  // namespace plumb::query
