// A guess by doubles, the middles of intervals or an eigenvector, is put on the lattice; intervals tell how far off it
// is.  What the lattice holds exactly is found by integers.
#include "plumb/figure/basic/rotation.hpp"

#include <gmpxx.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <span>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/pose_numbers.hpp"
#include "figure/basic/sine.hpp"
#include "plumb/figure/basic/rigid_poses.hpp"
#include "plumb/figure/basic/rounded_poses.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace {

/// w, x, y and z of a quaternion that is asked for, of any length.
using Asked = std::array<Interval, 4>;

using figure::Quaternion, figure::scaled_interval;

double largest_of(std::span<const double> numbers) {
  double largest = 0;
  for (const double x : numbers) largest = std::max(largest, std::fabs(x));
  return largest;
}

Rotation rounded_to_lattice(const std::array<double, 4>& q) {
  const double length = std::sqrt((q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]));
  // A guess of the nearest one; the products by a power of two round nothing.
  const auto part = [&](std::size_t i) { return std::nearbyint(q[i] / length * 0x1p25) * 0x1p-25 + 0.0; };
  return {part(0), part(1), part(2), part(3)};
}

/// The angle of the turn from one to the other is twice the arc whose tangent is the vector part of their quotient over
/// its scalar part, and no arc is longer than its tangent.
double angle_up(const Rotation& made, const Asked& asked) {
  const Quaternion<Interval> from = figure::quaternion<Interval>(inverse(made));
  const auto [scalar, vector] = product(from, Quaternion<Interval>{asked[0], {asked[1], asked[2], asked[3]}});
  return (Interval(2) * quotient(root(dot(vector, vector)), scalar)).upper;
}

NearRotation near_to(const Asked& asked) {
  std::array<double, 4> middle{};
  for (std::size_t i = 0; i < 4; ++i) middle[i] = asked[i].lower / 2 + asked[i].upper / 2;
  const Rotation made = rounded_to_lattice(middle);
  return {made, angle_up(made, asked)};
}

/// A multiple of the quaternion on the lattice, if there is one.  By integers without common divisor.
std::optional<Rotation> multiple_on_lattice(std::array<mpq_class, 4> q) {
  mpz_class below = 1, common = 0;
  for (mpq_class& x : q) below = lcm(below, x.get_den());
  std::array<mpz_class, 4> whole;
  for (std::size_t i = 0; i < 4; ++i) {
    whole[i] = q[i].get_num() * (below / q[i].get_den());
    common = gcd(common, whole[i]);
  }
  if (common == 0) return {};
  std::array<double, 4> part{};
  double square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    whole[i] /= common;
    if (abs(whole[i]) >= 0x1p27) return {};
    part[i] = whole[i].get_d();
    square += part[i] * part[i];
  }
  const int exponent = std::min(25, (std::ilogb(square) + 1) / 2);
  for (double& x : part) x = std::ldexp(x, -exponent) + 0.0;
  const Rotation made{part[0], part[1], part[2], part[3]};
  return exact_matrix(made) ? std::optional(made) : std::nullopt;
}

