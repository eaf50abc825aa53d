#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>
#include <sstream>

#include "certify/catalog.hpp"
#include "tool/manual/help_text.hpp"
#include "tool/manual/meanings.hpp"

namespace plumb::tool {
namespace {

/// The words in lines of at most `width` columns, the later ones with blanks in front.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string lines, word;
  std::size_t column = 0;
  std::istringstream words{std::string(text)};
  while (words >> word) {
    if (column + word.size() + 1 > width) {
      lines.append("\n").append(indent, ' ');
      column = indent;
    } else if (column > 0) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += word.size();
  }
  return lines;
}

/// " ax ay az", " a" for a number by itself, " a1 a2 a3 a4" where there are more than letters.
std::string words_of(const CatalogEntry& entry, std::size_t argument) {
  const auto letter = static_cast<char>('a' + argument);
  const auto count = static_cast<std::size_t>(entry.arguments[argument]);
  if (count == 1) return fmt::format(" {}", letter);
  std::string words;
  for (std::size_t i = 0; i < count; ++i) {
    words +=
        count <= entry.axes.size() ? fmt::format(" {}{}", letter, entry.axes[i]) : fmt::format(" {}{}", letter, i + 1);
  }
  return words;
}

/// "orient2d ax ay bx by cx cy", and what it means.
std::string predicates() {
  std::string text;
  for (const CatalogEntry& entry : catalog()) {
    std::string call(entry.name);
    for (std::size_t argument = 0; argument < entry.arguments.size(); ++argument) call += words_of(entry, argument);
    text += text.empty() ? "" : "\n";
    text += wrapped(call, 72, 4);
    if (const auto meaning = meaning_of(entry.name); !meaning.empty()) {
      text += "\n       " + wrapped(meaning, 64, 7);
    }
  }
  return text;
}

}  // namespace

Manual sign_manual() {
  return {"plumb sign",
          "decide signs exactly",
          {"plumb sign PREDICATE COORDINATE...", "plumb sign < CASES"},
          {{"DESCRIPTION", R"(
Prints the sign of PREDICATE at the points whose coordinates follow,
point after point: '+', '0' or '-', then the stage that decided.
Coordinates are decimal (0.1, -3e-7) or hexadecimal (0x1.8p-3), and
stand for their nearest double; NaN and infinities are refused.

Without arguments, cases are read from standard input, one a line:

       PREDICATE COORDINATE... [= SIGN] [# remark]

Where the expected SIGN is given and is not the true one, the answer
says so and the exit status is 1. Blank lines and remarks are passed
over; after a bad line nothing more is read.)"},
           {"PREDICATES", predicates()},
           {"STAGES", fmt::format("In the order of their cost, each sure where it answers:\n{},\n{}.",
                                  fmt::join(std::span(stage_names).first<4>(), ", "),
                                  fmt::join(std::span(stage_names).subspan<4>(), ", "))}},
          {{"EXIT STATUS", exit_status("A sign was not the one that its case expected.")}, {"EXAMPLES", R"(
plumb sign orient2d 0 0 1 0 0 1
       Prints "+ filter".

plumb sign orient2d -0.1 -0.2 0x1p-1 0.3 1e300 -1e-300
       Prints "- filter": signs are signs, not options.

echo 'incircle 0 0 1 0 1 1 0 1 = 0' | plumb sign
       Four corners of a square lie on one circle.)"}}};
}

}  // namespace plumb::tool
