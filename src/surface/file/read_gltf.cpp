// glTF and GLB: the meshes of a scene's nodes, each placed by its node and the nodes above it.
//
// Source: glTF 2.0 (ISO/IEC 12113), 3.5 (scenes and nodes), 3.7.2 (meshes).
#include <array>
#include <map>
#include <string>
#include <vector>

#include "surface/file/assembly.hpp"
#include "surface/file/gltf_document.hpp"

namespace plumb::surface {
namespace {

using Json = GltfDocument::Json;

std::string at(const char* list, std::uint64_t index) {
  std::string text(list);
  return text.append("[").append(std::to_string(index)).append("]");
}

class GltfScene {
 public:
  explicit GltfScene(Parse& parse) : parse_(parse), assembly_(parse), document_(parse, assembly_) {}

  void read() {
    parse_.report.unit = "meter";
    reached_.resize(document_.size("nodes"));
    const Json& root = document_.root();
    if (document_.size("scenes") != 0) {
      const std::uint64_t scene = document_.whole(root, "scene", "scene", 0);
      walk(document_.element("scenes", scene, "scene"), "nodes", at("scenes", scene), Placement(), 0);
    } else {
      for (const std::uint64_t node : roots()) take(node, "nodes", Placement(), 0);
    }
  }

 private:
  [[noreturn]] void fail(MeshFileProblem problem, const std::string& where, const std::string& text) const {
    document_.fail(problem, where, text);
  }

  /// Nodes that are no node's child.
  std::vector<std::uint64_t> roots() const {
    std::vector<bool> child(document_.size("nodes"));
    for (std::uint64_t n = 0; n < child.size(); ++n)
      for (const std::uint64_t c : list(document_.element("nodes", n, "nodes"), "children", at("nodes", n)))
        if (c < child.size()) child[c] = true;
    std::vector<std::uint64_t> roots;
    for (std::uint64_t n = 0; n < child.size(); ++n)
      if (!child[n]) roots.push_back(n);
    return roots;
  }

  std::vector<std::uint64_t> list(const Json& of, const char* key, const std::string& where) const {
    std::vector<std::uint64_t> numbers;
    const auto found = of.find(key);
    if (found == of.end()) return numbers;
    bool good = found->is_array();
    for (const Json& x : *found) {
      good = good && x.is_number_unsigned();
      if (good) numbers.push_back(x.get<std::uint64_t>());
    }
    if (!good) fail(MeshFileProblem::syntax, where, std::string(key) + " is no list of whole numbers; export it again");
    return numbers;
  }

  void walk(const Json& of, const char* key, const std::string& where, const Placement& outer, std::size_t depth) {
    for (const std::uint64_t node : list(of, key, where)) take(node, where, outer, depth);
  }

  void take(std::uint64_t index, const std::string& named_by, const Placement& outer, std::size_t depth) {
    const std::string where = at("nodes", index);
    const Json& node = document_.element("nodes", index, named_by);
    if (reached_[index])
      fail(MeshFileProblem::syntax, where,
           "is reached twice (" + in_quotes(name_of(node, index)) + "), expected a tree of nodes; export it again");
    reached_[index] = true;
    if (depth == deepest_part)
      fail(MeshFileProblem::unsupported, where,
           "lies in " + std::to_string(deepest_part) + " others, expected fewer; flatten the nodes");
    if (const auto extensions = node.find("extensions");
        extensions != node.end() && extensions->is_object() && extensions->contains("EXT_mesh_gpu_instancing"))
      fail(MeshFileProblem::unsupported, where, "has EXT_mesh_gpu_instancing, which is not read; bake the instances");
    const Placement placement = outer * placement_of(node, where);
    if (node.contains("mesh"))
      parse_.read_part(name_of(node, index), [&] { place(document_.whole(node, "mesh", where), where, placement); });
    walk(node, "children", where, placement, depth + 1);
  }

  /// The node's name, or that of its mesh, or its number.
  std::string name_of(const Json& node, std::uint64_t index) const {
    const auto named = [](const Json& of) {
      const auto name = of.find("name");
      return name != of.end() && name->is_string() ? name->get<std::string>() : std::string();
    };
    std::string name = named(node);
    const auto mesh = node.find("mesh");
    if (name.empty() && mesh != node.end() && mesh->is_number_unsigned() &&
        mesh->get<std::uint64_t>() < document_.size("meshes"))
      name = named(document_.element("meshes", mesh->get<std::uint64_t>(), at("nodes", index)));
    return name.empty() ? at("nodes", index) : name;
  }

  Placement placement_of(const Json& node, const std::string& where) const {
    if (const auto m = document_.numbers<16>(node, "matrix", where)) {  // column after column
      const auto& x = *m;
      if (x[3] != 0 || x[7] != 0 || x[11] != 0 || x[15] != 1)
        fail(MeshFileProblem::unsupported, where, "has a matrix that is not affine, expected a last row 0 0 0 1");
      return Placement({{{x[0], x[4], x[8], x[12]}, {x[1], x[5], x[9], x[13]}, {x[2], x[6], x[10], x[14]}}});
    }
    const auto move = document_.numbers<3>(node, "translation", where);
    const auto turn = document_.numbers<4>(node, "rotation", where);
    const auto scale = document_.numbers<3>(node, "scale", where);
    if (!move && !turn && !scale) return {};
    return Placement(move.value_or(std::array<double, 3>{}), turn.value_or(std::array<double, 4>{0, 0, 0, 1}),
                     scale.value_or(std::array<double, 3>{1, 1, 1}));
  }

