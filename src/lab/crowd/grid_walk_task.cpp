// Which cells of a uniform grid does a segment visit, or touch?
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "lab/crowd/crowds.hpp"
#include "lab/trial/float_methods.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/space/grid/grid_walk.hpp"

namespace plumb::lab::trial {
namespace {

/// 1 where touched cells count (closed), else 0 (half open); the length of a cell; both ends.
constexpr std::size_t walk_numbers = 8;
constexpr std::int64_t cells_across = 16;
constexpr double length_of_cell = 0.1;

using WalkNumbers = std::array<double, walk_numbers>;

/// As two numbers of 32 bits, which tell the cells of one walk apart.
std::array<std::uint32_t, 2> written(const Cell3& c) {
  const auto low = [](std::int64_t x) { return static_cast<std::uint32_t>(x & 0xffff); };
  return {low(c[0]) | low(c[1]) << 16, static_cast<std::uint32_t>(c[2])};
}

void set_walk(std::span<double> q, bool closed, double cell, const Point3& from, const Point3& to) {
  const WalkNumbers numbers{closed ? 1.0 : 0.0, cell, from.x, from.y, from.z, to.x, to.y, to.z};
  std::ranges::copy(numbers, q.begin());
}

Point3 anywhere_in_grid(Entropy& e) {
  const auto number = [&e] { return static_cast<double>(cells_across) * length_of_cell * unit_coordinate(e); };
  const double x = number(), y = number(), z = number();
  return {x, y, z};
}

/// Ends of halves of cells: corners, middles of edges and walls, and walks along them.
void fill_lattice(std::span<double> q, Entropy& e, bool closed) {
  const auto number = [&e] { return static_cast<double>(e.below(2 * cells_across)) / 2; };
  const double x = number(), y = number(), z = number();
  // Along an axis or a diagonal now and then.
  const auto to = [&](double from, double way) { return e.below(3) == 0 ? number() : from + way; };
  const double way = static_cast<double>(e.within(cells_across)) / 2;
  const double u = to(x, way), v = to(y, e.coin() ? way : 0), w = to(z, e.coin() ? -way : 0);
  set_walk(q, closed, 1, {x, y, z}, {u, v, w});
}

/// From somewhere through a corner, as near as doubles come to it.
void fill_corner(std::span<double> q, Entropy& e) {
  const auto wall = [&e] { return static_cast<double>(4 + e.below(8)) * length_of_cell; };
  const Point3 from = anywhere_in_grid(e);
  const double x = wall(), y = wall(), z = wall();
  set_walk(q, false, length_of_cell, from, {x + (x - from.x) / 4, y + (y - from.y) / 4, z + (z - from.z) / 4});
}

std::vector<InputClass> walk_classes() {
  return {
      {"uniform", "segments between places in 16 x 16 x 16 cells",
       [](std::span<double> q, Entropy& e) {
         const Point3 from = anywhere_in_grid(e), to = anywhere_in_grid(e);
         set_walk(q, false, length_of_cell, from, to);
       }},
      {"corners", "segments through a corner of cells, as near as doubles come to it", fill_corner},
      {"lattice", "ends of halves of cells, often along an axis or a diagonal",
       [](std::span<double> q, Entropy& e) { fill_lattice(q, e, false); }},
      {"off_by_ulps", "as lattice, each number an ulp up or down, or not",
       [](std::span<double> q, Entropy& e) {
         fill_lattice(q, e, false);
         for (double& x : q.subspan(2)) {
           const std::int64_t way = e.within(1);
           if (way != 0) x = std::nextafter(x, static_cast<double>(way) * std::numeric_limits<double>::infinity());
         }
       }},
      {"touched", "as lattice; cells that are only touched count",
       [](std::span<double> q, Entropy& e) { fill_lattice(q, e, true); }},
      {"far_away", "as corners, a million from the origin",
       [](std::span<double> q, Entropy& e) {
         fill_corner(q, e);
         for (double& x : q.subspan(2)) x += 0x1p20;
       }},
  };
}

/// At every parameter where a wall is crossed, and between them, in GMP's rationals.
class WalkJudge {
 public:
  const Pairs& cells(std::span<const double> q) {
    WalkNumbers key{};
    std::ranges::copy(q, key.begin());
    const auto [at, is_new] = found_.try_emplace(key);
    if (is_new) at->second = cells_of(key);
    return at->second;
  }

