// Boxes for the broad phase: random, clustered, touching on a lattice and off it by an ulp, all equal, nested, of
// hugely different sizes, flat, with numbers of any size and zeros of both signs.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/space/pairs/float_boxes.hpp"

namespace plumb::box_scenes {

enum class Scene {
  uniform,
  clustered,
  lattice,
  off_lattice,
  equal,
  nested,
  sizes,
  flat,
  extreme,
  one_far,
  needles,
  on_a_line
};
inline constexpr Scene last_scene = Scene::on_a_line;

inline double part(Entropy& e) { return static_cast<double>(e.bits(53)) * 0x1p-53; }

/// A number from the least to the greatest doubles, or a zero.
inline double any_number(Entropy& e) {
  const double x = std::ldexp(1 + part(e), static_cast<int>(e.below(2098)) - 1074) * 0.5;
  return e.below(16) == 0 ? (e.coin() ? -0.0 : 0.0) : e.coin() ? x : -x;
}

/// One axis of one box.
struct Interval {
  double from, to;
};

inline Interval interval(Scene scene, Entropy& e, double n, std::size_t axis, double size) {
  const double side = std::cbrt(n) * 1.5;
  const auto moved = [&](double x) {
    const auto way = e.below(3);
    return way == 0 ? x : std::nextafter(x, way == 1 ? -1e9 : 1e9);
  };
  switch (scene) {
    case Scene::uniform: {
      const double x = side * part(e);
      return {x, x + 2 * part(e)};
    }
    case Scene::clustered: {
      const double x = static_cast<double>(e.below(3)) * 100 + part(e) * part(e);
      return {x, x + 0.25 * part(e)};
    }
    case Scene::lattice: {
      const auto x = static_cast<double>(e.below(static_cast<std::uint64_t>(side)));
      return {x, x + static_cast<double>(e.below(3))};
    }
    case Scene::off_lattice: {
      const double x = 1 + static_cast<double>(e.below(static_cast<std::uint64_t>(side)));
      return {moved(x), moved(x + 1)};
    }
    case Scene::equal:
      return {1, 2};
    case Scene::nested:
      return {-size, size};
    case Scene::sizes: {
      const double x = 1000 * part(e);
      return {x, x + std::pow(1000.0, part(e))};
    }
    case Scene::flat: {
      const auto x = static_cast<double>(e.below(6));
      return {x, e.coin() ? x : x + 1};
    }
    case Scene::extreme: {
      const double x = any_number(e), y = any_number(e);
      return {x < y ? x : y, x < y ? y : x};
    }
    case Scene::one_far: {
      const double x = size == 0 ? 1e300 : side * part(e);
      return {x, x + 1.5};
    }
    case Scene::needles: {
      const double x = side * part(e);
      return {x, x + (static_cast<std::size_t>(size * 64) % 3 == axis ? side : 0.5)};
    }
    case Scene::on_a_line: {
      const double x = axis == 1 ? n * part(e) : 3;
      return {x, axis == 1 ? x + 2 : 3.0};
    }
  }
  return {0, 0};
}

inline std::vector<Aabb3> boxes_of(Scene scene, Entropy& e, std::size_t n) {
  std::vector<Aabb3> boxes;
  for (std::size_t i = 0; i < n; ++i) {
    const double size = static_cast<double>(i) / 64;
    const Interval x = interval(scene, e, static_cast<double>(n), 0, size);
    const Interval y = interval(scene, e, static_cast<double>(n), 1, size);
    const Interval z = interval(scene, e, static_cast<double>(n), 2, size);
    boxes.push_back({{x.from, y.from, z.from}, {x.to, y.to, z.to}});
  }
  return boxes;
}

inline std::vector<Aabb2> in_the_plane(const std::vector<Aabb3>& boxes) {
  std::vector<Aabb2> all;
  for (const Aabb3& b : boxes) all.push_back({{b.min.x, b.min.y}, {b.max.x, b.max.y}});
  return all;
}

/// The nearest floats.
inline std::vector<FloatBox3> in_floats(const std::vector<Aabb3>& boxes) {
  constexpr double most = std::numeric_limits<float>::max();
  const auto f = [](double x) { return static_cast<float>(x > most ? most : x < -most ? -most : x); };
  std::vector<FloatBox3> all;
  for (const Aabb3& b : boxes)
    all.push_back({{f(b.min.x), f(b.min.y), f(b.min.z)}, {f(b.max.x), f(b.max.y), f(b.max.z)}});
  return all;
}
inline std::vector<FloatBox2> in_floats(const std::vector<Aabb2>& boxes) {
  std::vector<Aabb3> lifted;
  for (const Aabb2& b : boxes) lifted.push_back({{b.min.x, b.min.y, 0}, {b.max.x, b.max.y, 0}});
  std::vector<FloatBox2> all;
  for (const FloatBox3& b : in_floats(lifted)) all.push_back({{b.min[0], b.min[1]}, {b.max[0], b.max[1]}});
  return all;
}

}  // namespace plumb::box_scenes
