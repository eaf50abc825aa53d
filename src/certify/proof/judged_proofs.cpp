#include "plumb/certify/judged_proofs.hpp"

#include <map>
#include <set>

#include "certify/proof/proof_lines.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/judged_bounds.hpp"

namespace plumb::certify::written {
namespace {

using Kind = Book::Entry::Kind;
using tape::Instruction;

bool is_leaf(Kind k) { return k == Kind::given || k == Kind::difference || k == Kind::sum; }

/// What one number is made of, as a tape of its own; its leaves come first.
class Extract {
 public:
  Extract(const std::vector<Book::Entry>& entries, std::size_t root) : entries_(entries) {
    collect(root);
    std::size_t arity = 0;
    for (const std::size_t i : order_) arity += entries_[i].kind == Kind::given ? 1 : is_leaf(entries_[i].kind) ? 2 : 0;
    std::size_t input = 0;
    for (const std::size_t i : order_) {
      const Book::Entry& e = entries_[i];
      if (e.kind == Kind::given) {
        place_[i] = input++;
        continue;
      }
      Instruction in{static_cast<char>(e.kind), 0, 0};
      if (is_leaf(e.kind)) {
        in = {e.kind == Kind::difference ? '-' : '+', index(input), index(input + 1)};
        input += 2;
      } else {
        in.left = index(place_.at(e.left)), in.right = index(place_.at(e.right));
      }
      instructions_.push_back(in);
      place_[i] = arity + instructions_.size() - 1;
    }
    arity_ = arity;
  }
  [[nodiscard]] tape::Program program() const { return {arity_, instructions_}; }

 private:
  void collect(std::size_t i) {
    if (!seen_.insert(i).second) return;
    if (!is_leaf(entries_[i].kind)) collect(entries_[i].left), collect(entries_[i].right);
    order_.push_back(i);
  }
  static std::uint16_t index(std::size_t i) {
    if (i > 0xffff) throw Error("a number of so many operations has no proof script");
    return static_cast<std::uint16_t>(i);
  }

  const std::vector<Book::Entry>& entries_;
  std::set<std::size_t> seen_;
  std::vector<std::size_t> order_;
  std::map<std::size_t, std::size_t> place_;
  std::vector<Instruction> instructions_;
  std::size_t arity_ = 0;
};

}  // namespace

void Book::judge(std::size_t entry, const Track& track) {
  if (track.root != 0) claims_.push_back({entry, track});
}

std::vector<std::string> Book::scripts(std::string_view name) const {
  std::set<std::string> bodies;
  std::vector<std::string> all;
  for (const Claim& c : claims_) {
    const Extract extract(entries_, c.entry);
    // A sum of two products of scales is 2 where they are 1.
    const double scales = c.track.others == 0 ? 1 : 2;
    const std::string body = proof::unit_script(extract.program(), arith::track::threshold(c.track) * scales,
                                                2 * scales * static_cast<double>(c.track.size) / Track::one);
    if (!bodies.insert(body).second) continue;
    all.push_back(
        proof::joined({"# A bound derived from the statement ", proof::one_line(name), ":\n# ", to_string(c.track),
                       "\n# Written by Plumb; `gappa FILE` exits with 0 when it found ", "the proof.\n", body}));
  }
  return all;
}

}  // namespace plumb::certify::written
