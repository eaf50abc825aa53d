#include "tool/clash/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "tool/clash/page_view.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/drawing/drawn_mesh.hpp"
#include "tool/drawing/mesh_view.hpp"
#include "tool/drawing/report_page.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;

/// A part as the script has it: which triangles are drawn, by their numbers in the mesh, and what meets another.
struct ScenePart {
  std::uint32_t part = 0;
  std::vector<std::uint32_t> drawn;
};

/// Parts of the first clashes, in their order, and where each stands.
class ClashScene {
 public:
  ClashScene(const ClashReport& report, std::span<const TriangleMesh> meshes, const ClashPageBounds& bounds)
      : meshes_(meshes), shown_(report.clashes.data(), std::min(report.clashes.size(), bounds.rows)) {
    for (const PartClash& pair : shown_)
      for (const std::uint32_t part : {pair.a, pair.b})
        if (place_.try_emplace(part, parts_.size()).second) parts_.push_back({part, {}});
    const std::size_t share = std::max<std::size_t>(1, bounds.triangles / std::max<std::size_t>(1, parts_.size()));
    for (ScenePart& of : parts_) {
      const auto n = static_cast<std::uint32_t>(meshes[of.part].triangles.size());
      const auto stride = static_cast<std::uint32_t>(n <= share ? 1 : n / share + 1);
      thinned_ += stride > 1 ? 1 : 0;
      for (std::uint32_t t = 0; t < n; t += stride) of.drawn.push_back(t);
    }
    for (const PartClash& pair : shown_) {
      for (std::size_t i = 0; i < told_of(pair); ++i) {
        parts_[place_.at(pair.a)].drawn.push_back(pair.clash.meeting[i].a);
        parts_[place_.at(pair.b)].drawn.push_back(pair.clash.meeting[i].b);
      }
    }
    for (ScenePart& of : parts_) {
      std::ranges::sort(of.drawn);
      of.drawn.erase(std::unique(of.drawn.begin(), of.drawn.end()), of.drawn.end());
    }
  }

  [[nodiscard]] std::span<const PartClash> shown() const { return shown_; }
  [[nodiscard]] std::span<const ScenePart> parts() const { return parts_; }
  [[nodiscard]] std::size_t thinned() const { return thinned_; }
  [[nodiscard]] std::size_t place_of(std::uint32_t part) const { return place_.at(part); }

  /// Numbers of what is drawn that meets the other: of the first part, or of the second.
  [[nodiscard]] json met(const PartClash& pair, bool of_second) const {
    const std::vector<std::uint32_t>& drawn = parts_[place_.at(of_second ? pair.b : pair.a)].drawn;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < told_of(pair); ++i) {
      const std::uint32_t t = of_second ? pair.clash.meeting[i].b : pair.clash.meeting[i].a;
      numbers.push_back(static_cast<std::size_t>(std::ranges::lower_bound(drawn, t) - drawn.begin()));
    }
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
  }

  [[nodiscard]] json part(const ScenePart& of, const std::string& name, const DrawnCube& cube) const {
    DrawnMesh made(meshes_[of.part], cube);
    for (const std::uint32_t t : of.drawn) made.add(t);
    return {{"name", name}, {"points", made.points()}, {"triangles", made.triangles()}};
  }

 private:
  static std::size_t told_of(const PartClash& pair) { return std::min(pair.clash.meeting.size(), ClashReport::told); }

  std::span<const TriangleMesh> meshes_;
  std::span<const PartClash> shown_;
  std::map<std::uint32_t, std::size_t> place_;
  std::vector<ScenePart> parts_;
  std::size_t thinned_ = 0;
};

/// Six digits of it: the line that tells a clash has all.
std::string short_number(const std::optional<double>& x) { return x ? fmt::format("{:.6g}", *x) : ""; }

std::string clash_row(const PartClash& pair, const ClashReport& report, std::size_t number) {
  const Clash& c = pair.clash;
  std::string depth = c.depth ? short_number(c.depth->upper) : "";
  if (c.depth && short_number(c.depth->lower) != depth) depth = short_number(c.depth->lower) + " to " + depth;
  return fmt::format(
      "<tr data-clash=\"{}\" data-word=\"{}\"><td><button type=\"button\">{} - {}</button></td><td>{}</td><td>{}</td>"
      "<td>{}</td><td>{}</td><td>{:.6g}, {:.6g}, {:.6g}</td></tr>\n",
      number, name_of(c.kind), escaped(printable(report.parts[pair.a].name)),
      escaped(printable(report.parts[pair.b].name)), name_of(c.kind), short_number(c.volume), depth,
      short_number(c.distance), c.place.x, c.place.y, c.place.z);
}

