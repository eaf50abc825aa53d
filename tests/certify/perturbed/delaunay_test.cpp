// What perturbation is for: the empty circles of a grid, where thousands of points lie on common circles, are those of
// one triangulation.  By brute force over all triples and quadruples.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "plumb/certify/perturbed.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb {
namespace {

template <class Point>
void shuffle_indices(std::vector<Point>& points, Entropy& e) {
  for (std::size_t i = 0; i < points.size(); ++i) points[i].index = i;
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1].index, points[e.below(i)].index);
}

using Edge = std::array<std::size_t, 2>;

/// Whether every other point lies left of the edge.
bool on_hull(const std::vector<Indexed2>& p, const Edge& edge) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (i != edge[0] && i != edge[1] && orient2d(perturbed, p[edge[0]], p[edge[1]], p[i]) != Sign::positive)
      return false;
  }
  return true;
}

void expect_triangulation(const std::vector<Indexed2>& p) {
  const std::size_t n = p.size();
  std::map<Edge, int> sides;
  std::set<std::size_t> used;
  std::size_t triangles = 0, hull = 0;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      for (std::size_t c = b + 1; c < n; ++c) {
        const Sign turn = orient2d(perturbed, p[a], p[b], p[c]);
        bool empty = true;
        for (std::size_t d = 0; d < n && empty; ++d) {
          empty = d == a || d == b || d == c || incircle(perturbed, p[a], p[b], p[c], p[d]) == -turn;
        }
        if (!empty) continue;
        ++triangles;
        used.insert({a, b, c});
        const bool left = turn == Sign::positive;
        for (const Edge& edge : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) ++sides[left ? edge : Edge{edge[1], edge[0]}];
      }
    }
  }
  for (const auto& [edge, count] : sides) {
    EXPECT_EQ(count, 1) << "two triangles on one side of an edge";
    const bool twin = sides.contains({edge[1], edge[0]}), outer = on_hull(p, edge);
    EXPECT_NE(twin, outer) << "a triangle beyond every edge but those of the hull";
    hull += outer;
  }
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      if (a != b && on_hull(p, {a, b})) {
        EXPECT_TRUE(sides.contains({a, b})) << "the hull is covered";
      }
    }
  }
  EXPECT_EQ(used.size(), n);
  EXPECT_EQ(triangles, 2 * n - 2 - hull);
}

TEST(PerturbedDelaunay, OfASquareGrid) {
  for (std::uint64_t number = 0; number < 3; ++number) {
    Entropy e(1, number);
    std::vector<Indexed2> points;
    for (int x = 0; x < 5; ++x)
      for (int y = 0; y < 5; ++y) points.push_back({{x * 0.1, y * 0.1}, 0});
    shuffle_indices(points, e);
    expect_triangulation(points);
  }
}

TEST(PerturbedDelaunay, OfPointsOnALineOrInOnePlace) {
  Entropy e(2);
  std::vector<Indexed2> line, place, mixed;
  for (int i = 0; i < 9; ++i) {
    line.push_back({{0.1 * i, 0.1 * i}, 0});
    place.push_back({{0.1, 1e300}, 0});
    mixed.push_back({{i < 5 ? 0.0 : static_cast<double>(i % 3), static_cast<double>(i % 2)}, 0});
  }
  for (std::vector<Indexed2>* points : {&line, &place, &mixed}) {
    shuffle_indices(*points, e);
    expect_triangulation(*points);
  }
}

using Facet = std::array<std::size_t, 3>;

/// The facet with its least corner first, so that turning it does not matter.
Facet turned(Facet f) {
  while (f[0] > f[1] || f[0] > f[2]) f = {f[1], f[2], f[0]};
  return f;
}

/// Whether every other point lies below the facet.
bool on_hull(const std::vector<Indexed3>& p, const Facet& f) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (std::ranges::count(f, i) == 0 && orient3d(perturbed, p[f[0]], p[f[1]], p[f[2]], p[i]) != Sign::positive) {
      return false;
    }
  }
  return true;
}

void expect_tetrahedralization(const std::vector<Indexed3>& p) {
  const std::size_t n = p.size();
  std::map<Facet, int> sides;
  std::set<Edge> edges;
  std::set<Facet> facets;
  std::size_t tetrahedra = 0;
  const auto empty = [&](const std::array<std::size_t, 4>& t, Sign turn) {
    for (std::size_t i = 0; i < n; ++i) {
      if (std::ranges::count(t, i) == 0 && insphere(perturbed, p[t[0]], p[t[1]], p[t[2]], p[t[3]], p[i]) != -turn) {
        return false;
      }
    }
    return true;
  };
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      for (std::size_t c = b + 1; c < n; ++c) {
        for (std::size_t d = c + 1; d < n; ++d) {
          const Sign turn = orient3d(perturbed, p[a], p[b], p[c], p[d]);
          if (!empty({a, b, c, d}, turn)) continue;
          ++tetrahedra;
          edges.insert({{a, b}, {a, c}, {a, d}, {b, c}, {b, d}, {c, d}});
          for (Facet f : {Facet{a, b, c}, Facet{a, d, b}, Facet{a, c, d}, Facet{b, d, c}}) {
            facets.insert([sorted = f]() mutable {
              std::ranges::sort(sorted);
              return sorted;
            }());
            if (turn == Sign::negative) std::swap(f[1], f[2]);
            ++sides[turned(f)];  // the fourth corner lies below it
          }
        }
      }
    }
  }
  for (const auto& [f, count] : sides) {
    EXPECT_EQ(count, 1) << "two tetrahedra on one side of a facet";
    EXPECT_NE(sides.contains(turned({f[0], f[2], f[1]})), on_hull(p, f))
        << "a neighbor beyond each facet but the hull's";
  }
  EXPECT_EQ(n + facets.size(), edges.size() + tetrahedra + 1) << "Euler";
}

TEST(PerturbedDelaunay, OfACubicGrid) {
  for (std::uint64_t number = 0; number < 2; ++number) {
    Entropy e(3, number);
    std::vector<Indexed3> points;
    for (int i = 0; i < 27; ++i) {
      points.push_back({{static_cast<double>(i % 3), static_cast<double>(i / 3 % 3), static_cast<double>(i / 9)}, 0});
    }
    shuffle_indices(points, e);
    expect_tetrahedralization(points);
  }
}

TEST(PerturbedDelaunay, OfPointsInAPlaneOrInOnePlace) {
  Entropy e(4);
  std::vector<Indexed3> plane, line, place, mixed;
  for (int i = 0; i < 9; ++i) {
    const auto x = static_cast<double>(i % 3), y = static_cast<double>(i / 3);
    plane.push_back({{x, y, x + y}, 0});
    line.push_back({{0.1 * i, 0, 0.2 * i}, 0});
    place.push_back({{0.1, 0.2, -1e300}, 0});
    mixed.push_back({{static_cast<double>(i % 2), static_cast<double>(i / 2 % 2), 0.0}, 0});
  }
  for (std::vector<Indexed3>* points : {&plane, &line, &place, &mixed}) {
    shuffle_indices(*points, e);
    expect_tetrahedralization(*points);
  }
}

}  // namespace
}  // namespace plumb
