#include "plumb/certify/proof_script.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "certify/case_line.hpp"
#include "certify/proof/proof_lines.hpp"
#include "certify/proof/terms.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {
namespace certify::proof {

std::string unit_script(const certify::tape::Program& program, double error, double most) {
  const std::string bound = hexadecimal(error), range = hexadecimal(most);
  Lines lines;
  lines.define("@double", " = ", "float<ieee_64, ne>");
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < program.arity; ++i) {
    const std::string name = joined({"x", std::to_string(i)});
    numbers.push_back({name, name});
  }
  Number root;  // before its rounding
  std::string value;
  for (const certify::tape::Instruction& i : program.instructions) {
    if (certify::terms::is_leaf(program, i)) {
      const Number l = leaf(i);
      if (lines.suppose_at_most(l.computed, "1")) lines.define(l.computed, " = ", joined({"double(", l.exact, ")"}));
      numbers.push_back(l);
      root = {l.exact, l.exact};
      value = l.computed;
      continue;
    }
    for (const auto operand : {i.left, i.right}) {
      if (operand < program.arity) lines.suppose_at_most(numbers[operand].computed, "1");
    }
    const Number before = applied(numbers[i.left], i.operation, numbers[i.right]);
    const std::string number = std::to_string(numbers.size() - program.arity);
    if (&i != &program.instructions.back()) {
      const std::string_view equals = i.doubles() ? " = " : " double= ";
      numbers.push_back({lines.name(joined({"t", number}), equals, before.computed),
                         lines.name(joined({"T", number}), " = ", before.exact)});
    } else {
      lines.define(root.computed = "unrounded", " = ", before.computed);
      lines.define(root.exact = "exact", " = ", before.exact);
      lines.define(value = "value", " = ", joined({"double(", root.computed, ")"}));
    }
  }
  std::string goals = joined({"|", root.computed, " - ", root.exact, "| <= ", bound});
  goals += joined({"\n  /\\ (", root.exact, " in [-", range, ", 0] -> ", value, " <= ", bound, ")"});
  goals += joined({"\n  /\\ (", root.exact, " in [0, ", range, "] -> ", value, " >= -", bound, ")"});
  return lines.claim(goals);
}

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return line;
}

}  // namespace certify::proof

double count_terms(const certify::tape::Program& program) {
  std::vector<double> terms(program.arity, 1);
  for (const certify::tape::Instruction& i : program.instructions) {
    const double left = terms[i.left], right = terms[i.right];
    terms.push_back(certify::terms::is_leaf(program, i) ? 1 : i.operation == '*' ? left * right : left + right);
    if (terms.back() >= 0x1p32) throw Error("a formula of 2^32 terms or more has no proof script");
  }
  return terms.back();
}

std::string proof_script(std::string_view name, const certify::tape::Program& program, double constant,
                         ProofScale scale) {
  using namespace certify::proof;
  if (program.instructions.empty()) throw Error("a formula without operations has no proof script");
  if (!(constant > 0) || !std::isfinite(constant)) {
    throw Error(joined({"the constant of a proof script is a positive number, not ", hexadecimal(constant)}));
  }
  const bool unit = scale == ProofScale::unit;
  std::string script = joined({"# Is the bound of the filter of ", one_line(name), " true, "});
  script += unit ? "for differences up to 1, in IEEE doubles?" : "term by term, at every scale?";
  script += "\n# Written by Plumb from the formula.  `gappa FILE` exits with 0 when it found the proof,";
  script += "\n# `gappa -Bcoq FILE` writes it down for Coq.";
  script += joined({"\n# constant of the filter: ", hexadecimal(constant)});
  const double terms = count_terms(program);
  script += joined({"\n# terms of the formula:   ", std::to_string(static_cast<std::uint64_t>(terms)), "\n"});
  return script + (unit ? unit_script(program, constant * terms, 2 * terms) : every_scale_script(program, constant));
}

}  // namespace plumb
