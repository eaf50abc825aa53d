#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "tool/replay/command.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

constexpr std::size_t listed = 10;

std::string place(const std::string& file, std::uint64_t line) {
  return fmt::format("{}, line {}", printable(file), line);
}

void tell_lines(std::span<const ReplayedLine> lines, std::string_view was, std::string_view is, std::string& text) {
  for (const ReplayedLine& r : lines.first(std::min(lines.size(), listed)))
    text += fmt::format("  {}: {}\n    {}{}{}{}\n", place(r.file, r.line), printable(r.question),
                        was.empty() ? "" : fmt::format("{} {}; ", was, printable(r.was)), is, is.empty() ? "" : " ",
                        printable(r.is));
  if (lines.size() > listed) text += fmt::format("  and {} more\n", lines.size() - listed);
}

nlohmann::json lines_json(std::span<const ReplayedLine> lines) {
  nlohmann::json all = nlohmann::json::array();
  for (const ReplayedLine& r : lines)
    all.push_back({{"kept_in", r.file}, {"line", r.line}, {"question", r.question}, {"was", r.was}, {"is", r.is}});
  return all;
}

}  // namespace

std::string replay_text(const ReplayReport& r, const Style& style) {
  const auto lines = [](std::size_t n) { return plural(n, "question", "questions"); };
  std::string text = fmt::format("{} asked, {} answered as before", lines(r.asked), r.alike);
  if (r.proved != 0) text += fmt::format(", {} with a proof", r.proved);
  text += '\n';
  if (!r.different.empty()) {
    text += style.red(fmt::format("{} answered otherwise", lines(r.different.size()))) + "\n";
    tell_lines(r.different, "was", "is", text);
  }
  if (!r.disproved.empty()) {
    text += style.red(fmt::format("{} answered otherwise than is proved", lines(r.disproved.size()))) + "\n";
    tell_lines(r.disproved, "proved", "is", text);
  }
  if (!r.unanswered.empty()) {
    text += fmt::format("{} had no answer\n", lines(r.unanswered.size()));
    tell_lines(r.unanswered, "", "", text);
  }
  return text;
}

nlohmann::json replay_json(const ReplayReport& r) {
  nlohmann::json unread = nlohmann::json::array();
  for (const UnreadLine& u : r.unread) unread.push_back({{"kept_in", u.file}, {"line", u.line}, {"why", u.why}});
  return {{"asked", r.asked},
          {"alike", r.alike},
          {"proved", r.proved},
          {"different", lines_json(r.different)},
          {"disproved", lines_json(r.disproved)},
          {"unanswered", lines_json(r.unanswered)},
          {"unread_lines", std::move(unread)}};
}

}  // namespace plumb::tool
