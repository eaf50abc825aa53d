#include "surface/repair/least_area.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "arith/root_sum.hpp"
#include "figure/basic/plane_of_points.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/predicates.hpp"

namespace plumb::surface {
namespace {

using Corners = std::array<std::uint32_t, 3>;  // by their places in the loop, ascending
using Triangulated = std::vector<Corners>;     // ascending

/// The square of twice a triangle's area.
template <class T, class Number>
T squared_area(const Number& number, const Point3& a, const Point3& b, const Point3& c) {
  const T ux = number(b.x) - number(a.x), uy = number(b.y) - number(a.y), uz = number(b.z) - number(a.z);
  const T vx = number(c.x) - number(a.x), vy = number(c.y) - number(a.y), vz = number(c.z) - number(a.z);
  const T x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  return x * x + y * y + z * z;
}

class LeastAreaSearch {
 public:
  LeastAreaSearch(std::span<const Point3> points, std::span<const std::uint32_t> loop, const TakenDiagonal& is_taken)
      : loop_(loop), n_(static_cast<std::uint32_t>(loop.size())), cells_(loop.size() * loop.size()) {
    for (const std::uint32_t v : loop) at_.push_back(points[v]);
    scale();
    for (std::uint32_t i = 0; i + 1 < n_; ++i) cell(i, i + 1).area = Interval(0);
    for (std::uint32_t length = 2; length < n_; ++length)
      for (std::uint32_t i = 0; i + length < n_; ++i)
        if (length + 1 == n_ || !is_taken(loop[i], loop[i + length])) bound(i, i + length);
  }

  [[nodiscard]] std::optional<LeastArea> least() {
    if (!cell(0, n_ - 1).is_filled()) return {};
    LeastArea found;
    for (const auto& [i, j, k] : filling_of(0, n_ - 1)) found.filling.push_back({loop_[i], loop_[j], loop_[k]});
    found.tied = cell(0, n_ - 1).tied;
    return found;
  }

 private:
  /// Of the part of the loop from i to k: between which numbers its least area lies; which corner it is cut off by.
  struct Cell {
    Interval area{Interval::infinity, Interval::infinity};
    std::uint32_t middle = 0;
    bool decided = false, tied = false;
    [[nodiscard]] bool is_filled() const { return area.lower < Interval::infinity; }
  };

  Cell& cell(std::uint32_t i, std::uint32_t k) { return cells_[std::size_t{i} * n_ + k]; }

  /// Multiplies all by a power of two, where that is exact; elsewhere coordinates stay, and bounds are wider.
  void scale() {
    double largest = 0;
    for (const Point3& p : at_) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    const int exponent = largest == 0 ? 0 : std::ilogb(largest) + 1;
    const auto times = [](const Point3& p, int power) {
      return Point3{std::ldexp(p.x, power), std::ldexp(p.y, power), std::ldexp(p.z, power)};
    };
    std::vector<Point3> scaled;
    for (const Point3& p : at_) {
      scaled.push_back(times(p, -exponent));
      if (times(scaled.back(), exponent) != p) return;
    }
    at_ = std::move(scaled);
  }

  [[nodiscard]] Interval area(const Corners& t) const {
    return root(squared_area<Interval>([](double x) { return Interval(x); }, at_[t[0]], at_[t[1]], at_[t[2]]));
  }
  [[nodiscard]] BigDyadic exact_square(const Corners& t) const {
    return squared_area<BigDyadic>([](double x) { return BigDyadic(x); }, at_[t[0]], at_[t[1]], at_[t[2]]);
  }

  /// With the corner j cut off; infinite where that cannot be, or is certainly more than `most`.
  Interval area_by(std::uint32_t i, std::uint32_t j, std::uint32_t k, double most) {
    constexpr Interval none{Interval::infinity, Interval::infinity};
    const Cell &one = cell(i, j), &other = cell(j, k);
    if (!one.is_filled() || !other.is_filled()) return none;
    const Interval parts = one.area + other.area;
    if (parts.lower > most || collinear(at_[i], at_[j], at_[k])) return none;
    Interval all = parts + area({i, j, k});
    all.lower = std::max(all.lower, 0.0);  // also where doubles end
    return all;
  }

  void bound(std::uint32_t i, std::uint32_t k) {
    Interval& least = cell(i, k).area;
    for (std::uint32_t j = i + 1; j < k; ++j) {
      const Interval all = area_by(i, j, k, least.upper);
      least = {std::min(least.lower, all.lower), std::min(least.upper, all.upper)};
    }
  }

