#include "exact_gap.hpp"

namespace plumb::query {
namespace {

// A point of the difference of the sets, or a direction.
struct Corner {
  Exact3 at;
  mpq_class weight;
  bool is_point;
};
using Corners = std::vector<Corner>;

Exact3 nearest(const Corners& corners) {
  Exact3 x{};
  for (const Corner& c : corners) x = x + c.weight * c.at;
  return x;
}

// The weights, of any sign, of the point nearest to the origin in the affine hull of independent corners: with d_i from
// the first point f to the other points, and the directions, the sum of c_j d_i . d_j is -d_i . f.
std::vector<mpq_class> affine_weights(const Corners& corners) {
  std::size_t first = 0;
  while (!corners[first].is_point) ++first;
  const Exact3& f = corners[first].at;
  std::vector<Exact3> d;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i != first) d.push_back(corners[i].is_point ? corners[i].at - f : corners[i].at);
  }
  const std::size_t n = d.size();
  std::vector<std::vector<mpq_class>> rows(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i].push_back(dot(d[i], d[j]));
    rows[i].push_back(-dot(d[i], f));
  }
  for (std::size_t k = 0; k < n; ++k) {  // a Gram matrix of independent vectors needs no other pivots
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || sgn(rows[i][k]) == 0) continue;
      const mpq_class times = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= times * rows[k][j];
    }
  }
  std::vector<mpq_class> weights(corners.size());
  weights[first] = 1;
  for (std::size_t i = 0, k = 0; i < corners.size(); ++i) {
    if (i == first) continue;
    weights[i] = rows[k][n] / rows[k][k];
    if (corners[i].is_point) weights[first] -= weights[i];
    ++k;
  }
  return weights;
}

// Moves the weights to the nearest point of the corners' hull, and drops the corners that it does without.
void approach(Corners& corners) {
  while (true) {
    const std::vector<mpq_class> goal = affine_weights(corners);
    mpq_class part = 1;  // of the way to the goal
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (sgn(goal[i]) >= 0) continue;
      mpq_class limit = corners[i].weight / (corners[i].weight - goal[i]);
      if (limit < part) part = std::move(limit);
    }
    Corners kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      mpq_class weight = corners[i].weight + part * (goal[i] - corners[i].weight);
      if (sgn(weight) > 0) kept.push_back({std::move(corners[i].at), std::move(weight), corners[i].is_point});
    }
    corners = std::move(kept);
    if (part == 1) return;
  }
}

const Exact3& least_along(const std::vector<Exact3>& points, const Exact3& direction, int sign) {
  const Exact3* best = nullptr;
  mpq_class least;
  for (const Exact3& p : points) {
    mpq_class along = sign * dot(direction, p);
    if (best != nullptr && along >= least) continue;
    best = &p;
    least = std::move(along);
  }
  return *best;
}

// Looks along the lines: distances are those of what is seen.
class Look {
 public:
  void along(Exact3 line) {
    see(line);
    if (!is_zero(line)) lines_.push_back(std::move(line));
  }
  void see(Exact3& v) const {
    for (const Exact3& line : lines_) {
      const mpq_class times = -dot(v, line) / dot(line, line);
      v = v + times * line;
    }
  }
  void see(FlatSet& set) const {
    if (lines_.empty()) return;
    for (Exact3& p : set.points) see(p);
    for (Exact3& d : set.directions) see(d);
  }

 private:
  std::vector<Exact3> lines_;  // perpendicular to one another
};

// The corner by which the set is nearer than its point x, if it is: a direction or a point that is least along x.
std::optional<Corner> nearer(const FlatSet& a, const FlatSet& b, const Exact3& x, const mpq_class& square) {
  for (const Exact3& d : a.directions) {
    if (sgn(dot(x, d)) < 0) return Corner{d, 0, false};
  }
  for (const Exact3& d : b.directions) {
    if (sgn(dot(x, d)) > 0) return Corner{mpq_class(-1) * d, 0, false};
  }
  Exact3 next = least_along(a.points, x, 1) - least_along(b.points, x, -1);
  if (dot(x, next) >= square) return {};
  return Corner{std::move(next), 0, true};
}

Relation relation_within(const FlatSet& a, const FlatSet& b, const mpq_class& reach) {
  if (sgn(reach) == 0) return relate(a, b);
  const std::optional<mpq_class> square = squared_distance(a, b);
  if (!square) return Relation::disjoint;
  return static_cast<Relation>(sgn(mpq_class(reach * reach - *square)));
}

}  // namespace

std::optional<mpq_class> squared_distance(const FlatSet& p, const FlatSet& q) {
  if (p.points.empty() || q.points.empty()) return {};
  Look look;
  for (const Exact3& line : p.lines) look.along(line);
  for (const Exact3& line : q.lines) look.along(line);
  FlatSet a = p, b = q;
  look.see(a), look.see(b);
  Corners corners{{a.points[0] - b.points[0], 1, true}};
  while (true) {
    const Exact3 x = nearest(corners);
    mpq_class square = dot(x, x);
    if (sgn(square) == 0) return square;
    auto next = nearer(a, b, x, square);
    if (!next) return square;
    corners.push_back(std::move(*next));
    approach(corners);
  }
}

Relation relate_swept(const FlatSet& core, double radius, const FlatSet& other) {
  return relation_within(core, other, radius);
}
Relation relate_swept(const FlatSet& core, double radius, const FlatSet& other_core, double other_radius) {
  return relation_within(core, other_core, mpq_class(radius) + mpq_class(other_radius));
}

FlatSet core_set(const Sphere3& sphere) { return flat_set(sphere.center); }
FlatSet core_set(const Capsule3& capsule) { return flat_set(Segment3{capsule.a, capsule.b}); }
FlatSet core_set(const Lozenge3& lozenge) {
  const auto exact = [](const auto& p) { return Exact3{p.x, p.y, p.z}; };
  const Exact3 corner = exact(lozenge.corner), e = exact(lozenge.edges[0]), f = exact(lozenge.edges[1]);
  return {{corner, corner + e, corner + f, corner + e + f}, {}, {}, {}};
}

}  // namespace plumb::query
