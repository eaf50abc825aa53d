// Pictures, in doubles: what is drawn is near to what was decided.
#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "tool/convex/command.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/drawing/drawn_hull.hpp"
#include "tool/drawing/report_page.hpp"
#include "tool/drawing/search_view.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

Point3 between(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// The corners of the difference, one after the other.
std::vector<Point3> simplex_of(const ConvexReport& r, const GjkStep& step) {
  std::vector<Point3> points;
  for (std::uint32_t i = 0; i < step.simplex.size; ++i) {
    const auto& [a, b] = step.simplex.corners[i];
    points.push_back(between(r.hulls[0].corners[a], r.hulls[1].corners[b]));
  }
  return points;
}

/// The point of a body (0, 1) that the step has nearest.
Point3 point_on(const ConvexReport& r, const GjkStep& step, std::size_t which) {
  std::vector<Point3> points;
  for (std::uint32_t i = 0; i < step.simplex.size; ++i)
    points.push_back(r.hulls[which].corners[step.simplex.corners[i][which]]);
  return weighted(points, step);
}

std::string vertex_line(const Point3& p) { return fmt::format("v {} {} {}\n", p.x, p.y, p.z); }

/// Objects of points, segments and polygons, whose numbers go on from one object to the next.
class ObjText {
 public:
  explicit ObjText(std::string about) : text_("# " + std::move(about) + "\n") {}

  void begin(std::string_view name, const std::vector<Point3>& points) {
    text_ += fmt::format("o {}\n", name);
    first_ = next_;
    for (const Point3& p : points) text_ += vertex_line(p);
    next_ += points.size();
  }
  template <class Numbers>
  void element(char kind, const Numbers& of) {
    text_ += kind;
    for (const std::size_t i : of) text_ += fmt::format(" {}", first_ + i);
    text_ += '\n';
  }
  [[nodiscard]] std::string text() const { return text_; }

 private:
  std::string text_;
  std::size_t first_ = 1, next_ = 1;
};

/// By the numbers of the hull's corners.
std::vector<std::vector<std::size_t>> faces_of(const HullOfMesh& h) {
  std::vector<std::vector<std::size_t>> faces(h.hull.face_count());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const std::uint32_t v : h.hull.face(f)) {
      faces[f].push_back(
          static_cast<std::size_t>(std::ranges::lower_bound(h.hull.vertices, v) - h.hull.vertices.begin()));
    }
  }
  return faces;
}

std::string bodies_obj(const ConvexReport& r) {
  ObjText obj("plumb convex: the hulls of " + r.hulls[0].asked.name + " (a) and " + r.hulls[1].asked.name + " (b)");
  char name = 'a';
  for (const HullOfMesh& h : r.hulls) {
    obj.begin(std::string(1, name++), h.corners);
    for (const auto& face : faces_of(h)) obj.element('f', face);
    if (h.hull.dimension == 1) obj.element('l', std::array<std::size_t, 2>{0, 1});
    if (h.hull.dimension == 0) obj.element('p', std::array<std::size_t, 1>{0});
  }
  return obj.text();
}

std::string step_obj(const ConvexReport& r, std::size_t number) {
  const GjkStep& step = r.steps[number];
  const std::vector<Point3> corners = simplex_of(r, step);
  ObjText obj(fmt::format("plumb convex: step {} of {} of GJK; corners are vertices of a less vertices of b, rounded",
                          number + 1, r.steps.size()));
  obj.begin("simplex", corners);
  using Numbers = std::vector<std::size_t>;
  if (corners.size() == 1) obj.element('p', Numbers{0});
  if (corners.size() == 2) obj.element('l', Numbers{0, 1});
  if (corners.size() == 3) obj.element('f', Numbers{0, 1, 2});
  if (corners.size() == 4) {
    for (const Numbers& face : {Numbers{0, 1, 2}, Numbers{0, 1, 3}, Numbers{0, 2, 3}, Numbers{1, 2, 3}})
      obj.element('f', face);
  }
  obj.begin("nearest", {weighted(corners, step)});
  obj.element('p', Numbers{0});
  obj.begin("origin", {{0, 0, 0}});
  obj.element('p', Numbers{0});
  obj.begin("between", {point_on(r, step, 0), point_on(r, step, 1)});
  obj.element('l', Numbers{0, 1});
  return obj.text();
}

/// What the page's script draws.
nlohmann::json scene(const ConvexReport& r) {
  using nlohmann::json;
  json bodies = json::array();
  for (const HullOfMesh& h : r.hulls) {
    const DrawnHull drawn = drawn_hull(h.hull, h.asked.mesh.vertices);
    json points = json::array();
    for (const Point3& p : drawn.points) points.push_back({p.x, p.y, p.z});
    bodies.push_back({{"points", std::move(points)}, {"edges", drawn.edges}});
  }
  return {{"bodies", std::move(bodies)}, {"steps", drawn_steps(r.steps, r.hulls[0].corners, r.hulls[1].corners)}};
}

std::string pairs_text(const ConvexReport& r, const GjkStep& step) {
  std::string text;
  for (std::uint32_t i = 0; i < step.simplex.size; ++i) {
    const auto& [a, b] = step.simplex.corners[i];
    text += fmt::format("{}{}&nbsp;&minus;&nbsp;{}", i == 0 ? "" : ", ", r.hulls[0].hull.vertices[a],
                        r.hulls[1].hull.vertices[b]);
  }
  return text;
}

std::string page_of(const ConvexReport& r) {
  ReportPage page{"GJK, step by step",
                  "GJK, step by step",
                  fmt::format("{} steps", r.steps.size()),
                  "The search looks for the point of the set of differences, a vertex of a less one of b, that is "
                  "nearest to the origin. Each step has a simplex of such differences; the next one is grown toward "
                  "the origin, until no difference lies nearer. Coordinates are rounded for the pictures.",
                  {},
                  {}};
  std::string rows;
  for (std::size_t i = 0; i < r.steps.size(); ++i) {
    rows += fmt::format("<tr data-step=\"{}\"><td>{}</td><td>{}</td><td>{}</td></tr>\n", i, i + 1,
                        pairs_text(r, r.steps[i]), r.steps[i].square);
  }
  page.body = fmt::format(
      "<section><article class=\"script\" hidden id=\"stage\">{}</article>\n<article><h3>{} (a) against {} (b)</h3>\n"
      "<div class=\"counts\"><table><thead><tr><th scope=\"col\">step</th><th scope=\"col\">vertices, a &minus; "
      "b</th><th scope=\"col\">squared distance from the origin</th></tr></thead>\n<tbody>\n{}</tbody></table></div>"
      "</article></section>\n{}",
      search_stage, escaped(r.hulls[0].asked.name), escaped(r.hulls[1].asked.name), rows, search_script);
  nlohmann::json raw = origin_json("plumb convex");
  raw["scene"] = scene(r);
  return report_page(page, raw);
}

}  // namespace

std::vector<NamedText> convex_history(const ConvexReport& r) {
  std::vector<NamedText> files{{"bodies.obj", bodies_obj(r)}};
  for (std::size_t i = 0; i < r.steps.size(); ++i)
    files.push_back({fmt::format("step-{:03}.obj", i + 1), step_obj(r, i)});
  files.push_back({"index.html", page_of(r)});
  return files;
}

}  // namespace plumb::tool