  void place(std::uint64_t index, const std::string& named_by, const Placement& placement) {
    const Json& mesh = document_.element("meshes", index, named_by);
    const std::string where = at("meshes", index);
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array())
      fail(MeshFileProblem::syntax, where, "has no list of primitives; export it again");
    std::map<std::uint64_t, Vertices> placed;  // primitives may have their points in common
    bool any = false;
    for (std::size_t p = 0; p < primitives->size(); ++p)
      any = add((*primitives)[p], where + "." + at("primitives", p), placement, placed) || any;
    parse_.report.parts += any;
  }

  struct Vertices {
    std::uint32_t first;
    std::uint64_t count;
  };

  /// False for points and lines, which are no surface.
  bool add(const Json& primitive, const std::string& where, const Placement& placement,
           std::map<std::uint64_t, Vertices>& placed) {
    if (!primitive.is_object()) fail(MeshFileProblem::syntax, where, "is no object; export it again");
    if (const auto e = primitive.find("extensions");
        e != primitive.end() && e->is_object() && e->contains("KHR_draco_mesh_compression"))
      fail(
          MeshFileProblem::unsupported, where,
          "is packed by Draco (KHR_draco_mesh_compression), which is not read; unpack it with `gltf-transform copy` or "
          "`gltf-pipeline`");
    constexpr std::uint64_t triangles = 4, fan = 6;  // between them strips
    const std::uint64_t mode = document_.whole(primitive, "mode", where, triangles);
    if (mode > fan)
      fail(MeshFileProblem::syntax, where, "has mode " + std::to_string(mode) + ", expected 0 to 6; export it again");
    if (mode < triangles) return false;
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object() || !attributes->contains("POSITION")) return false;
    const std::uint64_t accessor = document_.whole(*attributes, "POSITION", where + ".attributes");
    auto known = placed.find(accessor);
    if (known == placed.end()) {
      const auto points = document_.points(accessor, where);
      known = placed.emplace(accessor, Vertices{assembly_.place(points, placement, where), points.size()}).first;
    }
    const Vertices vertices = known->second;
    std::vector<std::uint32_t> corners;
    if (primitive.contains("indices")) {
      corners = document_.indices(document_.whole(primitive, "indices", where), where);
    } else {
      assembly_.charge(vertices.count, sizeof(std::uint32_t));
      for (std::uint64_t i = 0; i < vertices.count; ++i) corners.push_back(static_cast<std::uint32_t>(i));
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (corners[i] >= vertices.count)
        fail(MeshFileProblem::bad_index, where,
             "has index " + std::to_string(corners[i]) + " at place " + std::to_string(i) + ", expected less than " +
                 std::to_string(vertices.count) + ", the number of positions; export it again");
    if (mode == triangles && corners.size() % 3 != 0)
      fail(MeshFileProblem::syntax, where,
           "has " + std::to_string(corners.size()) + " corners, expected three for each triangle; export it again");
    assembly_.add(mode == triangles ? in_threes(corners) : turned(corners, mode == fan), vertices.first, placement);
    return true;
  }

  static std::vector<TriangleMesh::Triangle> in_threes(const std::vector<std::uint32_t>& c) {
    std::vector<TriangleMesh::Triangle> all;
    for (std::size_t i = 0; i + 2 < c.size(); i += 3) all.push_back({c[i], c[i + 1], c[i + 2]});
    return all;
  }

  // Of a strip or fan; one that names a vertex twice is a turn of the strip, and no surface.
  std::vector<TriangleMesh::Triangle> turned(const std::vector<std::uint32_t>& c, bool fan) {
    std::vector<TriangleMesh::Triangle> all;
    for (std::size_t i = 0; i + 2 < c.size(); ++i) {
      const auto t = fan ? TriangleMesh::Triangle{c[i + 1], c[i + 2], c[0]}
                         : TriangleMesh::Triangle{c[i], c[i + 1 + i % 2], c[i + 2 - i % 2]};
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
        ++parse_.report.dropped_faces;
      } else {
        all.push_back(t);
      }
    }
    return all;
  }

  Parse& parse_;
  Assembly assembly_;
  GltfDocument document_;
  std::vector<bool> reached_;
};

}  // namespace

void parse_gltf(Parse& parse) {
  try {
    GltfScene(parse).read();
  } catch (const Json::exception& e) {  // a member that is of another type than it should be
    fail_at_file(MeshFileProblem::syntax, parse.file,
                 "the glTF is not as expected (" + in_quotes(e.what()) + "); export it again");
  }
}

}  // namespace plumb::surface
