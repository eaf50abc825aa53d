#include "plumb/query/lp/linear_program.hpp"

#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/certify/checked.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "query/lp/corner_point.hpp"
#include "query/lp/guessed_corner.hpp"
#include "query/lp/seidel.hpp"
#include "query/lp/shuffle.hpp"

namespace plumb {
namespace query {
namespace {

constexpr std::size_t most_constraints = no_constraint - 1;

template <std::size_t D>
bool is_zero_normal(const Numbers<D>& n) {
  for (const double x : n) {
    if (x != 0) return false;
  }
  return true;
}

inline Vector2 to_vector(const Numbers<2>& n) { return {n[0], n[1]}; }
inline Vector3 to_vector(const Numbers<3>& n) { return {n[0], n[1], n[2]}; }
inline Point2 to_point(const Numbers<2>& n) { return {n[0], n[1]}; }
inline Point3 to_point(const Numbers<3>& n) { return {n[0], n[1], n[2]}; }

/// A program, and the ways in which it is asked.
template <std::size_t D>
class LinearProgram {
 public:
  using Of = LpOf<D>;
  using Named = typename Of::Named;
  using Answer = typename Of::Answer;
  using Plane = LpPlane<D>;

  LinearProgram(const typename Of::Vector& direction, std::span<const typename Of::Halfspace> given,
                std::vector<Named>& scratch)
      : given_(given), scratch_(scratch) {
    answer_.direction = direction;
  }

  /// By a guess, where it can be proved by weights above zero: then no other constraints decide.
  bool solve_as_guessed() {
    LargestNumbers<D> largest;
    for (const auto& h : given_) largest.take(h);
    const auto guess = guess_corner<D>(numbers_of(answer_.direction), given_, largest.normal, largest.limit);
    using Kind = typename GuessedCorner<D>::Kind;
    if (guess.kind == Kind::none) return false;
    std::array<Plane, D> planes;
    std::array<Numbers<D>, D> normals;
    for (std::size_t k = 0; k < D; ++k) {
      planes[k] = lp_plane(named(guess.constraints[k]));
      normals[k] = planes[k].normal;
    }
    if (determinant_sign_of<D>(normals) == Sign::zero) return false;
    Corner<D> corner;
    corner.set(planes);
    const bool is_optimal = guess.kind == Kind::corner;
    const Plane last = is_optimal ? Plane{} : lp_plane(named(guess.constraints[D]));
    for (std::size_t k = 0; k < D; ++k) {  // the weights of the sum: the direction, or the last normal turned round
      for (std::size_t i = 0; i < D; ++i) normals[i] = corner.planes()[i].normal;
      normals[k] = is_optimal ? numbers_of(answer_.direction) : last.normal;
      if (determinant_sign_of<D>(normals) != (is_optimal ? Sign::positive : Sign::negative)) return false;
    }
    if (is_optimal ? first_violated(corner, largest, given_, 0, given_.size()) != given_.size()
                   : corner.side(last) != Sign::positive)
      return false;
    std::array<std::uint32_t, D + 1> numbers = guess.constraints;
    answer_.deciding_count = D + (is_optimal ? 0 : 1);
    std::sort(numbers.begin(), numbers.begin() + answer_.deciding_count);
    for (std::size_t k = 0; k < answer_.deciding_count; ++k) answer_.deciding[k] = named(numbers[k]);
    answer_.kind = is_optimal ? LinearKind::optimal : LinearKind::infeasible;
    answer_.is_unique = is_optimal;
    if (is_optimal) keep_corner(corner);
    return true;
  }

  Answer solve(std::uint64_t seed) {
    if (solve_as_guessed() || !read()) return answer_;
    shuffle(std::span(scratch_), seed);
    Seidel<D> search(objective(), scratch_);
    const bool is_feasible = search.solve();
    if (is_feasible && !search.corner().has_far()) {
      keep_weights(search);
      if (seed == 0 || tight(search.corner()).size() == D) {
        keep_corner(search.corner());
        answer_.is_unique = answer_.deciding_count == D || is_only(search.corner());
        return answer_;
      }
    }
    if (seed != 0) return LinearProgram(answer_.direction, given_, scratch_).solve(0);  // what is named has one order
    if (!is_feasible) {
      keep_contradiction(search.contradiction());
    } else if (search.corner().far_along(numbers_of(answer_.direction)) == Sign::positive) {
      keep_ray(search.corner());
    } else {
      keep_weights(search);
      keep_first_of_unbounded();
    }
    return answer_;
  }

 private:
  [[nodiscard]] LpObjective<D> objective() const { return {numbers_of(answer_.direction)}; }

