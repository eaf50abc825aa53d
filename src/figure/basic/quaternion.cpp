// Each number is one formula of the quaternions' numbers, or a quotient of two by the square of the length.
#include "plumb/figure/basic/quaternion.hpp"

#include <array>

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"

namespace plumb {
namespace {

using Four = std::array<double, 4>;

Four four_of(const Quaternion& q) { return {q.w, q.x, q.y, q.z}; }

void require_finite_quaternion(std::string_view function, std::string_view name, const Quaternion& q) {
  require_finite_parts(function, {std::string(name) + ".w"}, q.w);
  require_finite_parts(function, {name}, Vector3{q.x, q.y, q.z});
}

bool is_nothing(const Quaternion& q) { return q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0; }

/// A number of Hamilton's product, by the numbers of q in the order and with the signs that go with p's.
Four of_product(std::size_t number, const Quaternion& q) {
  switch (number) {
    case 0:
      return {q.w, -q.x, -q.y, -q.z};
    case 1:
      return {q.x, q.w, q.z, -q.y};
    case 2:
      return {q.y, -q.z, q.w, q.x};
    default:
      return {q.z, q.y, -q.x, q.w};
  }
}

constexpr auto dot_of_fours = [](auto a, auto b, auto c, auto d, auto p, auto q, auto r, auto s) {
  return (a * p + b * q) + (c * r + d * s);
};
constexpr auto square_of_four = [](auto w, auto x, auto y, auto z) { return (w * w + x * x) + (y * y + z * z); };

/// What a number of the product is more than claimed.
struct ProductLessClaim {
  static constexpr std::string_view name = "number of a product, less what is claimed";
  static constexpr std::array arguments{4, 4, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    return dot_of_fours(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]) - p[8];
  }
};
/// A part of a turn's matrix, less what is claimed, times the square of the length.
template <class Part>
struct PartLessClaim {
  static constexpr std::string_view name = "part of a turn, less what is claimed";
  static constexpr std::array arguments{4, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 5>& p) const {
    return Part{}(p[0], p[1], p[2], p[3]) - p[4] * square_of_four(p[0], p[1], p[2], p[3]);
  }
};

double number_of_product(std::size_t i, const Quaternion& p, const Quaternion& q) {
  const double made = rounded_value(Rounding::nearest, dot_of_fours, four_of(p), of_product(i, q));
  return figure::within_doubles(made, "rounded_product", "a number of the product");
}

/// Of the matrix of a turn, times the square of the length: on the diagonal (w, own axis, the other two), else
/// (w, third axis, the axes of row and column), where `to` is the sign of w's part.
constexpr auto diagonal_part = [](auto w, auto x, auto y, auto z) { return (w * w + x * x) - (y * y + z * z); };
constexpr auto forward_part = [](auto w, auto z, auto x, auto y) { return (x * y + w * z) + (x * y + w * z); };
constexpr auto backward_part = [](auto w, auto z, auto x, auto y) { return (x * y - w * z) + (x * y - w * z); };

struct TurnPart {
  std::size_t row, column;
  /// The quaternion's numbers in the order that its formula wants.
  [[nodiscard]] Four order(const Quaternion& q) const {
    const std::array<double, 3> axes{q.x, q.y, q.z};
    if (row == column) return {q.w, axes[row], axes[(row + 1) % 3], axes[(row + 2) % 3]};
    return {q.w, axes[3 - row - column], axes[row], axes[column]};
  }
  /// f of the part's formula.
  template <class F>
  auto as(F f) const {
    if (row == column) return f(diagonal_part);
    return row == (column + 1) % 3 ? f(forward_part) : f(backward_part);
  }
};

double rounded_part_of(const TurnPart& part, const Quaternion& q) {
  return part.as(
      [&](auto formula) { return rounded_quotient(Rounding::nearest, formula, square_of_four, part.order(q)); });
}

bool holds_part(const TurnPart& part, const Quaternion& q, double claimed) {
  return part.as(
      [&](auto formula) { return sign_of(PartLessClaim<decltype(formula)>{}, part.order(q), claimed) == Sign::zero; });
}

std::optional<Pose> turn_in_doubles(std::string_view function, const Quaternion& q, bool only_exact) {
  require_finite_quaternion(function, "q", q);
  if (is_nothing(q)) return {};
  std::array<std::array<double, 3>, 3> m{};  // a column each
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      m[j][i] = rounded_part_of({i, j}, q);
      if (only_exact && !holds_part({i, j}, q, m[j][i])) return {};
    }
  }
  const auto column = [&](std::size_t j) { return Vector3{m[j][0], m[j][1], m[j][2]}; };
  return Pose{{column(0), column(1), column(2)}, {0, 0, 0}};
}