std::string clash_list(const ClashReport& report, const ClashScene& scene) {
  std::string rows, more;
  for (std::size_t i = 0; i < scene.shown().size(); ++i) rows += clash_row(scene.shown()[i], report, i);
  if (rows.empty()) rows = "<tr><td colspan=\"6\">no clash is listed</td></tr>\n";
  if (const std::size_t left = report.clashes.size() - scene.shown().size(); left != 0)
    more += fmt::format("<p>and {} more clashes, which --json and --csv list.</p>", grouped(left));
  if (scene.thinned() != 0)
    more += fmt::format("<p>{} drawn with triangles missing, for so many are not drawn; what meets is there.</p>",
                        plural(scene.thinned(), "large part is", "large parts are"));
  if (!report.unread.empty())
    more += fmt::format("<p>{} could not be read, and {} not here.</p>",
                        plural(report.unread.size(), "part or file", "parts or files"),
                        report.unread.size() == 1 ? "is" : "are");
  return fmt::format(
      "<div class=\"counts\" style=\"max-height: 80vh; overflow: auto\"><table><thead><tr><th scope=\"col\">parts</th>"
      "<th scope=\"col\">word</th><th scope=\"col\">volume</th><th scope=\"col\">depth</th><th scope=\"col\">"
      "distance</th><th scope=\"col\">place</th></tr></thead>\n<tbody>\n{}</tbody></table></div>{}",
      rows, more);
}

json scene_clash(const PartClash& pair, const ClashScene& scene, const ClashReport& report, const DrawnCube& cube) {
  const Clash& c = pair.clash;
  // What is no finite number is nothing in JSON.
  const bool leads = c.depth && std::isfinite(c.depth->upper);
  return {{"a", scene.place_of(pair.a)},
          {"b", scene.place_of(pair.b)},
          {"place", cube.of(c.place)},
          {"way", c.depth ? json{c.depth->direction.x, c.depth->direction.y, c.depth->direction.z} : json()},
          {"free", leads ? json(c.depth->upper) : json()},
          {"met_a", scene.met(pair, false)},
          {"met_b", scene.met(pair, true)},
          {"told", clash_line(report, pair, Style(false))}};
}

}  // namespace

std::string clash_page(const ClashReport& report, std::span<const TriangleMesh> meshes, const ClashPageBounds& bounds) {
  const ClashScene scene(report, meshes, bounds);
  const DrawnCube cube(meshes);
  json raw = origin_json("plumb clash");
  raw["unit"] = std::isfinite(cube.unit()) ? json(cube.unit()) : json();
  raw["parts"] = json::array();
  for (const ScenePart& of : scene.parts())
    raw["parts"].push_back(scene.part(of, printable(report.parts[of.part].name), cube));
  raw["shown"] = json::array();
  for (const PartClash& pair : scene.shown()) raw["shown"].push_back(scene_clash(pair, scene, report, cube));
  PageFilter words{"word", "Words", {}};
  for (std::size_t k = 1; k < report.counts.size(); ++k)
    if (report.counts[k] != 0) words.names.emplace_back(name_of(static_cast<ClashKind>(k)));
  ReportPage page{
      "Clashes",
      "Clashes",
      plural(report.parts.size(), "part", "parts"),
      clash_count(report) +
          ". Words, volumes and depths are exact and rounded once; coordinates are rounded further for the "
          "pictures alone.",
      {},
      fmt::format("<section class=\"wide\" style=\"display: flex; flex-wrap: wrap; gap: 16px; align-items: "
                  "flex-start\">\n<article style=\"flex: 1 1 420px\">{}</article>\n<article class=\"script\" "
                  "style=\"flex: 1 1 520px\" hidden id=\"stage\">{}</article></section>\n{}{}",
                  clash_list(report, scene), clash_stage, mesh_view_script, clash_script)};
  if (!words.names.empty()) page.filters.push_back(std::move(words));
  return report_page(page, raw);
}

}  // namespace plumb::tool
