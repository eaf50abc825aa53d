// Which clashes does the user want to hear of, and how near may parts of which names come?
//
//   --rule 'pipe*,wall*: clearance 0.05'   --rule 'bolt*,*: ignore touching'   --rule 'pipe*,pipe*: skip'
//
// Laws: (1) a rule is about pairs of which one name matches its first pattern and the other its second; * stands for any
// letters, ? for one.  (2) Of several rules the last that says something of a pair decides it: its clearance; a word is
// ignored if any rule, or --ignore, says so.
// Source: none.
// Cost: linear in the rules, for each pair.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/world/clash.hpp"

namespace plumb::tool {

/// On the command line words have hyphens: "within-clearance", "piercing".
std::vector<std::string> clash_words();
/// Throws Error for a word that is none of these.
ClashKind clash_word(std::string_view word);

struct ClashRule {
  std::string first, second;  // patterns
  std::optional<double> clearance;
  std::vector<ClashKind> ignored;
  bool skips = false;
};

/// Throws Error, which shows the rule and how one is written.
ClashRule parse_clash_rule(const std::string& text);

bool matches_pattern(std::string_view pattern, std::string_view name);

/// What all rules say of a pair of names.
struct ClashPolicy {
  std::optional<double> clearance;
  std::vector<ClashKind> ignored;
  bool skips = false;
};
ClashPolicy policy_for(const std::vector<ClashRule>& rules, std::string_view a, std::string_view b);

}  // namespace plumb::tool
