#include "plumb/surface/solid/round.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "plumb/surface/solid/boolean.hpp"
#include "surface/solid/soundness.hpp"

namespace plumb {
namespace {

Rational squared_move(const ExactPoint3& from, const Point3& to) {
  if (const auto* given = std::get_if<Point3>(&from.as()))
    if (given->x == to.x && given->y == to.y && given->z == to.z) return 0;
  const RationalPoint3 p = rational_point(from);
  const Rational x = p.x - to.x, y = p.y - to.y, z = p.z - to.z;
  return x * x + y * y + z * z;
}

/// Tells where vertices go in one round: to their nearest doubles, or to a grid where the round before went wrong.
class RoundingPlaces {
 public:
  /// All points go to the grid; to their nearest doubles where it is 0.
  explicit RoundingPlaces(double grid) : grid_(grid), all_are_coarse_(grid != 0) {}

  /// From now on, what was constructed and these points go to the grid.
  void make_coarse(const surface::Soundness& found, double grid) {
    grid_ = grid;
    for (const auto& pair : found.meeting)
      for (const std::uint32_t t : pair)
        for (const std::uint32_t v : found.plain.triangles[t]) coarse_.insert(key_of(found.plain.vertices[v]));
  }

  [[nodiscard]] Point3 place_of(const ExactPoint3& p) const {
    const Point3 nearest = approximate(p);
    const bool stays = !all_are_coarse_ && std::holds_alternative<Point3>(p.as()) && !coarse_.contains(key_of(nearest));
    if (grid_ == 0 || stays) return nearest;
    return {on_grid(nearest.x), on_grid(nearest.y), on_grid(nearest.z)};
  }

 private:
  using Key = std::array<double, 3>;
  static Key key_of(const Point3& p) { return {p.x, p.y, p.z}; }
  /// The quotient by a power of two is exact.
  [[nodiscard]] double on_grid(double x) const { return std::nearbyint(x / grid_) * grid_; }

  std::set<Key> coarse_;
  double grid_;
  bool all_are_coarse_;
};

/// The distance between neighboring doubles at the largest coordinate, times 2 for each round.
double grid_of_round(std::span<const Point3> vertices, std::uint32_t round) {
  double largest = 0;
  for (const Point3& p : vertices) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  int exponent = 0;
  (void)std::frexp(largest, &exponent);
  return std::ldexp(1.0, std::max(exponent - 53 + static_cast<int>(std::min(round, 50U)), -1022));
}

/// The mesh with its vertices moved, and a number that none moved farther than.
TriangleMesh moved_mesh(const ExactMesh& mesh, const RoundingPlaces& places, double& moved) {
  TriangleMesh made;
  Rational farthest = 0;
  for (const ExactPoint3& p : mesh.vertices) {
    made.vertices.push_back(places.place_of(p));
    farthest = std::max(farthest, squared_move(p, made.vertices.back()));
  }
  moved = farthest.sign() == Sign::zero ? 0 : rounded_root(Rounding::up, farthest);
  made.triangles = mesh.triangles;
  return made;
}

/// Vertices that triangles name, and triangles by their smallest vertices, in order.
void put_in_order(RoundedMesh& made) {
  std::vector<std::uint32_t> number(made.mesh.vertices.size());
  for (const auto& corners : made.mesh.triangles)
    for (const std::uint32_t v : corners) number[v] = 1;
  std::vector<Point3> kept;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (std::exchange(number[v], static_cast<std::uint32_t>(kept.size())) != 0) kept.push_back(made.mesh.vertices[v]);
  made.mesh.vertices = std::move(kept);
  struct Row {
    TriangleMesh::Triangle corners;
    SourceFace source;
    std::uint32_t before;
  };
  std::vector<Row> rows;
  for (std::uint32_t t = 0; t < made.sources.size(); ++t) {
    auto corners = made.mesh.triangles[t];
    for (std::uint32_t& v : corners) v = number[v];
    rows.push_back({corners, made.sources[t], t});
  }
  std::ranges::sort(rows, {}, &Row::corners);
  std::vector<std::uint32_t> now(rows.size());
  for (std::uint32_t t = 0; t < rows.size(); ++t) {
    made.mesh.triangles[t] = rows[t].corners;
    made.sources[t] = rows[t].source;
    now[rows[t].before] = t;
  }
  for (auto& [a, b] : made.meeting) {
    a = now[a], b = now[b];
    if (a > b) std::swap(a, b);
  }
  std::ranges::sort(made.meeting);
}

/// Rounds begin at the grid of round `first`, where that is not 0.
RoundedMesh rounded_from(const ExactMesh& mesh, std::uint32_t first, std::uint32_t rounds) {
  RoundedMesh made;
  ExactMesh exact = mesh;
  Rational moved = 0;
  if (first != 0) {
    std::vector<Point3> nearest;
    for (const ExactPoint3& p : mesh.vertices) nearest.push_back(approximate(p));
    made.grid = grid_of_round(nearest, first);
  }
  RoundingPlaces places(made.grid);
  while (true) {
    double farthest = 0;
    const TriangleMesh nearest = moved_mesh(exact, places, farthest);
    moved = moved + Rational(farthest);
    ++made.rounds;
    surface::Soundness found(nearest);
    if (found.sound || made.rounds >= rounds || found.meeting.size() > mesh.triangles.size()) {
      made.mesh = std::move(found.plain);
      for (const std::uint32_t t : found.triangle) made.sources.push_back(exact.sources[t]);
      made.sound = found.sound;
      made.meeting = std::move(found.meeting);
      break;
    }
    made.grid = grid_of_round(nearest.vertices, first + made.rounds);
    places.make_coarse(found, made.grid);
    ExactMesh resolved = resolve(nearest);
    for (SourceFace& source : resolved.sources) source = exact.sources[source.triangle];
    exact = std::move(resolved);
  }
  made.moved = moved.rounded(Rounding::up);
  return made;
}

}  // namespace

RoundedMesh round(const ExactMesh& mesh, const RoundingOptions& options) {
  // What is thinner than a grid is gone on one that is much coarser: an eighth of the rounds is kept for each of those.
  constexpr std::array<std::uint32_t, 4> firsts{0, 8, 16, 24};
  const std::uint32_t kept = options.rounds / 8;
  RoundedMesh made;
  std::uint32_t rounds = 0;
  for (std::uint32_t k = 0; k < firsts.size() && !made.sound && (k == 0 || rounds < options.rounds); ++k) {
    const std::uint32_t for_others = kept * static_cast<std::uint32_t>(firsts.size() - 1 - k);
    RoundedMesh again = rounded_from(mesh, firsts[k], options.rounds - rounds - for_others);
    rounds += again.rounds;
    if (k == 0 || again.sound) made = std::move(again);
  }
  made.rounds = rounds;
  put_in_order(made);
  return made;
}

}  // namespace plumb
