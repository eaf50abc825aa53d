#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tool/drawing/chart.hpp"
#include "tool/drawing/report_page.hpp"
#include "tool/drawing/search_view.hpp"
#include "tool/replay/command.hpp"
#include "tool/replay/drawn_question.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;

json triples(const std::vector<Point3>& points) {
  json all = json::array();
  for (const Point3& p : points) all.push_back({p.x, p.y, p.z});
  return all;
}

json scene_of(const DrawnQuestion& q) {
  json bodies = json::array(), marks = json::array();
  for (const DrawnFigure& f : q.figures)
    bodies.push_back(
        {{"name", f.name}, {"points", triples(f.points)}, {"edges", f.edges}, {"corners", triples(f.corners)}});
  for (const DrawnMark& m : q.marks) marks.push_back({{"title", m.title}, {"points", triples(m.points)}});
  json steps = q.steps.empty() ? json::array() : drawn_steps(q.steps, q.figures[0].corners, q.figures[1].corners);
  return {{"bodies", std::move(bodies)}, {"marks", std::move(marks)}, {"steps", std::move(steps)}};
}

std::string row(std::string_view name, std::string_view text, std::string_view note = {}) {
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td style=\"text-align: left; overflow-wrap: anywhere\">{}{}</td></tr>\n", name,
      escaped(text), note.empty() ? "" : fmt::format(" <em>({})</em>", escaped(note)));
}

std::string steps_table(const DrawnQuestion& q) {
  if (q.steps.empty()) return {};
  std::string rows;
  for (std::size_t i = 0; i < q.steps.size(); ++i) {
    std::string pairs;
    for (std::uint32_t k = 0; k < q.steps[i].simplex.size; ++k) {
      const auto& [a, b] = q.steps[i].simplex.corners[k];
      pairs += fmt::format("{}{}&nbsp;&minus;&nbsp;{}", k == 0 ? "" : ", ", a, b);
    }
    rows += fmt::format("<tr data-step=\"{}\"><td>{}</td><td>{}</td><td>{}</td></tr>\n", i, i + 1, pairs,
                        q.steps[i].square);
  }
  return "<article><h3>The search for the nearest points, GJK</h3>\n<p>Of figures that are round it is that of their "
         "cores. The square is that of the figures as they are given.</p>\n<div class=\"counts\"><table><thead><tr><th "
         "scope=\"col\">step</th><th scope=\"col\">corners, a &minus; b</th><th scope=\"col\">squared distance from "
         "the "
         "origin</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody></table></div></article>\n";
}

}  // namespace

std::string replay_page(const ReplayedQuestion& of) {
  const ReplayedLine& told = of.told;
  const DrawnQuestion drawn = drawn_question(of.asked);
  const bool is_alike = told.was == told.is;
  std::string rows = row("question", told.question);
  rows += told.was.empty() ? row("was answered", "", "it had no answer") : row("was answered", told.was);
  rows += row("is answered", told.is, told.was.empty() ? "" : is_alike ? "as before" : "otherwise");
  if (of.proved) rows += row("is proved", *of.proved, *of.proved == told.is ? "as answered" : "otherwise");
  for (const DrawnFigure& f : drawn.figures)
    rows += row(f.name, f.text, f.why_not.empty() ? "" : "not drawn: " + f.why_not);
  for (const DrawnMark& m : drawn.marks) rows += row("seen in green", m.title);

  ReportPage page{
      of.asked.question + ", asked again",
      of.asked.question + ", asked again",
      fmt::format("{}, line {}", printable(told.file), told.line),
      "One question, its answer as it was kept and as it is here. Answers are exact; the pictures are rounded, "
      "and of figures that are round they have a few hundred points.",
      {},
      {}};
  page.body = fmt::format(
      "<section><article class=\"script\" hidden id=\"stage\">{}</article>\n<article><h3>{}</h3>\n<div "
      "class=\"counts\"><table><tbody>\n{}</tbody></table></div></article>\n{}</section>\n{}",
      search_stage, is_alike || told.was.empty() ? "The question" : "The question, and what differs", rows,
      steps_table(drawn), search_script);
  json raw = origin_json("plumb replay");
  raw["question"] = {
      {"kept_in", told.file}, {"line", told.line}, {"question", told.question}, {"was", told.was}, {"is", told.is}};
  raw["scene"] = scene_of(drawn);
  return report_page(page, raw);
}

}  // namespace plumb::tool
