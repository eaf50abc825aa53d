// Support mapping in doubles: which corner of a hull is farthest along a direction?  A guess in doubles, which holds no bound.
//
// On a polyhedron it is climbed to from neighbor to neighbor, from the corner that was found last; of a body under a pose the
// direction is turned into the body's own frame, where it stands.
// Laws: what is told is a corner.  `is_given`: the corners are points of doubles as given, and `given(i)` is one;
// `is_running`: they are numbers with their errors, and `running(i)` is one.
// Source: RTCD 9.5.4, 9.5.5, 9.5.6.
// Cost: a product of vectors a corner, or a neighbor on the way.
#pragma once

#include <array>

#include "arith/running_error.hpp"
#include "arith/vec.hpp"
#include "certify/fused.hpp"
#include "query/gjk/quick_scan.hpp"
#include "query/separation/corners.hpp"

namespace plumb::query {

class QuickHull {
 public:
  QuickHull() {}                         // NOLINT: what is by default would be filled with zeros first
  QuickHull(const QuickHull&) = delete;  // it points into itself
  QuickHull& operator=(const QuickHull&) = delete;
  ~QuickHull() = default;

  /// Of the core of what is round.  Not of polygons whose convexity is to be proved, and of what is empty: false.
  bool set(const BodyView& body);
  /// Of any core but of what is swept or under a rigid pose, with the numbers of its corners.
  bool set(const CoreCorners& core);

  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] bool is_given() const { return is_given_; }
  [[nodiscard]] const Point3& given(std::uint32_t i) const { return at_[i]; }
  [[nodiscard]] bool is_running() const { return !is_posed_ && has_errors_; }
  [[nodiscard]] arith::Vec<Running> running(std::uint32_t i) const {
    if (is_given_) return arith::vec<Running>(at_[i]);
    const Point3 &p = few_[i], &off = off_[i];
    return {{p.x, off.x}, {p.y, off.y}, {p.z, off.z}};
  }
  [[nodiscard]] const ConvexPolyhedron3* solid() const { return solid_; }

  [[nodiscard, gnu::always_inline]] arith::Plain at(std::uint32_t i) const {
    const arith::Plain p{at_[i].x, at_[i].y, at_[i].z};
    return is_posed_ ? image(p) + translation_ : p;
  }
  /// The farthest along a direction.
  [[nodiscard]] std::uint32_t farthest(const arith::Plain& along, std::uint32_t last) const {
    const arith::Plain n = is_posed_ ? turned_back(along) : along;
    if (solid_ == nullptr || size_ <= most_scanned) return scanned(n);
    return climbed(n, best_of_some(n, last));
  }
  /// The same, from one that is likely near to it.
  [[nodiscard]] std::uint32_t farthest_from(const arith::Plain& along, std::uint32_t near) const {
    const arith::Plain n = is_posed_ ? turned_back(along) : along;
    constexpr std::uint32_t few = 16;  // a guess: fewer are looked at sooner than neighbors are
    return solid_ == nullptr || size_ < few ? scanned(n) : climbed(n, near);
  }
  /// Is every number of it one?
  [[nodiscard]] bool is_finite() const;
  /// The same, but of a polyhedron, whose numbers are what convex_polyhedron made and are not looked through.
  [[nodiscard]] bool is_finite_but_of_solid() const { return solid_ != nullptr || is_finite(); }
  /// About its middle.
  [[nodiscard]] arith::Plain middle() const {
    const std::uint32_t last = size_ - 1;
    return (at(0) + at(last) + at(last / 3) + at(last - last / 3)) * 0.25;
  }

 private:
  static constexpr std::uint32_t most_scanned = quick_scan::most_at_once;

  bool set_few(const FigureView& figure);
  void take_pose(const AnyPoseView& pose);
  [[nodiscard]] arith::Plain image(const arith::Plain& p) const {
    return columns_[0] * p.x + columns_[1] * p.y + columns_[2] * p.z;
  }
  [[nodiscard]] arith::Plain turned_back(const arith::Plain& n) const {
    return {arith::dot(columns_[0], n), arith::dot(columns_[1], n), arith::dot(columns_[2], n)};
  }
  [[nodiscard]] double reach(std::uint32_t i, const arith::Plain& n) const {
    return at_[i].x * n.x + at_[i].y * n.y + at_[i].z * n.z;
  }
  [[nodiscard, gnu::always_inline]] std::uint32_t scanned(const arith::Plain& n) const {
    if (size_ < 4) return scanned_singly(n);
    if (size_ <= 8) return quick_scan::Scan<quick_scan::PairLanes>(at_, size_, n.x, n.y, n.z).of_eight();
    return has_fma ? quick_scan::farthest_by_fours(at_, size_, n.x, n.y, n.z)
                   : quick_scan::farthest_by_pairs(at_, size_, n.x, n.y, n.z);
  }
  [[nodiscard]] std::uint32_t scanned_singly(const arith::Plain& n) const {
    std::uint32_t best = 0;
    double most = reach(0, n);
    for (std::uint32_t i = 1; i < size_; ++i) {
      const double r = reach(i, n);
      best = r > most ? i : best;
      most = r > most ? r : most;
    }
    return best;
  }
  /// The best of these and some others here and there: a way around a large polyhedron is long.
  [[nodiscard]] std::uint32_t best_of_some(const arith::Plain& n, std::uint32_t best) const {
    constexpr std::uint32_t large = 512;  // guesses, and that 8 others will do, and 16 of a large one
    const std::uint32_t step = size_ >> (size_ < large ? 3 : 4);
    double most = reach(best, n);
    for (std::uint32_t i = step >> 1; i < size_; i += step) {
      const double r = reach(i, n);
      best = r > most ? i : best;
      most = r > most ? r : most;
    }
    return best;
  }
  [[nodiscard]] std::uint32_t climbed(const arith::Plain& n, std::uint32_t from) const {
    double most = reach(from, n);
    for (;;) {  // ends, for `most` grows with each vertex
      std::uint32_t best = from;
      for (const std::uint32_t i : solid_->neighbors_of(from)) {
        const double r = reach(i, n);
        best = r > most ? i : best;
        most = r > most ? r : most;
      }
      if (best == from) return from;
      from = best;
    }
  }

  const Point3* at_ = nullptr;
  const ConvexPolyhedron3* solid_ = nullptr;
  std::uint32_t size_ = 0;
  bool is_given_ = true, is_posed_ = false, has_errors_ = true;
  std::array<arith::Plain, 3> columns_;
  arith::Plain translation_;
  std::array<Point3, 8> few_, off_;
};

}  // namespace plumb::query