/// The quaternion whose turn is the matrix over its columns' length, where that matrix is a rotation and the quaternion
/// one of rational numbers.
std::optional<std::array<mpq_class, 4>> quaternion_of(const std::array<Vector3, 3>& m) {
  const auto dot = [](auto a, auto b, auto c, auto x, auto y, auto z) { return a * x + b * y + c * z; };
  const auto squares = [](auto a, auto b, auto c, auto x, auto y, auto z) {
    return (a * a + b * b + c * c) - (x * x + y * y + z * z);
  };
  const auto vanishes = [](auto f, const Vector3& u, const Vector3& v) {
    return sign_of(f, u.x, u.y, u.z, v.x, v.y, v.z) == Sign::zero;
  };
  const auto& [u, v, w] = m;
  if (!vanishes(dot, u, v) || !vanishes(dot, v, w) || !vanishes(dot, w, u)) return {};
  if (!vanishes(squares, u, v) || !vanishes(squares, v, w)) return {};
  const mpq_class ux(u.x), uy(u.y), uz(u.z), vx(v.x), vy(v.y), vz(v.z), wx(w.x), wy(w.y), wz(w.z);
  const mpq_class square = ux * ux + uy * uy + uz * uz;
  if (!mpz_perfect_square_p(square.get_num_mpz_t()) || !mpz_perfect_square_p(square.get_den_mpz_t())) return {};
  const mpq_class length(sqrt(square.get_num()), sqrt(square.get_den()));
  // Multiples of the quaternion by each of its parts, of which one at least is not zero.
  using Multiple = std::array<mpq_class, 4>;
  for (const Multiple& q : {Multiple{length + ux + vy + wz, vz - wy, wx - uz, uy - vx},
                            Multiple{vz - wy, length + ux - vy - wz, vx + uy, wx + uz},
                            Multiple{wx - uz, vx + uy, length - ux + vy - wz, wy + vz},
                            Multiple{uy - vx, wx + uz, wy + vz, length - ux - vy + wz}}) {
    for (const mpq_class& x : q) {
      if (x != 0) return q;
    }
  }
  return {};
}

/// The eigenvector of the largest eigenvalue: of all turns its is the one whose matrix has the largest product with m.
Rotation guess(const std::array<Vector3, 3>& m, int exponent) {
  const auto at = [&](std::size_t i, double Vector3::*row) { return std::ldexp(m[i].*row, exponent); };
  const double ux = at(0, &Vector3::x), uy = at(0, &Vector3::y), uz = at(0, &Vector3::z);
  const double vx = at(1, &Vector3::x), vy = at(1, &Vector3::y), vz = at(1, &Vector3::z);
  const double wx = at(2, &Vector3::x), wy = at(2, &Vector3::y), wz = at(2, &Vector3::z);
  Eigen::Matrix4d k;
  k << ux + vy + wz, vz - wy, wx - uz, uy - vx,  //
      vz - wy, ux - vy - wz, vx + uy, wx + uz,   //
      wx - uz, vx + uy, -ux + vy - wz, wy + vz,  //
      uy - vx, wx + uz, wy + vz, -ux - vy + wz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(k);
  const Eigen::Vector4d q = solver.eigenvectors().col(3);
  const double sign = std::signbit(q[0]) ? -1 : 1;
  return rounded_to_lattice({sign * q[0], sign * q[1], sign * q[2], sign * q[3]});
}

/// The root of the sum of squares of what two matrices differ by, the second over its weight; upward.
template <std::size_t N>
double difference_up(const std::array<double, N>& a, const std::array<double, N>& b, double weight) {
  const int exponent = std::max(0, std::ilogb(largest_of(a)));
  Interval sum(0);
  for (std::size_t i = 0; i < N; ++i) {
    const Interval less =
        (Interval(a[i]) - quotient(Interval(b[i]), Interval(weight))) * Interval(std::ldexp(1, -exponent));
    sum = sum + less * less;
  }
  return (root(sum) * Interval(std::ldexp(1, exponent))).upper;
}

std::array<double, 9> numbers_of(const std::array<Vector3, 3>& m) {
  return {m[0].x, m[0].y, m[0].z, m[1].x, m[1].y, m[1].z, m[2].x, m[2].y, m[2].z};
}
std::array<double, 4> numbers_of(const std::array<Vector2, 2>& m) { return {m[0].x, m[0].y, m[1].x, m[1].y}; }

Rotation2 in_plane(const Rotation& q) { return {q.w, q.z}; }
NearRotation2 in_plane(const NearRotation& near) { return {in_plane(near.turn), near.off}; }

}  // namespace