  void decide(std::uint32_t i, std::uint32_t k) {
    Cell& here = cell(i, k);
    if (here.decided || k - i < 2) return;
    std::vector<std::uint32_t> middles;
    for (std::uint32_t j = i + 1; j < k; ++j)
      if (const Interval all = area_by(i, j, k, here.area.upper);
          all.lower < Interval::infinity && all.lower <= here.area.upper)
        middles.push_back(j);
    here.middle = middles[0];
    if (middles.size() > 1) {
      Triangulated best = filling_by(i, middles[0], k);
      for (std::size_t m = 1; m < middles.size(); ++m) {
        Triangulated next = filling_by(i, middles[m], k);
        const auto [ours, theirs] = apart(best, next);
        const Sign more = compare_areas(ours, theirs);
        if (more == Sign::zero)
          here.tied =
              here.tied || cell(i, middles[m]).tied || cell(middles[m], k).tied || !are_one_surface(ours, theirs);
        if (more != Sign::positive) continue;
        here.tied = false;
        here.middle = middles[m];
        best = std::move(next);
      }
    }
    here.decided = true;
    decide(i, here.middle), decide(here.middle, k);
    here.tied = here.tied || cell(i, here.middle).tied || cell(here.middle, k).tied;
  }

  Triangulated filling_of(std::uint32_t from, std::uint32_t to) {
    Triangulated filling;
    std::vector<std::array<std::uint32_t, 2>> open{{from, to}};
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (k - i < 2) continue;
      decide(i, k);
      const std::uint32_t j = cell(i, k).middle;
      filling.push_back({i, j, k});
      open.push_back({i, j}), open.push_back({j, k});
    }
    std::ranges::sort(filling);
    return filling;
  }
  Triangulated filling_by(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    Triangulated filling = filling_of(i, j);
    const Triangulated rest = filling_of(j, k);
    filling.insert(filling.end(), rest.begin(), rest.end());
    filling.push_back({i, j, k});
    std::ranges::sort(filling);
    return filling;
  }

  /// What each has that the other has not.
  static std::array<Triangulated, 2> apart(const Triangulated& one, const Triangulated& other) {
    std::array<Triangulated, 2> differ;
    std::ranges::set_difference(one, other, std::back_inserter(differ[0]));
    std::ranges::set_difference(other, one, std::back_inserter(differ[1]));
    return differ;
  }

  [[nodiscard]] Sign compare_areas(const Triangulated& one, const Triangulated& other) const {
    Interval difference(0);
    for (const Corners& t : one) difference = difference + area(t);
    for (const Corners& t : other) difference = difference - area(t);
    if (const Unsure<Sign> quick = difference.sign(); quick.certain()) return quick.value();
    std::vector<RootTerm> terms;
    for (const Corners& t : one) terms.push_back({1, exact_square(t)});
    for (const Corners& t : other) terms.push_back({-1, exact_square(t)});
    return sign_of_root_sum(terms);
  }

  /// In each plane the triangles of both turn alike and have one boundary: then they cover the same points.
  [[nodiscard]] bool are_one_surface(const Triangulated& one, const Triangulated& other) const {
    struct PlaneOfBoth {
      Corners span;
      std::map<std::array<std::uint32_t, 2>, int> edges;
    };
    std::vector<PlaneOfBoth> planes;
    const auto add = [&](const Corners& t, int times) {
      const auto is_plane = [&](const PlaneOfBoth& p) {
        const Point3 &a = at_[p.span[0]], &b = at_[p.span[1]], &c = at_[p.span[2]];
        return std::ranges::all_of(t, [&](std::uint32_t i) { return orient3d(a, b, c, at_[i]) == Sign::zero; });
      };
      const auto known = std::ranges::find_if(planes, is_plane);
      PlaneOfBoth& plane = known != planes.end() ? *known : planes.emplace_back(PlaneOfBoth{t, {}});
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        plane.edges[{std::min(a, b), std::max(a, b)}] += a < b ? times : -times;
      }
      const auto& [a, b, c] = plane.span;
      const Look look = look_at_plane(at_[a], at_[b], at_[c]);
      const auto turn = [&](const Corners& s) {
        return orient2d(projected(look, at_[s[0]]), projected(look, at_[s[1]]), projected(look, at_[s[2]]));
      };
      return turn(t) == turn(plane.span);
    };
    for (const Corners& t : one)
      if (!add(t, 1)) return false;
    for (const Corners& t : other)
      if (!add(t, -1)) return false;
    const auto is_zero = [](const auto& edge) { return edge.second == 0; };
    return std::ranges::all_of(planes, [&](const PlaneOfBoth& p) { return std::ranges::all_of(p.edges, is_zero); });
  }

  std::span<const std::uint32_t> loop_;
  std::uint32_t n_;
  std::vector<Point3> at_;
  std::vector<Cell> cells_;
};

}  // namespace

std::optional<LeastArea> least_area_filling(std::span<const Point3> points, std::span<const std::uint32_t> loop,
                                            const TakenDiagonal& is_taken) {
  return LeastAreaSearch(points, loop, is_taken).least();
}

}  // namespace plumb::surface
