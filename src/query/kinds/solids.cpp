#include "query/kinds/solids.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "plumb/degenerate/cloud.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb::degenerate {

namespace {

using FaceCorners = std::array<std::size_t, 3>;

Int up_to(Int most, Entropy& entropy) { return 1 + static_cast<Int>(entropy.below(static_cast<std::uint64_t>(most))); }

/// With a volume, and as long as one another in half of the cases.
Int3 solid_extent(Entropy& entropy) {
  constexpr std::array long_ones{Form::plain, Form::plain, Form::plain, Form::needle, Form::cap, Form::sliver};
  const int bits = static_cast<int>(entropy.below(6));
  return extent_of(long_ones[entropy.below(long_ones.size())], bits, entropy);
}

/// Four corners in one plane, in order, cut along one diagonal or the other.
void add_quad(Solid& solid, std::array<std::size_t, 4> q, Entropy& entropy) {
  if (entropy.coin()) std::rotate(q.begin(), q.begin() + 1, q.end());
  solid.triangles.push_back({q[0], q[1], q[2]});
  solid.triangles.push_back({q[0], q[2], q[3]});
}

void reverse(Solid& solid) {
  for (FaceCorners& t : solid.triangles) std::swap(t[0], t[1]);
}

void append(Solid& solid, const Solid& other) {
  const std::size_t first = solid.points.size();
  solid.points.insert(solid.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.triangles) solid.triangles.push_back({first + a, first + b, first + c});
}

Solid box_between(const Int3& low, const Int3& high, Entropy& entropy) {
  Solid solid;
  for (std::size_t i = 0; i < 8; ++i) {
    solid.points.push_back({(i & 1 ? high : low)[0], (i & 2 ? high : low)[1], (i & 4 ? high : low)[2]});
  }
  constexpr std::array<std::array<std::size_t, 4>, 6> faces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& face : faces) add_quad(solid, face, entropy);
  return solid;
}

Solid box(Entropy& entropy) { return box_between({0, 0, 0}, solid_extent(entropy), entropy); }

constexpr std::array<std::array<Int, 2>, 8> directions{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// Corners of a star about the origin, counterclockwise.
std::vector<Int3> star(Int most, Entropy& entropy) {
  constexpr std::array<std::array<std::size_t, 2>, 3> layouts{{{4, 2}, {8, 1}, {3, 3}}};  // corners, from each to next
  const auto [corners, step] = layouts[entropy.below(layouts.size())];
  std::vector<Int3> ring;
  for (std::size_t i = 0; i < corners; ++i) {
    const auto& [x, y] = directions[i * step % directions.size()];
    const Int far = up_to(most, entropy);
    ring.push_back({far * x, far * y, 0});
  }
  return ring;
}

Solid prism(Entropy& entropy) {
  const Int3 extent = solid_extent(entropy);
  Solid solid{star(extent[0], entropy), {}};
  const std::size_t n = solid.points.size();
  const Int3 up{entropy.within(extent[0]), entropy.within(extent[1]), extent[2]};
  for (std::size_t i = 0; i < n; ++i) solid.points.push_back(solid.points[i] + up);
  solid.points.push_back({0, 0, 0});
  solid.points.push_back(up);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    add_quad(solid, {i, next, n + next, n + i}, entropy);
    solid.triangles.push_back({next, i, 2 * n});
    solid.triangles.push_back({n + i, n + next, 2 * n + 1});
  }
  return solid;
}

Solid bipyramid(Entropy& entropy) {
  const Int3 extent = solid_extent(entropy);
  Solid solid{star(extent[0], entropy), {}};
  const std::size_t n = solid.points.size();
  solid.points.push_back({0, 0, extent[2]});
  solid.points.push_back({0, 0, -up_to(extent[2], entropy)});
  for (std::size_t i = 0; i < n; ++i) {
    solid.triangles.push_back({i, (i + 1) % n, n});
    solid.triangles.push_back({(i + 1) % n, i, n + 1});
  }
  return solid;
}

Solid hull(Entropy& entropy) {
  struct Made {
    Cloud cloud;
    double scale;  // that makes integers
  };
  constexpr std::array made{Made{Cloud::lattice, 1}, Made{Cloud::facets, 1},    Made{Cloud::exact_sphere, 1},
                            Made{Cloud::moments, 1}, Made{Cloud::ball, 0x1p10}, Made{Cloud::prism, 0x1p10}};
  const auto& [cloud, scale] = made[entropy.below(made.size())];
  std::vector<Point3> points = cloud3(cloud, 4 + entropy.below(13), entropy);
  for (Point3& p : points) p = {std::trunc(scale * p.x), std::trunc(scale * p.y), std::trunc(scale * p.z)};
  const Hull3 found = convex_hull(points, {.triangulate = true});
  if (found.dimension < 3) return box(entropy);
  Solid solid;
  for (const Point3& p : points) {
    solid.points.push_back({static_cast<Int>(p.x), static_cast<Int>(p.y), static_cast<Int>(p.z)});
  }
  for (std::size_t i = 0; i < found.corners.size(); i += 3) {
    solid.triangles.push_back({found.corners[i], found.corners[i + 1], found.corners[i + 2]});
  }
  return solid;
}

