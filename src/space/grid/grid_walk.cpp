// What a walk does now and then: it begins, comes from outside, crosses walls together, and sets its times anew.
#include "plumb/space/grid/grid_walk.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "plumb/arith/ball.hpp"
#include "space/grid/cell_place.hpp"
#include "space/grid/checked_grid.hpp"

namespace plumb {
namespace space {
namespace {

/// Which comes first, the wall below cell i of axis a or that below cell j of axis b?  The times are distance / way; this
/// is the sign of their difference times both ways.
struct CrossingOrder {
  template <class W>
  Sign operator()(const W& w, const WalkAxis& a, std::int64_t i, const WalkAxis& b, std::int64_t j) const {
    const auto way_a = w.difference(a.to, a.base), way_b = w.difference(b.to, b.base);
    return w.sign(way_to_wall(w, a, i) * way_b - way_to_wall(w, b, j) * way_a);
  }
};

int exact_order(const WalkAxis& a, std::int64_t i, const WalkAxis& b, std::int64_t j) {
  const auto s = static_cast<int>(certainly<ExactWorlds>(CrossingOrder{}, a, i, b, j));
  return (a.to > a.base) == (b.to > b.base) ? s : -s;
}

Ball ball_of(const WalkTime& t) { return {t.high, t.low, t.radius}; }

/// Times a power of two, which is exact where the way back leads to the same number: else digits were lost, or all.
Interval scaled(const Interval& x, double power_of_two) {
  const double l = x.lower * power_of_two, u = x.upper * power_of_two;
  return {Interval::down(l, l / power_of_two == x.lower ? 0 : -1),
          Interval::up(u, u / power_of_two == x.upper ? 0 : 1)};
}

/// A time in units, between two whole numbers; what is beyond every window counts as its end.
struct WholeInterval {
  std::int64_t lower = 0, width = 0;
  bool is_known = false;
};
WholeInterval in_units(const Ball& x, double units, std::int64_t most) {
  const Interval v = scaled(Interval{x.high} + Interval{x.low} + Interval{-x.radius, x.radius}, units);
  const double lower = std::floor(v.lower), upper = std::ceil(v.upper);
  const auto end = static_cast<double>(most);
  if (lower >= end) return {most, 0, true};
  if (!(lower > -end && upper < end)) return {};
  return {static_cast<std::int64_t>(lower), static_cast<std::int64_t>(upper) - static_cast<std::int64_t>(lower), true};
}

}  // namespace
}  // namespace space

template <std::size_t n>
GridWalk<n>::GridWalk(const CellGridOf<n>& grid, const Ray& ray, const GridWalkOptions<n>& options) {
  figure::require_finite_parts<decltype(ray.origin), decltype(ray.direction)>(
      "GridWalk", {"ray.origin", "ray.direction"}, ray.origin, ray.direction);
  set(grid, {coordinates(ray.origin), {}, coordinates(ray.direction)}, options);
}

template <std::size_t n>
GridWalk<n>::GridWalk(const CellGridOf<n>& grid, const Segment& segment, const GridWalkOptions<n>& options)
    : is_segment_(true) {
  figure::require_finite_parts<decltype(segment.a), decltype(segment.b)>("GridWalk", {"segment.a", "segment.b"},
                                                                         segment.a, segment.b);
  set(grid, {coordinates(segment.a), coordinates(segment.a), coordinates(segment.b)}, options);
}

template <std::size_t n>
void GridWalk<n>::set(const CellGridOf<n>& grid, const std::array<std::array<double, n>, 3>& line,
                      const GridWalkOptions<n>& options) {
  space::require_grid("GridWalk", grid);
  const auto origin = coordinates(grid.origin), size = coordinates(grid.size);
  is_closed_ = options.cells == WalkedCells::closed;
  for (std::size_t a = 0; a < n; ++a) {
    axis_[a] = {origin[a], size[a], line[0][a], line[1][a], line[2][a]};
    first_[a] = std::max(options.range.first[a], -most_cell);
    last_[a] = std::min(options.range.last[a], most_cell);
  }
}

template <std::size_t n>
void GridWalk<n>::stop() {
  stage_ = Stage::behind;
  time_.fill(never);
}

template <std::size_t n>
bool GridWalk<n>::next_slowly() {
  while (taken_ == queued_) {
    if (stage_ == Stage::behind) return false;
    taken_ = queued_ = 0;
    if (stage_ == Stage::before) {
      begin();
    } else {
      cross();
    }
  }
  told_ = queue_[taken_++];
  slack_ = taken_ == queued_ && !is_in_wall_ ? doubt_ : all_near;
  return true;
}

/// Which of the walls that come next is first: below 0 that of a.
template <std::size_t n>
int GridWalk<n>::order(std::size_t a, std::size_t b) const {
  const std::int64_t later = time_[a] - time_[b];
  int first = 0;
  if (later > doubt_ || later < -doubt_) {
    first = later > 0 ? 1 : -1;
  } else if (doubt_ != 0) {
    const auto time_of = [&](std::size_t x) {
      const Ball passed{static_cast<double>((cell_[x] - known_cell_[x]) * step_[x])};  // counted one by one
      return space::ball_of(known_time_[x]) + passed * space::ball_of(known_pace_[x]);
    };
    const Unsure<Sign> known = (time_of(a) - time_of(b)).sign();
    first = known.certain() ? static_cast<int>(known.value())
                            : space::exact_order(axis_[a], next_wall(a), axis_[b], next_wall(b));
  }
  if (first != 0 || is_closed_ || step_[a] == step_[b]) return first;
  return step_[a] > 0 ? -1 : 1;  // at the wall, a point is in the upper cell: who comes from there leaves it later
}

template <std::size_t n>
void GridWalk<n>::begin() {
  stage_ = Stage::within;
  unsigned outside = 0;  // axes whose wall into the range must be crossed first
  for (std::size_t a = 0; a < n; ++a) {
    const space::WalkAxis& x = axis_[a];
    if (first_[a] > last_[a]) return stop();
    const auto [at, on_wall] = space::place_of(space::PlaceOfNumber{}, x.from, x.origin, x.size);
    const bool touches_lower = on_wall && is_closed_;
    moves_[a] = x.base != x.to;
    time_[a] = never;
    if (!moves_[a]) {
      const std::int64_t lower = touches_lower ? at - 1 : at;
      in_wall_[a] = touches_lower && is_in_range(a, lower) && is_in_range(a, at);
      is_in_wall_ = is_in_wall_ || in_wall_[a];
      cell_[a] = is_in_range(a, lower) ? lower : at;
      if (!is_in_range(a, cell_[a])) return stop();
      continue;
    }
    const bool up = x.to > x.base;
    step_[a] = up ? 1 : -1;
    cell_[a] = up && touches_lower ? at - 1 : at;
    if (up ? cell_[a] > last_[a] : cell_[a] < first_[a]) return stop();
    const std::int64_t out = up ? last_[a] + 1 : first_[a] - 1;
    exits_[a] = true;
    stop_[a] = out;
    if (is_segment_) {
      const auto [end, end_on_wall] = space::place_of(space::PlaceOfNumber{}, x.to, x.origin, x.size);
      const std::int64_t last = !up && end_on_wall && is_closed_ ? end - 1 : end;
      if (up ? last < first_[a] : last > last_[a]) return stop();
      exits_[a] = up ? last >= out : last <= out;
      if (!exits_[a]) stop_[a] = last;
    }
    if (!is_in_range(a, cell_[a])) outside |= 1U << a;
  }
  if (outside != 0 && !enter(outside)) return stop();
  for (std::size_t a = 0; a < n; ++a) moves_[a] = moves_[a] && cell_[a] != stop_[a];
  set_times();
  if (outside == 0) queue_cells(cell_, 0);
}

/// From outside: to just before the last of the walls by which the line comes into the range.
template <std::size_t n>
bool GridWalk<n>::enter(unsigned outside) {
  const auto entry = [&](std::size_t a) { return step_[a] > 0 ? first_[a] : last_[a] + 1; };
  const auto e0 = static_cast<std::size_t>(std::countr_zero(outside));
  std::size_t e = e0;
  for (std::size_t a = e0 + 1; a < n; ++a) {
    if ((outside >> a & 1U) != 0 && space::exact_order(axis_[e], entry(e), axis_[a], entry(a)) < 0) e = a;
  }
  for (std::size_t a = 0; a < n; ++a) {
    if (!moves_[a]) continue;
    if (a == e) {
      cell_[a] = step_[a] > 0 ? entry(e) - 1 : entry(e);
      continue;
    }
    const auto [at, on_wall] = space::place_of(space::PlaceAtWall{}, axis_[a], axis_[e], entry(e));
    cell_[a] = step_[a] > 0 && on_wall ? at - 1 : at;
    if (step_[a] > 0 ? cell_[a] > last_[a] : cell_[a] < first_[a]) return false;
  }
  return true;
}

template <std::size_t n>
void GridWalk<n>::cross() {
  if (*std::min_element(time_.begin(), time_.end()) >= window) set_times();
  std::size_t first = n;
  unsigned group = 0;
  for (std::size_t a = 0; a < n; ++a) {
    if (!moves_[a]) continue;
    const int earlier = first == n ? -1 : order(a, first);
    if (earlier < 0) first = a, group = 0;
    if (earlier <= 0) group |= 1U << a;
  }
  if (first == n) return stop();
  cross_together(group);
}

template <std::size_t n>
void GridWalk<n>::cross_together(unsigned group) {
  const Cell old = cell_;
  bool leaves = false, is_inside = true;
  for (std::size_t a = 0; a < n; ++a) {
    if ((group >> a & 1U) != 0) {
      cell_[a] += step_[a];
      time_[a] += pace_[a];
      if (cell_[a] == stop_[a]) {
        leaves = leaves || exits_[a];
        moves_[a] = false;
        time_[a] = never;
      }
    }
    is_inside = is_inside && is_in_range(a, cell_[a]);
  }
  if (is_closed_) {
    queue_cells(old, group);
  } else if (is_inside) {
    queue_cells(cell_, 0);
  }
  if (leaves) stop();
}

/// The cells that are touched now: of the axes that have just been crossed both, but for those that have been told.
template <std::size_t n>
void GridWalk<n>::queue_cells(const Cell& old, unsigned crossed) {
  unsigned twofold = crossed;
  for (std::size_t a = 0; a < n; ++a) twofold |= in_wall_[a] ? 1U << a : 0U;
  for (unsigned upper = 0; upper < 1U << n; ++upper) {
    if ((upper & ~twofold) != 0 || (crossed != 0 && (upper & crossed) == 0)) continue;
    Cell c = old;
    bool is_inside = true;
    for (std::size_t a = 0; a < n; ++a) {
      if ((upper >> a & 1U) != 0) c[a] += (crossed >> a & 1U) != 0 ? step_[a] : 1;
      is_inside = is_inside && is_in_range(a, c[a]);
    }
    if (is_inside) queue_[queued_++] = c;
  }
}

/// Times are those of t times the ways of all axes that move, so that no quotient is needed: whole numbers of few bits
/// stay exact.
template <std::size_t n>
void GridWalk<n>::set_times() {
  const ExactNumbers<Ball, WorldKind::pairs> balls;
  const Ball nothing{0};
  std::array<Ball, 3> way{nothing, nothing, nothing}, time = way, pace = way;
  for (std::size_t a = 0; a < n; ++a) way[a] = magnitude(balls.difference(axis_[a].to, axis_[a].base));
  double least = Ball::infinity;
  std::size_t base = n;
  for (std::size_t a = 0; a < n; ++a) {
    if (!moves_[a]) continue;
    Ball others{1};
    bool any = false;
    for (std::size_t b = 0; b < n; ++b) {
      if (b == a || !moves_[b]) continue;
      others = any ? others * way[b] : way[b];
      any = true;
    }
    const Ball distance = space::way_to_wall(balls, axis_[a], next_wall(a));
    time[a] = (step_[a] > 0 ? distance : nothing - distance) * others;
    pace[a] = Ball{axis_[a].size} * others;
    known_time_[a] = {time[a].high, time[a].low, time[a].radius};
    known_pace_[a] = {pace[a].high, pace[a].low, pace[a].radius};
    if (pace[a].high < least) least = pace[a].high;
    if (base == n || time[a].high < time[base].high) base = a;
  }
  known_cell_ = cell_;
  doubt_ = 0;
  if (base != n) {
    constexpr int bits = 52;          // of the shortest pace: what is held by a double then is a whole number
    constexpr double fits = 0x1p900;  // a guess of where times fit: elsewhere every step is compared exactly
    const bool handy = least > 1 / fits && least < fits;
    const double units = handy ? std::ldexp(1, bits - std::ilogb(least)) : 1;
    const Ball now = time[base];
    for (std::size_t a = 0; a < n; ++a) {
      if (!moves_[a]) continue;
      const auto [at, at_width, at_known] =
          a == base ? space::WholeInterval{0, 0, true} : space::in_units(time[a] - now, units, never);
      const auto [by, by_width, by_known] = space::in_units(pace[a], units, never);
      if (!handy || !at_known || !by_known || by <= 0) {
        doubt_ = all_near;
        break;
      }
      time_[a] = at, pace_[a] = by;
      doubt_ = std::max(doubt_, at_width + (window / by + 2) * by_width);
    }
  }
  if (doubt_ == all_near) {  // nothing is known: every step is compared exactly
    for (std::size_t a = 0; a < n; ++a) time_[a] = moves_[a] ? 0 : never, pace_[a] = 0;
  }
}

template class GridWalk<2>;
template class GridWalk<3>;

}  // namespace plumb
