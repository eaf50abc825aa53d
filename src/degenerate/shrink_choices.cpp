#include <algorithm>
#include <bit>
#include <utility>

#include "plumb/degenerate/shrink.hpp"

namespace plumb {

ChoiceShrinks::ChoiceShrinks(std::vector<std::uint64_t> choices) : current_(std::move(choices)) {
  block_ = std::bit_floor(current_.size());
  place_ = current_.size();
}

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
      amount_ /= 2;
    } else if (++place_ < current_.size()) {
      amount_ = current_[place_];
    } else {
      pass_ = Pass::done;
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
  block_ /= 2;
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
