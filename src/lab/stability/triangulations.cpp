// Polygons cut into triangles, ear by ear and by the library: who loses a vertex, who covers too much.  Judged in GMP's
// rationals.
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "lab/stability/float_ways.hpp"
#include "lab/trial/ear_clipping.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/surface/planar/triangulate_polygon.hpp"

namespace plumb::lab::stability {
namespace {

constexpr std::size_t corners = 16;
using PolygonQuestion = std::array<double, 2 * corners>;
using PolygonAnswer = std::optional<trial::EarTriangles>;
using PolygonWay = Way<2 * corners, PolygonAnswer>;
using ExactPlace = trial::Place<mpq_class>;

struct Ears {
  template <class T>
  PolygonAnswer operator()(const std::array<T, 2 * corners>& q, T epsilon) const {
    std::vector<trial::Place<T>> points;
    for (std::size_t i = 0; i < q.size(); i += 2) points.push_back({q[i], q[i + 1]});
    return trial::EarClipping<T>(points, epsilon).run();
  }
};

PolygonAnswer ours(const PolygonQuestion& q) {
  Polygon2 polygon;
  for (std::size_t i = 0; i < q.size(); i += 2) polygon.vertices.push_back({q[i], q[i + 1]});
  return triangulate(polygon);
}

/// Fills the question with a path that turns left and crosses itself nowhere.
using FillPolygon = void (*)(PolygonQuestion& q, Entropy& entropy);

void put(PolygonQuestion& q, std::size_t i, double x, double y) { q[2 * i] = x, q[2 * i + 1] = y; }

void fill_star(PolygonQuestion& q, Entropy& entropy) {
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / corners, far = 0.1 + unit_coordinate(entropy);
    put(q, i, far * std::cos(angle), far * std::sin(angle));
  }
}

/// The outline of a square and a notch of it, with vertices anywhere on the edges: times `scale`.
void fill_outline(PolygonQuestion& q, Entropy& entropy, double scale) {
  const auto notch = static_cast<double>(1 + entropy.below(6));  // from the right edge inward, between y = 2 and 4
  const std::vector<std::array<double, 2>> ring{{0, 0},         {8, 0}, {8, 2}, {8 - notch, 2},
                                                {8 - notch, 4}, {8, 4}, {8, 8}, {0, 8}};
  std::vector<std::array<double, 2>> all;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto [x, y] = ring[i];
    const auto [u, v] = ring[(i + 1) % ring.size()];
    const double steps = std::max(std::fabs(u - x), std::fabs(v - y));
    for (double s = 0; s < steps; ++s) all.push_back({x + (u - x) * s / steps, y + (v - y) * s / steps});
  }
  while (all.size() > corners) {  // those between corners, by chance
    const std::size_t i = entropy.below(all.size());
    if (std::ranges::count(ring, all[i]) == 0) all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
  }
  const std::size_t first = entropy.below(corners);
  for (std::size_t i = 0; i < corners; ++i)
    put(q, i, all[(first + i) % corners][0] * scale, all[(first + i) % corners][1] * scale);
}

void fill_lattice(PolygonQuestion& q, Entropy& entropy) { fill_outline(q, entropy, 1); }
void fill_tenths(PolygonQuestion& q, Entropy& entropy) { fill_outline(q, entropy, 0.1); }

/// A chain along a line, off it by ulps, closed over one point far from it.
void fill_chain(PolygonQuestion& q, Entropy& entropy) {
  for (std::size_t i = 0; i + 1 < corners; ++i) {
    const double x = 1 + static_cast<double>(i) / 16;
    put(q, i, x, x / 3 + std::ldexp(static_cast<double>(entropy.within(2)), -52));
  }
  put(q, corners - 1, 1.5, 4);
}

/// A strip along a line, one to four ulps wide.
void fill_strip(PolygonQuestion& q, Entropy& entropy) {
  for (std::size_t i = 0; i < corners / 2; ++i) {
    const double x = 1 + static_cast<double>(i) / 8;
    const double y = x / 3 + std::ldexp(static_cast<double>(entropy.within(1)), -53);
    put(q, i, x, y);
    put(q, corners - 1 - i, x, y + std::ldexp(static_cast<double>(1 + entropy.below(2)), -53));
  }
}

/// The stars, a few hundredths of a millimeter across, where the unit is a meter.
void fill_small(PolygonQuestion& q, Entropy& entropy) {
  fill_star(q, entropy);
  for (double& x : q) x = std::ldexp(x, -16);
}

/// A square with a square hole, reached over a bridge that is walked both ways; lengths in tenths.
void fill_holed(PolygonQuestion& q, Entropy& entropy) {
  const double a = 0.1 * static_cast<double>(1 + entropy.below(5)),
               b = a + 0.1 * static_cast<double>(1 + entropy.below(3));
  const double middle = 0.1 * static_cast<double>(2 + entropy.below(5));
  const std::array<std::array<double, 2>, corners> ring{{{0, 0},
                                                         {a, 0},
                                                         {a, a},
                                                         {a, b},
                                                         {b, b},
                                                         {b, a},
                                                         {a, a},
                                                         {a, 0},
                                                         {b, 0},
                                                         {0.9, 0},
                                                         {0.9, middle},
                                                         {0.9, 0.9},
                                                         {b, 0.9},
                                                         {middle, 0.9},
                                                         {0, 0.9},
                                                         {0, middle}}};
  for (std::size_t i = 0; i < corners; ++i) put(q, i, ring[i][0], ring[i][1]);
}

