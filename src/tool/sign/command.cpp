#include "tool/sign/command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <optional>

#include "certify/case_line.hpp"
#include "certify/catalog.hpp"
#include "plumb/arith/error.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

/// Says the answer; true unless another one was expected.
bool answer(const CaseLine& c, const Style& style) {
  const Decision d = find_predicate(c.predicate)->decide(c.coordinates);
  const bool met = !c.expected.certain() || c.expected.value() == d.sign;
  const std::string note = met ? "" : style.red(fmt::format("  expected {}", to_char(c.expected.value())));
  say(fmt::format("{} {}{}\n", style.bold(std::string(1, to_char(d.sign))), to_string(d.stage), note));
  return met;
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& w : words) line += w + ' ';
  return line;
}

}  // namespace

int run_sign(const std::vector<std::string>& words, std::istream& lines) {
  const Style style(stdout);
  if (!words.empty()) {
    const auto c = parse_case_line(joined(words));
    if (!c) throw Error("sign: a predicate and its coordinates are expected, such as: orient2d 0 0 1 0 0 1");
    return answer(*c, style) ? 0 : 1;
  }
  bool met = true;
  const bool typed = ::isatty(STDIN_FILENO) == 1;
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    std::optional<CaseLine> c;
    try {
      c = parse_case_line(line);
    } catch (const Error& e) {
      throw Error(fmt::format("standard input, line {}: {}", number, e.what()));
    }
    if (c) met = answer(*c, style) && met;
    if (typed) flush_output();
  }
  return met ? 0 : 1;
}

}  // namespace plumb::tool
