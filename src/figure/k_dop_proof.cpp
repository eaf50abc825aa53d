#include "k_dop_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <plumb/predicates/determinant.hpp>

#include "plumb/certify/side_of_plane.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb::figure {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
constexpr int most_pivots = 40;

Sign side(const Vector2& d, double offset, const Point2& p) { return side_of_line(d, offset, p); }
Sign side(const Vector3& d, double offset, const Point3& p) { return side_of_plane(d, offset, p); }
Point2 point(const std::array<double, 3>& x) { return {x[0], x[1]}; }
Point3 point(const std::array<double, 4>& x) { return {x[0], x[1], x[2]}; }

// Rows of normal and limit, which have no common point.
bool have_no_point(const std::array<std::array<double, 3>, 3>& h) {
  const auto normal = [&](std::size_t i) { return Vector2{h[i][0], h[i][1]}; };
  const auto cofactor = [&](std::size_t i, std::size_t j) {
    return sign_of(predicates::Determinant2{}, normal(i), normal(j));
  };
  const std::array factors{cofactor(1, 2), -cofactor(0, 2), cofactor(0, 1)};
  const auto [least, most] = std::ranges::minmax(factors);
  const Sign sum = sign_of(predicates::Determinant3{}, h[0], h[1], h[2]);
  return (least != Sign::negative && sum == Sign::negative) || (most != Sign::positive && sum == Sign::positive);
}
bool have_no_point(const std::array<std::array<double, 4>, 4>& h) {
  const auto normal = [&](std::size_t i) { return Vector3{h[i][0], h[i][1], h[i][2]}; };
  const auto cofactor = [&](std::size_t i, std::size_t j, std::size_t k) {
    return sign_of(predicates::Determinant3{}, normal(i), normal(j), normal(k));
  };
  const std::array factors{cofactor(1, 2, 3), -cofactor(0, 2, 3), cofactor(0, 1, 3), -cofactor(0, 1, 2)};
  const auto [least, most] = std::ranges::minmax(factors);
  const Sign sum = -sign_of(predicates::Determinant4{}, h[0], h[1], h[2], h[3]);
  return (least != Sign::negative && sum == Sign::negative) || (most != Sign::positive && sum == Sign::positive);
}

// As in rational_lp.cpp, in doubles: rows of normal, 1 and limit; the last column is slack <= 1.
template <class Vector>
class Guess {
 public:
  static constexpr std::size_t dimension = sizeof(Vector) / sizeof(double), size = dimension + 1;
  using Row = std::array<double, size>;

  explicit Guess(const KDop<Vector>& k_dop) : k_dop_(k_dop), columns_(2 * k_dop.min.size()) {
    for (std::size_t k = 0; k < size; ++k) inverse_[k] = {}, inverse_[k][k] = 1;
    basis_.fill(none);
    basis_[dimension] = columns_;
    weight_[dimension] = 1;
    for (std::size_t i = 0; i < k_dop.min.size(); ++i)
      scale_ = std::max({scale_, std::fabs(k_dop.min[i]), std::fabs(k_dop.max[i])});
  }

  // False where the pivots do not come to an end.
  bool solve() {
    for (int pivots = 0; pivots < most_pivots; ++pivots) {
      multiply();
      const std::size_t in = entering();
      if (in == none) return true;
      const Row column = column_of(in);
      Row step{};
      for (std::size_t k = 0; k < size; ++k) {
        for (std::size_t i = 0; i < size; ++i) step[k] += inverse_[k][i] * column[i];
      }
      const std::size_t out = leaving(step);
      if (out == none) return false;
      pivot(out, in, step);
    }
    return false;
  }

  // The point, with the slack that all halfspaces have there.
  [[nodiscard]] const Row& at() const { return at_; }

  // Normals and limits of the halfspaces that decide; false where one is missing.
  bool deciding(std::array<Row, size>& rows) const {
    for (std::size_t k = 0; k < size; ++k) {
      if (basis_[k] >= columns_) return false;
      rows[k] = column_of(basis_[k]);
      rows[k][dimension] = limit(basis_[k]);
    }
    return true;
  }

