// What is asked of two bodies in contact, and what is known of it: their corners and radii, the normal, and the features
// that face each other.
//
// Laws: radii are doubles where `are_doubles`, else exact alone.  The normal leads from a to b.
// Source: query/contact/aim.hpp.
// Cost: that of the aim.
#pragma once

#include <algorithm>
#include <string_view>

#include "query/contact/clipped_features.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb::query::touching {

/// As doubles where all of them are, and without rounding.
class Radii {
 public:
  Radii(std::string_view function, const BodyView& a, const BodyView& b) {
    given_ = {radius_of(a), radius_of(b)};
    if ((given_[0] == 0 || a.pose.stands()) && (given_[1] == 0 || b.pose.stands())) return;
    const std::array<Body, 2> bodies = bodies_of(function, a, b);
    posed_ = {bodies[0].radius, bodies[1].radius};
    for (std::size_t i = 0; i < 2; ++i) {
      given_[i] = (*posed_)[i].get_d();
      are_doubles_ = are_doubles_ && given_[i] == (*posed_)[i];
    }
  }
  [[nodiscard]] bool are_doubles() const { return are_doubles_; }
  [[nodiscard]] double given(std::size_t i) const { return given_[i]; }
  [[nodiscard]] mpq_class exact(std::size_t i) const { return posed_ ? (*posed_)[i] : mpq_class(given_[i]); }
  [[nodiscard]] bool are_none() const { return given_[0] == 0 && given_[1] == 0; }

 private:
  std::array<double, 2> given_{};
  std::optional<std::array<mpq_class, 2>> posed_;
  bool are_doubles_ = true;
};

template <class T>
Vec<T> turned_back(const Vec<T>& v) {
  return Vec<T>{T(0.0), T(0.0), T(0.0)} - v;
}

/// What is asked about.
class Pair {
 public:
  Pair(std::string_view function, const BodyView& a, const BodyView& b, double margin, ContactCache* cache)
      : views_{a, b}, corners_(corners_of(function, a, b)), radii_(function, a, b), margin_(margin) {
    const auto before = cache != nullptr ? cached_aim(difference(), *cache) : std::nullopt;
    is_as_before_ = before.has_value();
    before ? take(*before) : aim(Guess::likely, cache);
  }
  Pair(const Pair&) = delete;  // what is seen refers to it
  Pair& operator=(const Pair&) = delete;
  ~Pair() = default;

  void aim(Guess guess, ContactCache* cache) { take(aim_at(difference(), guess, cache)); }
  [[nodiscard]] bool is_proved() const { return aim_->is_proved; }
  [[nodiscard]] bool do_cores_touch() const { return aim_->do_touch; }
  /// Another one, where this one is none.
  void aim_again(ContactCache* cache) {
    const Guess guess = is_as_before_ ? Guess::likely : aim_->is_widest ? Guess::none : Guess::widest;
    is_as_before_ = false;
    aim(guess, cache);
  }

  [[nodiscard]] Difference difference() const { return {corners_[0], corners_[1]}; }
  [[nodiscard]] const Radii& radii() const { return radii_; }
  [[nodiscard]] double margin() const { return margin_; }

  /// From b to a.
  [[nodiscard]] const Way& way() const { return aim_->way; }
  /// From a to b.
  template <class T>
  [[nodiscard]] Vec<T> normal() const {
    return turned_back(aim_->way.along<T>(difference()));
  }
  /// How far the cores are apart along the normal, times its length.
  template <class T>
  [[nodiscard]] T height(const Vec<T>& normal) const {
    return T(0.0) - sparse_dot(normal, difference().at<T>(aim_->at));
  }
  [[nodiscard]] Seen seen(std::size_t i) const {
    return {views_[i],
            corners_[i],
            aim_->at[i],
            i == 0 ? known_->a : known_->b,
            aim_->level ? &(*aim_->level)[i] : nullptr,
            aim_->all ? &(*aim_->all)[i] : nullptr};
  }

 private:
  void take(const Aim& aim) {
    aim_.emplace(aim);
    known_.emplace(aim.way.known(difference()));
  }

  std::array<BodyView, 2> views_;
  std::array<CoreCorners, 2> corners_;
  Radii radii_;
  double margin_;
  std::optional<Aim> aim_;
  std::optional<parting::KnownPlane> known_;
  bool is_as_before_ = false;  // it is what the cache holds
};

/// The features that face each other, and the corners of what they have in common.
struct Matched {
  std::array<Seen, 2> seen;
  std::array<Facing, 2> facing;
  FoundCorners corners;
};

/// Which parts of the features are as far as anything of their bodies, as far as that is known?
class LevelParts {
 public:
  explicit LevelParts(const Matched& m) : m_(m), are_all_{are_all(0), are_all(1)} {}

  /// Are both of a corner's points such, so that they are nearest, and as far apart as the bodies?
  [[nodiscard]] bool has(const Found& f) const {
    const bool of_a = f.kind == CornerKind::vertex_of_b ? are_all_[0]
                      : f.kind == CornerKind::edges     ? has_edge(0, f.i)
                                                        : has_corner(0, f.i);
    const bool of_b = f.kind == CornerKind::vertex_of_a ? are_all_[1]
                      : f.kind == CornerKind::edges     ? has_edge(1, f.j)
                                                        : has_corner(1, f.j);
    return of_a && of_b;
  }

 private:
  [[nodiscard]] bool has_corner(std::size_t body, std::size_t i) const {
    const Seen& s = m_.seen[body];
    const Index corner = m_.facing[body].corners[i];
    if (s.level != nullptr) return (corner & ~s.level->free) == s.level->first;
    return corner == s.at || s.known.has(corner) ||
           (s.all != nullptr && std::ranges::find(*s.all, corner) != s.all->end());
  }
  [[nodiscard]] bool has_edge(std::size_t body, std::size_t i) const {
    return has_corner(body, i) && has_corner(body, i + 1 == m_.facing[body].corners.size() ? 0 : i + 1);
  }
  [[nodiscard]] bool are_all(std::size_t body) const {
    bool all = true;
    for (std::size_t i = 0; i < m_.facing[body].corners.size(); ++i) all = all && has_corner(body, i);
    return all;
  }

  const Matched& m_;
  std::array<bool, 2> are_all_;
};

}  // namespace plumb::query::touching
