#include "plumb/query/variant/question_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "certify/case_line.hpp"
#include "query/variant/answer_text.hpp"

namespace plumb {
namespace {

using Figures = std::span<const AnyFigure>;
using Numbers = std::span<const double>;

Vector3 vector_of(Numbers n) { return {n[0], n[1], n[2]}; }

/// A whole number between these.
double require_whole(std::string_view question, double x, double least, double most) {
  if (x >= least && x <= most && x == std::floor(x)) return x;
  throw Error(std::string(question) + ": " + hexadecimal(x) + " is no whole number from " + hexadecimal(least) +
              " to " + hexadecimal(most));
}
Rounding rounding_of(std::string_view question, double x) {
  return static_cast<Rounding>(static_cast<int>(require_whole(question, x, -1, 1)));
}

template <class Ask>
auto ask_of_point(std::string_view question, const AnyFigure& p, const Ask& ask) {
  if (!p.is_posed()) {
    if (const auto* in_plane = get_if<Point2>(p)) return ask(*in_plane);
    if (const auto* in_space = get_if<Point3>(p)) return ask(*in_space);
  }
  throw Error(std::string(question) + ": the second figure is a point, point2 or point3, as it stands");
}

struct AskedForm {
  QuestionForm form;
  std::string (*answer)(Figures, Numbers);
};

/// A question of two figures and no number, as its function answers it.
#define PLUMB_PAIR(name)                                                                                  \
  AskedForm {                                                                                             \
    {#name, 2, 0, "two figures"}, [](Figures f, Numbers) { return query::answer_text(name(f[0], f[1])); } \
  }

template <class Ask>
std::string of_translations(Figures f, Numbers n, const Ask& ask) {
  return query::answer_text(ask(Translating{f[0], vector_of(n.first(3))}, Translating{f[1], vector_of(n.last(3))}));
}
template <class Ask>
std::string of_corners_in_motion(Figures f, Numbers n, const Ask& ask) {
  return query::answer_text(ask(Moving{f[0], f[1]}, Moving{f[2], f[3]}, ContactOptions{n[0]}));
}
constexpr std::string_view two_motions = "two figures, and how far each moves: x y z and x y z",
                           four_places =
                               "the first figure before and after, the second before and after, and how near "
                               "counts as contact";
#define PLUMB_MOTIONS(name)                                                                                         \
  AskedForm{{#name, 2, 6, two_motions},                                                                             \
            [](Figures f, Numbers n) {                                                                              \
              return of_translations(f, n, [](const auto& a, const auto& b) { return name(a, b); });                \
            }},                                                                                                     \
      AskedForm {                                                                                                   \
    {#name, 4, 1, four_places}, [](Figures f, Numbers n) {                                                          \
      return of_corners_in_motion(f, n, [](const auto& a, const auto& b, const auto& o) { return name(a, b, o); }); \
    }                                                                                                               \
  }

const std::array asked_forms{
    PLUMB_PAIR(relate),
    PLUMB_PAIR(intersects),
    PLUMB_MOTIONS(intersects),
    PLUMB_PAIR(contains),
    PLUMB_PAIR(distance),
    PLUMB_PAIR(exact_distance),
    AskedForm{{"squared_distance_exact", 2, 0, "two figures, neither of which is round"},
              [](Figures f, Numbers) { return query::answer_text(ExactDistance{squared_distance_exact(f[0], f[1])}); }},
    PLUMB_PAIR(closest_points),
    PLUMB_PAIR(first_hit),
    PLUMB_PAIR(first_hit_parameter),
    PLUMB_PAIR(hits),
    PLUMB_PAIR(intersection),
    PLUMB_MOTIONS(first_contact),
    PLUMB_MOTIONS(first_contact_time),
    AskedForm{{"penetration", 2, 0, "two convex figures"},
              [](Figures f, Numbers) { return query::answer_text(penetration(f[0], f[1])); }},
    AskedForm{{"contact", 2, 2, "two convex figures, the margin, and how many corners at most, 0 for all"},
              [](Figures f, Numbers n) {
                const double at_most = require_whole("contact", n[1], 0, 0x1p31);
                return query::answer_text(
                    contact(f[0], f[1], {.margin = n[0], .at_most = static_cast<std::size_t>(at_most)}));
              }},
    AskedForm{{"locate", 2, 0, "a figure and a point"},
              [](Figures f, Numbers) {
                return ask_of_point("locate", f[1],
                                    [&f](const auto& p) { return query::answer_text(locate(f[0], p)); });
              }},
    AskedForm{{"support_point", 1, 3, "a figure and a direction, x y z"},
              [](Figures f, Numbers n) { return query::answer_text(support_point(f[0], vector_of(n))); }},
    AskedForm{{"support_value", 1, 4, "a figure, a direction, x y z, and whether it is rounded down, -1, or up, 1"},
              [](Figures f, Numbers n) {
                return query::answer_text(support_value(f[0], vector_of(n), rounding_of("support_value", n[3])));
              }},
    AskedForm{{"fit_aabb", 1, 0, "a figure"}, [](Figures f, Numbers) { return query::answer_text(fit_aabb(f[0])); }},
};
#undef PLUMB_PAIR
#undef PLUMB_MOTIONS

std::string with_numbers(std::string_view words, Numbers numbers) {
  std::string text(words);
  for (const double x : numbers) text.append(" ").append(hexadecimal(x));
  return text;
}

const AskedForm& form_of(std::string_view name, std::size_t figures, std::size_t numbers) {
  std::string takes, names;
  for (const AskedForm& asked : asked_forms) {
    const QuestionForm& form = asked.form;
    if (form.name == name) {
      if (form.figures == figures && form.numbers == numbers) return asked;
      takes.append(takes.empty() ? "" : "; or ").append(form.arguments);
    } else if (!names.ends_with(form.name)) {
      names.append(names.empty() ? "" : ", ").append(form.name);
    }
  }
  if (takes.empty()) throw Error("there is no question " + quoted_word(name) + "; there are " + names);
  throw Error(std::string(name) + " takes " + takes + "; here are " + std::to_string(figures) + " figures and " +
              std::to_string(numbers) + " numbers");
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}
/// What stands before the mark, which is cut off the text together with it.
std::string_view cut_before(std::string_view& text, char mark) {
  const std::size_t at = std::min(text.find(mark), text.size());
  const std::string_view before = trimmed(text.substr(0, at));
  text.remove_prefix(std::min(at + 1, text.size()));
  return before;
}
bool begins_a_number(std::string_view text) { return text.find_first_of("+-.0123456789") == 0; }

}  // namespace

std::span<const QuestionForm> question_forms() {
  static const auto forms = [] {
    std::array<QuestionForm, asked_forms.size()> all;
    std::ranges::transform(asked_forms, all.begin(), &AskedForm::form);
    return all;
  }();
  return forms;
}

std::string to_string(const QuestionLine& line) {
  std::string text = line.question;
  for (const AnyFigure& figure : line.figures) text.append(" | ").append(to_string(figure));
  if (!line.numbers.empty()) text.append(with_numbers(" |", line.numbers));
  if (!line.answer.empty()) text.append(" = ").append(line.answer);
  return text;
}

std::optional<QuestionLine> parse_question_line(std::string_view line) {
  std::string_view told = line.substr(0, line.find('#'));
  if (trimmed(told).empty()) return std::nullopt;
  std::string_view asked = cut_before(told, '=');
  QuestionLine read{std::string(cut_before(asked, '|')), {}, {}, std::string(trimmed(told))};
  while (!asked.empty()) {
    std::string_view part = cut_before(asked, '|');
    if (begins_a_number(part)) {
      if (!asked.empty()) throw Error(read.question + ": numbers stand behind all figures");
      for (std::string_view word = next_word(part); !word.empty(); word = next_word(part))
        read.numbers.push_back(parse_double(word));
    } else if (const std::optional<AnyFigure> figure = parse_figure(part)) {
      read.figures.push_back(*figure);
    } else {
      throw Error(read.question + ": nothing stands between two bars");
    }
  }
  form_of(read.question, read.figures.size(), read.numbers.size());
  return read;
}

std::string answer_of(const QuestionLine& line) {
  const AskedForm& asked = form_of(line.question, line.figures.size(), line.numbers.size());
  try {
    return asked.answer(line.figures, line.numbers);
  } catch (const Error& e) {
    return query::refusal_text(e);
  }
}

}  // namespace plumb
