// Contact manifold: where do two axis-aligned boxes touch that stand or are moved without a turn?
//
// What rests in stacks, on floors and on shelves.  Each face is at one number, the sum of two that are given, so corners
// are picked by comparisons, and their numbers are these sums.
// Laws: the contact is that of query/contact/contact.hpp, bit by bit.  Nothing is known of other bodies, of boxes without
// an inside, of those that are near along several axes or overlap as much along two, and of what is not finite.
// Source: RTCD 4.2, 9.5.3; Knuth, TAOCP 4.2.2, on sums of two.
// Cost: a third of a us; no allocation.
#pragma once

#include <optional>

#include "plumb/query/contact/contact.hpp"

namespace plumb::query::touching {

/// The contact may be none.
struct UprightContact {
  bool is_known = false;
  std::optional<ContactManifold> manifold{};
};

UprightContact upright_contact(const BodyView& a, const BodyView& b, double margin);

}  // namespace plumb::query::touching
