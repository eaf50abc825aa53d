#include "certify/proof/terms.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "plumb/arith/error.hpp"

namespace plumb::certify::terms {
namespace {

using Leaves = std::vector<std::size_t>;  // in ascending order

struct Part {
  std::size_t node;
  double count;
  bool negative;
};
using Parts = std::map<Leaves, Part>;

class Expansion {
 public:
  explicit Expansion(const certify::tape::Program& program) {
    for (std::size_t i = 0; i < program.arity; ++i) numbers_.push_back(single(i, add({Step::coordinate, i, 0})));
    std::map<std::tuple<char, std::size_t, std::size_t>, std::size_t> leaves;  // which node each is
    for (std::size_t i = 0; i < program.instructions.size(); ++i) {
      const certify::tape::Instruction& in = program.instructions[i];
      if (is_leaf(program, in)) {
        const auto [at, is_new] = leaves.try_emplace({in.operation, in.left, in.right}, all_.nodes.size());
        if (is_new) add({Step::leaf, i, 0});
        numbers_.push_back(single(program.arity + at->second, at->second));
      } else {
        Parts parts = in.operation == '*' ? product(numbers_[in.left], numbers_[in.right])
                                          : sum(numbers_[in.left], numbers_[in.right], in.operation == '-');
        if (i + 1 < program.instructions.size() && !in.doubles()) {
          for (auto& [leaves_of, part] : parts) part.node = add({Step::rounded, part.node, 0});
        }
        numbers_.push_back(std::move(parts));
      }
    }
    for (const auto& [leaves_of, part] : numbers_.back()) all_.terms.push_back({part.node, part.count, part.negative});
  }

  [[nodiscard]] Expanded result() && { return std::move(all_); }

 private:
  static Parts single(std::size_t name, std::size_t node) { return {{Leaves{name}, Part{node, 1, false}}}; }

  std::size_t add(Node node) {
    all_.nodes.push_back(node);
    return all_.nodes.size() - 1;
  }

  void add(Parts& parts, const Leaves& leaves, const Part& more) {
    const auto [at, is_new] = parts.try_emplace(leaves, more);
    if (is_new && parts.size() >= 1u << 16) throw Error("a formula of 2^16 terms or more has no proof for every scale");
    if (is_new) return;
    Part& part = at->second;  // the sign of the first is that of all
    part.node = add({part.negative == more.negative ? Step::sum : Step::difference, part.node, more.node});
    part.count += more.count;
  }

  Parts product(const Parts& left, const Parts& right) {
    Parts parts;
    for (const auto& [a, l] : left) {
      for (const auto& [b, r] : right) {
        Leaves leaves(a.size() + b.size());
        std::merge(a.begin(), a.end(), b.begin(), b.end(), leaves.begin());
        add(parts, leaves, {add({Step::product, l.node, r.node}), l.count * r.count, l.negative != r.negative});
      }
    }
    return parts;
  }

  Parts sum(Parts left, const Parts& right, bool difference) {
    for (const auto& [leaves, r] : right) add(left, leaves, {r.node, r.count, r.negative != difference});
    return left;
  }

  Expanded all_;
  std::vector<Parts> numbers_;
};

void write_shape(const Expanded& expanded, std::size_t node, std::map<std::size_t, std::size_t>& seen,
                 std::string& text) {
  const auto [at, is_new] = seen.try_emplace(node, seen.size());
  if (!is_new) {
    text.append("#").append(std::to_string(at->second));
    return;
  }
  const Node& n = expanded.nodes[node];
  text += "xd*+-r"[static_cast<std::size_t>(n.step)];
  if (n.step == Step::coordinate || n.step == Step::leaf) return;
  write_shape(expanded, n.left, seen, text);
  if (n.step != Step::rounded) write_shape(expanded, n.right, seen, text);
}

}  // namespace

Expanded expand(const certify::tape::Program& program) { return Expansion(program).result(); }

std::string shape(const Expanded& expanded, std::size_t node) {
  std::map<std::size_t, std::size_t> seen;
  std::string text;
  write_shape(expanded, node, seen, text);
  return text;
}

}  // namespace plumb::certify::terms
