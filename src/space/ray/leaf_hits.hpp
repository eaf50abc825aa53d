// Which triangles of a leaf does a ray hit, and between which parameters?
//
// Laws: those told are hit exactly; the parameter lies between the two numbers told with it.
// Cost: a pass of lanes for eight triangles; the exact question for those that doubles leave in doubt.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/query/ray/hits.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "query/ray/batch_lanes.hpp"

namespace plumb::space {

class LeafHits {
 public:
  LeafHits(const AnyRay& ray, const Bvh& bvh, HitRule rule)
      : ray_(ray),
        lanes_(query::batch_ray(ray)),
        triangles_(bvh.triangles.view()),
        vertices_(bvh.vertices.view()),
        rule_(rule) {}

  LeafHits(const LeafHits&) = delete;  // it has its own addresses
  LeafHits& operator=(const LeafHits&) = delete;
  ~LeafHits() = default;

  [[nodiscard]] Triangle3 triangle(std::uint32_t slot) const {
    const Bvh::Corners& c = triangles_[slot];
    return {vertices_[c[0]], vertices_[c[1]], vertices_[c[2]]};
  }

  /// Tells the processor what will be asked for below a node.
  void fetch(const BoxNode& node) const {
    __builtin_prefetch(node.is_leaf() ? static_cast<const void*>(&triangles_[node.link])
                                      : static_cast<const void*>(&node + node.link));
  }

  /// Calls visit(slot, least, most) for each that is hit, until it returns Descent::stop.
  template <class Visit>
  Descent with_parameters(std::uint32_t first, std::uint32_t count, Visit&& visit) {
    return each(first, count, [&](std::uint32_t slot, std::uint8_t told, double least, double most) {
      if (told == 1) return visit(slot, least, most);
      if (least > -infinity && most < infinity)
        return hits(ray_, triangle(slot), rule_) ? visit(slot, least, most) : Descent::go_on;
      const auto hit = first_hit(ray_, triangle(slot), rule_);
      if (!hit) return Descent::go_on;
      return visit(slot, std::nextafter(hit->t, -infinity), std::nextafter(hit->t, infinity));
    });
  }

  /// Calls visit(slot) for each that is hit.
  template <class Visit>
  Descent hit(std::uint32_t first, std::uint32_t count, Visit&& visit) {
    return each(first, count, [&](std::uint32_t slot, std::uint8_t told, double, double) {
      return told == 1 || hits(ray_, triangle(slot), rule_) ? visit(slot) : Descent::go_on;
    });
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::uint32_t block = 8;

  template <class Visit>
  Descent each(std::uint32_t first, std::uint32_t count, const Visit& visit) {
    for (std::uint32_t from = 0; from < count; from += block) {
      const std::uint32_t n = std::min(block, count - from);
      gather(first + from, n);
      query::ask_lanes(lanes_, at_.data(), n, {told_.data(), least_.data(), most_.data()});
      for (std::uint32_t i = 0; i < n; ++i) {
        if (told_[i] != 0 && visit(first + from + i, told_[i], least_[i], most_[i]) == Descent::stop)
          return Descent::stop;
      }
    }
    return Descent::go_on;
  }

  // Lanes beyond n are those of the first triangle.
  void gather(std::uint32_t first, std::uint32_t n) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const Triangle3 t = triangle(first + i);
      const std::array numbers{t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z};
      for (std::size_t k = 0; k < 9; ++k) numbers_[k][i] = numbers[k];
    }
    for (std::uint32_t i = n; i < block; ++i) {
      for (std::size_t k = 0; k < 9; ++k) numbers_[k][i] = numbers_[k][0];
    }
  }

  const AnyRay& ray_;
  query::BatchRay lanes_;
  std::span<const Bvh::Corners> triangles_;
  std::span<const Point3> vertices_;
  HitRule rule_;
  std::array<std::array<double, block>, 9> numbers_;
  std::array<const double*, 9> at_{numbers_[0].data(), numbers_[1].data(), numbers_[2].data(),
                                   numbers_[3].data(), numbers_[4].data(), numbers_[5].data(),
                                   numbers_[6].data(), numbers_[7].data(), numbers_[8].data()};
  std::array<std::uint8_t, block> told_;
  std::array<double, block> least_, most_;
};

}  // namespace plumb::space
