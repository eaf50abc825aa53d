#include "tool/csg/tree.hpp"

#include <filesystem>
#include <map>
#include <utility>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "tool/boolean/command.hpp"
#include "tool/csg/facets.hpp"

namespace plumb::tool {
namespace {

using surface::Placement;

enum class CsgOperation { unite, intersect, subtract, differ };

class CsgBuilder {
 public:
  CsgBuilder(const std::string& text, const ReadOptions& reading, OutputFiles& outputs)
      : text_(text), reading_(reading), outputs_(outputs) {}

  std::optional<Csg3> united(const std::vector<CsgCall>& calls, const Placement& at) {
    return combined(CsgOperation::unite, calls, at);
  }
  CsgScene take(std::optional<Csg3> tree) { return {std::move(tree), std::move(imported_), placed_}; }

 private:
  [[noreturn]] void fail(const CsgCall& call, const std::string& text) const {
    fail_at(text_, call.line, call.name + ": " + text);
  }

  /// Nothing is an empty solid.
  std::optional<Csg3> combined(CsgOperation operation, const std::vector<CsgCall>& calls, const Placement& at) {
    std::optional<Csg3> all;
    for (std::size_t i = 0; i < calls.size(); ++i) {
      std::optional<Csg3> next = made(calls[i], at);
      if (i == 0) {
        all = std::move(next);
      } else if (operation == CsgOperation::intersect) {
        all = all && next ? std::optional(std::move(*all) & *next) : std::nullopt;
      } else if (operation == CsgOperation::subtract) {
        if (all && next) all = std::move(*all) - *next;
      } else if (!all) {
        all = std::move(next);
      } else if (next) {
        all = operation == CsgOperation::unite ? std::move(*all) | *next : (*all - *next) | (*next - *all);
      }
    }
    return all;
  }

  std::optional<Csg3> made(const CsgCall& call, const Placement& at) {
    const std::string& name = call.name;
    if (name == "union" || name == "group" || name == "color" || name == "render" || name == "root")
      return united(call.children, at);
    if (name == "intersection") return combined(CsgOperation::intersect, call.children, at);
    if (name == "difference") return combined(CsgOperation::subtract, call.children, at);
    if (name == "symmetric_difference") return combined(CsgOperation::differ, call.children, at);
    if (const auto map = map_of(call)) return united(call.children, at * *map);
    if (name == "hull") return leaf(call, hull_of(call, at));
    if (const auto mesh = mesh_of(call)) {
      if (!call.children.empty()) fail(call, "is a solid and has no children");
      return leaf(call, placed(call, *mesh, at));
    }
    refuse(call);
  }

  [[noreturn]] void refuse(const CsgCall& call) const {
    static const std::map<std::string, std::string> known{
        {"minkowski", "sums of solids are not made"},
        {"linear_extrude", "what is extruded is not read; import it as a mesh"},
        {"rotate_extrude", "what is turned about an axis is not read; import it as a mesh"},
        {"square", "flat shapes bound nothing"},
        {"circle", "flat shapes bound nothing"},
        {"polygon", "flat shapes bound nothing"},
        {"text", "flat shapes bound nothing"},
        {"surface", "height fields are not read; import them as meshes"},
        {"projection", "flat shapes bound nothing"},
        {"offset", "flat shapes bound nothing"},
        {"resize", "is not known to be exact; use scale or multmatrix"},
        {"rotate", "a turn has no exact matrix of doubles; use multmatrix"},
        {"module", "the language is not run; let OpenSCAD export the text ('openscad -o out.csg in.scad')"},
        {"for", "the language is not run; let OpenSCAD export the text ('openscad -o out.csg in.scad')"}};
    const auto found = known.find(call.name);
    fail(call,
         found != known.end() ? found->second : "is no solid or operation that is known; 'plumb csg --help' has all");
  }

