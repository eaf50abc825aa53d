#include "lab/stability/hull_signs.hpp"
#include "lab/trial/vec.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/predicates.hpp"
#include "tool/trial/contestant.hpp"

namespace plumb::lab::stability {
namespace {

using Index = std::uint32_t;
template <std::size_t D>
using PointSpan = std::span<const typename HullSigns<D>::Point>;

/// PointSpan as numbers of type T; what is at most epsilon counts as zero.
template <class T, std::size_t D>
class FloatSigns final : public HullSigns<D> {
 public:
  using typename HullSigns<D>::Facet;

  FloatSigns(PointSpan<D> points, T epsilon) : epsilon_(epsilon) {
    for (const auto& p : points) {
      std::array<T, D>& q = points_.emplace_back();
      std::ranges::transform(coordinates(p), q.begin(), [](double x) { return static_cast<T>(x); });
    }
  }
  [[nodiscard]] std::size_t size() const override { return points_.size(); }
  [[nodiscard]] bool before(Index a, Index b) const override { return points_[a] < points_[b]; }
  [[nodiscard]] int side(const Facet& facet, Index p) const override { return beyond(content(facet, p)); }
  [[nodiscard]] int farther(const Facet& facet, Index p, Index q) const override {
    return beyond(content(facet, p) - content(facet, q));
  }

 private:
  /// Twice the area with the point, or six times the volume.
  [[nodiscard]] T content(const Facet& facet, Index p) const {
    if constexpr (D == 2) {
      const auto &a = points_[facet[0]], &b = points_[facet[1]], &c = points_[p];
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    } else {
      const auto a = at(facet[0]);
      return dot(cross(at(facet[1]) - a, at(facet[2]) - a), at(p) - a);
    }
  }
  [[nodiscard]] trial::Vec<T> at(Index i) const { return {points_[i][0], points_[i][1], points_[i][2]}; }
  [[nodiscard]] int beyond(T x) const { return (x > epsilon_) - (x < -epsilon_); }

  std::vector<std::array<T, D>> points_;
  T epsilon_;
};

template <std::size_t D>
class ExactSigns final : public HullSigns<D> {
 public:
  using typename HullSigns<D>::Facet;

  explicit ExactSigns(PointSpan<D> points) : points_(points) {}
  [[nodiscard]] std::size_t size() const override { return points_.size(); }
  [[nodiscard]] bool before(Index a, Index b) const override {
    return compare_lexicographically(points_[a], points_[b]) == Sign::negative;
  }
  [[nodiscard]] int side(const Facet& f, Index p) const override {
    if constexpr (D == 2) {
      return static_cast<int>(orient2d(points_[f[0]], points_[f[1]], points_[p]));
    } else {
      return -static_cast<int>(orient3d(points_[f[0]], points_[f[1]], points_[f[2]], points_[p]));
    }
  }
  [[nodiscard]] int farther(const Facet& f, Index p, Index q) const override {
    if constexpr (D == 2) {
      const auto formula = [](auto ax, auto ay, auto bx, auto by, auto px, auto py, auto qx, auto qy) {
        return (bx - ax) * (py - qy) - (by - ay) * (px - qx);
      };
      return static_cast<int>(sign_of(formula, points_[f[0]], points_[f[1]], points_[p], points_[q]));
    } else {
      const auto formula = [](auto ax, auto ay, auto az, auto bx, auto by, auto bz, auto cx, auto cy, auto cz, auto px,
                              auto py, auto pz, auto qx, auto qy, auto qz) {
        const auto ux = bx - ax, uy = by - ay, uz = bz - az, vx = cx - ax, vy = cy - ay, vz = cz - az;
        return (uy * vz - uz * vy) * (px - qx) + (uz * vx - ux * vz) * (py - qy) + (ux * vy - uy * vx) * (pz - qz);
      };
      return static_cast<int>(sign_of(formula, points_[f[0]], points_[f[1]], points_[f[2]], points_[p], points_[q]));
    }
  }

 private:
  PointSpan<D> points_;
};

template <class T, std::size_t D>
std::unique_ptr<HullSigns<D>> plain(PointSpan<D> points) {
  return std::make_unique<FloatSigns<T, D>>(points, T(0));
}
template <std::size_t D>
std::unique_ptr<HullSigns<D>> absolute(PointSpan<D> points) {
  return std::make_unique<FloatSigns<double, D>>(points, trial::customary_epsilon);
}
template <std::size_t D>
std::unique_ptr<HullSigns<D>> relative(PointSpan<D> points) {
  double largest = 0;
  for (const auto& p : points) {
    for (const double x : coordinates(p)) largest = std::max(largest, trial::magnitude(x));
  }
  return std::make_unique<FloatSigns<double, D>>(points, trial::customary_epsilon * largest);
}
template <std::size_t D>
std::unique_ptr<HullSigns<D>> exact(PointSpan<D> points) {
  return std::make_unique<ExactSigns<D>>(points);
}

template <std::size_t D>
std::vector<HullMethod<D>> methods() {
  return {{"float32", false, plain<float, D>},
          {"double", false, plain<double, D>},
          {"absolute", false, absolute<D>},
          {"relative", false, relative<D>},
          {"long-double", false, plain<long double, D>},
          {"exact", true, exact<D>}};
}

}  // namespace

template <>
const std::vector<HullMethod<2>>& hull_methods<2>() {
  static const std::vector<HullMethod<2>> all = methods<2>();
  return all;
}
template <>
const std::vector<HullMethod<3>>& hull_methods<3>() {
  static const std::vector<HullMethod<3>> all = methods<3>();
  return all;
}

}  // namespace plumb::lab::stability
