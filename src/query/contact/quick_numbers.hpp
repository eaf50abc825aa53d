// How far are bodies apart along their normal, and where are the corners of their contact?  Each number rounded once, by
// pairs of doubles.
//
// Laws: what is told is exact, then rounded; what pairs of doubles leave open is nothing.  A distance that is nearly none is
// computed in integers first, for its digits are those that cancel.
// Source: query/contact/corner_numbers.hpp.
// Cost: some 800 operations a corner.
#pragma once

#include "plumb/arith/ball.hpp"
#include "query/contact/contact_pair.hpp"
#include "query/contact/corner_numbers.hpp"

namespace plumb::query::touching {

/// Is there a contact?  Where there is none the rest is not told.
struct Whole {
  bool is_near;
  Relation relation;
  Vector3 normal;
  double distance;
};

/// Is it within the margin?
struct Corner {
  bool is_near;
  ContactCorner told;
};
using QuickCorners = parting::ShortList<std::optional<Corner>, 16>;

class QuickNumbers {
 public:
  explicit QuickNumbers(const Pair& p);
  [[nodiscard]] std::optional<Whole> whole() const;
  /// One for each that was found.
  [[nodiscard]] QuickCorners corners(const Matched& m) const;

 private:
  /// How far a corner's points are apart: height / whole normals.
  struct Gap {
    Ball height, whole;
  };
  /// `gap`: in the place of what pairs of doubles tell.
  [[nodiscard]] std::optional<Corner> corner(const CornerPlaces<Ball>& places, const Found& f,
                                             const std::optional<Gap>& gap = {}) const;
  void tell_by_integers(const Matched& m, const CornerPlaces<Ball>& places, QuickCorners& corners) const;
  /// Of height / whole normals; `along` is that with their length.
  [[nodiscard]] std::optional<bool> beyond_limit(const Ball& height, const Ball& whole, const Ball& along) const;

  const Pair& pair_;
  Vec<Ball> normal_;
  Ball square_, length_, share_, radii_, limit_;
};

}  // namespace plumb::query::touching
