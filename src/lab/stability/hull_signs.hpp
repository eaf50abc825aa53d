// What does an algorithm for hulls ask of its points?  Their order, sides of lines or planes, and which is farther off;
// in numbers that round, or exactly.
//
// Laws: (1) an algorithm looks at points through HullSigns alone, so that only the numbers differ between methods; (2)
// the exact signs are those of the library's public functions.
// Source: RTCD 3.9.
// Cost: a virtual call and the sign.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb::lab::stability {

/// What an algorithm asks of points in D dimensions, 2 or 3, by index.
template <std::size_t D>
class HullSigns {
 public:
  using Point = std::conditional_t<D == 2, Point2, Point3>;
  /// In the plane from one point to another, in space three.
  using Facet = std::array<std::uint32_t, D>;

  HullSigns() = default;
  HullSigns(const HullSigns&) = delete;
  HullSigns& operator=(const HullSigns&) = delete;
  virtual ~HullSigns() = default;
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// By x, then y, then z, as the method keeps them.
  [[nodiscard]] virtual bool before(std::uint32_t a, std::uint32_t b) const = 0;
  /// Positive where p is to the left of the facet in the plane, and in space on the side that sees it counterclockwise.
  [[nodiscard]] virtual int side(const Facet& facet, std::uint32_t p) const = 0;
  /// Positive where p lies farther to that side than q.
  [[nodiscard]] virtual int farther(const Facet& facet, std::uint32_t p, std::uint32_t q) const = 0;

  [[nodiscard]] bool same(std::uint32_t a, std::uint32_t b) const { return !before(a, b) && !before(b, a); }

  /// All, in order, of equal ones the first.
  [[nodiscard]] std::vector<std::uint32_t> in_order() const {
    std::vector<std::uint32_t> order(size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::ranges::stable_sort(order, [this](std::uint32_t a, std::uint32_t b) { return before(a, b); });
    const auto is_same = [this](std::uint32_t a, std::uint32_t b) { return same(a, b); };
    order.erase(std::unique(order.begin(), order.end(), is_same), order.end());
    return order;
  }
};

/// How a number takes signs: rounded to float, double or long double, an epsilon counting as zero; or exactly.
template <std::size_t D>
struct HullMethod {
  std::string name;
  bool exact;
  std::unique_ptr<HullSigns<D>> (*signs)(std::span<const typename HullSigns<D>::Point> points);
};
template <std::size_t D>
const std::vector<HullMethod<D>>& hull_methods();
template <>
const std::vector<HullMethod<2>>& hull_methods<2>();
template <>
const std::vector<HullMethod<3>>& hull_methods<3>();

}  // namespace plumb::lab::stability
