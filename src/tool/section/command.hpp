// `plumb section`: where do these planes cut this mesh, as pictures, drawings and numbers?
//
// Laws: text, SVG, DXF and JSON hold the same contours, in the order of the planes as given.  Exit code 0 when done,
// also where nothing is cut or contours are open; a mesh or words that cannot be read, a plane without a normal, an
// output that cannot be written throw Error.
// Source: plumb/surface/section/section.hpp.
// Cost: that of sections.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/section/section.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/section/plane_words.hpp"
#include "tool/section/view.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct SectionOptions {
  MeshArguments meshes;  // one file
  std::vector<std::string> planes;
  std::optional<std::string> svg, dxf, json, out;  // "-" is standard output
  bool below = false;                              // vertices in a plane count as below it
};

int run_section(const SectionOptions& options);

/// The sections of a mesh, with the corners as they are drawn.
struct SectionReport {
  std::string mesh_name;
  LoadReport load;
  TriangleMesh mesh;
  std::vector<NamedPlane> planes;
  std::vector<Section> sections;                        // one for each plane
  std::vector<std::vector<std::vector<Point2>>> drawn;  // of each section's contours, in the coordinates of its view
  std::vector<std::vector<ContourMeasures>> measured;   // likewise
};

std::string section_text(const SectionReport& report, const Style& style);
nlohmann::json section_json(const SectionReport& report);

/// A layer a plane, the first at the bottom.
std::string section_svg(const SectionReport& report);
/// The same of one plane, all of a size.
std::string section_svg(const SectionReport& report, std::size_t plane);

/// AutoCAD R12: each contour a polyline, closed where it is, on a layer of its plane; in the mesh's coordinates.
std::string section_dxf(const SectionReport& report);

}  // namespace plumb::tool