/// An octahedron whose faces are cut in four, once or twice, its points moved onto a sphere, as integers can.
Solid sphere(Entropy& entropy) {
  const double radius = std::ldexp(1.0, 6 + static_cast<int>(entropy.below(7)));
  Solid solid{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
              {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  const auto onto_sphere = [radius](const Int3& p) {
    const double by = radius / std::sqrt(static_cast<double>(dot(p, p)));
    const auto rounded = [by](Int x) { return static_cast<Int>(std::round(by * static_cast<double>(x))); };
    return Int3{rounded(p[0]), rounded(p[1]), rounded(p[2])};
  };
  for (Int3& p : solid.points) p = onto_sphere(p);
  for (std::uint64_t times = 1 + entropy.below(2); times > 0; --times) {
    std::map<std::array<std::size_t, 2>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto [at, fresh] = middles.try_emplace({std::min(a, b), std::max(a, b)}, solid.points.size());
      if (fresh) solid.points.push_back(onto_sphere(solid.points[a] + solid.points[b]));
      return at->second;
    };
    std::vector<FaceCorners> finer;
    for (const auto& [a, b, c] : solid.triangles) {
      const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    solid.triangles = std::move(finer);
  }
  return solid;
}

/// A rectangle led around an axis in four or eight steps.
Solid torus(Entropy& entropy) {
  const Int3 extent = solid_extent(entropy);
  const std::size_t step = 1 + static_cast<std::size_t>(entropy.below(2)), n = directions.size() / step;
  const Int inner = up_to(extent[0], entropy), outer = inner + up_to(extent[1], entropy);
  const std::array<std::array<Int, 2>, 4> section{{{inner, 0}, {outer, 0}, {outer, extent[2]}, {inner, extent[2]}}};
  Solid solid;
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [x, y] = directions[i * step];
    for (const auto& [far, high] : section) solid.points.push_back({far * x, far * y, high});
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t l = (k + 1) % 4;
      add_quad(solid, {4 * i + k, 4 * next + k, 4 * next + l, 4 * i + l}, entropy);
    }
  }
  return solid;
}

/// A box with a hollow one in it, which may touch its walls.
Solid cavity(Entropy& entropy) {
  Int3 low{}, high{}, size{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto some = [&](Int most) { return static_cast<Int>(entropy.below(static_cast<std::uint64_t>(most) + 1)); };
    low[k] = some(3);
    high[k] = low[k] + 1 + some(3);
    size[k] = high[k] + some(3);
  }
  Solid hollow = box_between(low, high, entropy);
  reverse(hollow);
  Solid solid = box_between({0, 0, 0}, size, entropy);
  append(solid, hollow);
  return solid;
}

/// Two boxes that share a face, an edge, a corner, parts of them, or overlap.
Solid pair(Entropy& entropy) {
  const auto side = [&] {
    const Int low = static_cast<Int>(entropy.below(5));
    return std::array{low, low + up_to(4, entropy)};
  };
  const auto x = side(), y = side(), z = side();
  Solid solid = box_between({0, 0, 0}, {4, 4, 4}, entropy);
  append(solid, box_between({x[0], y[0], z[0]}, {x[1], y[1], z[1]}, entropy));
  return solid;
}

/// A box each of whose faces is cut into squares.
Solid cut_box(Entropy& entropy) {
  const Int n = 1 + up_to(3, entropy);
  Solid solid;
  std::map<Int3, std::size_t> numbers;
  const auto at = [&](const Int3& p) {
    const auto [found, fresh] = numbers.try_emplace(p, solid.points.size());
    if (fresh) solid.points.push_back(p);
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const Int side : {Int{0}, n}) {
      for (Int i = 0; i < n * n; ++i) {
        Int3 p{};
        p[axis] = side;
        p[u] = i % n, p[v] = i / n;
        Int3 q = p, r = p, s = p;
        ++q[u], ++r[u], ++r[v], ++s[v];
        if (side == 0) std::swap(q, s);
        add_quad(solid, {at(p), at(q), at(r), at(s)}, entropy);
      }
    }
  }
  return solid;
}

Solid any_simple(Entropy& entropy) {
  constexpr std::array makers{box, bipyramid, prism, hull};
  return makers[entropy.below(makers.size())](entropy);
}

/// Edges that have a point in their middle on one side only, and a triangle without area between.
Solid slits(Entropy& entropy) {
  Solid solid = any_simple(entropy);
  solid.multiply(2);
  for (Int times = up_to(4, entropy); times > 0; --times) {
    const std::size_t t = entropy.below(solid.triangles.size());
    const auto [a, b, c] = solid.triangles[t];
    const Int3 sum = solid.points[a] + solid.points[b];
    if (sum[0] % 2 != 0 || sum[1] % 2 != 0 || sum[2] % 2 != 0) continue;
    const std::size_t m = solid.points.size();
    solid.points.push_back({sum[0] / 2, sum[1] / 2, sum[2] / 2});
    solid.triangles[t] = {a, m, c};
    solid.triangles.push_back({m, b, c});
    solid.triangles.push_back({a, b, m});
  }
  return solid;
}

