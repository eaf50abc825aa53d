#include "plumb/degenerate/paste.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <sstream>

#include "degenerate/fields.hpp"
#include "degenerate/words.hpp"
#include "plumb/certify/case_line.hpp"

namespace plumb::degenerate {

namespace {

template <class Write>
std::string joined(std::span<const double> numbers, std::string_view between, const Write& write) {
  std::string text;
  for (const double x : numbers) text.append(text.empty() ? "" : between).append(write(x));
  return text;
}

// All numbers of one argument, without the count.
struct Given {
  const Argument& argument;
  std::span<const double> numbers;
  std::size_t points;  // where there may be any number
};

std::vector<Given> given(const Kind& kind, std::span<const double> numbers) {
  std::vector<Given> all;
  for (const Field& f : fields_of(kind, numbers)) {
    const Argument& argument = kind.arguments[f.argument];
    if (!all.empty() && &all.back().argument == &argument) {
      const auto first = static_cast<std::size_t>(all.back().numbers.data() - numbers.data());
      all.back().numbers = numbers.subspan(first, all.back().numbers.size() + f.size());
    } else {
      all.push_back({argument, numbers.subspan(f.first, f.size()), f.count});
    }
  }
  return all;
}

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
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const double x : numbers) hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3;
  std::ostringstream out;
  out << "Case" << std::hex << (hash >> 40);
  return out.str();
}

std::string cpp_expectation(const Kind& kind, const std::string& call, const Answer& exact) {
  std::string text = "  ";
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
      text.append("double t = 0;\n  ");
      [[fallthrough]];
    case AnswerForm::yes_no:
      text.append(exact.numbers[0] != 0 ? "EXPECT_NE(" : "EXPECT_EQ(").append(call).append(", 0);\n");
      if (exact.numbers.size() == 1) return text;
      return text.append("  EXPECT_DOUBLE_EQ(t, ").append(literal(exact.numbers[1])).append(");\n");
    case AnswerForm::triangles:
      break;
  }
  return text;
}

// Many hulls are right: the library judges.
std::string cpp_judged(const Kind& kind, std::span<const double> numbers, std::string_view function) {
  return std::string("  const double numbers[] = {")
      .append(joined(numbers, ", ", hexadecimal))
      .append("};\n  const auto& kind = plumb::degenerate::kind_named(\"")
      .append(kind.name)
      .append("\");\n  const auto given = kind.call(reinterpret_cast<plumb::degenerate::ForeignFunction>(")
      .append(function)
      .append("), numbers);\n  EXPECT_EQ(plumb::degenerate::judge(kind, numbers, given, {}).sort, \"\");\n");
}

std::string python_number(double x) {
  if (!std::isfinite(x)) return x > 0 ? "float(\"inf\")" : "-float(\"inf\")";
  return std::string("float.fromhex(\"").append(hexadecimal(x)).append("\")");
}

std::string python_answer(const Kind& kind, const Answer& exact) {
  switch (kind.form) {
    case AnswerForm::sign:
      return decimal(exact.numbers[0]);
    case AnswerForm::yes_no:
      return exact.numbers[0] != 0 ? "True" : "False";
    case AnswerForm::number:
      return python_number(exact.numbers[0]);
    case AnswerForm::hit:
      return exact.numbers[0] == 0 ? "None" : python_number(exact.numbers[1]);
    case AnswerForm::triangles:
      break;
  }
  return std::string("[").append(joined(exact.numbers, ", ", decimal)).append("]");
}

// Vertices, and elements that name them; OBJ counts from 1 through the whole file.
class Obj {
 public:
  // One of each point's coordinates, or as many as there are.
  std::size_t vertex(std::span<const double> p) {
    text_.append("v");
    for (std::size_t axis = 0; axis < 3; ++axis) text_.append(" ").append(decimal(axis < p.size() ? p[axis] : 0.0));
    text_.append("\n");
    return ++vertices_;
  }
  void element(std::string_view letter, std::span<const std::size_t> of) {
    elements_.append(letter);
    for (const std::size_t v : of) elements_.append(" ").append(std::to_string(v));
    elements_.append("\n");
  }
  // Eight corners, where bit k of the number says which end of axis k.
  template <class Corner>
  void box(const Corner& corner) {
    std::array<std::size_t, 8> at{};
    for (std::size_t i = 0; i < 8; ++i) at[i] = vertex(corner(i));
    constexpr std::array<std::array<std::size_t, 4>, 6> faces = {
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& f : faces) element("f", std::array{at[f[0]], at[f[1]], at[f[2]], at[f[3]]});
  }
  void begin(std::string_view name) { text_.append("o ").append(name).append("\n"); }
  void end() { text_.append(std::exchange(elements_, {})); }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_, elements_;
  std::size_t vertices_ = 0;
};

void add_points(Obj& obj, const Given& g) {
  const auto dimension = static_cast<std::size_t>(g.argument.parts[0].dimension);
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < g.numbers.size(); i += dimension)
    at.push_back(obj.vertex(g.numbers.subspan(i, dimension)));
  const bool chain = g.argument.any_number() && dimension == 2;
  if (chain || (!g.argument.any_number() && at.size() == 3)) return obj.element("f", at);
  if (!g.argument.any_number() && at.size() == 2) return obj.element("l", at);
  for (const std::size_t v : at) obj.element("p", std::array{v});
}

