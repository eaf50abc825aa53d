#include "lab/trial/cut_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "lab/trial/cutting_judge.hpp"
#include "plumb/degenerate/coordinates.hpp"

namespace plumb::lab::trial {
namespace {

void put_corner(CutPolygon& q, std::size_t i, double x, double y) { q[2 * i] = x, q[2 * i + 1] = y; }

void draw_star(CutPolygon& q, Entropy& entropy) {
  for (std::size_t i = 0; i < cut_corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / cut_corners,
                 far = 0.1 + unit_coordinate(entropy);
    put_corner(q, i, far * std::cos(angle), far * std::sin(angle));
  }
}

/// The outline of a square and a notch of it, with vertices anywhere on the edges: times `scale`.
void draw_outline(CutPolygon& q, Entropy& entropy, double scale) {
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
  while (all.size() > cut_corners) {  // those between corners, by chance
    const std::size_t i = entropy.below(all.size());
    if (std::ranges::count(ring, all[i]) == 0) all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
  }
  const std::size_t first = entropy.below(cut_corners);
  for (std::size_t i = 0; i < cut_corners; ++i)
    put_corner(q, i, all[(first + i) % cut_corners][0] * scale, all[(first + i) % cut_corners][1] * scale);
}

void draw_lattice(CutPolygon& q, Entropy& entropy) { draw_outline(q, entropy, 1); }
void draw_tenths(CutPolygon& q, Entropy& entropy) { draw_outline(q, entropy, 0.1); }

/// A chain along a line, off it by ulps, closed over one point far from it.
void draw_chain(CutPolygon& q, Entropy& entropy) {
  for (std::size_t i = 0; i + 1 < cut_corners; ++i) {
    const double x = 1 + static_cast<double>(i) / 16;
    put_corner(q, i, x, x / 3 + std::ldexp(static_cast<double>(entropy.within(2)), -52));
  }
  put_corner(q, cut_corners - 1, 1.5, 4);
}

/// A strip along a line, one to four ulps wide.
void draw_strip(CutPolygon& q, Entropy& entropy) {
  for (std::size_t i = 0; i < cut_corners / 2; ++i) {
    const double x = 1 + static_cast<double>(i) / 8;
    const double y = x / 3 + std::ldexp(static_cast<double>(entropy.within(1)), -53);
    put_corner(q, i, x, y);
    put_corner(q, cut_corners - 1 - i, x, y + std::ldexp(static_cast<double>(1 + entropy.below(2)), -53));
  }
}

/// The stars, a few hundredths of a millimeter across, where the unit is a meter.
void draw_small(CutPolygon& q, Entropy& entropy) {
  draw_star(q, entropy);
  for (double& x : q) x = std::ldexp(x, -16);
}

/// A square with a square hole, reached over a bridge that is walked both ways; lengths in tenths.
void draw_holed(CutPolygon& q, Entropy& entropy) {
  const double a = 0.1 * static_cast<double>(1 + entropy.below(5)),
               b = a + 0.1 * static_cast<double>(1 + entropy.below(3));
  const double middle = 0.1 * static_cast<double>(2 + entropy.below(5));
  const std::array<std::array<double, 2>, cut_corners> ring{{{0, 0},
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
  for (std::size_t i = 0; i < cut_corners; ++i) put_corner(q, i, ring[i][0], ring[i][1]);
}

}  // namespace

void PolygonFamily::fill(CutPolygon& polygon, Entropy& entropy) const {
  do {
    draw(polygon, entropy);
  } while (CuttingJudge(polygon).crosses_itself());
}

std::span<const PolygonFamily> polygon_families() {
  static const std::vector<PolygonFamily> all{
      {"stars", "rays of any length about a point, nothing degenerate", draw_star},
      {"lattice", "a notched square with vertices on its edges, of integers", draw_lattice},
      {"tenths", "the same in tenths, so that the vertices are beside the edges", draw_tenths},
      {"chain", "a chain of vertices that are off a line by ulps", draw_chain},
      {"strip", "a strip along a line, some ulps wide", draw_strip},
      {"small", "the stars, 2^-16 of their size", draw_small},
      {"bridged-hole", "a square with a hole that is reached over a bridge", draw_holed}};
  return all;
}

}  // namespace plumb::lab::trial
