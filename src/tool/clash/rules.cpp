#include "tool/clash/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "plumb/arith/error.hpp"
#include "plumb/surface/file/decimal.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

constexpr std::array<std::string_view, clash_kinds> kind_words{
    "apart", "within-clearance", "touching", "overlapping", "piercing", "enclosed", "duplicate"};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

[[noreturn]] void refuse_rule(const std::string& text, const std::string& why) {
  throw Error(
      fmt::format("--rule '{}': {}; write it like 'pipe*,wall*: clearance 0.05', 'bolt*,*: ignore touching' or "
                  "'pipe*,pipe*: skip'",
                  printable(text), why));
}

bool fits(const ClashRule& rule, std::string_view a, std::string_view b) {
  return (matches_pattern(rule.first, a) && matches_pattern(rule.second, b)) ||
         (matches_pattern(rule.first, b) && matches_pattern(rule.second, a));
}

}  // namespace

std::vector<std::string> clash_words() { return {kind_words.begin() + 1, kind_words.end()}; }

ClashKind clash_word(std::string_view word) {
  const auto* const at = std::ranges::find(kind_words.begin() + 1, kind_words.end(), word);
  if (at == kind_words.end()) throw Error(fmt::format("there is no word '{}' for clashes", printable(word)));
  return static_cast<ClashKind>(at - kind_words.begin());
}

ClashRule parse_clash_rule(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const std::string_view names = std::string_view(text).substr(0, colon == std::string::npos ? 0 : colon);
  const std::size_t comma = names.find(',');
  if (colon == std::string::npos || comma == std::string_view::npos) refuse_rule(text, "it names no two patterns");
  ClashRule rule{std::string(trimmed(names.substr(0, comma))), std::string(trimmed(names.substr(comma + 1))), {}, {}};
  if (rule.first.empty() || rule.second.empty()) refuse_rule(text, "a pattern is empty");
  const std::string_view said = trimmed(std::string_view(text).substr(colon + 1));
  const std::size_t space = std::min(said.find(' '), said.size());
  const std::string_view verb = said.substr(0, space);
  std::string_view rest = trimmed(said.substr(space));
  if (verb == "skip" && rest.empty()) {
    rule.skips = true;
  } else if (verb == "clearance") {
    double clearance = 0;
    DecimalReader reader;
    if (reader.read(rest, clearance) != DecimalReader::Outcome::number || clearance < 0)
      refuse_rule(text, fmt::format("'{}' is no clearance, expected a number that is not negative", printable(rest)));
    rule.clearance = clearance;
  } else if (verb == "ignore" && !rest.empty()) {
    for (std::size_t end = 0; !rest.empty(); rest = trimmed(rest.substr(std::min(end + 1, rest.size())))) {
      end = std::min(rest.find(','), rest.size());
      const std::string_view word = trimmed(rest.substr(0, end));
      if (std::ranges::count(clash_words(), word) == 0)
        refuse_rule(text, fmt::format("'{}' is no word for clashes", printable(word)));
      rule.ignored.push_back(clash_word(word));
    }
  } else {
    refuse_rule(text, fmt::format("'{}' says nothing that is known", printable(said)));
  }
  return rule;
}

bool matches_pattern(std::string_view pattern, std::string_view name) {
  std::size_t p = 0, n = 0, star = std::string_view::npos, from = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      from = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p, ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++from;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

ClashPolicy policy_for(const std::vector<ClashRule>& rules, std::string_view a, std::string_view b) {
  ClashPolicy policy;
  for (const ClashRule& rule : rules) {
    if (!fits(rule, a, b)) continue;
    if (rule.clearance) policy.clearance = rule.clearance;
    policy.skips = policy.skips || rule.skips;
    policy.ignored.insert(policy.ignored.end(), rule.ignored.begin(), rule.ignored.end());
  }
  return policy;
}

}  // namespace plumb::tool
