#include "plumb/degenerate/cloud.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/exact.hpp"

namespace plumb {

namespace {

constexpr int exact_bits = 20;

/// Coordinates of `count` points, one after the other.
class Filling {
 public:
  Filling(std::size_t dimension, std::size_t count, Entropy& entropy)
      : dimension_(dimension), count_(count), entropy_(entropy) {
    made_.reserve(dimension * count);
  }

  std::vector<double> made(Cloud cloud) && {
    switch (cloud) {
      case Cloud::ball:
        each([&] { return in_ball(); });
        break;
      case Cloud::sphere:
        each([&] { return on_sphere(); });
        break;
      case Cloud::exact_sphere:
        dimension_ == 2 ? exact(Degeneracy::cocircular) : lattice_sphere();
        break;
      case Cloud::lattice:
        lattice();
        break;
      case Cloud::facets:
        each([&] { return on_facet(); });
        break;
      case Cloud::prism:
        prism();
        break;
      case Cloud::moments:
        moments();
        break;
      case Cloud::skew_plane:
        skew_plane();
        break;
      case Cloud::plane:
        dimension_ == 2 ? line() : exact(Degeneracy::coplanar);
        break;
      case Cloud::circle:
        exact(Degeneracy::cocircular);
        break;
      case Cloud::line:
        line();
        break;
      case Cloud::place:
        place();
        break;
    }
    return std::move(made_);
  }

 private:
  using Coordinates = std::array<double, 3>;  // of which the plane takes two

  template <class Make>
  void each(Make make) {
    for (std::size_t i = 0; i < count_; ++i) add(make());
  }
  void add(const Coordinates& x) { made_.insert(made_.end(), x.begin(), x.begin() + dimension()); }
  [[nodiscard]] std::ptrdiff_t dimension() const { return static_cast<std::ptrdiff_t>(dimension_); }
  [[nodiscard]] double squared(const Coordinates& x) const {
    return x[0] * x[0] + x[1] * x[1] + (dimension_ == 3 ? x[2] * x[2] : 0);
  }

  Coordinates in_cube() {
    Coordinates x{};
    for (std::size_t axis = 0; axis < dimension_; ++axis) x[axis] = signed_unit_coordinate(entropy_);
    return x;
  }
  // By rejection; a stream that is exhausted gives the origin at once.
  Coordinates in_ball() {
    Coordinates x = in_cube();
    while (squared(x) > 1) x = in_cube();
    return x;
  }
  Coordinates on_sphere() {
    Coordinates x = in_ball();
    const double length = std::sqrt(squared(x));
    if (length == 0) return {1, 0, 0};
    for (double& c : x) c /= length;
    return x;
  }

  void exact(Degeneracy degeneracy) {
    made_.resize(dimension_ * count_);
    fill_exact(degeneracy, static_cast<int>(dimension_), exact_bits, made_, entropy_);
  }

  // All solutions of x^2 + y^2 + z^2 = n for one n that has about 3 count of them, in random order.
  void lattice_sphere() {
    const std::int64_t root = std::clamp<std::int64_t>(static_cast<std::int64_t>(count_ / 2), 4, 3000);
    std::int64_t n = root * root | 1;
    if (n % 8 == 7) n += 2;
    std::vector<Coordinates> solutions;
    for (std::int64_t x = -root - 1; x <= root + 1; ++x) {
      for (std::int64_t y = -root - 1; y <= root + 1; ++y) {
        const std::int64_t z2 = n - x * x - y * y;
        if (z2 < 0) continue;
        const auto z = static_cast<std::int64_t>(std::sqrt(static_cast<double>(z2)) + 0.5);
        if (z * z != z2) continue;
        for (const std::int64_t signed_z : {z, -z}) {
          if (signed_z == z || z != 0)
            solutions.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(signed_z)});
        }
      }
    }
    shuffle(solutions);
    for (std::size_t i = 0; i < count_; ++i) add(solutions[i % solutions.size()]);
  }