void add_figure(Obj& obj, const Given& g) {
  const std::span<const double> x = g.numbers;
  const std::vector<Part>& parts = g.argument.parts;
  if (parts[0].role == Role::corners) {
    return obj.box([&](std::size_t i) { return std::array{x[i & 1 ? 3 : 0], x[i & 2 ? 4 : 1], x[i & 4 ? 5 : 2]}; });
  }
  if (parts.size() == 3) {  // center, axes, half extents: corners are rounded
    return obj.box([&](std::size_t i) {
      std::array<double, 3> p{x[0], x[1], x[2]};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double by = (i >> axis & 1) != 0 ? x[12 + axis] : -x[12 + axis];
        for (std::size_t k = 0; k < 3; ++k) p[k] += by * x[3 + 3 * axis + k];
      }
      return p;
    });
  }
  if (parts.size() == 2) {  // a ray, as far as its direction
    const std::size_t from = obj.vertex(x.first(3));
    const std::size_t to = obj.vertex(std::array{x[0] + x[3], x[1] + x[4], x[2] + x[5]});
    return obj.element("l", std::array{from, to});
  }
  add_points(obj, g);
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
  std::istringstream in{std::string(line.substr(0, line.find_first_of("=#")))};
  std::string word;
  if (!(in >> word) || word != kind.name) return std::nullopt;
  Numbers numbers;
  while (in >> word) numbers.push_back(parse_double(word));
  if (const std::string flaw = flaw_of(kind, numbers); !flaw.empty()) throw Error(flaw);
  return numbers;
}

std::string decimal_text(const Kind& kind, std::span<const double> numbers) {
  std::string text;
  for (const Given& g : given(kind, numbers)) {
    text.append(text.empty() ? "" : "\n").append(g.argument.name).append(" =");
    const auto dimension = static_cast<std::size_t>(g.argument.parts[0].dimension);
    for (std::size_t i = 0; i < g.numbers.size(); i += dimension) {
      text.append(" (").append(joined(g.numbers.subspan(i, dimension), ", ", decimal)).append(")");
    }
  }
  return text;
}

std::string cpp_text(const Kind& kind, std::span<const double> numbers, std::string_view function) {
  std::string declaration(kind.signature);
  declaration.replace(declaration.find(" f(") + 1, 1, function);
  std::string text = "#include <gtest/gtest.h>\n#include <math.h>\n#include <stddef.h>\n";
  if (kind.judge != nullptr) text.append("\n#include \"plumb/query/kinds.hpp\"\n");
  text.append("\nextern \"C\" ").append(declaration).append(";\n\n// Exact: ");
  const Answer exact = kind.exact(numbers);
  text.append(words(kind, exact)).append("\nTEST(").append(pascal(kind.name)).append(", ");
  text.append(name_of_numbers(numbers)).append(") {\n");
  if (kind.judge != nullptr) return text.append(cpp_judged(kind, numbers, function)).append("}\n");
  std::string call = std::string(function).append("(");
  for (const Given& g : given(kind, numbers)) {
    text.append("  const double ").append(g.argument.name).append("[] = {");
    text.append(joined(g.numbers, ", ", hexadecimal)).append("};  // ");
    text.append(joined(g.numbers, ", ", decimal)).append("\n");
    call.append(call.back() == '(' ? "" : ", ").append(g.argument.name);
    if (g.argument.any_number()) call.append(", ").append(std::to_string(g.points));
  }
  call.append(kind.form == AnswerForm::hit ? ", &t)" : ")");
  return text.append(cpp_expectation(kind, call, exact)).append("}\n");
}

std::string python_text(const Kind& kind, std::span<const double> numbers) {
  std::string text = std::string("# ").append(kind.name).append(": ").append(kind.question).append("\n");
  for (const Given& g : given(kind, numbers)) {
    text.append(g.argument.name).append(" = [float.fromhex(x) for x in \"");
    text.append(joined(g.numbers, " ", hexadecimal)).append("\".split()]  # ");
    text.append(joined(g.numbers, ", ", decimal)).append("\n");
  }
  const Answer exact = kind.exact(numbers);
  return text.append("exact = ")
      .append(python_answer(kind, exact))
      .append("  # ")
      .append(words(kind, exact))
      .append("\n");
}

std::string obj_text(const Kind& kind, std::span<const double> numbers) {
  Obj obj;
  for (const Given& g : given(kind, numbers)) {
    obj.begin(g.argument.name);
    add_figure(obj, g);
    obj.end();
  }
  if (kind.form == AnswerForm::triangles) {
    const Numbers corners = kind.exact(numbers).numbers;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      std::array<std::size_t, 3> face{};
      for (std::size_t k = 0; k < 3; ++k) face[k] = static_cast<std::size_t>(corners[i + k]) + 1;
      obj.element("f", face);
    }
    obj.end();
  }
  return std::string("# ").append(case_line(kind, numbers)).append("\n").append(obj.text());
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
