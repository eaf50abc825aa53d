#include "plumb/degenerate/exact.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace plumb {

namespace {

using Int = std::int64_t;
using Int3 = std::array<Int, 3>;

constexpr Int largest(int bits) { return (Int{1} << bits) - 1; }

// At least 1, so that a factor or a direction is never zero.
Int positive(Entropy& entropy, int bits) {
  return bits == 0 ? 1 : 1 + static_cast<Int>(entropy.below(static_cast<std::uint64_t>(largest(bits))));
}

double squared(Int x) { return static_cast<double>(x) * static_cast<double>(x); }

Int nonnegative(Entropy& entropy, int bits) { return static_cast<Int>(entropy.bits(bits)); }

// An offset generator is set up once a set from `budget` and then makes points whose coordinates stay below 2^budget.

// k d on a line, i u + j v on a plane: multiples of `multiple_bits` bits, directions of the bits that are left.
class FlatOffsets {
 public:
  FlatOffsets(bool plane, int dimension, int budget, Entropy& entropy) : plane_(plane) {
    const int bits = plane ? budget - 1 : budget;
    const std::array layouts = {bits / 2, bits / 4, bits - bits / 4};
    multiple_bits_ = layouts[entropy.below(layouts.size())];
    first_ = direction(dimension, bits - multiple_bits_, entropy);
    // A plane whose second direction vanishes holds collinear points: doubly degenerate, and still coplanar.
    if (plane && entropy.below(8) != 7) second_ = direction(dimension, bits - multiple_bits_, entropy);
  }

  Int3 next(Entropy& entropy) {
    const Int i = entropy.within(largest(multiple_bits_));
    const Int j = plane_ ? entropy.within(largest(multiple_bits_)) : 0;
    return {i * first_[0] + j * second_[0], i * first_[1] + j * second_[1], i * first_[2] + j * second_[2]};
  }

 private:
  static Int3 direction(int dimension, int bits, Entropy& entropy) {
    Int3 made{};
    for (int axis = 0; axis < dimension; ++axis) made[static_cast<std::size_t>(axis)] = entropy.within(largest(bits));
    if (made == Int3{}) made[0] = 1;
    return made;
  }

  bool plane_;
  int multiple_bits_;
  Int3 first_{}, second_{};
};

// Different numbers below `range`, as long as there are enough for all points: equal points are a family of their own.
class Walk {
 public:
  Walk() = default;
  Walk(std::uint64_t range, std::size_t points, Entropy& entropy)
      : range_(range), longest_step_(range / (points + 1)), at_(range - 1 + entropy.below(range)) {}

  std::uint64_t next(Entropy& entropy) {
    at_ = (at_ + 1 + entropy.below(longest_step_)) % range_;
    return at_;
  }

 private:
  std::uint64_t range_ = 1, longest_step_ = 1, at_ = 0;
};

// A factor that stretches a circle or sphere of this radius to any size below 2^budget, half the time the greatest odd
// one: differences then take up to a bit more than 53.
Int stretch(double radius, int budget, Entropy& entropy) {
  const double most = std::ldexp(1 - 0x1p-40, budget) / radius;  // the few roundings of the radius are far below 2^-40
  const auto whole = static_cast<std::uint64_t>(most);
  return static_cast<Int>(entropy.coin() ? (whole - 1) | 1 : 1 + entropy.below(whole));
}

// (x + i y) = product of Gaussian integers; conjugating a factor keeps the norm, as do the eight symmetries of a
// square.
class CircleOffsets {
 public:
  CircleOffsets(int budget, std::size_t points, Entropy& entropy)
      : factors_(budget < 10                   ? 1
                 : budget < 15                 ? 2
                 : points <= 16 || budget < 20 ? 3
                                               : 5) {
    // |product| < 2^(sum of bits + factors / 2).
    const int bits = budget - (factors_ + 1) / 2;
    double radius = 1;
    for (int f = 0; f < factors_; ++f) {
      const int own = (bits + f) / factors_;
      const Int re = positive(entropy, own), im = nonnegative(entropy, own);
      factor_[static_cast<std::size_t>(f)] = {re, im};
      radius *= std::sqrt(static_cast<double>(re * re + im * im));
    }
    stretch_ = stretch(radius, budget, entropy);
    walk_ = Walk(std::uint64_t{4} << factors_, points, entropy);  // conjugating the first factor too gives nothing new
  }

