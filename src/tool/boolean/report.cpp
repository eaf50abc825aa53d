#include <fmt/format.h>

#include <algorithm>

#include "tool/boolean/command.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

std::string rounding_text(const RoundedMesh& result) {
  if (result.moved == 0) return "no point moved";
  std::string text = fmt::format("no point moved farther than {:.2g}", result.moved);
  if (result.rounds > 1) text += fmt::format("; {} rounds, to a grid of {:.2g}", result.rounds, result.grid);
  return text;
}

}  // namespace

std::string boolean_text(const BooleanReport& report, const Style& style) {
  const RoundedMesh& r = report.result;
  std::string text = style.bold(report.operation) +
                     fmt::format(": {} vertices, {} triangles", r.mesh.vertices.size(), r.mesh.triangles.size());
  if (r.mesh.triangles.empty()) {
    text += ", empty";
  } else if (report.volume) {
    text += fmt::format(", volume {}", *report.volume);
  }
  text += fmt::format("\n{}: {}\n", r.sound ? style.green("sound") : style.red("not sound"), rounding_text(r));
  const std::size_t shown = std::min(r.meeting.size(), BooleanReport::listed);
  for (std::size_t i = 0; i < shown; ++i)
    text += fmt::format("  triangles {} and {} cross or touch\n", r.meeting[i][0], r.meeting[i][1]);
  if (shown < r.meeting.size()) text += fmt::format("  and {} more pairs\n", grouped(r.meeting.size() - shown));
  if (report.written) text += fmt::format("written: {}\n", printable(*report.written));
  return text;
}

nlohmann::json boolean_json(const BooleanReport& report) {
  using nlohmann::json;
  const RoundedMesh& r = report.result;
  const std::size_t told = std::min(r.meeting.size(), BooleanReport::told);
  json pairs = json::array();
  for (std::size_t i = 0; i < told; ++i) pairs.push_back(r.meeting[i]);
  return {{"operation", report.operation},
          {"vertices", r.mesh.vertices.size()},
          {"triangles", r.mesh.triangles.size()},
          {"volume", report.volume ? json(*report.volume) : json()},
          {"is_sound", r.sound},
          {"moved", r.moved},
          {"rounds", r.rounds},
          {"grid", r.grid},
          {"meeting_triangles", std::move(pairs)},
          {"more_meeting", r.meeting.size() - told},
          {"written", report.written ? json(*report.written) : json()}};
}

}  // namespace plumb::tool