/// The first number of q v q*, where the axes are named in a turn that begins with it.
constexpr auto turned_part = [](auto w, auto x, auto y, auto z, auto u, auto v, auto t) {
  const auto second = (x * y - w * z) * v, third = (x * z + w * y) * t;
  return ((w * w + x * x) - (y * y + z * z)) * u + ((second + second) + (third + third));
};
constexpr auto square_beside = [](auto w, auto x, auto y, auto z, auto, auto, auto) {
  return (w * w + x * x) + (y * y + z * z);
};

}  // namespace

Quaternion rounded_product(const Quaternion& p, const Quaternion& q) {
  require_finite_quaternion("rounded_product", "p", p);
  require_finite_quaternion("rounded_product", "q", q);
  return {number_of_product(0, p, q), number_of_product(1, p, q), number_of_product(2, p, q),
          number_of_product(3, p, q)};
}

std::optional<Quaternion> exact_product(const Quaternion& p, const Quaternion& q) {
  require_finite_quaternion("exact_product", "p", p);
  require_finite_quaternion("exact_product", "q", q);
  Four made{};
  for (std::size_t i = 0; i < 4; ++i) {
    made[i] = rounded_value(Rounding::nearest, dot_of_fours, four_of(p), of_product(i, q));
    if (made[i] - made[i] != 0 || sign_of(ProductLessClaim{}, four_of(p), of_product(i, q), made[i]) != Sign::zero) {
      return {};
    }
  }
  return Quaternion{made[0], made[1], made[2], made[3]};
}

double rounded_length(const Quaternion& q) {
  require_finite_quaternion("rounded_length", "q", q);
  return rounded_root(Rounding::nearest, square_of_four, four_of(q));
}

std::optional<Pose> rounded_turn(const Quaternion& q) { return turn_in_doubles("rounded_turn", q, false); }
std::optional<Pose> exact_turn(const Quaternion& q) { return turn_in_doubles("exact_turn", q, true); }

std::optional<Vector3> rounded_turned(const Quaternion& q, const Vector3& v) {
  require_finite_quaternion("rounded_turned", "q", q);
  require_finite_parts("rounded_turned", {"v"}, v);
  if (is_nothing(q)) return {};
  const auto number = [&](double x, double y, double z, const Vector3& turned) {
    const double made = rounded_quotient(Rounding::nearest, turned_part, square_beside, Four{q.w, x, y, z}, turned);
    return figure::within_doubles(made, "rounded_turned", "a number of the image");
  };
  return Vector3{number(q.x, q.y, q.z, v), number(q.y, q.z, q.x, {v.y, v.z, v.x}),
                 number(q.z, q.x, q.y, {v.z, v.x, v.y})};
}

bool same_turn(const Quaternion& p, const Quaternion& q) {
  require_finite_quaternion("same_turn", "p", p);
  require_finite_quaternion("same_turn", "q", q);
  if (is_nothing(p) || is_nothing(q)) return is_nothing(p) && is_nothing(q);
  const Four a = four_of(p), b = four_of(q);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto minor_of = [](auto ai, auto aj, auto bi, auto bj) { return ai * bj - aj * bi; };
      if (sign_of(minor_of, a[i], a[j], b[i], b[j]) != Sign::zero) return false;
    }
  }
  return true;
}

}  // namespace plumb
