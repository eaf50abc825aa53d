#include "certify/batch/tape_plan.hpp"

#include <utility>

namespace plumb::batch {
namespace {

StepKind kind_of(char operation, bool left_is_plain, bool right_is_plain) {
  using enum StepKind;
  const bool both = left_is_plain && right_is_plain, one = left_is_plain || right_is_plain;
  if (operation == '*') return both ? product_of_plains : one ? product_of_plain_and_any : product;
  if (operation == '+') return both ? sum_of_plains : one ? sum_of_plain_and_any : sum;
  if (both) return difference_of_plains;
  return left_is_plain ? difference_of_plain_and_any : right_is_plain ? difference_of_any_and_plain : difference;
}

}  // namespace

TapePlan::TapePlan(const BatchFormula& asked, std::span<const Column> columns) : constant_(asked.constant) {
  const std::size_t arity = columns.size();
  for (const Column& c : columns) strides_.push_back(c.stride);
  beside_.assign(arity, 1);
  for (std::size_t k = 0; k < arity; k += beside_[k]) {
    const Column& c = columns[k];
    if (!c.apart && (c.stride == 2 || c.stride == 3)) beside_[k] = c.stride;
  }

  const std::span<const tape::Instruction> instructions = asked.program.instructions;
  std::vector<std::size_t> last_use(arity + instructions.size(), 0);
  for (std::size_t i = 0; i < instructions.size(); ++i)
    last_use[instructions[i].left] = last_use[instructions[i].right] = i;
  last_use.back() = instructions.size();

  std::vector<std::uint16_t> place;  // of each number: a coordinate's own, a result's slot
  std::vector<bool> plain(arity, true);
  for (std::size_t k = 0; k < arity; ++k) place.push_back(static_cast<std::uint16_t>(k));
  std::vector<std::uint16_t> free;
  for (std::size_t i = 0; i < instructions.size(); ++i) {
    const tape::Instruction& in = instructions[i];
    if (free.empty()) free.push_back(static_cast<std::uint16_t>(arity + slots_++));
    const std::uint16_t to = free.back();
    free.pop_back();
    const bool leaf = in.operation != '*' && in.left < arity && in.right < arity;
    if (leaf) {
      const StepKind kind = in.operation == '+' ? StepKind::plain_sum : StepKind::plain_difference;
      steps_.push_back({kind, in.left, in.right, to});
    } else {
      const StepKind kind = kind_of(in.operation, plain[in.left], plain[in.right]);
      std::uint16_t left = place[in.left], right = place[in.right];
      const bool turned = in.operation != '-' && !plain[in.left] && plain[in.right];  // the plain one first
      if (turned) std::swap(left, right);
      steps_.push_back({kind, left, right, to});
    }
    place.push_back(to);
    plain.push_back(leaf);
    const auto release = [&](std::uint16_t operand) {
      if (operand >= arity && last_use[operand] == i) free.push_back(place[operand]);
    };
    release(in.left);
    if (in.right != in.left) release(in.right);
    if (last_use[arity + i] == 0) free.push_back(to);  // nobody reads it
  }
}

}  // namespace plumb::batch
