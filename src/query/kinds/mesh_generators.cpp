#include "query/kinds/mesh_generators.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "plumb/degenerate/moves.hpp"
#include "query/kinds/solids.hpp"

namespace plumb::degenerate {

namespace {

/// Divides halves and thirds of edges and faces, and halves of those.
constexpr Int parts = 12;

Int3 half_way(const Int3& a, const Int3& b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}; }
Int3 third(const Int3& sum) { return {sum[0] / 3, sum[1] / 3, sum[2] / 3}; }

void append_triangles(Numbers& numbers, std::span<const std::array<std::size_t, 3>> triangles) {
  numbers.push_back(static_cast<double>(triangles.size()));
  for (const auto& t : triangles) {
    for (const std::size_t i : t) numbers.push_back(static_cast<double>(i));
  }
}

/// A solid, and places that have to do with it.
class Scene {
 public:
  Scene(Solid solid, Entropy& entropy) : solid_(std::move(solid)), entropy_(entropy) {
    turn(solid_, entropy_);
    solid_.multiply(parts);
    for (const Int3& p : solid_.points) {
      for (const Int x : p) size_ = std::max(size_, std::abs(x));
    }
  }

  void point_case(Numbers& numbers) {
    const Int3 p = place();
    const Placement placement = placement_of({p});
    numbers.clear();
    add_point(numbers, p, placement);
    if (entropy_.below(4) == 3) move_by_ulps(numbers, 2, 3, entropy_);
    add_mesh(numbers, placement);
  }

  void ray_case(Numbers& numbers) {
    auto [origin, direction] = ray();
    const Int common = std::gcd(direction[0], std::gcd(direction[1], direction[2]));
    if (common > 0 && entropy_.coin()) {
      for (Int& d : direction) d /= common;
    }
    if (entropy_.below(8) == 7) direction = -1 * direction;
    const Placement placement = placement_of({origin, direction});
    numbers.clear();
    add_point(numbers, origin, placement);
    add_point(numbers, direction, {{}, placement.scale, placement.exponent});
    if (entropy_.below(4) == 3) move_by_ulps(numbers, 2, 3, entropy_);
    add_mesh(numbers, placement);
  }

 private:
  using Triangle3Int = std::array<Int3, 3>;

  /// Any, beginning with any corner.
  Triangle3Int triangle() {
    std::array<std::size_t, 3> t = solid_.triangles[entropy_.below(solid_.triangles.size())];
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(entropy_.below(3)), t.end());
    return {solid_.points[t[0]], solid_.points[t[1]], solid_.points[t[2]]};
  }
  Int3 on(const Triangle3Int& t) {
    switch (entropy_.below(4)) {
      case 0:
        return t[0];
      case 1:
        return half_way(t[0], t[1]);
      case 2:
        return third(t[0] + t[0] + t[1]);
      default:
        return third(t[0] + t[1] + t[2]);
    }
  }
  Int3 feature() { return on(triangle()); }
  Int3 beside(Int3 p) {
    p[entropy_.below(3)] += entropy_.within(2 * size_);
    return p;
  }

  Int3 place() {
    switch (entropy_.below(8)) {
      case 0:
      case 1:
        return feature();
      case 2:
      case 3:
        return beside(feature());
      case 4:
      case 5: {
        const Int3 first = feature();
        return half_way(first, feature());
      }
      case 6: {
        const Int3 a = feature(), b = feature(), c = feature();
        return {a[0], b[1], c[2]};
      }
      default:
        return anywhere();
    }
  }
  Int3 anywhere() {
    const Int x = entropy_.within(size_), y = entropy_.within(size_);
    return {x, y, entropy_.within(size_)};
  }

