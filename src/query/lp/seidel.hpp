// Linear programming, Seidel's algorithm: the search for the best corner in D = 2 or 3 dimensions, over exact signs.
//
// Three planes infinitely far away (two lines) bound the program where its objective grows, so that there is a best
// corner before the first constraint; an optimum that lies on one of them is none of the program's own.  Ties are broken
// by an objective that is a list of vectors, of which the later ones are infinitely smaller than those before.
// Laws: solve ends with the one best corner, or with constraints that contradict one another, whatever the order.
// Source: Seidel 1991; de Berg and others, Computational Geometry, chapter 4; RTCD 9.4.1.
// Cost: expected some 11 sides a constraint in space, 3 in the plane.
#pragma once

#include <span>

#include "query/lp/corner.hpp"

namespace plumb::query {

template <class Named>
auto lp_plane(const Named& n) {
  const auto normal = numbers_of(n.halfspace.normal);
  return LpPlane<normal.size()>{normal, n.halfspace.offset, 0, n.number};
}

/// What is maximized: direction . x, then less x, then less y, then less z; `sense` 1 instead of -1: more.
template <std::size_t D>
struct LpObjective {
  Numbers<D> direction{};
  double sense = -1;

  [[nodiscard]] Numbers<D> level(std::size_t i) const {
    if (i == 0) return direction;
    Numbers<D> r{};
    r[i - 1] = sense;
    return r;
  }
  static constexpr std::size_t levels = D + 1;
};

template <std::size_t D>
class Seidel {
 public:
  using Plane = LpPlane<D>;
  using Named = typename LpOf<D>::Named;

  /// Of constraints in the order in which they come; no normal is zero.
  Seidel(const LpObjective<D>& objective, std::span<const Named> constraints)
      : objective_(objective), constraints_(constraints) {
    for (std::size_t k = 0; k < D; ++k) {
      sides_[k] = objective.direction[k] != 0 ? (objective.direction[k] > 0 ? 1 : -1) : objective.sense;
      far_[k].normal[k] = sides_[k], far_[k].far = 1;
    }
    Numbers<D> most{};
    for (const Named& c : constraints) {
      const Numbers<D> n = numbers_of(c.halfspace.normal);
      for (std::size_t k = 0; k < D; ++k) most[k] = std::max(most[k], magnitude_of(n[k]));
      most_limit_ = std::max(most_limit_, magnitude_of(c.halfspace.offset));
    }
    most_ = most;
  }

  /// Is there a point that meets all constraints?
  bool solve() {
    if constexpr (D == 2) {
      move({far_[0], far_[1]});
    } else {
      move({far_[0], far_[1], far_[2]});
    }
    for (std::size_t i = 0;; ++i) {
      i = first_violated(i, constraints_.size());
      if (i == constraints_.size()) return true;
      const Plane p = lp_plane(constraints_[i]);
      if constexpr (D == 2) {
        if (!on_line({p}, i)) return false;
      } else {
        if (!on_plane(p, i)) return false;
      }
    }
  }

  /// The best corner, after solve.
  [[nodiscard]] Corner<D>& corner() { return corner_; }
  /// Constraints that contradict one another, where solve has found none.
  [[nodiscard]] std::span<const Plane> contradiction() const { return {contradiction_.data(), contradiction_size_}; }

  /// Has the plane a part in the objective's direction as a sum of the corner's normals?
  [[nodiscard]] Sign weight_of(std::size_t k) const {
    std::array<Numbers<D>, D> rows;
    for (std::size_t i = 0; i < D; ++i) rows[i] = corner_.planes()[i].normal;
    rows[k] = objective_.direction;
    return determinant_sign_of<D>(rows);
  }

 private:
  void move(const std::array<Plane, D>& planes) {
    corner_.set(planes);
    // No number of a constraint is larger than these, so no bound of a constraint's value is larger than theirs.
    safe_ = corner_.has_far() ? 0 : Corner<D>::value(corner_.quick(), most_, most_limit_, [](double x) {
                                      return Approximate(x);
                                    }).reach();
  }

  /// The first of constraints [from, to) that the corner violates; `to` where it violates none.
  std::size_t first_violated(std::size_t from, std::size_t to) {
    if (corner_.has_far()) {
      for (std::size_t i = from; i < to; ++i) {
        if (corner_.side(lp_plane(constraints_[i])) == Sign::positive) return i;
      }
      return to;
    }
    CornerNumbers<double, D> c{};
    for (std::size_t k = 0; k < D; ++k) c.at[k] = corner_.quick().at[k].value;
    c.weight = corner_.quick().weight.value;
    const double safe = -safe_;
    for (std::size_t i = from; i < to; ++i) {
      const auto& h = constraints_[i].halfspace;
      const double value = Corner<D>::value(c, numbers_of(h.normal), h.offset, [](double x) { return x; });
      if (value < safe) continue;  // inside, by more than doubles can be off
      if (corner_.side(lp_plane(constraints_[i])) == Sign::positive) return i;
    }
    return to;
  }

  bool contradict(std::initializer_list<Plane> planes) {
    contradiction_size_ = 0;
    for (const Plane& p : planes) contradiction_[contradiction_size_++] = p;
    return false;
  }