  std::pair<Int, Int> next(Entropy& entropy) {
    const std::uint64_t choice = walk_.next(entropy);
    Int x = stretch_, y = 0;
    for (int f = 0; f < factors_; ++f) {
      const auto [re, absolute_im] = factor_[static_cast<std::size_t>(f)];
      const Int im = f == 0 || (choice >> (f + 2)) % 2 == 0 ? absolute_im : -absolute_im;
      const Int next_x = x * re - y * im;
      y = x * im + y * re;
      x = next_x;
    }
    if ((choice & 1) != 0) std::swap(x, y);
    return {(choice & 2) != 0 ? -x : x, (choice & 4) != 0 ? -y : y};
  }

 private:
  int factors_;
  std::array<std::pair<Int, Int>, 5> factor_{};
  Int stretch_ = 1;
  Walk walk_;
};

struct Quaternion {
  Int a = 1, b = 0, c = 0, d = 0;
};

Quaternion quaternion(int bits, Entropy& entropy) {
  if (bits == 0) return {};
  const Int a = positive(entropy, bits), b = nonnegative(entropy, bits), c = nonnegative(entropy, bits);
  return {a, b, c, nonnegative(entropy, bits)};
}

// The `which`-th (below 48) of the symmetries of a cube, reflections included.
Int3 symmetric(const Int3& v, std::uint64_t which) {
  constexpr std::array<std::array<std::size_t, 3>, 6> orders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
  const auto& order = orders[which / 8];
  return {(which & 1) != 0 ? -v[order[0]] : v[order[0]], (which & 2) != 0 ? -v[order[1]] : v[order[1]],
          (which & 4) != 0 ? -v[order[2]] : v[order[2]]};
}

// q v q': |result| = N(q) |v|, whatever the order and the signs of the parts of q.
class SphereOffsets {
 public:
  SphereOffsets(int budget, std::size_t points, Entropy& entropy) {
    // |q v q'| < 2^(2 bits + 2) * sqrt(3) 2^vector_bits; without a rotation the vector has the whole budget.
    rotation_bits_ = entropy.below(4) == 0 ? 0 : (budget - 3) / 3;
    const int vector_bits = rotation_bits_ == 0 ? budget - 1 : budget - 3 - 2 * rotation_bits_;
    rotation_ = quaternion(rotation_bits_, entropy);
    const Int x = positive(entropy, vector_bits), y = nonnegative(entropy, vector_bits);
    const Int z = nonnegative(entropy, vector_bits);
    const auto [a, b, c, d] = rotation_;
    const Int by =
        stretch(static_cast<double>(a * a + b * b + c * c + d * d) * std::sqrt(squared(x) + squared(y) + squared(z)),
                budget, entropy);
    vector_ = {by * x, by * y, by * z};
    walk_ = Walk(rotation_bits_ == 0 ? 48 : 48 * 48 * 4, points, entropy);
  }

  Int3 next(Entropy& entropy) {
    std::uint64_t choice = walk_.next(entropy);
    const Int3 start = symmetric(vector_, choice % 48);
    if (rotation_bits_ == 0) return start;
    choice /= 48;
    const Int3 axis = symmetric({rotation_.b, rotation_.c, rotation_.d}, choice % 48);
    std::array<Int, 4> parts = {rotation_.a, axis[0], axis[1], axis[2]};
    std::swap(parts[0], parts[choice / 48]);
    const auto [a, b, c, d] = parts;
    const auto [x, y, z] = start;
    const Int along = 2 * (b * x + c * y + d * z);
    const Int scale = a * a - b * b - c * c - d * d;
    return {scale * x + along * b + 2 * a * (c * z - d * y), scale * y + along * c + 2 * a * (d * x - b * z),
            scale * z + along * d + 2 * a * (b * y - c * x)};
  }

 private:
  int rotation_bits_;
  Quaternion rotation_;
  Int3 vector_{};
  Walk walk_;
};

// x u + y w for (x, y) on a circle and u, w two columns of the rotation of a quaternion: orthogonal and of one length.
class SpaceCircleOffsets {
 public:
  SpaceCircleOffsets(int budget, std::size_t points, Entropy& entropy)
      : SpaceCircleOffsets(budget, entropy.coin() ? budget / 6 : 0, points, entropy) {}

