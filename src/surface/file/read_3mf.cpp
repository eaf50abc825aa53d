// 3MF: a zip archive of XML parts.  The build's items name objects, which are meshes or made of other objects, each
// placed by a transform.
//
// Source: 3MF Core Specification 1.3; 3MF Production Extension 1.1 (objects in parts of their own).
#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "surface/file/assembly.hpp"
#include "surface/file/zip_archive.hpp"

namespace plumb::surface {
namespace {

using pugi::xml_node;

std::string_view local_name(const char* name) {
  const std::string_view whole(name);
  return whole.substr(whole.find(':') + 1);  // npos + 1 is 0
}

xml_node child(const xml_node& of, std::string_view name) {
  return of.find_child([name](const xml_node& n) { return local_name(n.name()) == name; });
}

std::string_view attribute(const xml_node& of, std::string_view name) {
  return of.find_attribute([name](const pugi::xml_attribute& a) { return local_name(a.name()) == name; }).value();
}

/// A part of the package that holds a model.
struct Model {
  std::string path, text;  // the document lies in its text
  pugi::xml_document document;
  std::map<std::string_view, xml_node> objects;
};

struct ObjectMesh {
  std::vector<Point3> vertices;
  std::vector<TriangleMesh::Triangle> triangles;
};

class Package {
 public:
  explicit Package(Parse& parse) : parse_(parse), zip_(parse.bytes, parse.file, parse.limit), assembly_(parse) {}

  void read() {
    const Model& root = model(start_part());
    const xml_node top = child(root.document, "model");
    parse_.report.unit = unit_of(top);
    for (const xml_node& item : child(top, "build").children()) {
      if (local_name(item.name()) == "item") place(root, item, Placement(), "item of the build");
    }
  }

 private:
  [[noreturn]] void fail(MeshFileProblem problem, const Model& in, const std::string& text) const {
    fail_at_file(problem, parse_.file, in_quotes(in.path) + ": " + text);
  }

  std::string start_part() {
    const auto names = zip_.entry("_rels/.rels");
    const char* const mend = "; is this a 3MF file, or a zip archive of meshes to be unpacked?";
    if (!names)
      fail_at_file(MeshFileProblem::syntax, parse_.file,
                   std::string("the zip archive holds no \"_rels/.rels\", expected the parts of a 3MF") + mend);
    pugi::xml_document relations;
    require_room(*names, "_rels/.rels");
    if (!relations.load_buffer(names->data(), names->size(), pugi::parse_minimal | pugi::parse_escapes))
      fail_at_file(MeshFileProblem::syntax, parse_.file, "\"_rels/.rels\" is no XML; export it again");
    for (const xml_node& r : child(relations, "Relationships").children())
      if (attribute(r, "Type").ends_with("/3dmodel")) return without_slash(attribute(r, "Target"));
    fail_at_file(MeshFileProblem::syntax, parse_.file,
                 std::string("\"_rels/.rels\" names no 3D model, expected one of the type .../3dmodel") + mend);
  }

  static std::string without_slash(std::string_view path) {
    return std::string(path.starts_with('/') ? path.substr(1) : path);
  }

  // An element takes a '<' and an attribute a '=': more memory than these take, the document will not.
  void require_room(std::string_view text, std::string_view path) const {
    constexpr std::uint64_t element = 144, attribute = 48;  // and text before an element is a node, too
    const auto count = [&](char c) { return static_cast<std::uint64_t>(std::count(text.begin(), text.end(), c)); };
    if (count('<') * element + count('=') * attribute > parse_.limit)
      fail_at_file(MeshFileProblem::too_large, parse_.file,
                   in_quotes(path) + ": its elements take more than " + std::to_string(parse_.limit) +
                       " bytes, expected no more; raise the limit if you trust it");
  }

  const Model& model(const std::string& path) {
    const auto known = models_.find(path);
    if (known != models_.end()) return known->second;
    auto text = zip_.entry(path);
    Model& m = models_[path];
    m.path = path;
    if (!text) fail(MeshFileProblem::syntax, m, "this part is named but not in the archive; export it again");
    m.text = std::move(*text);
    require_room(m.text, path);
    const auto parsed =
        m.document.load_buffer_inplace(m.text.data(), m.text.size(), pugi::parse_minimal | pugi::parse_escapes);
    if (!parsed)
      fail(MeshFileProblem::syntax, m,
           "no XML at byte " + std::to_string(parsed.offset) + " (" + parsed.description() + "); export it again");
    const xml_node top = child(m.document, "model");
    if (!top) fail(MeshFileProblem::syntax, m, "its root is not <model>, expected a 3MF model; export it again");
    for (const xml_node& object : child(top, "resources").children()) {
      if (local_name(object.name()) != "object") continue;
      const std::string_view id = attribute(object, "id");
      if (!m.objects.emplace(id, object).second)
        fail(MeshFileProblem::syntax, m,
             "two objects have the id " + in_quotes(id) + ", expected one; export it again");
    }
    return m;
  }

  std::string_view unit_of(const xml_node& top) const {
    constexpr std::array<std::string_view, 6> units{"micron", "millimeter", "centimeter", "inch", "foot", "meter"};
    const std::string_view named = attribute(top, "unit");
    if (named.empty()) return "millimeter";
    const auto found = std::find(units.begin(), units.end(), named);
    if (found == units.end())
      fail_at_file(MeshFileProblem::syntax, parse_.file,
                   "the unit is " + in_quotes(named) +
                       ", expected micron, millimeter, centimeter, inch, foot or meter; export it again");
    return *found;
  }

