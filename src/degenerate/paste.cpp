#include "plumb/degenerate/paste.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "certify/case_line.hpp"
#include "degenerate/fields.hpp"
#include "degenerate/known_answer.hpp"
#include "degenerate/words.hpp"
#include "plumb/degenerate/convention.hpp"

namespace plumb::degenerate {

namespace {

// TriangleTriangle
std::string pascal(std::string_view name) {
  std::string text;
  bool upper = true;
  for (const char c : name) {
    if (c == '-') {
      upper = true;
    } else {
      text.push_back(upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c);
      upper = false;
    }
  }
  return text;
}

std::string literal(double x) {
  if (std::isfinite(x)) return hexadecimal(x);
  return x > 0 ? "HUGE_VAL" : "-HUGE_VAL";
}

// The case's own name: the same numbers have the same.
std::string name_of_numbers(std::span<const double> numbers) {
  std::ostringstream out;
  out << "Case" << std::hex << (fingerprint(numbers) >> 40);
  return out.str();
}

std::string cpp_expectation(const Kind& kind, const std::string& call, const Answer& exact) {
  std::string text = "  ";
  if (!is_known(kind, exact)) {
    if (kind.form == AnswerForm::hit) text.append("double t = 0;\n  ");
    return text.append(call).append(";  // any answer will do\n");
  }
  switch (kind.form) {
    case AnswerForm::sign:
      return text.append(exact.numbers[0] > 0   ? "EXPECT_GT("
                         : exact.numbers[0] < 0 ? "EXPECT_LT("
                                                : "EXPECT_EQ(")
          .append(call)
          .append(", 0);\n");
    case AnswerForm::number:
      return text.append("EXPECT_DOUBLE_EQ(")
          .append(call)
          .append(", ")
          .append(literal(exact.numbers[0]))
          .append(");\n");
    case AnswerForm::hit:
      // Who leaves the parameter alone is not asked for it.
      text.append("double t = ").append(literal(exact.numbers.back())).append(";\n  ");
      [[fallthrough]];
    case AnswerForm::yes_no:
      text.append(exact.numbers[0] != 0 ? "EXPECT_NE(" : "EXPECT_EQ(").append(call).append(", 0);\n");
      if (kind.form == AnswerForm::yes_no || !knows_parameter(exact)) return text;
      return text.append("  EXPECT_DOUBLE_EQ(t, ").append(literal(exact.numbers[1])).append(");\n");
    case AnswerForm::triangles:
      break;
  }
  return text;
}

// Many hulls are right, and where a convention is open two answers: the library judges.
bool has_other_answers(const Kind& kind, std::span<const double> numbers, const Answer& exact) {
  const auto differs = [&](const Exact& other) { return other(numbers).numbers != exact.numbers; };
  return kind.judge || std::ranges::any_of(kind.also_right, differs);
}

std::string cpp_judged(const Kind& kind, std::span<const double> numbers, std::string_view function) {
  return std::string("  using namespace plumb::degenerate;\n  const double numbers[] = {")
      .append(joined(numbers, ", ", hexadecimal))
      .append("};\n  const Kind kind = under(kind_named(\"")
      .append(kind.name)
      .append("\"), {Boundary::")
      .append(name_of(kind.declared.boundary))
      .append(", Ends::")
      .append(name_of(kind.declared.ends))
      .append("});\n  const Answer given = callable_of(kind, ")
      .append(function)
      .append(")(numbers);\n  EXPECT_EQ(judge(kind, numbers, given, kind.tolerance).sort, \"\");\n");
}

bool is_number(const std::string& word) {
  if (word == "inf" || word == "-inf") return true;
  try {
    static_cast<void>(parse_double(word));
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// What words(kind, answer) makes of some answer.
bool is_answer(const Kind& kind, const std::string& text) {
  if (text == "NaN" || text == "no answer") return true;  // where none is known
  switch (kind.form) {
    case AnswerForm::sign:
      return text == "+" || text == "0" || text == "-";
    case AnswerForm::yes_no:
      return text == "yes" || text == "no";
    case AnswerForm::number:
      return is_number(text);
    case AnswerForm::hit:
      return text == "yes" || text == "no" || (text.starts_with("yes at ") && is_number(text.substr(7)));
    case AnswerForm::triangles:
      break;
  }
  const std::size_t end = text.find_first_not_of("0123456789");
  if (end == 0 || end == text.npos || text.compare(end, 10, " triangles") != 0) return false;
  const std::string list = text.substr(end + 10);
  return list.empty() || (list.starts_with(": (") && list.find_first_not_of("0123456789 ()", 1) == list.npos);
}

}  // namespace

std::string case_line(const Kind& kind, std::span<const double> numbers) {
  return std::string(kind.name)
      .append(" ")
      .append(joined(numbers, " ", hexadecimal))
      .append(" = ")
      .append(words(kind, kind.exact(numbers)));
}

std::optional<Numbers> parse_case(const Kind& kind, std::string_view line) {
  line = line.substr(0, line.find('#'));
  const std::size_t sign = line.find('=');
  std::istringstream in{std::string(line.substr(0, sign))};
  std::string word;
  if (!(in >> word) || word != kind.name) return std::nullopt;
  Numbers numbers;
  while (in >> word) numbers.push_back(parse_double(word));
  if (const std::string flaw = flaw_of(kind, numbers); !flaw.empty()) throw Error(flaw);
  if (sign == line.npos) return numbers;
  constexpr std::string_view blank = " \t\r\n";
  std::string_view answer = line.substr(sign + 1);
  answer.remove_prefix(std::min(answer.find_first_not_of(blank), answer.size()));
  answer = answer.substr(0, answer.find_last_not_of(blank) + 1);
  if (is_answer(kind, std::string(answer))) return numbers;
  throw Error(std::string("'")
                  .append(answer)
                  .append("' after '=' is no answer of ")
                  .append(kind.name)
                  .append("; give one as " + words(kind, kind.exact(numbers)) + ", or leave it out with the '='"));
}

std::string decimal_text(const Kind& kind, std::span<const double> numbers) {
  std::string text;
  for (const Given& g : given(kind, numbers)) {
    text.append(text.empty() ? "" : "\n").append(g.argument.name).append(" =");
    for (std::size_t i = 0; i < g.numbers.size();) {  // the parts, or the one again and again
      for (const Part& part : g.argument.parts) {
        const auto dimension = static_cast<std::size_t>(part.dimension);
        for (std::size_t n = 0; n < part.count; ++n, i += dimension)
          text.append(" (").append(joined(g.numbers.subspan(i, dimension), ", ", decimal)).append(")");
      }
    }
  }
  return text;
}

std::string cpp_text(const Kind& kind, std::span<const double> numbers, std::string_view function) {
  std::string declaration(kind.signature);
  declaration.replace(declaration.find(" f(") + 1, 1, function);
  std::string text = "#include <gtest/gtest.h>\n#include <math.h>\n#include <stddef.h>\n";
  const Answer exact = kind.exact(numbers);
  const bool judged = has_other_answers(kind, numbers, exact);
  if (judged) text.append("\n#include <plumb/degenerate.hpp>\n#include <plumb/query/kinds/kinds.hpp>\n");
  text.append("\nextern \"C\" ").append(declaration).append(";\n\n// Exact: ");
  text.append(words(kind, exact)).append("\nTEST(").append(pascal(kind.name)).append(", ");
  text.append(name_of_numbers(numbers)).append(") {\n");
  if (judged) return text.append(cpp_judged(kind, numbers, function)).append("}\n");
  std::string call = std::string(function).append("(");
  for (const Given& g : given(kind, numbers)) {
    if (names_points(g.argument.parts[0].role)) {
      text.append("  const size_t ").append(g.argument.name).append("[] = {");
      text.append(joined(g.numbers, ", ", decimal)).append("};\n");
    } else {
      text.append("  const double ").append(g.argument.name).append("[] = {");
      text.append(joined(g.numbers, ", ", hexadecimal)).append("};  // ");
      text.append(joined(g.numbers, ", ", decimal)).append("\n");
    }
    call.append(call.back() == '(' ? "" : ", ").append(g.argument.name);
    if (g.argument.any_number()) call.append(", ").append(std::to_string(g.count));
  }
  call.append(kind.form == AnswerForm::hit ? ", &t)" : ")");
  return text.append(cpp_expectation(kind, call, exact)).append("}\n");
}

std::string text(const Kind& kind, const Findings& findings) {
  std::ostringstream out;
  out << kind.name << ": " << kind.question << "  " << findings.asked() << " cases, seed " << findings.seed << "\n";
  std::size_t width = 9;
  for (const Tally& t : findings.tallies) width = std::max(width, t.generator.size());
  const auto cell = [&](auto value) {
    out.width(11);
    out << value;
  };
  const auto row_begins = [&](std::string_view name) { out << "  " << name << std::string(width - name.size(), ' '); };
  row_begins("generator");
  for (const std::string_view head : {"asked", "wrong", "unsure", "failed", "degenerate"}) cell(head);
  out << "\n";
  for (const Tally& t : findings.tallies) {
    row_begins(t.generator);
    for (const std::uint64_t count : {t.asked, t.wrong, t.unsure, t.failed, t.degenerate}) cell(count);
    out << "\n";
  }
  for (const Finding& f : findings.findings) {
    out << "\n" << f.generator << " " << f.index << ": " << f.sort;
    if (f.degenerate) out << ", of a degenerate figure";
    if (!f.repeated) out << " (not when asked again)";
    out << "; given " << words(kind, f.given) << ", exact " << words(kind, f.exact) << "\n";
    out << decimal_text(kind, f.smallest) << "\n" << case_line(kind, f.smallest) << "\n";
  }
  return out.str();
}

}  // namespace plumb::degenerate
