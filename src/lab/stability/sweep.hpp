// Which of these segments meet?  A line sweeps over the plane, and keeps the segments that it cuts in order.
//
// Laws: over a number that does not round, and without an epsilon, (1) the pairs are those that meet, for whatever
// segments; (2) there are at most 2 n + n (n - 1) / 2 events; what needs more has lost its way and is stopped.
// Source: Bentley and Ottmann 1979, as in de Berg and others, Computational Geometry, chapter 2.
// Cost: events times n.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "lab/trial/segment_tests.hpp"

namespace plumb::lab::stability {

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

template <class T>
class Sweep {
 public:
  Sweep(std::vector<trial::Segment<T>> segments, T epsilon)
      : segments_(std::move(segments)), epsilon_(std::move(epsilon)) {
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      trial::Segment<T>& s = segments_[i];
      if (s.b < s.a) std::swap(s.a, s.b);
      events_[s.a].insert(i);
      events_[s.b].insert(i);
    }
  }

  /// None where it did not end.
  std::optional<Pairs> run() {
    const std::size_t n = segments_.size();
    std::size_t left = 2 * n + n * (n - 1) / 2;
    while (!events_.empty()) {
      if (left-- == 0) return std::nullopt;
      const trial::Place<T> at = events_.begin()->first;
      std::set<std::size_t> here = std::move(events_.begin()->second);
      events_.erase(events_.begin());
      handle(at, std::move(here));
    }
    return pairs_;
  }

 private:
  bool goes_on(std::size_t i, const trial::Place<T>& at) const { return at < segments_[i].b; }

  void handle(const trial::Place<T>& at, std::set<std::size_t> here) {
    for (const std::size_t i : status_) {
      if (side(segments_[i], at, epsilon_) == 0 && within_box(segments_[i], at)) here.insert(i);
    }
    for (const std::size_t i : here) {
      for (const std::size_t j : here) {
        if (i < j) pairs_.insert({i, j});
      }
    }
    std::erase_if(status_, [&](std::size_t i) { return here.contains(i); });
    std::vector<std::size_t> on;
    std::ranges::copy_if(here, std::back_inserter(on), [&](std::size_t i) { return goes_on(i, at); });
    std::ranges::stable_sort(on, [this](std::size_t i, std::size_t j) { return steeper(j, i); });
    const auto above = std::partition_point(status_.begin(), status_.end(),
                                            [&](std::size_t i) { return side(segments_[i], at, epsilon_) > 0; });
    const auto first = static_cast<std::size_t>(above - status_.begin()), after = first + on.size();
    status_.insert(above, on.begin(), on.end());
    look(first, at);
    if (after != first) look(after, at);
  }

  /// Does i rise faster to the right than j?
  bool steeper(std::size_t i, std::size_t j) const {
    const trial::Segment<T>&s = segments_[i], &t = segments_[j];
    return (t.b.x - t.a.x) * (s.b.y - s.a.y) - (t.b.y - t.a.y) * (s.b.x - s.a.x) > epsilon_;
  }

  /// Will the segment at this place of the status and the one below it cross further on?
  void look(std::size_t place, const trial::Place<T>& at) {
    if (place == 0 || place >= status_.size()) return;
    const std::size_t i = status_[place - 1], j = status_[place];
    if (!meet_by_parameters(segments_[i], segments_[j], epsilon_)) return;
    const auto p = crossing(segments_[i], segments_[j], epsilon_);
    if (p && at < *p) events_[*p].insert({i, j});
  }

  std::vector<trial::Segment<T>> segments_;
  T epsilon_;
  std::map<trial::Place<T>, std::set<std::size_t>> events_;
  std::vector<std::size_t> status_;  // from below to above
  Pairs pairs_;
};

}  // namespace plumb::lab::stability
