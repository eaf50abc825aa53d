// Linear programming, Seidel's algorithm: the search for the best corner in D = 2 or 3 dimensions, over exact signs.
//
// Three planes infinitely far away (two lines) bound the program where its objective grows, so that there is a best
// corner before the first constraint; an optimum that lies on one of them is none of the program's own.  Ties are
// broken by an objective that is a list of vectors, of which the later ones are infinitely smaller than those before.
// Where a constraint is violated, the search in its plane starts at the best corner there of those that met in the
// corner before.
// Laws: solve ends with the one best corner, or with constraints that contradict one another, whatever the order.
// Source: Seidel 1991; de Berg and others, Computational Geometry, chapter 4; RTCD 9.4.1.
// Cost: expected some 11 sides a constraint in space, 3 in the plane.
#pragma once

#include <span>

#include "query/lp/corner.hpp"

namespace plumb::query {

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
    for (const Named& c : constraints) largest_.take(c.halfspace);
    for (std::size_t k = 0; k < D; ++k) {
      sides_[k] = objective.direction[k] != 0 ? (objective.direction[k] > 0 ? 1 : -1) : objective.sense;
      far_[k].normal[k] = sides_[k], far_[k].far = 1;
    }
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
        if (!on_line({p}, i, far_)) return false;
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
  void move(const std::array<Plane, D>& planes) { corner_.set(planes); }

  /// What is infinitely far away is violated by no point that is not.
  bool is_violated(const Plane& p) {
    if (p.far != 0 && !corner_.has_far()) return false;
    return corner_.side(p) == Sign::positive;
  }

  std::size_t first_violated(std::size_t from, std::size_t to) {
    return query::first_violated(corner_, largest_, constraints_, from, to);
  }

  bool contradict(std::span<const Plane> planes, const Plane& last) {
    std::copy(planes.begin(), planes.end(), contradiction_.begin());
    contradiction_[planes.size()] = last;
    contradiction_size_ = planes.size() + 1;
    return false;
  }

  /// The best corner in a plane that the corner violates, of the constraints before `count`.
  bool on_plane(const Plane& plane, std::size_t count) requires(D == 3) {
    const std::array<Plane, 3> before = corner_.planes();
    const std::size_t drop = dropped(plane);
    if (drop == 3) return contradict(before, plane);
    const std::array<Plane, 5> kept{before[(drop + 1) % 3], before[(drop + 2) % 3], far_[0], far_[1], far_[2]};
    move({plane, kept[0], kept[1]});
    for (std::size_t k = 2; k < kept.size(); ++k) {
      if (is_violated(kept[k]) && !on_line({plane, kept[k]}, 0, std::span(kept).first(k))) return false;
    }
    for (std::size_t j = 0;; ++j) {
      j = first_violated(j, count);
      if (j == count) return true;
      if (!on_line({plane, lp_plane(constraints_[j])}, j, kept)) return false;
    }
  }

  /// Which plane of the corner does the best corner in this plane, of those of the corner alone, do without?  The
  /// normal is a sum of theirs, and so is the objective; it is the one whose weight in the objective is least, over
  /// that in the normal, of those of weight above zero in the normal (the ratio test of the dual simplex method).  With
  /// three planes p, q, r of positive determinant the ratio of p less that of q has the sign of det(objective, normal,
  /// r). Three where there is none: the plane contradicts them.
  [[nodiscard]] std::size_t dropped(const Plane& plane) const requires(D == 3) {
    const std::array<Plane, 3>& p = corner_.planes();
    std::size_t best = 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const Sign weight = determinant_sign_of<3>({plane.normal, p[(k + 1) % 3].normal, p[(k + 2) % 3].normal});
      if (weight != Sign::positive) continue;
      if (best == 3 || is_less_ratio(k, best, plane)) best = k;
    }
    return best;
  }
  [[nodiscard]] bool is_less_ratio(std::size_t i, std::size_t j, const Plane& plane) const requires(D == 3) {
    const std::size_t third = 3 - i - j;
    const Sign turn = (i + 1) % 3 == j ? Sign::positive : Sign::negative;
    for (std::size_t level = 0; level < objective_.levels; ++level) {
      const Sign s =
          determinant_sign_of<3>({objective_.level(level), plane.normal, corner_.planes()[third].normal}) * turn;
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

  /// The best corner on a line, of the constraints before `count` and those that are kept.  Before, the corner is the
  /// best of the same constraints in the plane, or in all, and violates the last plane of the line.
  bool on_line(const std::array<Plane, D - 1>& line, std::size_t count, std::span<const Plane> kept) {
    Sign up = Sign::zero;  // the turn of the way on which the objective grows
    for (std::size_t level = 0; up == Sign::zero && level < objective_.levels; ++level)
      up = along(line, objective_.level(level));
    if (up == Sign::zero) return contradict(std::span(line).first(D - 2), line[D - 2]);  // parallel planes
    const std::array<Plane, D> before = corner_.planes();
    bool has_end = false;
    for (const Plane& p : before) {  // those that ended the plane end the line
      if (p.number == line[0].number || along(line, p.normal) != up) continue;
      if (!has_end || corner_.side(p) == Sign::positive) move(with(line, p));
      has_end = true;
    }
    for (const Plane& p : kept) {
      if (!is_violated(p)) continue;
      if (along(line, p.normal) != up) return contradict_on(line, p);
      move(with(line, p));
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
    // What bounds the other way may be violated by now: of those that are kept the constraints that ended the plane,
    // which may come after `count`.  They would be asked in their turn, but the corner would not be the best of those
    // before until then, and constraints be named that do not contradict one another.
    for (const Plane& p : kept) {
      if (is_violated(p)) return contradict_on(line, p);
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
  LargestNumbers<D> largest_;
  Corner<D> corner_;
  std::array<Plane, D + 1> contradiction_{};
  std::size_t contradiction_size_ = 0;
};

}  // namespace plumb::query
