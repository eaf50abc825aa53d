#include "near_pair.hpp"

#include <array>

namespace plumb::query {
namespace {

using Plain = core::Vec<double>;

Plain plain(const Vertex& v) { return {v.x.value, v.y.value, v.z.value}; }

/// Points of the difference of the hulls, with the weights of their nearest point to the origin.
class Simplex {
 public:
  struct Corner {
    std::size_t a, b;
    Plain at;
    double weight;
  };

  explicit Simplex(const Corner& first) : size_(1) { corners_[0] = first; }

  [[nodiscard]] std::span<const Corner> corners() const { return {corners_.data(), size_}; }
  [[nodiscard]] bool is_full() const { return size_ == corners_.size(); }
  [[nodiscard]] bool has(std::size_t a, std::size_t b) const {
    for (const Corner& c : corners()) {
      if (c.a == a && c.b == b) return true;
    }
    return false;
  }
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
    const double along = -core::dot(p, d), square = core::dot(d, d);
    if (!(along > 0)) return {{i}, {1}, 1};
    if (!(along < square)) return {{j}, {1}, 1};
    const double t = along / square;
    return {{i, j}, {1 - t, t}, 2};
  }

  // The regions of RTCD 5.1.5, seen from the origin.
  [[nodiscard]] Part triangle(std::size_t i, std::size_t j, std::size_t k) const {
    const Plain &a = corners_[i].at, &b = corners_[j].at, &c = corners_[k].at;
    const Plain ab = b - a, ac = c - a;
    const double d1 = -core::dot(ab, a), d2 = -core::dot(ac, a);
    if (d1 <= 0 && d2 <= 0) return {{i}, {1}, 1};
    const double d3 = -core::dot(ab, b), d4 = -core::dot(ac, b);
    if (d3 >= 0 && d4 <= d3) return {{j}, {1}, 1};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return edge(i, j);
    const double d5 = -core::dot(ab, c), d6 = -core::dot(ac, c);
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
    return core::dot(x, x);
  }

  [[nodiscard]] Part tetrahedron() const {
    constexpr std::array<std::array<std::size_t, 4>, 4> faces{{{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}};
    Part best{};
    double least = -1;
    std::array<double, 4> weight{};
    double sum = 0;
    bool inside = true;
    for (const auto& [i, j, k, off] : faces) {
      const Plain &a = corners_[i].at, n = core::cross(corners_[j].at - a, corners_[k].at - a);
      const double height = core::dot(n, corners_[off].at - a), origin = -core::dot(n, a);
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

class Search {
 public:
  Search(std::span<const Vertex> a, std::span<const Vertex> b, double radius_a, double radius_b)
      : a_(a), b_(b), reach_(Running(radius_a) + Running(radius_b)) {}

  std::optional<Sign> run() const {
    constexpr int most_rounds = 32;
    constexpr double near = 1 - 0x1p-30, far = 1 + 0x1p-30;  // beyond them a proof is likely
    const double square = reach_.value * reach_.value;
    Simplex simplex({0, 0, plain(a_[0]) - plain(b_[0]), 1});
    for (int round = 0; round < most_rounds; ++round) {
      const Plain x = simplex.nearest();
      const double xx = core::dot(x, x);
      if (xx < square * near) return proved_near(simplex);
      const auto [i, j] = extremes(x);
      const Plain w = plain(a_[i]) - plain(b_[j]);
      const double least = core::dot(x, w);
      if (least > 0 && least * least > square * xx * far) return proved_far(x);
      if (simplex.has(i, j) || !(least < xx)) {
        if (xx < square) return proved_near(simplex);
        return proved_far(x);
      }
      if (simplex.is_full()) return {};  // about the origin, but for roundings
      simplex.add({i, j, w, 1});
    }
    return {};
  }

 private:
  [[nodiscard]] std::pair<std::size_t, std::size_t> extremes(const Plain& n) const {
    const auto first = [&n](std::span<const Vertex> all, double sign) {
      std::size_t best = 0;
      double least = sign * core::dot(n, plain(all[0]));
      for (std::size_t i = 1; i < all.size(); ++i) {
        const double along = sign * core::dot(n, plain(all[i]));
        if (along < least) best = i, least = along;
      }
      return best;
    };
    return {first(a_, 1), first(b_, -1)};
  }

  // With weights w_k >= 0 the sum of w_k (a_k - b_k) over that of w_k is the way between points of the hulls.
  [[nodiscard]] std::optional<Sign> proved_near(const Simplex& simplex) const {
    Vertex way;
    Running whole;
    for (const Simplex::Corner& c : simplex.corners()) {
      if (!(c.weight >= 0)) return {};
      const Running weight(c.weight);
      way = way + (a_[c.a] - b_[c.b]) * weight;
      whole = whole + weight;
    }
    const Running reach = reach_ * whole;
    const Unsure<Sign> s = (core::dot(way, way) - reach * reach).sign();
    if (s.certain() && s.value() == Sign::negative) return Sign::negative;
    return {};
  }

  // Every n . (x - y) is at least the gap, and the gap's square is more than that of |n| times the radii.
  [[nodiscard]] std::optional<Sign> proved_far(const Plain& direction) const {
    const Vertex n{Running(direction.x), Running(direction.y), Running(direction.z)};
    const Vertex& from = b_[0];
    double above = 0, below = core::dot(n, a_[0] - from).lower();
    for (const Vertex& y : b_.subspan(1)) {
      const double top = core::dot(n, y - from).upper();
      if (!(top <= above)) above = top;
    }
    for (const Vertex& x : a_.subspan(1)) {
      const double bottom = core::dot(n, x - from).lower();
      if (!(bottom >= below)) below = bottom;
    }
    if (!(below > above)) return {};
    const Running gap = Running(below) - Running(above);
    const Unsure<Sign> s = (gap * gap - reach_ * reach_ * core::dot(n, n)).sign();
    if (s.certain() && s.value() == Sign::positive) return Sign::positive;
    return {};
  }

  std::span<const Vertex> a_, b_;
  Running reach_;
};

}  // namespace

std::optional<Sign> quick_gap(std::span<const Vertex> a, std::span<const Vertex> b, double radius_a, double radius_b) {
  return Search(a, b, radius_a, radius_b).run();
}

}  // namespace plumb::query