  /// The best corner in the plane of constraint `count`, of those before it.
  bool on_plane(const Plane& plane, std::size_t count) requires(D == 3) {
    move(far_corner(plane));
    for (std::size_t j = 0;; ++j) {
      j = first_violated(j, count);
      if (j == count) return true;
      if (!on_line({plane, lp_plane(constraints_[j])}, j)) return false;
    }
  }

  /// Where the plane cuts an edge of the planes far away with the least loss.
  std::array<Plane, 3> far_corner(const Plane& plane) const requires(D == 3) {
    const auto rise = sign_over_all([&](const auto& maker) {  // of the plane's value at the far corner
      return maker(plane.normal[0]) * maker(sides_[0]) + maker(plane.normal[1]) * maker(sides_[1]) +
             maker(plane.normal[2]) * maker(sides_[2]);
    });
    const bool beyond = rise == Sign::positive || (rise == Sign::zero && plane.limit < 0);
    const bool at_corner = rise == Sign::zero && plane.limit == 0;
    std::size_t best = 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const double along = plane.normal[k] * sides_[k];
      if (along == 0 || (!at_corner && (along > 0) != beyond)) continue;
      if (best == 3 || loses_less(plane, k, best)) best = k;
    }
    return {plane, far_[(best + 1) % 3], far_[(best + 2) % 3]};
  }
  /// On the edge along axis i: what it loses a unit, over how soon it meets the plane.
  bool loses_less(const Plane& plane, std::size_t i, std::size_t j) const {
    for (std::size_t level = 0; level < objective_.levels; ++level) {
      const Numbers<D> g = objective_.level(level);
      const Sign s = sign_over_all([&](const auto& maker) {
        return maker(g[i] * sides_[i]) * maker(magnitude_of(plane.normal[j])) -
               maker(g[j] * sides_[j]) * maker(magnitude_of(plane.normal[i]));
      });
      if (s != Sign::zero) return s == Sign::negative;
    }
    return false;
  }

  /// The way along the line of D - 1 planes.
  template <class Maker>
  static auto way(const std::array<Plane, D - 1>& line, const Maker& maker) {
    if constexpr (D == 2) {
      return std::array{maker(line[0].normal[1]), maker(-line[0].normal[0])};
    } else {
      return cross3(made<3>(maker, line[0].normal), made<3>(maker, line[1].normal));
    }
  }
  static Sign along(const std::array<Plane, D - 1>& line, const Numbers<D>& v) {
    return sign_over_all([&](const auto& maker) { return dot_of(made<D>(maker, v), way(line, maker)); });
  }
  static std::array<Plane, D> with(const std::array<Plane, D - 1>& line, const Plane& p) {
    std::array<Plane, D> r{};
    for (std::size_t k = 0; k + 1 < D; ++k) r[k] = line[k];
    r[D - 1] = p;
    return r;
  }

  /// The best corner on a line, of the constraints before `count`.
  bool on_line(const std::array<Plane, D - 1>& line, std::size_t count) {
    Sign up = Sign::zero;  // the turn of the way on which the objective grows
    for (std::size_t level = 0; up == Sign::zero && level < objective_.levels; ++level)
      up = along(line, objective_.level(level));
    if (up == Sign::zero) {  // parallel planes
      if constexpr (D == 3) return contradict({line[0], line[1]});
    }
    bool has_end = false;
    for (const Plane& p : far_) {
      if (along(line, p.normal) != up) continue;  // it bounds the way up nowhere
      if (!has_end || corner_.side(p) == Sign::positive) move(with(line, p));
      has_end = true;
    }
    std::size_t last = 0;  // constraints before it have been asked at an earlier corner
    for (std::size_t k = 0;; ++k) {
      k = first_violated(k, count);
      if (k == count) break;
      const Plane p = lp_plane(constraints_[k]);
      if (along(line, p.normal) != up) return contradict_on(line, p);
      move(with(line, p));
      last = k;
    }
    const std::size_t below = first_violated(0, last);
    return below == last || contradict_on(line, lp_plane(constraints_[below]));
  }
  /// Of a constraint that leaves nothing of the line, or nothing below the corner.
  bool contradict_on(const std::array<Plane, D - 1>& line, const Plane& p) {
    const bool parallel = along(line, p.normal) == Sign::zero;
    contradiction_size_ = 0;
    for (const Plane& l : line) contradiction_[contradiction_size_++] = l;
    contradiction_[contradiction_size_++] = p;
    if (parallel) return false;
    for (const Plane& c : corner_.planes()) {  // the one that ends the line
      bool in_line = false;
      for (const Plane& l : line) in_line = in_line || l.number == c.number;
      if (!in_line) contradiction_[contradiction_size_++] = c;
    }
    return false;
  }

  LpObjective<D> objective_;
  std::span<const Named> constraints_;
  Numbers<D> sides_{};
  std::array<Plane, D> far_{};
  Numbers<D> most_{};
  double most_limit_ = 0, safe_ = 0;
  Corner<D> corner_;
  std::array<Plane, D + 1> contradiction_{};
  std::size_t contradiction_size_ = 0;
};

}  // namespace plumb::query
