// Zonotope: how far do two sums of edges overlap along the normals of their difference's facets?
//
// Along the normal n of two groups of edges the difference reaches sum |n . g| over the other groups to both sides of
// its middle c, everything times two; the bodies overlap by sum |n . g| - |n . c|.
// Laws: signs are exact: errors of doubles first, then integers; n . g of three groups is one determinant.  What is times
// an exact zero is an exact zero in them.
// Source: RTCD 4.4.1, 5.2.1.
// Cost: fifteen cross products, twenty determinants and as many products in doubles with their errors; integers are made once.
#pragma once

#include "arith/approximate.hpp"
#include "arith/sparse_vec.hpp"
#include "query/penetration/edge_sum.hpp"

namespace plumb::query::parting {

/// The same, as a number that says how far off it is.
inline Running running(const Approximate& x) { return {x.value, x.reach()}; }
/// What has no terms is zero, and known to be.
inline Approximate settled(const Approximate& x) { return x.magnitude == 0 ? Approximate(0.0) : x; }
inline SumParts<Approximate> settled(const SumParts<Approximate>& parts) {
  const auto all = [](const Vec<Approximate>& v) -> Vec<Approximate> {
    return {settled(v.x), settled(v.y), settled(v.z)};
  };
  const auto& g = parts.group;
  return {{all(g[0]), all(g[1]), all(g[2]), all(g[3]), all(g[4]), all(g[5])}, all(parts.middle)};
}
inline Vec<Running> running(const Vec<Approximate>& v) { return {running(v.x), running(v.y), running(v.z)}; }

class Zonotope {
 public:
  explicit Zonotope(const EdgeSum& sum);

  [[nodiscard]] const EdgeSum& sum() const { return sum_; }
  [[nodiscard]] std::uint32_t normals() const { return normals_; }
  [[nodiscard]] std::array<std::uint32_t, 2> pair(std::uint32_t normal) const { return normal_[normal].of; }
  /// The square is that of the overlap over the normal's length, in running errors, and has the overlap's sign.
  [[nodiscard]] const Running& square(std::uint32_t normal) const { return normal_[normal].square; }

  /// Along a normal of two groups, in running errors: times its length; `square` as above.
  struct OfNormal {
    std::array<std::uint32_t, 2> of;
    Vec<Running> normal;
    Running reach, middle, overlap, square;
  };
  [[nodiscard]] const OfNormal& rough(std::uint32_t normal) const { return normal_[normal]; }
  /// How much a group other than its two leads along a normal.
  [[nodiscard]] Running rough_along(std::uint32_t normal, std::uint32_t group) const {
    const auto [p, q] = normal_[normal].of;
    const Running& size = determinant_[1U << p | 1U << q | 1U << group];
    return p < group && group < q ? Running{-size.value, size.error} : size;
  }

  [[nodiscard]] Sign sign_of_overlap(std::uint32_t i) {
    return sign_of([&]<class T>() -> T { return overlap<T>(i); });
  }
  [[nodiscard]] Sign sign_of_middle(std::uint32_t i) {
    return sign_of([&]<class T>() -> T { return middle<T>(i); });
  }
  /// How much a group leads along a normal.
  [[nodiscard]] Sign sign_along(std::uint32_t i, std::uint32_t group) {
    return sign_of([&]<class T>() -> T { return along<T>(i, group); });
  }
  /// Are the two groups parallel, so that the normal is zero?
  [[nodiscard]] bool is_parallel(std::uint32_t i);
  /// Has the difference an extent along the normal?
  [[nodiscard]] bool has_reach(std::uint32_t i) {
    return sign_of([&]<class T>() -> T { return reach<T>(i); }) == Sign::positive;
  }
  /// The order of the squares, of overlaps that are not negative.
  [[nodiscard]] Sign compare(std::uint32_t i, std::uint32_t j) {
    return sign_of([&]<class T>() -> T {
      const T x = overlap<T>(i), y = overlap<T>(j);
      const Vec<T> m = normal<T>(i), n = normal<T>(j);
      return x * x * dot(n, n) - y * y * dot(m, m);
    });
  }
  /// Are all edges of a body known to be independent by doubles?
  [[nodiscard]] bool is_independent(std::uint32_t body) const;

 private:
  template <class T>
  [[nodiscard]] const SumParts<T>& parts() {
    if constexpr (std::is_same_v<T, Running>) {
      if (!rough_) rough_.emplace(sum_.parts<T>());
      return *rough_;
    } else if constexpr (std::is_same_v<T, StackDyadic>) {
      if (!short_) short_.emplace(sum_.parts<T>()), is_lost_ = StackDyadic::left_range();
      if (is_lost_) static_cast<void>(StackDyadic(std::numeric_limits<double>::quiet_NaN()));  // it leaves it again
      return *short_;
    } else {
      if (!big_) big_.emplace(sum_.parts<T>());
      return *big_;
    }
  }
  template <class T>
  [[nodiscard]] Vec<T> normal(std::uint32_t i) {
    if constexpr (std::is_same_v<T, Running>) return normal_[i].normal;
    const auto [p, q] = normal_[i].of;
    return cross(parts<T>().group[p], parts<T>().group[q]);
  }
  template <class T>
  [[nodiscard]] T along(std::uint32_t i, std::uint32_t group) {
    return dot(normal<T>(i), parts<T>().group[group]);
  }
  template <class T>
  [[nodiscard]] T middle(std::uint32_t i) {
    if constexpr (std::is_same_v<T, Running>) return normal_[i].middle;
    return dot(normal<T>(i), parts<T>().middle);
  }
  template <class T>
  [[nodiscard]] T reach(std::uint32_t i) {
    if constexpr (std::is_same_v<T, Running>) return normal_[i].reach;
    T sum(0.0);
    for (std::uint32_t g = 0; g < sum_.groups(); ++g) {
      if (g != normal_[i].of[0] && g != normal_[i].of[1]) sum = sum + magnitude(along<T>(i, g));
    }
    return sum;
  }
  template <class T>
  [[nodiscard]] T overlap(std::uint32_t i) {
    if constexpr (std::is_same_v<T, Running>) return normal_[i].overlap;
    return reach<T>(i) - magnitude(middle<T>(i));
  }

  const EdgeSum& sum_;
  std::optional<SumParts<Running>> rough_;
  std::optional<SumParts<StackDyadic>> short_;
  std::optional<SumParts<BigDyadic>> big_;
  bool is_lost_ = false;
  std::uint32_t normals_ = 0;
  std::array<OfNormal, 15> normal_;
  std::array<Running, 64> determinant_;  // of three groups in their order, by their bits
};

}  // namespace plumb::query::parting
