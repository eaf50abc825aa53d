// Figures for trees: boxes, segments and triangles of the points of point_sets.hpp; nested ones, hugely different sizes,
// and small ones on a lattice, which touch.
#pragma once

#include <algorithm>
#include <array>

#include "plumb/space/kd_tree/figure_tree.hpp"
#include "space/kd_tree/point_sets.hpp"

namespace plumb::figure_sets {

/// Behind those of points.
enum class Kind : unsigned char { nested = point_sets::kinds, sizes, grains };
inline constexpr std::size_t kinds = point_sets::kinds + 3;
inline constexpr std::array<std::string_view, 3> kind_names{"nested", "sizes", "grains"};

inline std::string_view name_of(std::size_t kind) {
  return kind < point_sets::kinds ? point_sets::kind_names[kind] : kind_names[kind - point_sets::kinds];
}

/// One figure's points, of a kind that is none of points.
template <class Point>
std::array<Point, 3> own_points(Kind kind, std::size_t n, Entropy& e) {
  using point_sets::made;
  if (kind == Kind::grains) {
    std::array<double, 3> base;
    for (double& x : base) x = static_cast<double>(e.within(4));
    const auto at = [&](std::size_t axis) { return base[axis] + static_cast<double>(e.below(2)); };
    std::array<Point, 3> points;
    for (Point& p : points) {
      const double x = at(0), y = at(1), z = at(2);
      p = made<Point>(x, y, z);
    }
    return points;
  }
  const bool nested = kind == Kind::nested;
  const double size = nested ? static_cast<double>(1 + e.below(n)) : std::ldexp(1, static_cast<int>(e.within(60)));
  const auto at = [&] { return nested ? 0.0 : static_cast<double>(e.within(3)); };
  const double x = at(), y = at(), z = at();
  return {made<Point>(x - size, y - size, z - size), made<Point>(x + size, y + size, z + size),
          made<Point>(x + size, y - size, z)};
}

template <class Figure>
Figure spanned(const std::array<typename FigureTree<Figure>::Point, 3>& p) {
  if constexpr (requires(const Figure& f) { f.min; }) {
    Figure box{p[0], p[0]};
    box.min.x = std::min(p[0].x, p[1].x), box.max.x = std::max(p[0].x, p[1].x);
    box.min.y = std::min(p[0].y, p[1].y), box.max.y = std::max(p[0].y, p[1].y);
    if constexpr (FigureTree<Figure>::dimension == 3) {
      box.min.z = std::min(p[0].z, p[1].z), box.max.z = std::max(p[0].z, p[1].z);
    }
    return box;
  } else if constexpr (requires(const Figure& f) { f.c; }) {
    return {p[0], p[1], p[2]};
  } else {
    return {p[0], p[1]};
  }
}

template <class Figure>
struct Set {
  std::vector<Figure> figures;
  std::vector<typename FigureTree<Figure>::Point> points;  // that they are spanned by
};

template <class Figure>
Set<Figure> figures(std::size_t kind, std::size_t n, Entropy& e) {
  using Point = typename FigureTree<Figure>::Point;
  Set<Figure> set;
  for (std::size_t i = 0; i < n && kind >= point_sets::kinds; ++i) {
    const auto points = own_points<Point>(static_cast<Kind>(kind), n, e);
    set.points.insert(set.points.end(), points.begin(), points.end());
  }
  if (kind < point_sets::kinds) {
    const auto points = static_cast<point_sets::Kind>(kind);
    // Few, so that figures have corners and edges in common.
    set.points = point_sets::points<Point>(points, 3 + e.below(3 * n), e);
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::array<Point, 3> of;
    for (std::size_t k = 0; k < 3; ++k) {
      of[k] = set.points[kind < point_sets::kinds ? e.below(set.points.size()) : 3 * i + k];
    }
    set.figures.push_back(spanned<Figure>(of));
  }
  return set;
}

/// Where to ask: at corners, half-way between them, elsewhere.
template <class Figure>
typename FigureTree<Figure>::Point place(std::size_t kind, const Set<Figure>& set, Entropy& e) {
  const auto points = static_cast<point_sets::Kind>(std::min(kind, point_sets::kinds - 1));
  return point_sets::query(kind < point_sets::kinds ? points : point_sets::Kind::lattice, set.points, e);
}

}  // namespace plumb::figure_sets