 private:
  static mpz_class floor_of(const mpq_class& x) {
    mpz_class down;
    mpz_fdiv_q(down.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
    return down;
  }
  static Pairs cells_of(const WalkNumbers& q) {
    const mpq_class size(q[1]);
    std::array<mpq_class, 3> from, way;  // in cells
    std::set<mpq_class> times{0, 1};
    for (std::size_t a = 0; a < 3; ++a) {
      from[a] = mpq_class(q[2 + a]) / size;
      way[a] = mpq_class(q[5 + a]) / size - from[a];
      if (way[a] == 0) continue;
      const mpq_class to = from[a] + way[a], last = std::max(from[a], to);
      for (mpq_class wall = floor_of(std::min(from[a], to)); wall <= last; wall += 1) {
        const mpq_class t = (wall - from[a]) / way[a];
        if (t > 0 && t < 1) times.insert(t);
      }
    }
    std::set<std::array<std::uint32_t, 2>> all;
    const auto look_at = [&](const mpq_class& t) {
      Cell3 upper{};
      std::array<bool, 3> on_wall{};
      for (std::size_t a = 0; a < 3; ++a) {
        const mpq_class x = from[a] + t * way[a];
        const mpz_class down = floor_of(x);
        upper[a] = down.get_si();
        on_wall[a] = x == down;
      }
      for (unsigned below = 0; below < (q[0] != 0 ? 8U : 1U); ++below) {
        Cell3 cell = upper;
        bool touches = true;
        for (std::size_t a = 0; a < 3; ++a) {
          if ((below >> a & 1U) == 0) continue;
          touches = touches && on_wall[a];
          --cell[a];
        }
        if (touches) all.insert(written(cell));
      }
    };
    const mpq_class* before = nullptr;
    for (const mpq_class& t : times) {
      if (before != nullptr) look_at((*before + t) / 2);
      look_at(t);
      before = &t;
    }
    return {all.begin(), all.end()};
  }
  std::map<WalkNumbers, Pairs> found_;
};

/// As commonly written, after Amanatides and Woo: of the next walls' parameters the least; each is added up, or divided
/// for anew.  Which cells are touched it does not ask.
template <class T, bool accumulated>
Pairs plain_walk(const std::array<T, walk_numbers>& q) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const T cell = q[1];
  Cell3 at{}, end{}, step{};
  std::array<T, 3> time{}, pace{}, way{};
  const auto wall_time = [&](std::size_t a) {
    return (static_cast<T>(at[a] + (way[a] > 0 ? 1 : 0)) * cell - q[2 + a]) / way[a];
  };
  for (std::size_t a = 0; a < 3; ++a) {
    at[a] = static_cast<std::int64_t>(std::floor(q[2 + a] / cell));
    end[a] = static_cast<std::int64_t>(std::floor(q[5 + a] / cell));
    way[a] = q[5 + a] - q[2 + a];
    step[a] = way[a] > 0 ? 1 : -1;
    pace[a] = way[a] == 0 ? infinity : cell / magnitude(way[a]);
    time[a] = way[a] == 0 ? infinity : wall_time(a);
  }
  Pairs cells;
  while (true) {
    cells.push_back(written(at));
    const std::size_t x_or_y = time[0] <= time[1] ? 0 : 1, a = time[x_or_y] <= time[2] ? x_or_y : 2;
    if (at[a] == end[a]) return cells;
    at[a] += step[a];
    time[a] = accumulated ? time[a] + pace[a] : wall_time(a);
  }
}

Pairs exact_walk(const WalkNumbers& q) {
  GridWalk3 walk(CellGrid3{{0, 0, 0}, {q[1], q[1], q[1]}}, Segment3{{q[2], q[3], q[4]}, {q[5], q[6], q[7]}},
                 {q[0] != 0 ? WalkedCells::closed : WalkedCells::half_open, {}});
  Pairs cells;
  while (walk.next()) cells.push_back(written(walk.cell()));
  return cells;
}

}  // namespace

Task grid_walk_task() {
  Task task{"grid-walk", "which cells of a grid does a segment visit?", walk_numbers, AnswerKind::set, {}, {}, {}, {},
            16};
  task.classes = walk_classes();
  task.symmetries = {{{0, 1, 5, 6, 7, 2, 3, 4}, 1}};  // the other way round
  const auto judge = std::make_shared<WalkJudge>();
  task.judge = [judge](std::span<const double> q) { return as_answer(judge->cells(q)); };
  task.tallies = {{"false cells", "cells that are not visited and are named",
                   [judge](std::span<const double> q, double, const Round& round, std::size_t i) {
                     return count_lacking(round.given_pairs(i), judge->cells(q));
                   }},
                  {"missed cells", "cells that are visited and are not named",
                   [judge](std::span<const double> q, double, const Round& round, std::size_t i) {
                     return count_lacking(judge->cells(q), round.given_pairs(i));
                   }}};
  task.methods.push_back(
      each_of<float, walk_numbers>("float32", "parameters added up in single precision", plain_walk<float, true>));
  task.methods.push_back(
      each_of<double, walk_numbers>("double", "parameters added up, as commonly written", plain_walk<double, true>));
  task.methods.push_back(
      each_of<double, walk_numbers>("recomputed", "double, parameters divided for anew", plain_walk<double, false>));
  task.methods.push_back(each_of<double, walk_numbers>("exact", "ours, one segment at a time", exact_walk));
  return task;
}

}  // namespace plumb::lab::trial