/// What is true of a polygon.
class PolygonJudge {
 public:
  explicit PolygonJudge(const PolygonQuestion& q) {
    for (std::size_t i = 0; i < q.size(); i += 2) points_.push_back({mpq_class(q[i]), mpq_class(q[i + 1])});
  }
  /// Crosses an edge another between their ends?  Then it is no question.
  [[nodiscard]] bool crosses_itself() const {
    for (std::size_t i = 0; i < corners; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const ExactPlace &a = points_[i], &b = points_[(i + 1) % corners], &c = points_[k],
                         &d = points_[(k + 1) % corners];
        if (sgn(area(a, b, c)) * sgn(area(a, b, d)) < 0 && sgn(area(c, d, a)) * sgn(area(c, d, b)) < 0) return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool lost(const trial::EarTriangles& triangles) const {
    std::set<std::array<mpq_class, 2>> named;
    for (const auto& t : triangles)
      for (const std::uint32_t v : t) named.insert({points_[v].x, points_[v].y});
    return !std::ranges::all_of(points_, [&](const ExactPlace& p) { return named.contains({p.x, p.y}); });
  }
  [[nodiscard]] bool other_area(const trial::EarTriangles& triangles) const {
    mpq_class whole = 0, sum = 0;
    for (std::size_t i = 1; i + 1 < corners; ++i) whole += area(points_[0], points_[i], points_[i + 1]);
    for (const auto& [a, b, c] : triangles) sum += abs(area(points_[a], points_[b], points_[c]));
    return sum != whole;
  }
  [[nodiscard]] bool flat(const trial::EarTriangles& triangles) const {
    return std::ranges::any_of(triangles,
                               [&](const auto& t) { return area(points_[t[0]], points_[t[1]], points_[t[2]]) <= 0; });
  }
  /// Neither is beyond an edge of the other.
  [[nodiscard]] bool overlap(const trial::EarTriangles& triangles) const {
    const auto parts = [&](const auto& s, const auto& t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const ExactPlace &a = points_[s[k]], &b = points_[s[(k + 1) % 3]];
        if (std::ranges::all_of(t, [&](std::uint32_t v) { return area(a, b, points_[v]) <= 0; })) return true;
      }
      return false;
    };
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (!parts(triangles[i], triangles[k]) && !parts(triangles[k], triangles[i])) return true;
    return false;
  }

 private:
  std::vector<ExactPlace> points_;
};

Findings triangulated(FillPolygon fill, const Settings& settings) {
  std::vector<std::pair<PolygonQuestion, PolygonJudge>> cases;
  for (std::uint64_t i = 0, n = settings.quick ? 60 : 2000; i < n; ++i) {
    Entropy entropy(settings.seed, i);
    PolygonQuestion q{};
    fill(q, entropy);
    PolygonJudge judge(q);
    if (!judge.crosses_itself()) cases.emplace_back(q, std::move(judge));
  }
  auto ways = float_ways<2 * corners, PolygonAnswer>(Ears{});
  ways.push_back(exact_way<2 * corners, PolygonAnswer>(ours));
  return {outcomes_of(ways,
                      [&](const PolygonWay& way) {
                        std::vector<Count> counts{{"polygons that lost a vertex"},
                                                  {"polygons covered by another area than theirs"},
                                                  {"polygons with a triangle of no area, or turned over"},
                                                  {"polygons whose triangles overlap"},
                                                  {"polygons left without triangles: no ear was found"}};
                        for (const auto& [question, judge] : cases) {
                          const PolygonAnswer told = way.ask(question);
                          ++counts[4].of;
                          if (!told) ++counts[4].failures;
                          if (!told) continue;
                          const std::array failed{judge.lost(*told), judge.other_area(*told), judge.flat(*told),
                                                  judge.overlap(*told)};
                          for (std::size_t k = 0; k < failed.size(); ++k) {
                            ++counts[k].of;
                            counts[k].failures += failed[k];
                          }
                        }
                        return counts;
                      }),
          {}};
}

}  // namespace

Experiment triangulation_experiment() {
  return {"triangulation", "do triangles cover a polygon, all of its vertices kept?", "RTCD 12.5.1",
          [](const Settings& settings) {
            const auto scene = [&](std::string name, std::string about, FillPolygon fill) {
              return Scene{std::move(name), std::move(about), [=] { return triangulated(fill, settings); }};
            };
            return std::vector{
                scene("stars", "rays of any length about a point, nothing degenerate", fill_star),
                scene("lattice", "a notched square with vertices on its edges, of integers", fill_lattice),
                scene("tenths", "the same in tenths, so that the vertices are beside the edges", fill_tenths),
                scene("chain", "a chain of vertices that are off a line by ulps", fill_chain),
                scene("strip", "a strip along a line, some ulps wide", fill_strip),
                scene("small", "the stars, 2^-16 of their size", fill_small),
                scene("bridged-hole", "a square with a hole that is reached over a bridge", fill_holed)};
          }};
}

}  // namespace plumb::lab::stability
