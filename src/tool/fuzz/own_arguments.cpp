#include "tool/fuzz/own_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "plumb/arith/error.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

using degenerate::Argument;
using degenerate::Part;
using degenerate::Role;

[[noreturn]] void refuse(const std::string& word) {
  throw Error(fmt::format(
      "fuzz: --argument: '{}' is no argument; write such as a:point2, t:point3x3, poly:points2+3, d:vector3, "
      "b:box3, r:length, ray:point3,vector3",
      printable(word)));
}

}  // namespace

Argument own_argument(const std::string& word) {
  static const std::regex whole("([A-Za-z_][A-Za-z_0-9]*):(.+)");
  static const std::regex part(
      "(?:(point|vector)([1-9])(?:x([1-9][0-9]?))?|(points)([23])(?:\\+([1-9][0-9]?))?|(box)([1-9])|(length)s?([1-9])?"
      ")");
  std::smatch found;
  if (!std::regex_match(word, found, whole)) refuse(word);
  Argument argument{found[1].str(), {}};
  const std::string parts = found[2].str();
  for (std::size_t at = 0; at <= parts.size();) {
    const std::size_t end = std::min(parts.find(',', at), parts.size());
    const std::string one = parts.substr(at, end - at);
    std::smatch m;
    if (!std::regex_match(one, m, part)) refuse(word);
    const auto number = [&](std::size_t group, int otherwise) {
      return m[group].matched ? std::stoi(m[group].str()) : otherwise;
    };
    if (m[4].matched) {
      argument.parts.push_back({Role::points, number(5, 3)});
      argument.least = static_cast<std::size_t>(number(6, 1));
    } else if (m[7].matched) {
      argument.parts.push_back({Role::corners, number(8, 3), 2});
    } else if (m[9].matched) {
      argument.parts.push_back({Role::extents, number(10, 1)});
    } else {
      const Role role = m[1].str() == "point" ? Role::points : Role::vector;
      argument.parts.push_back({role, number(2, 3), static_cast<std::size_t>(number(3, 1))});
    }
    at = end + 1;
  }
  return argument;
}

degenerate::AnswerForm own_answer(const std::string& word) {
  if (word == "yes-no") return degenerate::AnswerForm::yes_no;
  return word == "number" ? degenerate::AnswerForm::number : degenerate::AnswerForm::sign;
}

}  // namespace plumb::tool
