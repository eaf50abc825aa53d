// How do the scripts for Gappa name things, and how do they state a claim?
//
// Law: small letters are what doubles hold, capitals exact numbers; d4_7 is the difference of the coordinates 4 and 7,
// s4_7 their sum, x4 a coordinate by itself; one expression has one name.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "plumb/certify/detail/tape.hpp"

namespace plumb::certify::proof {

/// One number of the tape under two names.
struct Number {
  std::string computed, exact;
};

/// d4_7 and D4_7
Number leaf(const certify::tape::Instruction& i);

/// "l - r", of the computed numbers and of the exact ones.
Number applied(const Number& left, char operation, const Number& right);

/// The pieces, one after another.
std::string joined(std::initializer_list<std::string_view> pieces);

/// Definitions, and hypotheses in the order in which they were first made.
class Lines {
 public:
  void define(std::string_view name, std::string_view equals, const std::string& expression);

  /// The name of the expression: the given one, unless it has one already.
  std::string name(std::string_view name, std::string_view equals, const std::string& expression);

  /// "|name| <= bound"; false when it was supposed before.
  bool suppose_at_most(std::string_view name, std::string_view bound);

  /// The definitions, and "{ H /\ H -> goals }".
  [[nodiscard]] std::string claim(const std::string& goals) const;

 private:
  std::map<std::string, std::string> names_;
  std::set<std::string> known_;
  std::string definitions_, hypotheses_;
};

/// Remarks of Gappa end with their line: the text without ends of lines.
std::string one_line(std::string_view text);

/// For leaves up to 1 the computed value is off by this error at most; the exact one is at most so large.
std::string unit_script(const certify::tape::Program& program, double error, double most);
std::string every_scale_script(const certify::tape::Program& program, double constant);

}  // namespace plumb::certify::proof
