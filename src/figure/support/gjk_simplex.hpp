// Which points of a difference of convex hulls are nearest to the origin?  The simplex of Gilbert, Johnson and Keerthi,
// in doubles: a guess for what is proved after it.
//
// Laws: the corners kept are those that the nearest point needs, as far as doubles tell; four are kept where the origin
// is among them.  What a corner is the difference of goes along with it.
// Source: Gilbert, Johnson and Keerthi 1988; RTCD 9.5, 9.5.4, 5.1.2, 5.1.5, 5.1.6.
// Cost: up to some 200 operations a corner.
#pragma once

#include <array>
#include <span>

#include "arith/vec.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb::figure::gjk {

using arith::Plain;

template <class Ends>
class Simplex {
 public:
  struct Corner {
    Ends ends;
    Plain at;
    double weight = 1;
  };

  explicit Simplex(const Corner& first) : size_(1) { corners_[0] = first; }

  [[nodiscard]] std::span<const Corner> corners() const { return {corners_.data(), size_}; }
  [[nodiscard]] bool is_full() const { return size_ == corners_.size(); }
  [[nodiscard]] Plain nearest() const {
    Plain x{0, 0, 0};
    for (const Corner& c : corners()) x = x + c.at * c.weight;
    return x;
  }

  /// Adds a corner and keeps those that the nearest point needs.
  void add(const Corner& c) {
    corners_[size_++] = c;
    switch (size_) {
      case 2:
        keep(edge(0, 1));
        break;
      case 3:
        keep(triangle(0, 1, 2));
        break;
      default:
        keep(tetrahedron());
    }
  }

 private:
  struct Part {
    std::array<std::size_t, 4> index;
    std::array<double, 4> weight;
    std::size_t size;
  };

  [[nodiscard]] Part edge(std::size_t i, std::size_t j) const {
    const Plain &p = corners_[i].at, d = corners_[j].at - p;
    const double along = -arith::dot(p, d), square = arith::dot(d, d);
    if (!(along > 0)) return {{i}, {1}, 1};
    if (!(along < square)) return {{j}, {1}, 1};
    const double t = along / square;
    return {{i, j}, {1 - t, t}, 2};
  }

  // The regions of RTCD 5.1.5, seen from the origin.
  [[nodiscard]] Part triangle(std::size_t i, std::size_t j, std::size_t k) const {
    const Plain &a = corners_[i].at, &b = corners_[j].at, &c = corners_[k].at;
    const Plain ab = b - a, ac = c - a;
    const double d1 = -arith::dot(ab, a), d2 = -arith::dot(ac, a);
    if (d1 <= 0 && d2 <= 0) return {{i}, {1}, 1};
    const double d3 = -arith::dot(ab, b), d4 = -arith::dot(ac, b);
    if (d3 >= 0 && d4 <= d3) return {{j}, {1}, 1};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return edge(i, j);
    const double d5 = -arith::dot(ab, c), d6 = -arith::dot(ac, c);
    if (d6 >= 0 && d5 <= d6) return {{k}, {1}, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return edge(i, k);
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) return edge(j, k);
    const double whole = 1 / (va + vb + vc), v = vb * whole, w = vc * whole;
    return {{i, j, k}, {1 - v - w, v, w}, 3};
  }

  [[nodiscard]] double square_of(const Part& part) const {
    Plain x{0, 0, 0};
    for (std::size_t i = 0; i < part.size; ++i) x = x + corners_[part.index[i]].at * part.weight[i];
    return arith::dot(x, x);
  }

  [[nodiscard]] Part tetrahedron() const {
    constexpr std::array<std::array<std::size_t, 4>, 4> faces{{{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}};
    Part best{};
    double least = -1;
    std::array<double, 4> weight{};
    double sum = 0;
    bool inside = true;
    for (const auto& [i, j, k, off] : faces) {
      const Plain &a = corners_[i].at, n = arith::cross(corners_[j].at - a, corners_[k].at - a);
      const double height = arith::dot(n, corners_[off].at - a), origin = -arith::dot(n, a);
      weight[off] = height == 0 ? 0 : origin / height;
      sum += weight[off];
      if (weight[off] > 0) continue;
      inside = false;
      const Part part = triangle(i, j, k);
      const double square = square_of(part);
      if (least < 0 || square < least) best = part, least = square;
    }
    if (!inside) return best;
    for (double& w : weight) w /= sum;
    return {{0, 1, 2, 3}, weight, 4};
  }

  void keep(const Part& part) {
    std::array<Corner, 4> kept{};
    for (std::size_t i = 0; i < part.size; ++i) {
      kept[i] = corners_[part.index[i]];
      kept[i].weight = part.weight[i];
    }
    corners_ = kept;
    size_ = part.size;
  }

  std::array<Corner, 4> corners_{};
  std::size_t size_;
};

/// Is the origin strictly inside of a tetrahedron?  By sign(i, j, k), that of the triple product of three corners; zero
/// where it is not certain.
template <class TripleSign>
bool is_around_origin(TripleSign sign) {
  const Sign first = sign(1, 2, 3);
  return first != Sign::zero && sign(2, 3, 0) == -first && sign(3, 0, 1) == first && sign(0, 1, 2) == -first;
}

}  // namespace plumb::figure::gjk
