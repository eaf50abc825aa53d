#include <algorithm>
#include <bit>
#include <utility>

#include "plumb/degenerate/shrink.hpp"

namespace plumb {

namespace {

// How far the choices after a simpler one are shifted to give it other followers, such as a simpler family other
// points.
constexpr std::size_t longest_redraw = 12;

}  // namespace

ChoiceShrinks::ChoiceShrinks(std::vector<std::uint64_t> choices) : current_(std::move(choices)) {}

bool ChoiceShrinks::next() {
  if (started_) advance();
  started_ = true;
  while (pass_ != Pass::done) {
    if (propose()) return true;
    advance();
  }
  return false;
}

// Whether the state names a candidate that differs from the current case; if so, makes it.
bool ChoiceShrinks::propose() {
  if (pass_ == Pass::lower) {
    if (place_ >= current_.size() || amount_ == 0) return false;
    candidate_ = current_;
    candidate_[place_] -= amount_;
    return true;
  }
  if (pass_ == Pass::redraw) {
    if (place_ + block_ >= current_.size() || current_[place_] == 0) return false;
    const auto place = current_.begin() + static_cast<std::ptrdiff_t>(place_);
    candidate_.assign(current_.begin(), place);
    candidate_.push_back(0);
    candidate_.insert(candidate_.end(), place + 1 + static_cast<std::ptrdiff_t>(block_), current_.end());
    return true;
  }
  if (block_ == 0 || place_ < block_) return false;
  const auto end = current_.begin() + static_cast<std::ptrdiff_t>(place_);
  const auto begin = end - static_cast<std::ptrdiff_t>(block_);
  if (pass_ == Pass::zero && std::all_of(begin, end, [](std::uint64_t choice) { return choice == 0; })) return false;
  candidate_.assign(current_.begin(), begin);
  if (pass_ == Pass::zero) candidate_.resize(place_, 0);
  candidate_.insert(candidate_.end(), end, current_.end());
  return true;
}

void ChoiceShrinks::advance() {
  const bool accepted = std::exchange(accepted_, false);
  if (pass_ == Pass::lower) {
    if (accepted) {
      amount_ = std::min(amount_, current_[place_]);  // the same step once more
    } else if (amount_ > 1) {
      amount_ = std::bit_floor(amount_ - 1);  // powers of two keep the parity, which is a sign in Entropy::within
    } else if (++place_ < current_.size()) {
      amount_ = current_[place_];
    } else {
      pass_ = Pass::done;
    }
    return;
  }
  if (pass_ == Pass::redraw) {
    if (!accepted && block_ < longest_redraw) {
      ++block_;
    } else if (block_ = 0; ++place_ >= current_.size()) {
      pass_ = Pass::drop;
      block_ = std::bit_floor(current_.size());
      place_ = current_.size();
    }
    return;
  }
  if (accepted && pass_ == Pass::drop) {
    place_ = std::min(place_, current_.size());  // what followed the dropped block has moved into its place
    return;
  }
  if (place_ > block_) {
    --place_;
    return;
  }
  block_ = block_ > 8
               ? block_ / 2
               : block_ - std::min<std::size_t>(block_, 1);  // every short length: points take one to six choices
  place_ = current_.size();
  if (block_ > 0) return;
  if (pass_ == Pass::drop) {
    pass_ = Pass::zero;
    block_ = std::bit_floor(current_.size());
  } else {
    pass_ = Pass::lower;
    place_ = 0;
    amount_ = current_.empty() ? 0 : current_[0];
  }
}

void ChoiceShrinks::accept() {
  current_ = candidate_;
  accepted_ = true;
}

std::vector<std::uint64_t> shrink_choices(std::vector<std::uint64_t> choices, const FailsOnChoices& still_fails,
                                          std::size_t most_calls) {
  for (bool improved = true; improved;) {
    improved = false;
    ChoiceShrinks shrinks(choices);
    while (shrinks.next()) {
      if (most_calls == 0) return shrinks.current();
      --most_calls;
      if (!still_fails(shrinks.candidate())) continue;
      shrinks.accept();
      improved = true;
    }
    choices = shrinks.current();
  }
  return choices;
}

}  // namespace plumb