  /// The constraints that are planes; false where one that is none holds nowhere.
  bool read() {
    scratch_.clear();
    scratch_.reserve(given_.size());
    for (std::size_t i = 0; i < given_.size(); ++i) {
      const Numbers<D> n = numbers_of(given_[i].normal);
      if (!is_zero_normal<D>(n)) {
        scratch_.push_back(named(static_cast<std::uint32_t>(i)));
      } else if (given_[i].offset < 0) {
        answer_.kind = LinearKind::infeasible;
        answer_.deciding[0] = named(static_cast<std::uint32_t>(i));
        answer_.deciding_count = 1;
        return false;
      }
    }
    return true;
  }

  /// Of the optimum: the constraints whose normals have the direction as a sum with weights above zero.
  void keep_weights(Seidel<D>& search) {
    const Corner<D>& corner = search.corner();
    answer_.deciding_count = 0;
    std::array<std::uint32_t, D> numbers{};
    for (std::size_t k = 0; k < D; ++k) {  // ascending, by insertion
      if (search.weight_of(k) != Sign::positive) continue;
      std::size_t at = answer_.deciding_count++;
      for (; at > 0 && numbers[at - 1] > corner.planes()[k].number; --at) numbers[at] = numbers[at - 1];
      numbers[at] = corner.planes()[k].number;
    }
    for (std::size_t k = 0; k < answer_.deciding_count; ++k) answer_.deciding[k] = named(numbers[k]);
  }
  [[nodiscard]] Named named(std::uint32_t number) const { return {given_[number], number}; }

  void keep_corner(const Corner<D>& corner) {
    for (std::size_t k = 0; k < D; ++k) {
      const Plane& p = corner.planes()[k];
      answer_.corner[k] = {{to_vector(p.normal), p.limit}, p.number};
    }
    std::sort(answer_.corner.begin(), answer_.corner.end(),
              [](const Named& a, const Named& b) { return a.number < b.number; });
    std::array<typename Of::Halfspace, D> planes;
    for (std::size_t k = 0; k < D; ++k) planes[k] = answer_.corner[k].halfspace;
    answer_.at = to_point(nearest_corner<D>(planes));
  }

  [[nodiscard]] std::vector<Named> tight(Corner<D>& corner) const {
    std::vector<Named> r;
    for (const Named& n : scratch_) {
      if (corner.side(lp_plane(n)) == Sign::zero) r.push_back(n);
    }
    return r;
  }
  /// Is the first of the optimal points the last one, too?  It is where it is so of the constraints that meet there.
  [[nodiscard]] bool is_only(Corner<D>& corner) const {
    const std::vector<Named> there = tight(corner);
    Seidel<D> opposite({numbers_of(answer_.direction), 1}, there);
    opposite.solve();
    if (opposite.corner().has_far()) return false;
    for (const Plane& p : corner.planes()) {
      if (opposite.corner().side(p) != Sign::zero) return false;
    }
    return true;
  }