  Int3 next(Entropy& entropy) {
    const auto [x, y] = circle_.next(entropy);
    const Int3 v = {x * u_[0] + y * w_[0], x * u_[1] + y * w_[1], x * u_[2] + y * w_[2]};
    return symmetric(v, 8 * order_);
  }

 private:
  // The columns have length N(q) < 2^(2 bits + 2).
  SpaceCircleOffsets(int budget, int bits, std::size_t points, Entropy& entropy)
      : circle_(bits == 0 ? budget : budget - 2 * bits - 2, points, entropy), order_(entropy.below(3)) {
    const auto [a, b, c, d] = quaternion(bits, entropy);
    u_ = {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
    w_ = {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)};
  }

  CircleOffsets circle_;
  std::uint64_t order_;
  Int3 u_{}, w_{};
};

// How offsets become coordinates: (base + scale * offset) * 2^exponent, the base below 2^53 - 2^budget.
struct Layout {
  int budget;
  std::array<double, 3> base{};
  double scale = 1;
  double unit = 1;
  bool own_exponents = false;  // every point times a power of two of its own: lines and planes through the origin only
};

template <class Next>
void place(const Layout& layout, int dimension, std::span<double> coordinates, Entropy& entropy, const Next& next) {
  const auto stride = static_cast<std::size_t>(dimension);
  for (std::size_t first = 0; first + stride <= coordinates.size(); first += stride) {
    const Int3 offset = next(entropy);
    const double unit =
        layout.own_exponents ? std::ldexp(layout.unit, static_cast<int>(entropy.within(30))) : layout.unit;
    for (std::size_t axis = 0; axis < stride; ++axis) {
      coordinates[first + axis] = (layout.base[axis] + layout.scale * static_cast<double>(offset[axis])) * unit;
    }
  }
}

void fill(Degeneracy degeneracy, int dimension, const Layout& layout, std::span<double> coordinates, Entropy& entropy) {
  const std::size_t points = coordinates.size() / static_cast<std::size_t>(dimension);
  const auto run = [&](auto offsets) {
    place(layout, dimension, coordinates, entropy, [&](Entropy& choices) { return offsets.next(choices); });
  };
  if (is_flat(degeneracy))
    return run(FlatOffsets(degeneracy == Degeneracy::coplanar && dimension == 3, dimension, layout.budget, entropy));
  if (dimension == 2) {
    CircleOffsets circle(layout.budget, points, entropy);
    return place(layout, dimension, coordinates, entropy, [&](Entropy& choices) {
      const auto [x, y] = circle.next(choices);
      return Int3{x, y, 0};
    });
  }
  // Points of one circle lie on many spheres: the sharper degeneracy is met within the weaker one.
  if (degeneracy == Degeneracy::cocircular || entropy.below(8) == 7) {
    return run(SpaceCircleOffsets(layout.budget, points, entropy));
  }
  run(SphereOffsets(layout.budget, points, entropy));
}

}  // namespace

void fill_exact(Degeneracy degeneracy, int dimension, int bits, std::span<double> coordinates, Entropy& entropy) {
  Layout layout{.budget = bits - 1};
  for (double& base : layout.base) base = static_cast<double>(entropy.within(largest(bits - 1)));
  fill(degeneracy, dimension, layout, coordinates, entropy);
}

void fill_exact_long(Degeneracy degeneracy, int dimension, std::span<double> coordinates, Entropy& entropy) {
  Layout layout{.budget = 49, .unit = 0x1p-52};
  switch (entropy.below(3)) {
    case 0:  // odd base, even offsets: odd coordinates of magnitude 2^52 to 2^53
      layout.scale = 2;
      for (double& base : layout.base) {
        const double odd = 0x1.8p52 + static_cast<double>(2 * entropy.within(largest(48)) + 1);
        base = entropy.coin() ? -odd : odd;
      }
      break;
    case 1:  // around the origin: differences take 54 bits
      layout.budget = 52;
      for (double& base : layout.base) base = static_cast<double>(entropy.within(largest(51)));
      break;
    default:  // through the origin, or about it
      layout.budget = 53;
      layout.own_exponents = is_flat(degeneracy);
      break;
  }
  fill(degeneracy, dimension, layout, coordinates, entropy);
}

}  // namespace plumb
