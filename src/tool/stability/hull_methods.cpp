#include <algorithm>

#include "plumb/certify/direction.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/predicates.hpp"
#include "tool/stability/hull_ways.hpp"
#include "tool/trial/contestant.hpp"
#include "tool/trial/vec.hpp"

namespace plumb::tool::stability {
namespace {

using Index = std::uint32_t;

/// Points as numbers of type T; what is at most epsilon counts as zero.
template <class T>
class FloatSigns final : public HullSigns {
 public:
  FloatSigns(std::span<const Point2> points, T epsilon) : epsilon_(epsilon) {
    for (const Point2& p : points) points_.push_back({static_cast<T>(p.x), static_cast<T>(p.y)});
  }
  [[nodiscard]] std::size_t size() const override { return points_.size(); }
  [[nodiscard]] bool before(Index a, Index b) const override { return points_[a] < points_[b]; }
  [[nodiscard]] int turn(Index a, Index b, Index c) const override { return beyond(area(a, b, c)); }
  [[nodiscard]] int farther(Index a, Index b, Index c, Index d) const override {
    return beyond(area(a, b, c) - area(a, b, d));
  }

 private:
  [[nodiscard]] T area(Index a, Index b, Index c) const {
    const auto &p = points_[a], &q = points_[b], &r = points_[c];
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }
  [[nodiscard]] int beyond(T x) const { return (x > epsilon_) - (x < -epsilon_); }

  std::vector<std::array<T, 2>> points_;
  T epsilon_;
};

class ExactSigns final : public HullSigns {
 public:
  explicit ExactSigns(std::span<const Point2> points) : points_(points) {}
  [[nodiscard]] std::size_t size() const override { return points_.size(); }
  [[nodiscard]] bool before(Index a, Index b) const override {
    return compare_lexicographically(points_[a], points_[b]) == Sign::negative;
  }
  [[nodiscard]] int turn(Index a, Index b, Index c) const override {
    return static_cast<int>(orient2d(points_[a], points_[b], points_[c]));
  }
  [[nodiscard]] int farther(Index a, Index b, Index c, Index d) const override {
    const auto formula = [](auto ax, auto ay, auto bx, auto by, auto cx, auto cy, auto dx, auto dy) {
      return (bx - ax) * (cy - dy) - (by - ay) * (cx - dx);
    };
    return static_cast<int>(sign_of(formula, points_[a], points_[b], points_[c], points_[d]));
  }

 private:
  std::span<const Point2> points_;
};

template <class T>
std::unique_ptr<HullSigns> plain(std::span<const Point2> points) {
  return std::make_unique<FloatSigns<T>>(points, T(0));
}
std::unique_ptr<HullSigns> absolute(std::span<const Point2> points) {
  return std::make_unique<FloatSigns<double>>(points, trial::customary_epsilon);
}
std::unique_ptr<HullSigns> relative(std::span<const Point2> points) {
  double largest = 0;
  for (const Point2& p : points) largest = std::max({largest, trial::magnitude(p.x), trial::magnitude(p.y)});
  return std::make_unique<FloatSigns<double>>(points, trial::customary_epsilon * largest);
}
std::unique_ptr<HullSigns> exact(std::span<const Point2> points) { return std::make_unique<ExactSigns>(points); }

}  // namespace

const std::vector<HullMethod>& hull_methods() {
  static const std::vector<HullMethod> all{
      {"float32", false, plain<float>}, {"double", false, plain<double>},           {"absolute", false, absolute},
      {"relative", false, relative},    {"long-double", false, plain<long double>}, {"exact", true, exact}};
  return all;
}

}  // namespace plumb::tool::stability