  /// Those of them that have a weight.
  void keep_contradiction(std::span<const Plane> planes) {
    std::vector<Plane> kept(planes.begin(), planes.end());
    for (std::size_t i = 0; i < kept.size();) {
      std::vector<Numbers<D>> others;
      for (std::size_t j = 0; j < kept.size(); ++j) {
        if (j != i) others.push_back(kept[j].normal);
      }
      if (are_independent(others)) {
        ++i;
      } else {
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    std::sort(kept.begin(), kept.end(), [](const Plane& a, const Plane& b) { return a.number < b.number; });
    answer_.kind = LinearKind::infeasible;
    answer_.deciding_count = static_cast<std::uint32_t>(kept.size());
    for (std::size_t k = 0; k < kept.size(); ++k) answer_.deciding[k] = named(kept[k].number);
  }
  static bool are_independent(const std::vector<Numbers<D>>& v) {
    if (v.size() == D) {
      std::array<Numbers<D>, D> rows;
      std::copy(v.begin(), v.end(), rows.begin());
      return determinant_sign_of<D>(rows) != Sign::zero;
    }
    if (v.size() < 2) return true;
    for (std::size_t k = 0; k < D; ++k) {  // two of space: a component of their cross product
      const std::size_t i = (k + 1) % D, j = (k + 2) % D;
      if (determinant_sign_of<2>({Numbers<2>{v[0][i], v[0][j]}, Numbers<2>{v[1][i], v[1][j]}}) != Sign::zero)
        return true;
    }
    return false;
  }

  /// The way on which the best corner of a program with planes far away goes with them.
  void keep_ray(const Corner<D>& corner) {
    std::array<typename Of::Halfspace, D> planes;
    for (std::size_t k = 0; k < D; ++k) planes[k] = {to_vector(corner.planes()[k].normal), corner.planes()[k].far};
    std::sort(planes.begin(), planes.end(), [](const auto& a, const auto& b) {
      return std::pair(numbers_of(a.normal), a.offset) < std::pair(numbers_of(b.normal), b.offset);
    });
    const typename Of::Vector direction = answer_.direction;
    answer_ = LinearProgram({}, given_, scratch_).solve(0);  // a feasible point
    answer_.kind = LinearKind::unbounded;
    answer_.is_unique = false;
    answer_.deciding_count = 0;
    answer_.deciding = {};
    answer_.direction = direction;
    answer_.ray = to_vector(nearest_corner<D>(planes));
    if constexpr (D == 2) {
      answer_.ray_lines = planes;
    } else {
      answer_.ray_planes = planes;
    }
  }

  /// Of optimal points that have no lexicographically first: coordinate by coordinate, within those that are left.
  /// What decides a program holds with equality where it is optimal, so it is turned round and added.
  void keep_first_of_unbounded() {
    std::vector<Named> rows;  // their numbers are their places here
    const auto add = [&](const typename Of::Halfspace& h) {
      rows.push_back({h, static_cast<std::uint32_t>(rows.size())});
    };
    const auto turned = [](const typename Of::Halfspace& h) {
      Numbers<D> n = numbers_of(h.normal);
      for (double& x : n) x = -x;
      return typename Of::Halfspace{to_vector(n), -h.offset};
    };
    std::vector<Named> origin;  // the constraint that a row is, or is turned round
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (is_zero_normal<D>(numbers_of(given_[i].normal))) continue;
      add(given_[i]);
      origin.push_back(named(static_cast<std::uint32_t>(i)));
    }
    const auto hold = [&](const Named& n) {
      add(turned(n.halfspace));
      origin.push_back(n);
    };
    for (std::size_t k = 0; k < answer_.deciding_count; ++k) hold(answer_.deciding[k]);
    for (std::size_t k = 0; k < D; ++k) {
      bool has_end = false;
      for (const double way : {-1.0, 1.0}) {
        Numbers<D> axis{};
        axis[k] = way;
        std::vector<Named> order = rows;
        shuffle(std::span(order), 0);
        Seidel<D> search({axis}, order);
        search.solve();
        if (search.corner().far_along(axis) == Sign::positive) continue;
        for (std::size_t i = 0; i < D; ++i) {
          if (search.weight_of(i) == Sign::positive) hold(origin[search.corner().planes()[i].number]);
        }
        has_end = true;
        break;
      }
      if (has_end) continue;
      Numbers<D> axis{};
      axis[k] = 1;
      const typename Of::Halfspace level{to_vector(axis), 0};
      add(level);
      origin.push_back({level, no_constraint});
      hold({level, no_constraint});
    }
    Seidel<D> search(objective(), rows);
    search.solve();
    Corner<D> corner;
    std::array<Plane, D> planes = search.corner().planes();
    for (Plane& p : planes) p = lp_plane(origin[p.number]);
    corner.set(planes);
    keep_corner(corner);
  }

  std::span<const typename Of::Halfspace> given_;
  std::vector<Named>& scratch_;
  Answer answer_{};
};

template <std::size_t D>
auto maximize(const typename LpOf<D>::Vector& direction, std::span<const typename LpOf<D>::Halfspace> constraints,
              std::vector<typename LpOf<D>::Named>& scratch, const LinearOptions& options) {
  assert_sound_thread();
  if (constraints.size() > most_constraints)
    throw Error("maximize: " + std::to_string(constraints.size()) + " constraints, more than 2^32 - 2");
  double sum = 0;
  for (const auto& h : constraints) sum += (figure::sum_of(h.normal) + h.offset) * 0;
  for (const double x : numbers_of(direction)) sum += x * 0;
  if (sum != 0) [[unlikely]] {
    figure::require_sound("maximize", "direction", typename LpOf<D>::Halfspace{direction, 0});
    for (std::size_t i = 0; i < constraints.size(); ++i)
      figure::require_sound("maximize", "constraints[" + std::to_string(i) + "]", constraints[i]);
  }
  return LinearProgram<D>(direction, constraints, scratch).solve(options.seed);
}

}  // namespace
}  // namespace query

LinearAnswer2 maximize(const Vector2& direction, std::span<const Halfspace2> constraints,
                       std::vector<NamedHalfspace2>& scratch, const LinearOptions& options) {
  return query::maximize<2>(direction, constraints, scratch, options);
}
LinearAnswer3 maximize(const Vector3& direction, std::span<const Halfspace3> constraints,
                       std::vector<NamedHalfspace3>& scratch, const LinearOptions& options) {
  return query::maximize<3>(direction, constraints, scratch, options);
}
LinearAnswer2 maximize(const Vector2& direction, std::span<const Halfspace2> constraints,
                       const LinearOptions& options) {
  std::vector<NamedHalfspace2> scratch;
  return maximize(direction, constraints, scratch, options);
}
LinearAnswer3 maximize(const Vector3& direction, std::span<const Halfspace3> constraints,
                       const LinearOptions& options) {
  std::vector<NamedHalfspace3> scratch;
  return maximize(direction, constraints, scratch, options);
}

}  // namespace plumb
