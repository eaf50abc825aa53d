#include "certify/proof/proof_lines.hpp"

namespace plumb::certify::proof {

std::string joined(std::initializer_list<std::string_view> pieces) {
  std::string text;
  for (const std::string_view piece : pieces) text.append(piece);
  return text;
}

Number leaf(const certify::tape::Instruction& i) {
  const std::string pair = joined({std::to_string(i.left), "_", std::to_string(i.right)});
  const bool difference = i.operation == '-';
  return {joined({difference ? "d" : "s", pair}), joined({difference ? "D" : "S", pair})};
}

Number applied(const Number& left, char operation, const Number& right) {
  const std::string sign{' ', operation, ' '};
  return {joined({left.computed, sign, right.computed}), joined({left.exact, sign, right.exact})};
}

void Lines::define(std::string_view name, std::string_view equals, const std::string& expression) {
  definitions_.append(joined({name, equals, expression, ";\n"}));
}

std::string Lines::name(std::string_view name, std::string_view equals, const std::string& expression) {
  const auto [at, is_new] = names_.try_emplace(joined({equals, expression}), name);
  if (is_new) define(name, equals, expression);
  return at->second;
}

bool Lines::suppose_at_most(std::string_view name, std::string_view bound) {
  const std::string hypothesis = joined({"|", name, "| <= ", bound});
  if (!known_.insert(hypothesis).second) return false;
  hypotheses_.append(joined({hypotheses_.empty() ? "" : "\n  /\\ ", hypothesis}));
  return true;
}

std::string Lines::claim(const std::string& goals) const {
  return joined({definitions_, "\n{ ", hypotheses_, "\n->\n  ", goals, " }\n"});
}

}  // namespace plumb::certify::proof
