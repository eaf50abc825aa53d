// `plumb doctor --digest`: does this build answer, on this machine, as every build must?  Answers of all kinds, in
// order, and what the hash must be.
//
// Laws: (1) the questions are drawn from a seed, without a choice that a machine or a compiler could make otherwise.
// (2) The hash does not depend on the order of bytes in memory: it takes whole numbers, and doubles by their bits.
// (3) An error is an answer.
// Source: the finalizer of splitmix64 (Steele, Lea and Flood 2014).
// Cost: 6 s of one processor in full, below a second small.  Nothing is searched.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/arith/point.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

/// Hashes answers one after the other; of what has several numbers each is one.
class HashedAnswers {
 public:
  template <std::integral Number>
  void add(Number x) {
    std::uint64_t word = hash_ ^ static_cast<std::uint64_t>(x);
    word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9;
    word = (word ^ (word >> 27)) * 0x94d049bb133111eb;
    hash_ = (word ^ (word >> 31)) + 0x9e3779b97f4a7c15;
    ++count_;
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  template <class Choice>
  requires std::is_enum_v<Choice>
  void add(Choice x) { add(static_cast<std::int64_t>(x)); }
  void add(const Point2& p) { add(p.x), add(p.y); }
  void add(const Point3& p) { add(p.x), add(p.y), add(p.z); }
  template <class List>
  requires requires(const List& list) { list.size(), list.begin(); }
  void add(const List& list) {
    add(list.size());
    for (const auto& one : list) add(one);
  }
  /// A question that may be refused.
  template <class Ask>
  void ask(const Ask& question) {
    try {
      question();
    } catch (const Error&) {
      add(0x6e6f6e65);
    }
  }

  [[nodiscard]] std::uint64_t hash() const { return hash_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  std::uint64_t hash_ = 0, count_ = 0;
};

/// One kind of answers; asks `times` as many as there are in small.
struct DigestPart {
  std::string_view name;
  void (*answer)(HashedAnswers& to, std::uint64_t times);
};
void answer_signs(HashedAnswers& to, std::uint64_t times);
void answer_batches(HashedAnswers& to, std::uint64_t times);
void answer_relations(HashedAnswers& to, std::uint64_t times);
void answer_distances(HashedAnswers& to, std::uint64_t times);
void answer_boxes(HashedAnswers& to, std::uint64_t times);
void answer_hulls(HashedAnswers& to, std::uint64_t times);
void answer_trees(HashedAnswers& to, std::uint64_t times);
void answer_sections(HashedAnswers& to, std::uint64_t times);
void answer_solids(HashedAnswers& to, std::uint64_t times);
inline constexpr std::array digest_parts{
    DigestPart{"signs", answer_signs},         DigestPart{"batches", answer_batches},
    DigestPart{"relations", answer_relations}, DigestPart{"distances", answer_distances},
    DigestPart{"boxes", answer_boxes},         DigestPart{"hulls", answer_hulls},
    DigestPart{"trees", answer_trees},         DigestPart{"sections", answer_sections},
    DigestPart{"solids", answer_solids}};

struct PartDigest {
  std::uint64_t count, hash;
  friend bool operator==(const PartDigest&, const PartDigest&) = default;
};
struct Digest {
  std::array<PartDigest, digest_parts.size()> parts;
  PartDigest all;  // how many there are, and a hash of the parts'
};
enum class DigestSize : unsigned char { small, full };

Digest digest_of_answers(DigestSize size);
/// What stands in the repository.
const Digest& expected_digest(DigestSize size);
/// Says it; 0 where it is what it must be, else 1.
int run_digest(DigestSize size, unsigned threads);
std::string digest_text(const Digest& found, const Digest& expected, const Style& style);

}  // namespace plumb::tool
