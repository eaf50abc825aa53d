// Cramer's rule: the unknown asked for is swapped into the first column, so that one pair of formulas serves all.
#include "plumb/figure/basic/small_system.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "certify/rounded.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {
namespace {

template <std::size_t N>
using Column = std::array<double, N>;

/// Of N columns and the right side: the determinant of the columns, the first of them replaced by the right side or
/// not.
template <std::size_t N, bool ByRight>
struct Columns {
  static constexpr std::string_view name = "solve";
  static constexpr int points = static_cast<int>(N) + 1, dimension = static_cast<int>(N);

  template <class T>
  constexpr auto operator()(const std::array<T, N*(N + 1)>& p) const {
    // Column j of the determinant; a determinant is that of its transpose, so columns stand for rows.
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      const std::array<T, N * N> m{p[I < N && ByRight ? N * N + I : I]...};
      if constexpr (N == 2) {
        return predicates::Determinant2{}(m);
      } else if constexpr (N == 3) {
        return predicates::Determinant3{}(m);
      } else {
        return predicates::Determinant4{}(m);
      }
    }
    (std::make_index_sequence<N * N>{});
  }
};

template <std::size_t N>
Column<N> column(const Rows<N>& rows, std::size_t j) {
  Column<N> c{};
  for (std::size_t i = 0; i < N; ++i) c[i] = rows[i][j];
  return c;
}

std::string entry(std::string_view name, std::size_t i) {
  return std::string(name).append("[").append(std::to_string(i)).append("]");
}

template <std::size_t N>
void require_finite_system(std::string_view function, const Rows<N>& rows, const Column<N>& right) {
  bool finite = true;
  for (const auto& row : rows) {
    for (const double x : row) finite &= x - x == 0;
  }
  for (const double x : right) finite &= x - x == 0;
  if (finite) return;
  std::vector<std::string> names;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      names.push_back(entry(entry("rows", i), j));
      numbers.push_back(rows[i][j]);
    }
  }
  for (std::size_t i = 0; i < N; ++i) {
    names.push_back(entry("right", i));
    numbers.push_back(right[i]);
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  throw_non_finite(function, std::vector<int>(numbers.size(), 1), numbers, "xyz", views);
}

double finite(double x, std::string_view function, std::string_view what) {
  if (!std::isinf(x)) return x;
  throw BeyondDoubles(std::string(function).append(": ").append(what).append(" is beyond the largest double"));
}

/// The solution of a system whose determinant is not zero.
template <std::size_t N>
Column<N> cramer(std::string_view function, const Rows<N>& rows, const Column<N>& right) {
  Column<N> x{};
  for (std::size_t j = 0; j < N; ++j) {
    x[j] = [&]<std::size_t... I>(std::index_sequence<I...>) {
      const auto swapped = [&](std::size_t i) { return i == 0 ? j : i == j ? 0 : i; };
      return rounded_quotient(Rounding::nearest, Columns<N, true>{}, Columns<N, false>{}, column(rows, swapped(I))...,
                              right);
    }
    (std::make_index_sequence<N>{});
    finite(x[j], function, entry("x", j));
  }
  return x;
}

using Matrix = std::vector<std::vector<BigDyadic>>;

/// The rank of the first `width` columns, which are eliminated without a division.
std::size_t eliminate(Matrix& m, std::size_t width) {
  std::size_t rank = 0;
  for (std::size_t j = 0; j < width && rank < m.size(); ++j) {
    std::size_t pivot = rank;
    while (pivot < m.size() && m[pivot][j].sign() == Sign::zero) ++pivot;
    if (pivot == m.size()) continue;
    std::swap(m[pivot], m[rank]);
    for (std::size_t i = rank + 1; i < m.size(); ++i) {
      const BigDyadic factor = m[i][j];
      for (std::size_t k = 0; k < m[i].size(); ++k) m[i][k] = m[i][k] * m[rank][j] - factor * m[rank][k];
    }
    ++rank;
  }
  return rank;
}

template <std::size_t N>
SystemSolution<N> singular(const Rows<N>& rows, const Column<N>& right) {
  Matrix m(N);
  for (std::size_t i = 0; i < N; ++i) {
    for (const double x : rows[i]) m[i].emplace_back(x);
    m[i].emplace_back(right[i]);
  }
  const std::size_t rank = eliminate(m, N);
  for (std::size_t i = rank; i < N; ++i) {  // what is left says that zero is this number
    if (m[i][N].sign() != Sign::zero) return {Solutions::none, rank, {}};
  }
  return {Solutions::many, rank, {}};
}

template <std::size_t N>
SystemSolution<N> solution(const Rows<N>& rows, const Column<N>& right) {
  require_finite_system("solve", rows, right);
  if (determinant_sign(rows) == Sign::zero) return singular(rows, right);
  return {Solutions::one, N, cramer("solve", rows, right)};
}

template <std::size_t N, class Determinant>
double rounded_determinant(Determinant, const Rows<N>& rows) {
  require_finite_system("determinant", rows, Column<N>{});
  const double d =
      std::apply([](const auto&... row) { return rounded_value(Rounding::nearest, Determinant{}, row...); }, rows);
  return finite(d, "determinant", "it");
}

template <std::size_t N>
std::optional<Rows<N>> inverted(const Rows<N>& rows) {
  require_finite_system("inverse", rows, Column<N>{});
  if (determinant_sign(rows) == Sign::zero) return {};
  Rows<N> result{};
  for (std::size_t j = 0; j < N; ++j) {
    Column<N> unit{};
    unit[j] = 1;
    const Column<N> x = cramer("inverse", rows, unit);
    for (std::size_t i = 0; i < N; ++i) result[i][j] = x[i];
  }
  return result;
}

}  // namespace

SystemSolution<2> solve(const Rows<2>& rows, const std::array<double, 2>& right) { return solution(rows, right); }
SystemSolution<3> solve(const Rows<3>& rows, const std::array<double, 3>& right) { return solution(rows, right); }
SystemSolution<4> solve(const Rows<4>& rows, const std::array<double, 4>& right) { return solution(rows, right); }

double determinant(const Rows<2>& rows) { return rounded_determinant(predicates::Determinant2{}, rows); }
double determinant(const Rows<3>& rows) { return rounded_determinant(predicates::Determinant3{}, rows); }
double determinant(const Rows<4>& rows) { return rounded_determinant(predicates::Determinant4{}, rows); }

std::optional<Rows<2>> inverse(const Rows<2>& rows) { return inverted(rows); }
std::optional<Rows<3>> inverse(const Rows<3>& rows) { return inverted(rows); }
std::optional<Rows<4>> inverse(const Rows<4>& rows) { return inverted(rows); }

}  // namespace plumb
