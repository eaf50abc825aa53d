#include "tool/section/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/terminal/decimal_list.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/write_folder.hpp"

namespace plumb::tool {
namespace {

SectionReport report_of(const SectionOptions& options) {
  SectionReport report;
  for (const std::string& words : options.planes) {
    for (NamedPlane& plane : planes_of(words)) report.planes.push_back(std::move(plane));
    if (report.planes.size() > most_planes) throw Error(fmt::format("more than {} planes", most_planes));
  }
  report.mesh_name = name_of_input(options.meshes.words.front());
  report.mesh =
      triangulate(read_input(options.meshes.words.front(), &report.load, options.meshes.reading()), &report.load.fans);
  std::vector<AnyPlane3> planes;
  for (const NamedPlane& plane : report.planes) planes.push_back(plane.plane);
  report.sections = sections(report.mesh, planes, options.below ? OnPlane::below : OnPlane::above);
  for (const Section& section : report.sections) {
    const SectionView view(section.plane);
    auto& drawn = report.drawn.emplace_back();
    auto& measured = report.measured.emplace_back();
    for (const Contour& contour : section.contours) {
      auto& points = drawn.emplace_back();
      for (const SectionCorner& corner : contour.corners) points.push_back(view.at(report.mesh, corner));
      measured.push_back(measures(points, contour.closed));
    }
  }
  return report;
}

struct Counted {
  std::size_t outer = 0, holes = 0, flat = 0, open = 0, corners = 0;
  double area = 0, length = 0;
};

Counted count(const Section& section, const std::vector<ContourMeasures>& measured) {
  Counted n;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const Contour& c = section.contours[i];
    ++(!c.closed ? n.open : c.turn == Sign::positive ? n.outer : c.turn == Sign::negative ? n.holes : n.flat);
    n.corners += c.corners.size();
    n.area += measured[i].area;
    n.length += measured[i].length;
  }
  return n;
}

std::string remarks(const Section& section, const Counted& n, const Style& style) {
  std::string text;
  const auto remark = [&](std::uint64_t many, const char* what) {
    if (many != 0) text += fmt::format("{}{} {}", text.empty() ? "  " : ", ", many, what);
  };
  remark(section.coplanar_triangles.size(), "triangles in the plane");
  remark(section.touching_corners, "touching corners");
  remark(section.canceled_segments, "segments canceled");
  remark(n.flat, "without area");
  return n.open == 0 ? style.dim(text) : style.dim(text) + style.red(text.empty() ? "  open" : ", open");
}

}  // namespace

std::string section_text(const SectionReport& report, const Style& style) {
  std::size_t widest = 5, inexact = 0, open = 0;
  for (const NamedPlane& plane : report.planes) {
    widest = std::max(widest, plane.name.size());
    inexact += !plane.exact;
  }
  std::string text =
      style.bold(printable(report.mesh_name)) +
      fmt::format(": {} vertices, {} triangles, {} {}\n", report.mesh.vertices.size(), report.mesh.triangles.size(),
                  report.planes.size(), report.planes.size() == 1 ? "plane" : "planes");
  text += style.dim(fmt::format("{:<{}} {:>6} {:>6} {:>6} {:>9} {:>14} {:>14}\n", "plane", widest, "outer", "holes",
                                "open", "corners", "area", "length"));
  for (std::size_t i = 0; i < report.planes.size(); ++i) {
    const Counted n = count(report.sections[i], report.measured[i]);
    text += fmt::format("{:<{}} {:>6} {:>6} {:>6} {:>9} {:>14.6g} {:>14.6g}{}\n", report.planes[i].name, widest,
                        n.outer, n.holes, n.open, n.corners, n.area, n.length, remarks(report.sections[i], n, style));
    open += n.open != 0;
  }
  text += inexact_remark(inexact, report.planes.size(), "planes");
  if (open != 0)
    text += fmt::format(
        "{} of {} sections are open: the mesh has holes there, or triangles wound against each other; 'plumb check' "
        "tells.\n",
        open, report.planes.size());
  return text;
}

int run_section(const SectionOptions& options) {
  if (options.meshes.words.size() != 1) throw Error("section: one MESH is needed; 'plumb section --help' explains");
  if (options.planes.empty()) throw Error("section: a --plane is needed, such as --plane z=1.5");
  OutputFiles outputs(options.meshes.words);
  outputs.promise("--svg", options.svg);
  outputs.promise("--dxf", options.dxf);
  outputs.promise("--json", options.json);
  if (options.out) require_report_folder(*options.out, "section", {"section-0001.svg"});
  const SectionReport report = report_of(options);
  outputs.require_not_read(report.load.files_beside);
  if (!outputs.on_standard_output()) say(section_text(report, Style(stdout)));
  if (options.svg) outputs.write("--svg", section_svg(report));
  if (options.dxf) outputs.write("--dxf", section_dxf(report));
  if (options.json) outputs.write("--json", json_text(section_json(report)));
  if (options.out) {
    std::vector<NamedText> files;
    for (std::size_t i = 0; i < report.planes.size(); ++i)
      files.push_back({fmt::format("section-{:04}.svg", i + 1), section_svg(report, i)});
    write_report(*options.out, "section", std::move(files), outputs.keep_streams());
  } else {
    outputs.keep();
  }
  return 0;
}

}  // namespace plumb::tool
