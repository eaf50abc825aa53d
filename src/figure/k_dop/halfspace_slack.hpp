// Linear programming: has some point slack in all of these halfspaces, or do they leave their boundaries only, or
// nothing?
//
// Halfspaces are normal . x <= limit for x of at most three numbers, given over doubles with a bound of their errors
// and, where that leaves a doubt, in integers.  The greatest slack t that one point can have in all, normal . x + unit
// t <= limit with t <= 1, is guessed by the simplex method on the dual program in plain doubles.  Its proofs:
// - a point in doubles with slack in all;
// - the last basis, solved exactly: weights that are not negative combine its normals to zero, so that no point has
//   more slack than its own point, which all other halfspaces hold.  The sign of that slack is the answer.
// Laws: what is answered is true; where the basis is not the exact optimum nothing is answered.
// Source: Farkas' lemma; Chvatal, Linear Programming, 1983, chapters 3 and 5; RTCD 9.4.
// Cost: some ns a halfspace and pivot; some ten microseconds more where the slack is nearly zero.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "arith/running_error.hpp"
#include "plumb/arith/big.hpp"

namespace plumb::figure {

template <class T>
struct SlackRow {
  std::array<T, 3> normal;
  T limit;
};

class HalfspaceSlack {
 public:
  using Near = SlackRow<Running>;
  using Exact = SlackRow<BigDyadic>;

  /// `exactly(i)` is row i once more.
  explicit HalfspaceSlack(std::function<Exact(std::size_t)> exactly) : exactly_(std::move(exactly)) {}

  void reserve(std::size_t rows);
  /// One more halfspace; its slack is measured in about `unit`, which is positive, as large as its normal.
  void add(const Near& row, double unit);

  /// 1: some point has slack in all; 0: none has, but some lies in all; -1: none does.
  [[nodiscard]] std::optional<int> sign();

  /// In two steps: what doubles prove,
  [[nodiscard]] std::optional<int> sign_by_doubles();
  /// then, unless the guess failed, the halfspaces that keep the slack down, the foremost first,
  [[nodiscard]] std::vector<std::size_t> deciding() const;
  [[nodiscard]] const std::array<double, 4>& guessed_point() const { return at_; }  // three numbers, and their slack
  /// and what integers prove.
  [[nodiscard]] std::optional<int> sign_by_integers() const;

 private:
  static constexpr std::size_t most = 4;                                    // numbers of a point, and its slack
  static constexpr std::size_t held = static_cast<std::size_t>(-1);         // in place of a row: the number is zero
  static constexpr std::size_t at_most_one = static_cast<std::size_t>(-2);  // slack <= 1
  using Column = std::array<double, most>;
  /// What a row says of a point, its slack and 1, all times w: the sum of products is not positive.
  using ExactRow = std::array<BigDyadic, most + 1>;

  [[nodiscard]] bool guess();
  void multiply();
  [[nodiscard]] std::size_t entering() const;
  [[nodiscard]] std::size_t leaving(const Column& step) const;
  void pivot(std::size_t out, std::size_t in, const Column& step);
  [[nodiscard]] double limit(std::size_t j) const { return j == held ? 0 : j == at_most_one ? 1 : guess_[j].limit; }

  [[nodiscard]] bool has_slack_everywhere() const;
  [[nodiscard]] bool has_no_point() const;
  [[nodiscard]] ExactRow exact_row(std::size_t j, std::size_t number) const;
  [[nodiscard]] Running weight(std::size_t k) const;
  [[nodiscard]] Sign weight_sign(const std::array<ExactRow, most>& rows, std::size_t k) const;
  [[nodiscard]] bool hold_all(const ExactRow& place) const;

  struct Given {
    Near near;
    double unit;
  };
  std::function<Exact(std::size_t)> exactly_;
  std::vector<Given> rows_;
  std::vector<SlackRow<double>> guess_;  // in units, without what is lost in errors
  double scale_ = 0;
  bool guessed_ = false;
  std::array<Column, most> inverse_{};
  std::array<std::size_t, most> basis_{};  // at k, at first: what holds number k, or slack
  Column weight_{}, at_{};
};

}  // namespace plumb::figure
