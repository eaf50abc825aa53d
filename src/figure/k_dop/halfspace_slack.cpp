#include "figure/k_dop/halfspace_slack.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace plumb::figure {
namespace {

// Of the guess, which is proved afterward: where it gives up, which weights and steps it takes for zero, and which
// violations, as a part of the largest limit, for none.
constexpr int most_pivots = 60;
constexpr double nothing = 0x1p-30, no_violation = 0x1p-40;
constexpr double most_scale = 0x1p1000, least_scale = 1 / most_scale;  // powers of two whose inverses are doubles

double certain_part(const Running& x) { return std::fabs(x.value) > x.error ? x.value : 0; }
/// The power of two in a number that is not negative; infinite or zero beyond and below those of normal size.
double power_below(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & std::bit_cast<std::uint64_t>(HUGE_VAL));
}

}  // namespace

void HalfspaceSlack::reserve(std::size_t rows) {
  rows_.reserve(rows);
  guess_.reserve(rows);
}

void HalfspaceSlack::add(const Near& row, double unit) {
  const double by = std::clamp(power_below(unit), least_scale, most_scale), times = 1 / by;  // powers of two
  rows_.push_back({row, by});
  const auto part = [times](const Running& x) { return certain_part(x) * times; };
  guess_.push_back({{part(row.normal[0]), part(row.normal[1]), part(row.normal[2])}, part(row.limit)});
  scale_ = std::max(scale_, std::fabs(guess_.back().limit));
}

std::optional<int> HalfspaceSlack::sign() {
  const auto near = sign_by_doubles();
  return near ? near : sign_by_integers();
}

std::optional<int> HalfspaceSlack::sign_by_doubles() {
  guessed_ = guess();
  if (!guessed_) return {};
  if (at_[3] > 0 && has_slack_everywhere()) return 1;
  if (at_[3] < 0 && has_no_point()) return -1;
  return {};
}

std::vector<std::size_t> HalfspaceSlack::deciding() const {
  std::vector<std::size_t> order, rows;
  for (std::size_t k = 0; k < most; ++k) {
    if (guessed_ && basis_[k] < rows_.size() && weight_[k] > nothing) order.push_back(k);
  }
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return weight_[a] > weight_[b]; });
  for (const std::size_t k : order) rows.push_back(basis_[k]);
  return rows;
}

// min limits . y with sum of y_j columns = (0, .., 0, 1), y >= 0: a basis of four columns, which at first are the
// numbers held at zero and slack <= 1.
bool HalfspaceSlack::guess() {
  for (std::size_t k = 0; k < most; ++k) inverse_[k] = {}, inverse_[k][k] = 1;
  basis_.fill(held);
  basis_[3] = at_most_one;
  weight_ = {};
  weight_[3] = 1;
  for (int pivots = 0; pivots < most_pivots; ++pivots) {
    multiply();
    const std::size_t in = entering();
    if (in == held) return true;
    Column step{};
    for (std::size_t k = 0; k < most; ++k) {
      step[k] = inverse_[k][3];
      for (std::size_t i = 0; i < 3; ++i) step[k] += inverse_[k][i] * guess_[in].normal[i];
    }
    const std::size_t out = leaving(step);
    if (out == most) return false;
    pivot(out, in, step);
  }
  return false;
}

void HalfspaceSlack::multiply() {
  at_ = {};
  for (std::size_t k = 0; k < most; ++k) {
    const double cost = limit(basis_[k]);
    for (std::size_t i = 0; i < most; ++i) at_[i] += cost * inverse_[k][i];
  }
}

// The row that the point violates most.
std::size_t HalfspaceSlack::entering() const {
  std::size_t best = held;
  double largest = scale_ * no_violation;
  for (std::size_t j = 0; j < guess_.size(); ++j) {
    const auto& n = guess_[j].normal;
    const double above = ((n[0] * at_[0] + n[1] * at_[1]) + (n[2] * at_[2] + at_[3])) - guess_[j].limit;
    if (above > largest) best = j, largest = above;
  }
  return best;
}

std::size_t HalfspaceSlack::leaving(const Column& step) const {
  std::size_t best = most;
  for (std::size_t k = 0; k < most; ++k) {
    if (basis_[k] == held && std::fabs(step[k]) > nothing) return k;
    if (step[k] > nothing && (best == most || weight_[k] * step[best] < weight_[best] * step[k])) best = k;
  }
  return best;
}

void HalfspaceSlack::pivot(std::size_t out, std::size_t in, const Column& step) {
  weight_[out] /= step[out];
  for (double& x : inverse_[out]) x /= step[out];
  for (std::size_t k = 0; k < most; ++k) {
    if (k == out) continue;
    weight_[k] -= step[k] * weight_[out];
    for (std::size_t i = 0; i < most; ++i) inverse_[k][i] -= step[k] * inverse_[out][i];
  }
  basis_[out] = in;
}

bool HalfspaceSlack::has_slack_everywhere() const {
  return std::ranges::all_of(rows_, [&](const Given& given) {
    const Near& row = given.near;
    Running sum = Running(0.0) - row.limit;
    for (std::size_t k = 0; k < 3; ++k) sum = sum + row.normal[k] * Running(at_[k]);
    return sum.upper() < 0;
  });
}

}  // namespace plumb::figure
