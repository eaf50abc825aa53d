// Support mapping in doubles: which corner of a hull is farthest along a direction?  A guess in doubles, which holds no bound.
//
// On a polyhedron it is climbed to from neighbor to neighbor, from the corner that was found last; of a body under a pose the
// direction is turned into the body's own frame, where it stands.
// Law: what is told is a corner.  `is_given`: the corners are points of doubles as given, and `given(i)` is one.
// Source: RTCD 9.5.4, 9.5.5, 9.5.6.
// Cost: a product of vectors a corner, or a neighbor on the way.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "arith/vec.hpp"
#include "query/separation/corners.hpp"

namespace plumb::query {

class QuickHull {
 public:
  QuickHull() {}                         // NOLINT: what is by default would be filled with zeros first
  QuickHull(const QuickHull&) = delete;  // it points into itself
  QuickHull& operator=(const QuickHull&) = delete;
  ~QuickHull() = default;

  /// Not of what is round, of polygons whose convexity is to be proved, and of what is empty: false.
  bool set(const BodyView& body);
  /// Of any core but of what is swept, with the numbers of its corners.
  bool set(const CoreCorners& core);

  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] bool is_given() const { return is_given_; }
  [[nodiscard]] const Point3& given(std::uint32_t i) const { return at_[i]; }
  [[nodiscard]] const ConvexPolyhedron3* solid() const { return solid_; }

  [[nodiscard]] arith::Plain at(std::uint32_t i) const {
    const arith::Plain p{at_[i].x, at_[i].y, at_[i].z};
    return pose_ == nullptr ? p : image(p) + arith::vec<double>(pose_->translation);
  }
  /// The farthest along a direction.
  [[nodiscard]] std::uint32_t farthest(const arith::Plain& along, std::uint32_t last) const {
    const arith::Plain n = pose_ == nullptr ? along : turned_back(along);
    if (solid_ == nullptr || size_ <= most_scanned) return scanned(n.x, n.y, n.z);
    return climbed(n, best_of_some(n, last));
  }
  /// The same, from one that is likely near to it.
  [[nodiscard]] std::uint32_t farthest_from(const arith::Plain& along, std::uint32_t near) const {
    const arith::Plain n = pose_ == nullptr ? along : turned_back(along);
    return solid_ == nullptr || size_ < 16 ? scanned(n.x, n.y, n.z) : climbed(n, near);
  }
  /// Is every number of it one?
  [[nodiscard]] bool is_finite() const;
  /// About its middle.
  [[nodiscard]] arith::Plain middle() const {
    const std::uint32_t last = size_ - 1;
    return (at(0) + at(last) + at(last / 3) + at(last - last / 3)) * 0.25;
  }

 private:
  static constexpr std::uint32_t most_scanned = 64;

  bool set_few(const FigureView& figure);
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
  // Two doubles, and what was found of them.
  using Two [[gnu::vector_size(16)]] = double;
  using Bits [[gnu::vector_size(16)]] = std::int64_t;
  /// Four points from one place on and four from another, two and two.
  using Block = std::array<Two, 4>;
  struct Along {
    Two x_y, z_x, y_z;
  };
  static Two larger(const Two& a, const Two& b) { return a > b ? a : b; }
  static Two most_of(const Block& b) { return larger(larger(b[0], b[1]), larger(b[2], b[3])); }
  static double more_of(const Two& t) { return t[1] > t[0] ? t[1] : t[0]; }

  /// Of points i and i + 1: (x y) (z x) (y z) times (n.x n.y) (n.z n.x) (n.y n.z).
  [[nodiscard]] Two reaches(std::uint32_t i, const Along& n) const {
    std::array<Two, 3> v;
    std::memcpy(v.data(), at_ + i, sizeof(v));
    const Two first = v[0] * n.x_y, both = v[1] * n.z_x, second = v[2] * n.y_z;
    return (Two{first[0], second[0]} + Two{first[1], second[1]}) + both;
  }
  [[nodiscard]] Block block(std::uint32_t from, std::uint32_t other, const Along& n) const {
    return {reaches(from, n), reaches(from + 2, n), reaches(other, n), reaches(other + 2, n)};
  }
  /// Which of eight is as much as this: the first one, and one of them where there is NaN.
  static std::uint32_t place_of(const Block& b, double most) {
    const Two wanted{most, most};
    const Bits found = ((b[0] == wanted) & Bits{1, 2}) | ((b[1] == wanted) & Bits{4, 8}) |
                       ((b[2] == wanted) & Bits{16, 32}) | ((b[3] == wanted) & Bits{64, 128});
    return static_cast<std::uint32_t>(std::countr_zero(static_cast<std::uint64_t>(found[0] | found[1] | 128)));
  }
  /// First how far all of them are, then which one is that far: nothing waits for a comparison.  The last block ends
  /// where the points end, and begins within the one before it. (By numbers, in registers: pairs of them would wait for
  /// a vector that has just been stored.)
  [[nodiscard]] std::uint32_t scanned(double x, double y, double z) const {
    if (size_ < 4) return scanned_singly({x, y, z});
    const Along along{Two{x, y}, Two{z, x}, Two{y, z}};
    if (size_ <= 8) {
      const std::uint32_t other = size_ - 4;
      const Block b = block(0, other, along);
      const std::uint32_t place = place_of(b, more_of(most_of(b)));
      return place < 4 ? place : other + place - 4;
    }
    if (size_ > most_scanned) return scanned_at_length(along);
    std::array<Block, most_scanned / 8> all;
    std::array<Two, most_scanned / 8> most_in;
    Two most = most_in[0] = most_of(all[0] = block(0, 4, along));
    const std::uint32_t blocks = (size_ + 7) / 8, last = size_ - 8;
    for (std::uint32_t k = 1; k < blocks; ++k) {
      const std::uint32_t from = std::min(8 * k, last);
      most = larger(most_in[k] = most_of(all[k] = block(from, from + 4, along)), most);
    }
    const double far = more_of(most);
    const Two wanted{far, far};
    Bits bit{1, 1}, found{0, 0};
    for (std::uint32_t k = 0; k < blocks; ++k, bit += bit) found |= (most_in[k] == wanted) & bit;
    const auto k = static_cast<std::uint32_t>(
        std::countr_zero(static_cast<std::uint64_t>(found[0] | found[1]) | std::uint64_t{1} << (blocks - 1)));
    return std::min(8 * k, last) + place_of(all[k], far);
  }
  /// The same of many: the best block so far.
  [[nodiscard]] std::uint32_t scanned_at_length(const Along& n) const {
    Block best = block(0, 4, n);
    double far = more_of(most_of(best));
    std::uint32_t best_from = 0;
    for (std::uint32_t from = 8; from < size_; from += 8) {
      const std::uint32_t start = std::min(from, size_ - 8);
      const Block b = block(start, start + 4, n);
      const double most = more_of(most_of(b));
      if (most > far) best = b, far = most, best_from = start;
    }
    return best_from + place_of(best, far);
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
    const std::uint32_t step = size_ >> (size_ < 512 ? 3 : 4);
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
  const Pose* pose_ = nullptr;
  std::uint32_t size_ = 0;
  bool is_given_ = true;
  std::array<Point3, 8> few_;
};

}  // namespace plumb::query
