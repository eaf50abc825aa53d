#include <fmt/format.h>

#include <algorithm>

#include "plumb/figure/basic/equal_points.hpp"
#include "plumb/surface/topology/topology.hpp"
#include "tool/intersect/command.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

std::string_view verb(Relation relation) { return relation == Relation::touching ? "touch" : "overlap"; }

/// "segment 0 0 0, 1 1 0"
std::string common_text(const Intersection3& common) {
  std::string text(word_of(common.kind));
  std::string_view between = " ";
  for (const Point3& p : approximate(common)) {
    text += fmt::format("{}{:.6g} {:.6g} {:.6g}", between, p.x, p.y, p.z);
    between = ", ";
  }
  return text;
}

std::string verdict(const IntersectReport& r, const Style& style) {
  const std::string what = r.overlapping ? "overlap" : "meet";
  if (r.many() == 0) return style.green(fmt::format("no two triangles {}", what)) + "\n";
  if (!r.complete) return style.red(fmt::format("there are triangles that {}", what)) + "\n";
  const std::string pairs = plural(r.many(), "pair of triangles", "pairs of triangles");
  const std::string text = fmt::format("{} {}{}", pairs, what, r.many() == 1 ? "s" : "");
  if (r.overlapping) return style.red(text) + "\n";
  return style.red(text) + fmt::format(": {} touch{}, {} overlap{}\n", grouped(r.found.touching),
                                       r.found.touching == 1 ? "es" : "", grouped(r.found.overlapping),
                                       r.found.overlapping == 1 ? "s" : "");
}

/// Triangles that have equal points, but no vertex in common.
std::string remark(const IntersectReport& r) {
  if (!r.of_one() || r.found.touching == 0) return {};
  const std::vector<std::uint32_t> first = first_equal(r.meshes.front().mesh.vertices);
  std::uint64_t repeated = 0;
  for (std::size_t v = 0; v < first.size(); ++v) repeated += first[v] != v ? 1 : 0;
  if (repeated == 0) return {};
  return fmt::format("{} where another is: triangles that meet there share none, and touch.\n",
                     plural(repeated, "vertex lies", "vertices lie"));
}

}  // namespace

std::string_view word_of(IntersectionKind common) {
  return common == IntersectionKind::point ? "point" : common == IntersectionKind::segment ? "segment" : "polygon";
}

std::string intersect_text(const IntersectReport& r, std::size_t most, const Style& style) {
  std::string text;
  for (const AskedMesh& mesh : r.meshes) text += mesh_line(mesh, style) + "\n";
  text += verdict(r, style);
  if (!r.pairs || r.pairs->empty()) return text + remark(r);
  const std::size_t shown = std::min(most, r.pairs->size());
  text += style.dim(fmt::format("{:>10} {:>10}{}\n", r.of_one() ? "triangle" : "of a", r.of_one() ? "triangle" : "of b",
                                r.in_common ? "         in common" : ""));
  for (std::size_t i = 0; i < shown; ++i) {
    const TrianglePair& p = (*r.pairs)[i];
    const std::string common = r.in_common ? " " + common_text((*r.in_common)[i]) : "";
    text += common.empty() ? fmt::format("{:>10} {:>10} {}\n", p.a, p.b, verb(p.relation))
                           : fmt::format("{:>10} {:>10} {:<7}{}\n", p.a, p.b, verb(p.relation), common);
  }
  if (shown < r.pairs->size()) text += fmt::format("and {} more; --all lists them\n", grouped(r.pairs->size() - shown));
  return text + remark(r);
}

}  // namespace plumb::tool
