#include <utility>

#include "arith/form_root.hpp"

namespace plumb::arith {
namespace {

/// u and t of a root that is listed, if it is between 0 and 1.
void list(RootCount& count, const BriefInteger& u, const BriefInteger& t) {
  if (u.is_lost() || t.is_lost()) {
    count.certain = false;
  } else if (u.sign() * t.sign() > 0) {
    const bool negative = u.sign() < 0;
    count.root[static_cast<std::size_t>(count.listed++)] = {negative ? -u : u, negative ? -t : t};
  }
}

BriefInteger times(std::int64_t factor, const BriefInteger& x) { return BriefInteger(factor) * x; }

void count_of_quadratic(const Form& f, RootCount& count) {
  const BriefInteger d = f.at(1) * f.at(1) - times(4, f.at(0) * f.at(2));
  if (d.is_lost()) {
    count.certain = false;
  } else if (d.sign() > 0) {
    count.single = 2;
  } else if (d.sign() == 0) {
    list(count, times(2, f.at(2)), -f.at(1));
  }
}

/// Of one whose signs vary twice or three times.
void count_of_cubic(const Form& f, int changes, RootCount& count) {
  const BriefInteger &a = f.at(3), &b = f.at(2), &c = f.at(1), &d = f.at(0);
  const BriefInteger ac = a * c, bd = b * d, ad = a * d, bc = b * c;
  const BriefInteger e = b * b - times(3, ac), g = c * c - times(3, bd), h = bc - times(9, ad);
  const BriefInteger discriminant = times(4, e * g) - h * h;  // three times it
  if (discriminant.is_lost()) {
    count.certain = false;
  } else if (discriminant.sign() > 0) {
    count.single = changes;
  } else if (discriminant.sign() < 0) {
    count.single = changes - 2;
  } else if (e.sign() == 0) {
    list(count, times(3, a), -b);
  } else {
    list(count, times(2, e), -h);
    list(count, a * e, times(4, a * bc) - times(9, a * ad) - b * (b * b));
    if (count.listed < 2) return;
    auto& [first, second] = count.root;
    if ((first[1] * second[0] - second[1] * first[0]).sign() > 0) std::swap(first, second);
  }
}

}  // namespace

RootCount count_roots(const Form& form) {
  RootCount count;
  const int changes = sign_changes(form).count;
  if (changes < 2) {
    count.single = changes;
  } else if (form.degree == 2) {
    count_of_quadratic(form, count);
  } else {
    count_of_cubic(form, changes, count);
  }
  return count;
}

}  // namespace plumb::arith
