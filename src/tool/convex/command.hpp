// `plumb convex`: how do the convex hulls of these two meshes lie, how far are they apart or how deep in one another, and
// what proves it?  GJK, penetration depth, certificates.
//
// Laws: (1) text, JSON, certificate and history tell of the same hulls: those of all vertices of either file, whose numbers
// are the file's, from 0, the least of equal ones.  (2) The certificate was verified before it is written, and
// docs/verify_certificate.py reads it.  (3) The history's frames are the simplices of the search, one a file, and one page of
// all.  Exit code 0 when done, however they lie; a mesh that cannot be read or has no vertex, an output that cannot be written
// throw Error.
// Source: RTCD 9.5; plumb/query/gjk/gjk.hpp, plumb/query/certificate/certificate.hpp, plumb/query/penetration/penetration.hpp.
// Cost: that of the hulls, and of rationals for the certificate.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/certificate/certificate.hpp"
#include "plumb/query/gjk/gjk.hpp"
#include "plumb/query/penetration/penetration.hpp"
#include "tool/mesh/asked_mesh.hpp"
#include "tool/terminal/terminal.hpp"
#include "tool/terminal/write_folder.hpp"

namespace plumb::tool {

struct ConvexOptions {
  MeshArguments meshes;                                   // two files
  std::optional<std::string> json, certificate, history;  // "-" is standard output; the last is a folder
};

int run_convex(const ConvexOptions& options);

/// The hull of a file's vertices.
struct HullOfMesh {
  AskedMesh asked;
  Hull3 hull;
  std::vector<Point3> corners;     // of the hull: number i is vertex hull.vertices[i] of the file
  ConvexPolyhedron3 solid;         // of them, where the hull is not flat
  std::optional<std::string> why;  // the mesh is no boundary of its hull, and what is wrong; nothing: it is

  explicit HullOfMesh(AskedMesh mesh);
  [[nodiscard]] bool is_solid() const { return hull.dimension == 3; }
};

struct ConvexReport {
  std::vector<HullOfMesh> hulls;  // a, b
  Certificate proof;
  GjkAnswer nearest;
  std::vector<GjkStep> steps;
  std::optional<Penetration> penetration;  // where they overlap or touch
  bool is_parted = false;                  // exactly, though they overlap: what is flat, in one plane
};

ConvexReport convex_report(std::vector<AskedMesh> meshes);

std::string convex_text(const ConvexReport& report, const Style& style);
nlohmann::json convex_json(const ConvexReport& report);
/// For docs/verify_certificate.py.
std::string convex_certificate(const ConvexReport& report);
/// bodies.obj, step-001.obj and so on, index.html.
std::vector<NamedText> convex_history(const ConvexReport& report);

/// The file's numbers of the corners of one of the two (0, 1) that the nearest points lie between, ascending.
std::vector<std::uint32_t> nearest_corners(const ConvexReport& report, std::size_t which);

/// f(a, b) of the two bodies: polyhedra where they are solid, hulls of their corners where they are flat.
template <class F>
auto with_bodies(const ConvexReport& report, F f) {
  const HullOfMesh &a = report.hulls[0], &b = report.hulls[1];
  const VertexHull3 flat_a{a.corners}, flat_b{b.corners};
  if (a.is_solid()) return b.is_solid() ? f(a.solid, b.solid) : f(a.solid, flat_b);
  return b.is_solid() ? f(flat_a, b.solid) : f(flat_a, flat_b);
}

}  // namespace plumb::tool