 private:
  [[nodiscard]] double limit(std::size_t j) const {
    if (j == columns_) return 1;
    return j % 2 == 0 ? k_dop_.max[j / 2] : -k_dop_.min[j / 2];
  }
  [[nodiscard]] Row column_of(std::size_t j) const {
    Row column{};
    column[dimension] = 1;
    if (j == columns_) return column;
    const auto d = coordinates(k_dop_.directions.all()[j / 2]);
    for (std::size_t i = 0; i < dimension; ++i) column[i] = j % 2 == 0 ? d[i] : -d[i];
    return column;
  }
  void multiply() {
    at_ = {};
    for (std::size_t k = 0; k < size; ++k) {
      const double cost = basis_[k] == none ? 0 : limit(basis_[k]);
      for (std::size_t i = 0; i < size; ++i) at_[i] += cost * inverse_[k][i];
    }
  }
  // Violations within rounding are none: whether the guess is right is proved elsewhere.
  [[nodiscard]] std::size_t entering() const {
    std::size_t best = none;
    double most = scale_ * 0x1p-40;
    for (std::size_t i = 0; i < k_dop_.min.size(); ++i) {
      const auto d = coordinates(k_dop_.directions.all()[i]);
      double place = 0;
      for (std::size_t k = 0; k < dimension; ++k) place += d[k] * at_[k];
      const double above = place + at_[dimension] - k_dop_.max[i], below = k_dop_.min[i] - place + at_[dimension];
      if (above > most) best = 2 * i, most = above;
      if (below > most) best = 2 * i + 1, most = below;
    }
    return best;
  }
  [[nodiscard]] std::size_t leaving(const Row& step) const {
    constexpr double nothing = 0x1p-30;
    std::size_t best = none;
    for (std::size_t k = 0; k < size; ++k) {
      if (basis_[k] == none && std::fabs(step[k]) > nothing) return k;
      if (step[k] > nothing && (best == none || weight_[k] * step[best] < weight_[best] * step[k])) best = k;
    }
    return best;
  }
  void pivot(std::size_t out, std::size_t in, const Row& step) {
    weight_[out] /= step[out];
    for (double& x : inverse_[out]) x /= step[out];
    for (std::size_t k = 0; k < size; ++k) {
      if (k == out) continue;
      weight_[k] -= step[k] * weight_[out];
      for (std::size_t i = 0; i < size; ++i) inverse_[k][i] -= step[k] * inverse_[out][i];
    }
    basis_[out] = in;
  }

  const KDop<Vector>& k_dop_;
  std::size_t columns_;
  std::array<Row, size> inverse_;
  std::array<std::size_t, size> basis_;
  Row weight_{}, at_{};
  double scale_ = 0;
};

template <class Vector>
std::optional<bool> proved(const KDop<Vector>& k_dop) {
  Guess<Vector> guess(k_dop);
  if (!guess.solve()) return {};
  const auto& at = guess.at();
  if (at.back() > 0) {
    const auto p = point(at);
    for (const double x : coordinates(p)) {
      if (!(x - x == 0)) return {};
    }
    for (std::size_t i = 0; i < k_dop.min.size(); ++i) {
      const Vector& d = k_dop.directions.all()[i];
      if (side(d, k_dop.min[i], p) != Sign::positive || side(d, k_dop.max[i], p) != Sign::negative) return {};
    }
    return true;
  }
  std::array<typename Guess<Vector>::Row, Guess<Vector>::size> rows;
  if (guess.deciding(rows) && have_no_point(rows)) return false;
  return {};
}

}  // namespace

std::optional<bool> has_inner_point(const KDop2& k_dop) { return proved(k_dop); }
std::optional<bool> has_inner_point(const KDop3& k_dop) { return proved(k_dop); }

}  // namespace plumb::figure
