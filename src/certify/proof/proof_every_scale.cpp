// The claim of ProofScale::every: one goal for each shape of a term.
#include <map>
#include <vector>

#include "certify/case_line.hpp"
#include "certify/proof/proof_lines.hpp"
#include "certify/proof/terms.hpp"

namespace plumb::certify::proof {
namespace {

class Writer {
 public:
  Writer(const certify::tape::Program& program, const certify::terms::Expanded& expanded)
      : program_(program), expanded_(expanded), numbers_(expanded.nodes.size()) {}

  /// Names the node and what it is made of.
  const Number& number(std::size_t node) {
    Number& own = numbers_[node];
    if (own.computed.empty()) own = named(expanded_.nodes[node]);
    return own;
  }

  /// "|computed - exact|" before the last rounding.
  std::string error(std::size_t node) {
    const certify::terms::Node& n = expanded_.nodes[node];
    if (n.step != certify::terms::Step::leaf)
      return joined({"|", number(node).computed, " - ", number(node).exact, "|"});
    number(node);
    const std::string exact = numbers_[node].exact;
    return joined({"|", exact, " - ", exact, "|"});
  }

  [[nodiscard]] const Lines& lines() const { return lines_; }

 private:
  static constexpr std::string_view rounding = "0x1p-53";

  Number named(const certify::terms::Node& n) {
    switch (n.step) {
      case certify::terms::Step::coordinate: {
        const std::string name = joined({"x", std::to_string(n.left)});
        lines_.suppose_at_most(name, "1");
        return {name, name};
      }
      case certify::terms::Step::leaf: {
        const Number l = leaf(program_.instructions[n.left]);
        lines_.suppose_at_most(l.computed, "1");
        lines_.suppose_at_most(joined({l.exact, " -/ ", l.computed}), rounding);
        return l;
      }
      case certify::terms::Step::rounded: {
        const Number before = number(n.left);
        const std::string name = joined({"t", std::to_string(++roundings_)});
        lines_.suppose_at_most(joined({name, " -/ ", before.computed}), rounding);
        return {name, before.exact};
      }
      default: {
        const char operation = n.step == certify::terms::Step::product ? '*'
                               : n.step == certify::terms::Step::sum   ? '+'
                                                                       : '-';
        const Number left = number(n.left), both = applied(left, operation, number(n.right));
        const std::string own = std::to_string(++results_);
        return {lines_.name(joined({"r", own}), " = ", both.computed),
                lines_.name(joined({"R", own}), " = ", both.exact)};
      }
    }
  }

  const certify::tape::Program program_;
  const certify::terms::Expanded& expanded_;
  std::vector<Number> numbers_;
  Lines lines_;
  std::size_t roundings_ = 0, results_ = 0;
};

}  // namespace

std::string every_scale_script(const certify::tape::Program& program, double constant) {
  const certify::terms::Expanded expanded = certify::terms::expand(program);
  std::map<std::string, std::size_t> shapes;  // and how many terms have it
  for (const certify::terms::Term& t : expanded.terms) ++shapes[shape(expanded, t.node)];
  const double rest = 1 - (static_cast<double>(program.instructions.size()) + 2) * 0x1p-51;
  Writer writer(program, expanded);
  std::string goals;
  for (const certify::terms::Term& t : expanded.terms) {
    const auto alike = shapes.find(shape(expanded, t.node));
    if (alike == shapes.end()) continue;
    goals += joined({goals.empty() ? "" : "\n  /\\ ", writer.error(t.node), " <= "});
    goals += joined({hexadecimal(constant * rest * t.count), "  # as ", std::to_string(alike->second), " of them"});
    shapes.erase(alike);
  }
  return writer.lines().claim(goals + "\n");
}

}  // namespace plumb::certify::proof
