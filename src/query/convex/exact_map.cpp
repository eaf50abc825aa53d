#include "query/convex/exact_map.hpp"

#include <utility>

#include "arith/exact_number.hpp"
#include "query/body/weighted_pose.hpp"

namespace plumb::query {
namespace {

/// The rows of the matrix, made simple by steps that `steps` keeps: steps * matrix = rows (Gauss, Jordan).
class Elimination {
 public:
  explicit Elimination(const ExactMap& map) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) rows_[i][k] = map.columns[k][i];
      steps_[i][i] = 1;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      std::size_t i = rank_;
      while (i < 3 && sgn(rows_[i][k]) == 0) ++i;
      if (i == 3) continue;
      std::swap(rows_[i], rows_[rank_]), std::swap(steps_[i], steps_[rank_]);
      const mpq_class pivot = rows_[rank_][k];
      scale(rows_[rank_], pivot), scale(steps_[rank_], pivot);
      for (std::size_t j = 0; j < 3; ++j) {
        if (j == rank_) continue;
        const mpq_class by = rows_[j][k];
        rows_[j] = rows_[j] - by * rows_[rank_];
        steps_[j] = steps_[j] - by * steps_[rank_];
      }
      pivots_[rank_++] = k;
    }
  }

  [[nodiscard]] std::size_t rank() const { return rank_; }

  /// Along which nothing changes.
  [[nodiscard]] std::vector<Exact3> kernel() const {
    std::vector<Exact3> all;
    for (std::size_t k = 0; k < 3; ++k) {
      if (is_pivot(k)) continue;
      Exact3 v{0, 0, 0};
      v[k] = 1;
      for (std::size_t i = 0; i < rank_; ++i) v[pivots_[i]] = -rows_[i][k];
      all.push_back(std::move(v));
    }
    return all;
  }

  /// At right angles to the range.
  [[nodiscard]] std::vector<Exact3> normals() const {
    return {steps_.begin() + static_cast<long>(rank_), steps_.end()};
  }

  /// One of those that the matrix maps to v, which is in its range.
  [[nodiscard]] Exact3 solve(const Exact3& v) const {
    Exact3 x{0, 0, 0};
    for (std::size_t i = 0; i < rank_; ++i) x[pivots_[i]] = dot(steps_[i], v);
    return x;
  }

 private:
  static void scale(Exact3& v, const mpq_class& by) {
    for (mpq_class& x : v) x /= by;
  }
  [[nodiscard]] bool is_pivot(std::size_t k) const {
    for (std::size_t i = 0; i < rank_; ++i) {
      if (pivots_[i] == k) return true;
    }
    return false;
  }

  std::array<Exact3, 3> rows_, steps_;
  std::array<std::size_t, 3> pivots_{};
  std::size_t rank_ = 0;
};

}  // namespace

ExactMap exact_map(const AnyPoseView& pose) {
  const auto by = weighted_pose<BigDyadic>(pose);
  const mpq_class weight = gmp_number(by.weight);
  const auto over_weight = [&](const Vec3<BigDyadic>& v) {
    const auto part = [&](const BigDyadic& x) {
      return by.has_weight ? mpq_class(gmp_number(x) / weight) : gmp_number(x);
    };
    return Exact3{part(v.x), part(v.y), part(v.z)};
  };
  return {{over_weight(by.columns[0]), over_weight(by.columns[1]), over_weight(by.columns[2])},
          over_weight(by.translation)};
}
ExactMap exact_identity() { return exact_map(AnyPoseView()); }

Exact3 turned(const ExactMap& map, const Exact3& v) {
  return v[0] * map.columns[0] + v[1] * map.columns[1] + v[2] * map.columns[2];
}
Exact3 image(const ExactMap& map, const Exact3& p) { return turned(map, p) + map.translation; }

FlatSet image(const ExactMap& map, const FlatSet& s) {
  FlatSet r;
  for (const Exact3& p : s.points) r.points.push_back(image(map, p));
  for (const auto& [from, to] : {std::pair{&s.directions, &r.directions}, std::pair{&s.lines, &r.lines}}) {
    for (const Exact3& v : *from) {
      Exact3 w = turned(map, v);
      if (!is_zero(w)) to->push_back(std::move(w));
    }
  }
  r.edges = s.edges;
  return r;
}

ExactMap composed(const ExactMap& outer, const ExactMap& inner) {
  const auto& c = inner.columns;
  return {{turned(outer, c[0]), turned(outer, c[1]), turned(outer, c[2])}, image(outer, inner.translation)};
}

bool is_singular(const ExactMap& map) { return Elimination(map).rank() < 3; }

ExactMap inverse(const ExactMap& map) {
  const Elimination e(map);
  ExactMap r;
  for (std::size_t k = 0; k < 3; ++k) {
    Exact3 unit{0, 0, 0};
    unit[k] = 1;
    r.columns[k] = e.solve(unit);
  }
  r.translation = mpq_class(-1) * e.solve(map.translation);
  return r;
}

Preimage preimage(const ExactMap& map, const FlatSet& s) {
  const Elimination e(map);
  Preimage r{s, true};
  for (const Exact3& n : e.normals()) {
    PlaneSection part = section(r.set, n, dot(n, map.translation));
    r = {std::move(part.set), r.of_inside && part.of_inside};
  }
  if (r.set.points.empty()) return {{}, false};
  for (Exact3& p : r.set.points) p = e.solve(p - map.translation);
  for (Exact3& d : r.set.directions) d = e.solve(d);
  for (Exact3& l : r.set.lines) l = e.solve(l);
  for (Exact3& v : e.kernel()) r.set.lines.push_back(std::move(v));
  return r;
}

std::optional<mpq_class> squared_scale(const ExactMap& map, int dimension) {
  const auto& c = map.columns;
  const auto n = static_cast<std::size_t>(dimension);
  const mpq_class square = dot(c[0], c[0]);
  for (std::size_t i = 0; i < n; ++i) {
    if (dot(c[i], c[i]) != square) return {};
    for (std::size_t j = i + 1; j < n; ++j) {
      if (sgn(dot(c[i], c[j])) != 0) return {};
    }
  }
  return square;
}

}  // namespace plumb::query
