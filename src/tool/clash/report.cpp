#include <fmt/format.h>

#include <algorithm>

#include "tool/clash/command.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;

json triple(double x, double y, double z) { return json::array({x, y, z}); }

template <class T>
json or_null(const std::optional<T>& x) {
  return x ? json(*x) : json();
}

/// Why is none told of what has insides in common?  Empty where one is, or where nothing is in common inside.
std::string why_no_volume(const ClashReport& report, const PartClash& pair) {
  const ClashKind kind = pair.clash.kind;
  if (pair.clash.volume || kind == ClashKind::apart || kind == ClashKind::within_clearance ||
      kind == ClashKind::touching)
    return {};
  if (!report.measured) return "it was not asked for";
  const AssemblyMember &a = report.parts[pair.a], &b = report.parts[pair.b];
  if (!a.closed && !b.closed) return fmt::format("{} and {} are not closed", a.name, b.name);
  return fmt::format("{} is not closed", a.closed ? b.name : a.name);
}

std::string measures_text(const Clash& c, const ClashReport& report, const PartClash& pair) {
  std::string text;
  if (c.inner)
    text += fmt::format(", {} in {}", printable(report.parts[*c.inner == 0 ? pair.a : pair.b].name),
                        printable(report.parts[*c.inner == 0 ? pair.b : pair.a].name));
  if (c.distance) text += fmt::format(", distance {}", *c.distance);
  if (c.volume) text += fmt::format(", volume {}", *c.volume);
  if (const std::string why = why_no_volume(report, pair); !why.empty() && report.measured)
    text += fmt::format(", no volume: {}", printable(why));
  if (c.depth && c.depth->lower == c.depth->upper) text += fmt::format(", depth {}", c.depth->upper);
  if (c.depth && c.depth->lower != c.depth->upper)
    text += fmt::format(", depth {} to {}", c.depth->lower, c.depth->upper);
  return text;
}

/// In quotes where it has to be, as RFC 4180 says.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}
std::string csv_number(const std::optional<double>& x) { return x ? fmt::format("{}", *x) : ""; }

json clash_json_of(const PartClash& pair, const ClashReport& report) {
  const Clash& c = pair.clash;
  const std::size_t told = std::min(c.meeting.size(), ClashReport::told);
  const std::string why = why_no_volume(report, pair);
  json meeting = json::array();
  for (std::size_t i = 0; i < told; ++i) meeting.push_back({c.meeting[i].a, c.meeting[i].b});
  return {{"part_a", report.parts[pair.a].name},
          {"part_b", report.parts[pair.b].name},
          {"word", name_of(c.kind)},
          {"place", triple(c.place.x, c.place.y, c.place.z)},
          {"distance", or_null(c.distance)},
          {"inner_part", c.inner ? json(report.parts[*c.inner == 0 ? pair.a : pair.b].name) : json()},
          {"volume", or_null(c.volume)},
          {"why_no_volume", why.empty() ? json() : json(why)},
          {"depth_lower", c.depth ? json(c.depth->lower) : json()},
          {"depth_upper", c.depth ? json(c.depth->upper) : json()},
          {"way_out", c.depth ? triple(c.depth->direction.x, c.depth->direction.y, c.depth->direction.z) : json()},
          {"part_triangles", std::move(meeting)},
          {"more_meeting", c.meeting.size() - told}};
}

}  // namespace

std::string clash_line(const ClashReport& report, const PartClash& pair, const Style& style) {
  const Clash& c = pair.clash;
  const std::string word(name_of(c.kind));
  const bool mild = c.kind == ClashKind::touching || c.kind == ClashKind::within_clearance;
  return fmt::format("{} - {}: {} at ({}, {}, {}){}", style.bold(printable(report.parts[pair.a].name)),
                     style.bold(printable(report.parts[pair.b].name)), mild ? style.yellow(word) : style.red(word),
                     c.place.x, c.place.y, c.place.z, measures_text(c, report, pair));
}

std::string clash_count(const ClashReport& report) {
  std::string counts;
  for (std::size_t k = 1; k < report.counts.size(); ++k)
    if (report.counts[k] != 0)
      counts += fmt::format("{}{} {}", counts.empty() ? ": " : ", ", grouped(report.counts[k]),
                            name_of(static_cast<ClashKind>(k)));
  std::string text = fmt::format("{}, {} in reach{}", plural(report.parts.size(), "part", "parts"),
                                 plural(report.asked, "pair", "pairs"), counts.empty() ? ": no clash" : counts);
  if (report.ignored != 0) text += fmt::format(" ({} ignored)", grouped(report.ignored));
  const auto sheets = static_cast<std::size_t>(
      std::ranges::count_if(report.parts, [](const AssemblyMember& part) { return !part.closed; }));
  if (sheets != 0) text += fmt::format("; {} not closed, and taken for sheets", plural(sheets, "part is", "parts are"));
  return text;
}

std::string clash_text(const ClashReport& report, bool all, const Style& style) {
  std::string text;
  std::size_t shown = 0;
  for (const PartClash& pair : report.clashes) {
    if (!all && shown == ClashReport::listed) break;
    ++shown;
    text += clash_line(report, pair, style) + "\n";
  }
  if (shown < report.clashes.size())
    text += fmt::format("and {} more, which '--all' lists\n", grouped(report.clashes.size() - shown));
  return text + clash_count(report) + "\n";
}

json clash_json(const ClashReport& report) {
  json said = origin_json("plumb clash");
  said["passed_over"] = report.passed_over;
  said["not_read"] = json::array();
  for (const UnreadMesh& part : report.unread) said["not_read"].push_back({{"mesh", part.name}, {"error", part.why}});
  said["assembly"] = json::array();
  for (const AssemblyMember& part : report.parts)
    said["assembly"].push_back({{"part_name", part.name},
                                {"mesh", part.file},
                                {"vertices", part.vertices},
                                {"triangles", part.triangles},
                                {"closed", part.closed}});
  said["clearance"] = or_null(report.clearance);
  said["asked_pairs"] = report.asked;
  said["answered_pairs"] = report.answered;
  said["ignored_pairs"] = report.ignored;
  said["clashes"] = json::array();
  for (const PartClash& pair : report.clashes) said["clashes"].push_back(clash_json_of(pair, report));
  return said;
}

std::string clash_csv(const ClashReport& report) {
  std::string text =
      "part_a,part_b,word,x,y,z,distance,inner_part,volume,depth_lower,depth_upper,meeting,why_no_volume\n";
  for (const PartClash& pair : report.clashes) {
    const Clash& c = pair.clash;
    const std::string inner = c.inner ? report.parts[*c.inner == 0 ? pair.a : pair.b].name : "";
    const auto depth = [&](double ClashDepth::*end) {
      return c.depth ? std::optional<double>((*c.depth).*end) : std::nullopt;
    };
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(report.parts[pair.a].name),
                        csv_field(report.parts[pair.b].name), name_of(c.kind), c.place.x, c.place.y, c.place.z,
                        csv_number(c.distance), csv_field(inner), csv_number(c.volume),
                        csv_number(depth(&ClashDepth::lower)), csv_number(depth(&ClashDepth::upper)), c.meeting.size(),
                        csv_field(why_no_volume(report, pair)));
  }
  return text;
}

}  // namespace plumb::tool
