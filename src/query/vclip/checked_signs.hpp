// Adaptive precision: signs of texts about two solids, whose numbers are looked at before integers are made of them.
//
// Laws: those of certify/carried_errors.hpp; NaN and infinity throw NonFinite by name where a sign asks for them, for no
// double that came of them is certain.
// Source: docs/proof.md.
// Cost: as a rule three times that of plain doubles; nothing is looked at where these tell.
#pragma once

#include "certify/carried_errors.hpp"
#include "query/vclip/clip_input.hpp"

namespace plumb::query::vclipping {

class CheckedSigns {
 public:
  CheckedSigns(std::string_view function, const ClipView& a, const ClipView& b) : function_(function), views_{&a, &b} {}

  template <class Text>
  Sign operator()(const Text& text) {
    if (const Unsure<Sign> s = text.template operator()<Running>().sign(); s.certain()) [[likely]]
      return s.value();
    check();
    return sign_by_integers(text);
  }

  /// Throws where a number of the two is none.
  void check() {
    if (!checked_) static_cast<void>(bodies_of(function_, body_view(*views_[0]), body_view(*views_[1])));
    checked_ = true;
  }

 private:
  std::string_view function_;
  std::array<const ClipView*, 2> views_;
  bool checked_ = false;
};

}  // namespace plumb::query::vclipping
