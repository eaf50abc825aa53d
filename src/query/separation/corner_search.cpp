// A guess in doubles, which holds no bound.
#include "query/separation/corner_search.hpp"

#include "query/separation/guessed_corners.hpp"

namespace plumb::query {
namespace {

using arith::Plain;

/// A figure in doubles, seen from near to it.
class PlainHull {
 public:
  PlainHull(const CoreCorners& c, const Plain& origin, std::uint32_t start)
      : corners_(c), origin_(origin), last_(start) {
    if (c.polyhedron() != nullptr || c.is_listed()) return;
    for (std::size_t k = 0; k < c.ways(); ++k) ways_[k] = c.way<double>(k);
    for (std::size_t i = 0; i < c.size(); ++i) points_[i] = c.at<double>(i) - origin;
  }

  [[nodiscard]] Plain at(std::size_t i) const {
    return corners_.polyhedron() != nullptr || corners_.is_listed() ? corners_.at<double>(i) - origin_ : points_[i];
  }
  /// The least corner along a direction, from the one that was found last.
  std::uint32_t least(const Plain& n) {
    if (corners_.polyhedron() != nullptr) return climb(n);
    std::uint32_t best = 0;
    if (corners_.ways() > 0) {
      for (std::uint32_t k = 0; k < corners_.ways(); ++k) best |= arith::dot(ways_[k], n) < 0 ? 1u << k : 0u;
      return best;
    }
    double along = arith::dot(at(0), n);
    for (std::uint32_t i = 1; i < corners_.size(); ++i) {
      const double d = arith::dot(at(i), n);
      if (d < along) best = i, along = d;
    }
    return best;
  }

 private:
  std::uint32_t climb(const Plain& n) {
    double along = arith::dot(at(last_), n);
    for (bool better = true; better;) {  // ends, for `along` falls with each vertex
      better = false;
      for (const std::uint32_t i : corners_.polyhedron()->neighbors_of(last_)) {
        const double d = arith::dot(at(i), n);
        if (d < along) along = d, last_ = i, better = true;
      }
    }
    return last_;
  }

  const CoreCorners& corners_;
  Plain origin_;
  std::array<Plain, 8> points_;
  std::array<Plain, 3> ways_;
  std::uint32_t last_;
};

}  // namespace

DifferenceCorners guessed_nearest(const CoreCorners& a, const CoreCorners& b) {
  DifferenceCorners from;
  from.add({0, 0});
  std::uint32_t rounds = 0;
  return guessed_nearest(a, b, from, rounds);
}

DifferenceCorners guessed_nearest(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& from,
                                  std::uint32_t& rounds) {
  const auto [first_a, first_b] = from.ends[0];
  const Plain origin = a.at<double>(first_a);
  PlainHull p(a, origin, first_a), q(b, origin, first_b);
  return guessed_between(p, q, from, rounds);
}

}  // namespace plumb::query
