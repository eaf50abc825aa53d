// A guess in doubles, which holds no bound.
#include "query/separation/corner_search.hpp"

#include "query/gjk/quick_hull.hpp"
#include "query/separation/guessed_corners.hpp"

namespace plumb::query {
namespace {

using arith::Plain;

/// Seen from near to it.
class NearHull {
 public:
  NearHull(const QuickHull& hull, const Plain& origin, std::uint32_t last)
      : hull_(hull), origin_(origin), last_(last) {}
  [[nodiscard]] Plain at(std::uint32_t i) const { return hull_.at(i) - origin_; }
  std::uint32_t least(const Plain& n) { return last_ = hull_.farthest(n * -1, last_); }

 private:
  const QuickHull& hull_;
  Plain origin_;
  std::uint32_t last_;
};

/// What moves or is swept is a list of corners that nobody holds; a polyhedron that moves is climbed.
class MovingHull {
 public:
  MovingHull(const CoreCorners& c, const Plain& origin, std::uint32_t last)
      : corners_(c), origin_(origin), last_(last) {}
  [[nodiscard]] Plain at(std::uint32_t i) const { return corners_.at<double>(i) - origin_; }
  std::uint32_t least(const Plain& n) {
    if (corners_.polyhedron() != nullptr) return climbed(n);
    std::uint32_t best = 0;
    double along = arith::dot(at(0), n);
    for (std::uint32_t i = 1; i < corners_.size(); ++i) {
      const double d = arith::dot(at(i), n);
      if (d < along) best = i, along = d;
    }
    return best;
  }

 private:
  std::uint32_t climbed(const Plain& n) {
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
  std::uint32_t last_;
};

}  // namespace

DifferenceCorners guessed_nearest(const CoreCorners& a, const CoreCorners& b) {
  std::uint32_t rounds = 0;
  return guessed_nearest(a, b, {}, rounds);
}

DifferenceCorners guessed_nearest(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& known,
                                  std::uint32_t& rounds) {
  DifferenceCorners from = known;
  QuickHull p, q;
  const bool are_standing = p.set(a) && q.set(b);
  if (from.size == 0) from.add({0, 0});
  if (known.size == 0 && are_standing) {
    const Plain way = p.middle() - q.middle();
    from.ends[0] = {p.farthest(way * -1, 0), q.farthest(way, 0)};
  }
  const auto [first_a, first_b] = from.ends[0];
  const Plain origin = a.at<double>(first_a);
  if (are_standing) {
    NearHull near_p(p, origin, first_a), near_q(q, origin, first_b);
    return guessed_between(near_p, near_q, from, rounds);
  }
  MovingHull moving_p(a, origin, first_a), moving_q(b, origin, first_b);
  return guessed_between(moving_p, moving_q, from, rounds);
}

}  // namespace plumb::query