  /// What an item or component names, placed where it says within `outer`.
  void place(const Model& in, const xml_node& reference, const Placement& outer, const std::string& who) {
    const std::string_view id = attribute(reference, "objectid"), path = attribute(reference, "path");
    const Model& of = path.empty() ? in : model(without_slash(path));
    const auto object = of.objects.find(id);
    if (object == of.objects.end())
      fail(MeshFileProblem::bad_index, in,
           "an " + who + " names object " + in_quotes(id) + ", which is not there; export it again");
    const xml_node node = object->second;
    const std::string named = "object " + in_quotes(id);
    if (std::find(open_.begin(), open_.end(), node) != open_.end())
      fail(MeshFileProblem::syntax, of, named + " is a component of itself, expected none of that; export it again");
    if (open_.size() == deepest_part)
      fail(MeshFileProblem::unsupported, of,
           named + " lies in " + std::to_string(deepest_part) + " others, expected fewer; flatten the components");
    assembly_.charge(1, sizeof(Placement));
    const Placement placement = outer * transform(in, reference, who);
    if (const xml_node mesh = child(node, "mesh")) {
      const std::string_view called = attribute(node, "name");
      parse_.read_part(called.empty() ? "object " + std::string(id) : std::string(called), [&] {
        const ObjectMesh& m = mesh_of(of, node, mesh, named);
        if (m.triangles.empty()) return;
        ++parse_.report.parts;
        const std::uint32_t first = assembly_.place(m.vertices, placement, in_quotes(of.path) + ": " + named);
        assembly_.add(m.triangles, first, placement);
      });
    }
    open_.push_back(node);
    for (const xml_node& component : child(node, "components").children())
      if (local_name(component.name()) == "component") place(of, component, placement, "component of " + named);
    open_.pop_back();
  }

  // Twelve numbers: the images of the three axes, then of the origin.
  Placement transform(const Model& in, const xml_node& reference, const std::string& who) {
    std::string_view text = attribute(reference, "transform");
    if (text.empty()) return {};
    std::array<double, 12> m{};
    constexpr const char* space = " \t\r\n";
    for (double& x : m) {
      text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
      const std::string_view word = text.substr(0, text.find_first_of(space));
      DecimalReader unreported;  // the report counts coordinates
      if (unreported.read(word, x) != DecimalReader::Outcome::number)
        fail(MeshFileProblem::bad_number, in,
             "the transform of an " + who + " has " + in_quotes(word) + ", expected twelve numbers; export it again");
      text.remove_prefix(word.size());
    }
    if (text.find_first_not_of(space) != std::string_view::npos)
      fail(MeshFileProblem::syntax, in,
           "the transform of an " + who + " goes on with " + in_quotes(text) +
               ", expected twelve numbers; export it again");
    return Placement({{{m[0], m[3], m[6], m[9]}, {m[1], m[4], m[7], m[10]}, {m[2], m[5], m[8], m[11]}}});
  }

  const ObjectMesh& mesh_of(const Model& in, const xml_node& object, const xml_node& mesh, const std::string& named) {
    const auto known = meshes_.find(object.internal_object());
    if (known != meshes_.end()) return known->second;
    ObjectMesh m;  // kept when it is whole
    for (const xml_node& v : child(mesh, "vertices").children()) {
      if (local_name(v.name()) != "vertex") continue;
      Point3& p = m.vertices.emplace_back();
      const auto fill = [&](double& x, const char* axis) {
        const std::string_view text = attribute(v, axis);
        if (parse_.decimals.read(text, x) != DecimalReader::Outcome::number)
          fail(MeshFileProblem::bad_number, in,
               named + ": " + axis + " of vertex " + std::to_string(m.vertices.size() - 1) + " is " + in_quotes(text) +
                   ", expected a number within the doubles; export it again");
      };
      fill(p.x, "x");
      fill(p.y, "y");
      fill(p.z, "z");
    }
    for (const xml_node& t : child(mesh, "triangles").children()) {
      if (local_name(t.name()) != "triangle") continue;
      TriangleMesh::Triangle& corners = m.triangles.emplace_back();
      constexpr std::array<const char*, 3> names{"v1", "v2", "v3"};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string_view text = attribute(t, names[k]);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), corners[k]);
        if (text.empty() || error != std::errc() || end != text.data() + text.size() || corners[k] >= m.vertices.size())
          fail(MeshFileProblem::bad_index, in,
               named + ": " + names[k] + " of triangle " + std::to_string(m.triangles.size() - 1) + " is " +
                   in_quotes(text) + ", expected a number below " + std::to_string(m.vertices.size()) +
                   ", the vertices there are; export it again");
      }
    }
    return meshes_.emplace(object.internal_object(), std::move(m)).first->second;
  }

  Parse& parse_;
  ZipArchive zip_;
  Assembly assembly_;
  std::map<std::string, Model> models_;
  std::map<const void*, ObjectMesh> meshes_;
  std::vector<xml_node> open_;  // the objects that the walk is within
};

}  // namespace

void parse_3mf(Parse& parse) {
  parse.report.encoding = MeshEncoding::ascii;
  Package(parse).read();
}

}  // namespace plumb::surface