/// Each triangle has corners of its own, or some have.
Solid unwelded(Entropy& entropy) {
  Solid solid = any_simple(entropy);
  const bool all = !entropy.coin();
  for (FaceCorners& t : solid.triangles) {
    for (std::size_t& i : t) {
      if (!all && entropy.coin()) continue;
      solid.points.push_back(solid.points[i]);
      i = solid.points.size() - 1;
    }
  }
  return solid;
}

/// Triangles between any of its points, each with its reverse: they are boundary, and bound nothing.
Solid fins(Entropy& entropy) {
  Solid solid = any_simple(entropy);
  for (Int times = up_to(4, entropy); times > 0; --times) {
    const auto any = [&] { return static_cast<std::size_t>(entropy.below(solid.points.size())); };
    const std::size_t a = any(), b = any(), c = any();
    solid.triangles.insert(solid.triangles.end(), {{a, b, c}, {b, a, c}});
  }
  return solid;
}

Solid inside_out(Entropy& entropy) {
  Solid solid = any_simple(entropy);
  reverse(solid);
  return solid;
}

/// Heights over a grid; in one plane in a quarter of the cases.
Solid terrain(Entropy& entropy) {
  const Int n = 1 + up_to(4, entropy), most = entropy.below(4) == 3 ? 1 : Int{1} << entropy.below(6);
  Solid solid;
  for (Int i = 0; i < n * n; ++i) {
    solid.points.push_back({i % n, i / n, static_cast<Int>(entropy.below(static_cast<std::uint64_t>(most)))});
  }
  for (Int i = 0; i < (n - 1) * (n - 1); ++i) {
    const auto p = static_cast<std::size_t>(i / (n - 1) * n + i % (n - 1)), up = static_cast<std::size_t>(n);
    add_quad(solid, {p, p + 1, p + up + 1, p + up}, entropy);
  }
  return solid;
}

/// Any three of a few points of a small grid: flat triangles, repeated and reversed ones, such that cross.
Solid soup(Entropy& entropy) {
  Solid solid;
  for (std::uint64_t n = 3 + entropy.below(6); n > 0; --n) {
    solid.points.push_back({entropy.within(3), entropy.within(3), entropy.within(3)});
  }
  for (Int m = up_to(12, entropy); m > 0; --m) {
    const auto any = [&] { return static_cast<std::size_t>(entropy.below(solid.points.size())); };
    const std::size_t a = any(), b = any(), c = any();
    solid.triangles.push_back({a, b, c});
    if (entropy.below(4) == 3) solid.triangles.push_back({b, a, c});
  }
  return solid;
}

constexpr std::array closed_sorts{
    SolidSort{"box", "a box", box},
    SolidSort{"prism", "a slanting prism over a star", prism},
    SolidSort{"bipyramid", "two pyramids over a star", bipyramid},
    SolidSort{"hull", "the convex hull of a cloud, faces in one plane cut into triangles", hull},
    SolidSort{"sphere", "32 or 128 triangles about a ball", sphere},
    SolidSort{"torus", "a ring", torus},
    SolidSort{"cavity", "a box with a hollow in it, which may touch the walls", cavity},
    SolidSort{"pair", "two boxes that share a face, an edge or a corner, or overlap", pair},
    SolidSort{"cut", "a box, each face cut into squares", cut_box},
    SolidSort{"slits", "edges cut on one side only, a triangle without area between", slits},
    SolidSort{"unwelded", "equal points with different indices: each triangle has its own, or some have", unwelded},
    SolidSort{"fins", "triangles with their reverse, which bound nothing, but are boundary", fins},
    SolidSort{"inside_out", "triangles clockwise seen from outside", inside_out},
};

constexpr std::array open_sorts{
    SolidSort{"terrain", "heights over a grid, or a plane cut into triangles", terrain},
    SolidSort{"soup", "any triangles of a few points: flat, repeated, reversed, crossing ones", soup},
};

}  // namespace

void Solid::multiply(Int by) {
  for (Int3& p : points) p = by * p;
}

std::span<const SolidSort> solid_sorts() { return closed_sorts; }
std::span<const SolidSort> sheet_sorts() { return open_sorts; }

void turn(Solid& solid, Entropy& entropy) {
  IntMap map = any_permutation(3, entropy);
  if (entropy.below(3) == 2) map = after(map, any_turn(entropy));
  for (Int3& p : solid.points) p = map(p);
  if (dot(map.columns[0], cross(map.columns[1], map.columns[2])) < 0) reverse(solid);
}

}  // namespace plumb::degenerate