  // 0 ... side - 1 in each axis, for the least side that has as many points; which are left out is random.
  void lattice() {
    std::size_t side = 1;
    const auto points = [&] { return dimension_ == 2 ? side * side : side * side * side; };
    while (points() < count_) ++side;
    std::vector<Coordinates> all;
    for (std::size_t i = 0; i < points(); ++i) {
      all.push_back(
          {static_cast<double>(i % side), static_cast<double>(i / side % side), static_cast<double>(i / side / side)});
    }
    shuffle(all);
    all.resize(count_);
    for (const Coordinates& x : all) add(x);
  }

  Coordinates on_facet() {
    Coordinates x{};
    for (std::size_t axis = 0; axis < dimension_; ++axis) x[axis] = static_cast<double>(entropy_.within(64));
    x[entropy_.below(dimension_)] = entropy_.coin() ? 64 : -64;
    return x;
  }

  // A rational point of the circle for each parameter, rounded: no sine, which differs from library to library.
  void prism() {
    std::vector<Coordinates> circle;
    const std::size_t sides = std::max<std::size_t>(count_ / (dimension_ == 2 ? 3 : 2), 3);
    for (std::size_t i = 0; i < sides; ++i) {
      const double t = unit_coordinate(entropy_), below = 1 + t * t, x = (1 - t * t) / below, y = 2 * t / below;
      const bool turn = entropy_.coin(), flip = entropy_.coin();
      const double u = turn ? y : x, v = turn ? x : y;
      circle.push_back({flip ? -u : u, entropy_.coin() ? -v : v, 0});
    }
    for (std::size_t i = 0; i < count_; ++i) {
      Coordinates x = circle[i % sides];
      x[2] = i / sides % 2 == 0 ? 0.5 : -0.5;
      add(x);
    }
  }

  // So many integers in random order, zero in their middle.
  std::vector<double> parameters() {
    std::vector<double> all;
    for (std::size_t i = 0; i < count_; ++i) all.push_back(static_cast<double>(i) - static_cast<double>(count_ / 2));
    shuffle(all);
    return all;
  }

  void moments() {
    for (const double t : parameters()) add({t, t * t, t * t * t});
  }

  void line() {
    Coordinates start{}, step{};
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      start[axis] = grid_coordinate(entropy_, exact_bits);
      step[axis] = static_cast<double>(entropy_.within(255));
    }
    if (step == Coordinates{}) step[0] = 1;
    for (const double t : parameters()) add({start[0] + t * step[0], start[1] + t * step[1], start[2] + t * step[2]});
  }

  void skew_plane() {
    const Coordinates normal = in_cube();
    const double below = normal[dimension_ - 1] == 0 ? 1 : normal[dimension_ - 1];
    each([&] {
      Coordinates x = in_cube();
      const double above = x[0] * normal[0] + (dimension_ == 3 ? x[1] * normal[1] : 0);
      x[dimension_ - 1] = -above / below;
      return x;
    });
  }

  void place() {
    const Coordinates x = entropy_.coin() ? in_cube() : Coordinates{};
    each([&] {
      Coordinates same = x;
      for (double& c : same) {
        if (c == 0 && entropy_.coin()) c = -0.0;
      }
      return same;
    });
  }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[entropy_.below(i)]);
  }

  std::size_t dimension_, count_;
  Entropy& entropy_;
  std::vector<double> made_;
};

}  // namespace

std::vector<Point2> cloud2(Cloud cloud, std::size_t count, Entropy& entropy) {
  const std::vector<double> x = Filling(2, count, entropy).made(cloud);
  std::vector<Point2> points(count);
  for (std::size_t i = 0; i < count; ++i) points[i] = {x[2 * i], x[2 * i + 1]};
  return points;
}

std::vector<Point3> cloud3(Cloud cloud, std::size_t count, Entropy& entropy) {
  const std::vector<double> x = Filling(3, count, entropy).made(cloud);
  std::vector<Point3> points(count);
  for (std::size_t i = 0; i < count; ++i) points[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
  return points;
}

}  // namespace plumb
