// Support mapping in doubles: which corner of a hull is farthest along a direction?  A guess in doubles, which holds no bound.
//
// On a polyhedron it is climbed to from neighbor to neighbor, from the corner that was found last; of a body under a pose the
// direction is turned into the body's own frame, where it stands.
// Law: what is told is a corner.  `is_given`: the corners are points of doubles as given, and `given(i)` is one.
// Source: RTCD 9.5.4, 9.5.5, 9.5.6.
// Cost: a product of vectors a corner, or a neighbor on the way.
#pragma once

#include <array>
#include <optional>

#include "arith/vec.hpp"
#include "query/separation/corners.hpp"

namespace plumb::query {

class QuickHull {
 public:
  /// Nothing of what is round, of polygons whose convexity is to be proved, and of what is empty.
  static std::optional<QuickHull> of(const BodyView& body);
  /// Of a body that has been looked at, which may be a polygon; that and what it is of must live on.
  static std::optional<QuickHull> of_sound(const BodyView& body);

  QuickHull(const QuickHull& h) { *this = h; }
  QuickHull& operator=(const QuickHull& h) {
    solid_ = h.solid_, pose_ = h.pose_, size_ = h.size_, is_given_ = h.is_given_;
    if (h.at_ == h.few_.data()) {
      for (std::uint32_t i = 0; i < size_; ++i) few_[i] = h.few_[i];
      at_ = few_.data();
    } else {
      at_ = h.at_;
    }
    return *this;
  }
  ~QuickHull() = default;

  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] bool is_given() const { return is_given_; }
  [[nodiscard]] const Point3& given(std::uint32_t i) const { return at_[i]; }
  [[nodiscard]] const ConvexPolyhedron3* solid() const { return solid_; }

  [[nodiscard]] arith::Plain at(std::uint32_t i) const {
    const arith::Plain p{at_[i].x, at_[i].y, at_[i].z};
    return pose_ == nullptr ? p : image(p) + arith::vec<double>(pose_->translation);
  }
  /// The farthest along n, from one of them.
  [[nodiscard]] std::uint32_t farthest(const arith::Plain& along, std::uint32_t from) const {
    const arith::Plain n = pose_ == nullptr ? along : turned_back(along);
    return solid_ != nullptr && size_ > most_scanned ? climbed(n, from) : scanned(n);
  }
  /// About its middle.
  [[nodiscard]] arith::Plain middle() const {
    const std::uint32_t last = size_ - 1;
    return (at(0) + at(last) + at(last / 3) + at(last - last / 3)) * 0.25;
  }

 private:
  static constexpr std::uint32_t most_scanned = 12;
  QuickHull() = default;

  [[nodiscard]] arith::Plain image(const arith::Plain& p) const {
    const auto& [u, v, w] = pose_->columns;
    return {u.x * p.x + v.x * p.y + w.x * p.z, u.y * p.x + v.y * p.y + w.y * p.z, u.z * p.x + v.z * p.y + w.z * p.z};
  }
  [[nodiscard]] arith::Plain turned_back(const arith::Plain& n) const {
    const auto along = [&](const Vector3& c) { return c.x * n.x + c.y * n.y + c.z * n.z; };
    return {along(pose_->columns[0]), along(pose_->columns[1]), along(pose_->columns[2])};
  }
  [[nodiscard]] double reach(std::uint32_t i, const arith::Plain& n) const {
    return at_[i].x * n.x + at_[i].y * n.y + at_[i].z * n.z;
  }
  [[nodiscard]] std::uint32_t scanned(const arith::Plain& n) const {
    std::uint32_t best = 0;
    double most = reach(0, n);
    for (std::uint32_t i = 1; i < size_; ++i) {
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
  const Pose* pose_ = nullptr;
  std::uint32_t size_ = 0;
  bool is_given_ = true;
  std::array<Point3, 8> few_;
};

}  // namespace plumb::query