NearRotation rotation(const Vector3& axis, double angle) {
  require_finite_parts("rotation", {"axis", "angle"}, axis, angle);
  const double largest = largest_of(std::array{axis.x, axis.y, axis.z});
  if (largest == 0)
    throw InvalidShape("rotation: axis is zero, which has no direction; give one with a number that is not zero");
  const int exponent = -std::ilogb(largest);
  const Interval x = scaled_interval(axis.x, exponent), y = scaled_interval(axis.y, exponent),
                 z = scaled_interval(axis.z, exponent);
  const auto [cosine, sine] = figure::cosine_and_sine_of_half(angle);
  return near_to({cosine * root(x * x + y * y + z * z), sine * x, sine * y, sine * z});
}

NearRotation2 rotation(double angle) {
  require_finite_parts("rotation", {"angle"}, angle);
  return in_plane(rotation(Vector3{0, 0, 1}, angle));
}

std::optional<NearRotation> nearest_rotation(const Pose& pose) {
  figure::require_sound("nearest_rotation", pose);
  if (handedness(pose) != Sign::positive) return {};
  const auto& m = pose.columns;
  const std::array<double, 9> numbers = numbers_of(m);
  Rotation turn = guess(m, -std::ilogb(largest_of(numbers)));
  if (const auto q = quaternion_of(m)) turn = multiple_on_lattice(*q).value_or(turn);
  const TurnMatrix made = *exact_matrix(turn);
  return NearRotation{turn, difference_up(numbers, numbers_of(made.columns), made.weight)};
}

std::optional<NearRotation2> nearest_rotation(const Pose2& pose) {
  figure::require_sound("nearest_rotation", pose);
  if (handedness(pose) != Sign::positive) return {};
  // The nearest turn is by the angle of the vector (x, y), the quaternion by half of it.
  const auto& [u, v] = pose.columns;
  const mpq_class x = mpq_class(u.x) + mpq_class(v.y), y = mpq_class(u.y) - mpq_class(v.x), square = x * x + y * y;
  const auto half = [&x, &y](const auto& length) -> std::array<mpq_class, 4> {
    if (x >= 0) return {length + x, 0, 0, y};
    return {y, 0, 0, length - x};
  };
  std::optional<Rotation> turn;
  if (mpz_perfect_square_p(square.get_num_mpz_t()) && mpz_perfect_square_p(square.get_den_mpz_t()))
    turn = multiple_on_lattice(half(mpq_class(sqrt(square.get_num()), sqrt(square.get_den()))));
  if (!turn) {
    const int exponent = -std::ilogb(largest_of(numbers_of(pose.columns)));
    const double near_x = std::ldexp(u.x, exponent) + std::ldexp(v.y, exponent);
    const double near_y = std::ldexp(u.y, exponent) - std::ldexp(v.x, exponent);
    const double length = std::sqrt(near_x * near_x + near_y * near_y);
    turn = near_x >= 0 ? rounded_to_lattice({length + near_x, 0, 0, near_y})
                       : rounded_to_lattice({near_y, 0, 0, length - near_x});
  }
  const TurnMatrix2 made = *exact_matrix(in_plane(*turn));
  return NearRotation2{in_plane(*turn), difference_up(numbers_of(pose.columns), numbers_of(made.columns), made.weight)};
}

NearRotation on_turn_lattice(const Rotation& turn) {
  figure::require_sound("on_turn_lattice", turn);
  const auto& [w, x, y, z] = turn;
  if (arith::is_on_turn_lattice(w, x, y, z)) return {turn, 0};
  if (const auto same = multiple_on_lattice({mpq_class(w), mpq_class(x), mpq_class(y), mpq_class(z)}))
    return {*same, 0};
  const int exponent = -std::ilogb(largest_of(std::array{w, x, y, z}));
  return near_to({scaled_interval(w, exponent), scaled_interval(x, exponent), scaled_interval(y, exponent),
                  scaled_interval(z, exponent)});
}

NearRotation2 on_turn_lattice(const Rotation2& turn) {
  figure::require_sound("on_turn_lattice", turn);
  return in_plane(on_turn_lattice(Rotation{turn.w, 0, 0, turn.z}));
}

}  // namespace plumb