  struct IntRay {
    Int3 origin, direction;
  };
  IntRay ray() {
    switch (entropy_.below(6)) {
      case 0: {  // from between two features
        const Int3 first = feature(), origin = half_way(first, feature());
        return {origin, feature() - origin};
      }
      case 1: {  // from afar
        const Int3 origin = 3 * anywhere();
        return {origin, feature() - origin};
      }
      case 2: {  // from a feature
        const Int3 origin = feature();
        return {origin, feature() - origin};
      }
      case 3: {  // along an axis
        const Int3 target = feature(), origin = beside(target);
        return {origin, target - origin};
      }
      case 4: {  // along an edge
        const Triangle3Int t = triangle();
        const Int3 edge = t[1] - t[0];
        return {t[0] + entropy_.within(3) * edge, edge};
      }
      default: {  // in the plane of a triangle
        const Triangle3Int t = triangle();
        const Int3 u = t[1] - t[0], v = t[2] - t[0];
        const Int i = entropy_.within(3), j = entropy_.within(3);
        const Int3 origin = t[0] + i * u + j * v;
        return {origin, on(t) - origin};
      }
    }
  }

  Placement placement_of(std::initializer_list<Int3> others) {
    Int most = size_;
    for (const Int3& p : others) {
      for (const Int x : p) most = std::max(most, std::abs(x));
    }
    const auto bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(most)));
    return any_placement(bits, entropy_.below(4) == 3, entropy_);
  }
  static void add_point(Numbers& numbers, const Int3& p, const Placement& at) {
    for (std::size_t k = 0; k < 3; ++k) {
      numbers.push_back(std::ldexp(static_cast<double>(at.base[k] + at.scale * p[k]), at.exponent));
    }
  }
  void add_mesh(Numbers& numbers, const Placement& placement) const {
    numbers.push_back(static_cast<double>(solid_.points.size()));
    for (const Int3& p : solid_.points) add_point(numbers, p, placement);
    append_triangles(numbers, solid_.triangles);
  }

  Solid solid_;
  Entropy& entropy_;
  Int size_ = 1;
};

using MakeCase = void (Scene::*)(Numbers& numbers);

void add_generators(std::vector<Generator>& all, std::span<const SolidSort> sorts, MakeCase make) {
  for (const SolidSort& sort : sorts) {
    all.push_back({std::string(sort.name), std::string(sort.about),
                   [solid = sort.make, make](Numbers& numbers, Entropy& entropy) {
                     Scene scene(solid(entropy), entropy);
                     (scene.*make)(numbers);
                   }});
  }
}

}  // namespace

std::vector<Generator> ray_mesh_generators() {
  std::vector<Generator> all;
  add_generators(all, sheet_sorts(), &Scene::ray_case);
  add_generators(all, solid_sorts(), &Scene::ray_case);
  return all;
}

std::vector<Generator> polyhedron_generators() {
  std::vector<Generator> all;
  add_generators(all, solid_sorts(), &Scene::point_case);
  return all;
}

void arrange_ray_and_soup(Numbers& numbers, Entropy& entropy, const Fill& fill) {
  const std::size_t n = 3 + entropy.below(6);
  std::vector<double> points(6 + 3 * n);
  fill(points, entropy);
  aim_at_second(points);
  numbers.assign(points.begin(), points.begin() + 6);
  append_counted(numbers, std::span(points).subspan(6), 3);
  std::vector<std::array<std::size_t, 3>> triangles{{0, 1, 2}};
  for (std::uint64_t more = entropy.below(6); more > 0; --more) {
    const std::size_t a = entropy.below(n), b = entropy.below(n);
    triangles.push_back({a, b, entropy.below(n)});
  }
  append_triangles(numbers, triangles);
}

void arrange_point_and_solid(Numbers& numbers, Entropy& entropy, const Fill& fill) {
  static constexpr std::array<std::array<std::size_t, 3>, 4> tetrahedron{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  static constexpr std::array<std::array<std::size_t, 3>, 6> two{
      {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
  static constexpr std::array<std::array<std::size_t, 3>, 8> octahedron{
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  const std::size_t n = 4 + entropy.below(3);
  std::vector<double> points(3 + 3 * n);
  fill(points, entropy);
  numbers.assign(points.begin(), points.begin() + 3);
  append_counted(numbers, std::span(points).subspan(3), 3);
  n == 4   ? append_triangles(numbers, tetrahedron)
  : n == 5 ? append_triangles(numbers, two)
           : append_triangles(numbers, octahedron);
}

}  // namespace plumb::degenerate