  std::optional<Placement> map_of(const CsgCall& call) const {
    Placement::Rows rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    if (call.name == "multmatrix") {
      const CsgArguments arguments(call, text_, {"m"});
      const auto given = arguments.rows("m", 4, 4);
      if (given.size() != 3 && given.size() != 4) fail(call, "the matrix has not 4 rows");
      if (given.size() == 4 && given[3] != std::vector<double>{0, 0, 0, 1})
        fail(call, "the last row of the matrix is not [0, 0, 0, 1]");
      for (std::size_t r = 0; r < 3; ++r) std::copy(given[r].begin(), given[r].end(), rows[r].begin());
    } else if (call.name == "translate" || call.name == "scale") {
      const CsgArguments arguments(call, text_, {"v"});
      const CsgValue* const v = arguments.find("v");
      if (v == nullptr) fail(call, "by what is not said");
      const std::vector<double> by = arguments.numbers(*v, "v");
      if (by.size() != 3) fail(call, "v is not three numbers");
      for (std::size_t r = 0; r < 3; ++r) rows[r][call.name == "scale" ? r : 3] = by[r];
    } else {
      return {};
    }
    return Placement(rows);
  }

  std::optional<TriangleMesh> mesh_of(const CsgCall& call) {
    if (call.name == "cube") return triangulate(mesh_of_cube(call, text_));
    if (call.name == "polyhedron") return triangulate(mesh_of_polyhedron(call, text_));
    if (call.name == "cylinder") return triangulate(mesh_of_cylinder(call, text_));
    if (call.name == "sphere") return triangulate(mesh_of_sphere(call, text_));
    if (call.name == "import") return imported(call);
    return {};
  }

  TriangleMesh imported(const CsgCall& call) {
    const CsgArguments arguments(call, text_, {"file"});
    const CsgValue* const value = arguments.find("file");
    const std::string* const named = value != nullptr ? std::get_if<std::string>(&value->is) : nullptr;
    if (named == nullptr || named->empty()) fail(call, "the file is not named");
    if (text_ == name_of_input("-")) fail(call, "a text of standard input has no folder to find files from");
    const std::string file = (std::filesystem::path(text_).parent_path() / *named).string();
    if (file == "-") fail(call, "a mesh is read from a file");
    outputs_.require_not_read({file});
    LoadReport load;
    const PolygonMesh polygons = read_input(file, &load, reading_);
    imported_.push_back(asked_mesh(file, polygons, std::move(load), outputs_));
    complain_of_inside_out(imported_.back(), "");
    return imported_.back().mesh;
  }

  TriangleMesh placed(const CsgCall& call, TriangleMesh mesh, const Placement& at) {
    if (at.is_identity()) return mesh;
    for (Point3& p : mesh.vertices) {
      const auto image = at(p, placed_);
      if (!image) fail(call, "a corner is beyond all doubles under its matrices");
      p = *image;
    }
    if (at.mirrors())
      for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
  }

  TriangleMesh hull_of(const CsgCall& call, const Placement& at) {
    std::vector<Point3> points;
    for (const CsgCall& child : call.children) put_points(child, at, points);
    const Hull3 hull = convex_hull(points);
    if (hull.dimension < 3) return {};
    return triangulate(convex_polyhedron(hull, points).mesh);
  }
  void put_points(const CsgCall& call, const Placement& at, std::vector<Point3>& points) {
    if (const auto mesh = mesh_of(call)) {
      const TriangleMesh image = placed(call, *mesh, at);
      for (const auto& t : image.triangles)
        for (const std::uint32_t v : t) points.push_back(image.vertices[v]);
      return;
    }
    const auto map = map_of(call);
    if (!map && call.name != "union" && call.name != "group" && call.name != "color" && call.name != "hull")
      fail(call, "in a hull, solids are united and placed, no more");
    for (const CsgCall& child : call.children) put_points(child, map ? at * *map : at, points);
  }

  Csg3 leaf(const CsgCall& call, TriangleMesh mesh) {
    try {
      return csg(std::move(mesh));
    } catch (const UnbalancedEdge& e) {
      const std::string mend = call.name == "import" && !imported_.empty()
                                   ? "; run 'plumb repair " + printable(imported_.back().name) + " -o MENDED' first"
                                   : "";
      fail(call, unbalanced_text(e) + mend);
    }
  }

  const std::string& text_;
  const ReadOptions& reading_;
  OutputFiles& outputs_;
  std::vector<AskedMesh> imported_;
  surface::Placed placed_;
};

}  // namespace

CsgScene scene_of(const std::vector<CsgCall>& calls, const std::string& text, const ReadOptions& reading,
                  OutputFiles& outputs) {
  CsgBuilder builder(text, reading, outputs);
  std::optional<Csg3> tree = builder.united(calls, Placement());
  return builder.take(std::move(tree));
}

}  // namespace plumb::tool
