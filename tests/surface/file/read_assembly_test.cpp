// Are the parts of a file those that it names, each with its own faces, and is one that cannot be read told by its name?
#include "plumb/surface/file/read_assembly.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "surface/file/packages.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> names_of(const AssemblyParts& parts) {
  std::vector<std::string> names;
  for (const AssemblyPart& p : parts.parts) names.push_back(p.name);
  return names;
}

using Corners = std::array<Point3, 3>;
std::vector<Corners> corners_of(const TriangleMesh& mesh) {
  std::vector<Corners> all;
  for (const auto& [a, b, c] : mesh.triangles) all.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  return all;
}

/// Together they are the mesh, face after face.
void expect_whole(const AssemblyParts& parts, const TriangleMesh& mesh) {
  std::vector<Corners> all;
  for (const AssemblyPart& p : parts.parts) {
    const auto own = corners_of(p.mesh);
    all.insert(all.end(), own.begin(), own.end());
    EXPECT_FALSE(own.empty());
  }
  EXPECT_EQ(all, corners_of(mesh));
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";

TEST(ReadAssembly, TakesObjectsOfAnObj) {
  const std::string text = square + "o base plate\ng left\nf 1 2 3 4\ng right\nf 1 2 5\no lid\nf 2 3 5\no empty\n";
  const AssemblyParts parts = parse_assembly(text, "box.obj");
  EXPECT_THAT(names_of(parts), ElementsAre("base plate", "lid"));
  EXPECT_EQ(parts.parts[0].mesh.triangles.size(), 3U);
  EXPECT_EQ(parts.parts[0].mesh.vertices.size(), 5U);
  EXPECT_EQ(parts.parts[1].mesh.vertices.size(), 3U);
}

TEST(ReadAssembly, TakesGroupsWhereThereAreNoObjects) {
  const AssemblyParts parts =
      parse_assembly(square + "f 1 2 3\ng a\nf 1 2 5\ng b\nf 2 3 5\ng a\nf 3 4 5\n", "x/box.obj");
  EXPECT_THAT(names_of(parts), ElementsAre("box", "a", "b"));
  EXPECT_EQ(parts.parts[1].mesh.triangles.size(), 2U);  // what is named again goes on
}

TEST(ReadAssembly, TakesOtherFilesWhole) {
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_THAT(names_of(parse_assembly(off, "some/where/lid.off")), ElementsAre("lid"));
  EXPECT_THROW((void)parse_assembly("OFF\n3 1 0\n0 0 0\n", "lid.off"), MeshFileError);
}

json scene() {
  return json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"name": "arm", "children": [1, 2, 3]}, {"name": "bolt", "mesh": 0, "translation": [1, 0, 0]},
              {"name": "nut", "mesh": 1}, {"mesh": 0, "scale": [-1, 1, 1]}],
    "meshes": [{"name": "cylinder", "primitives": [{"attributes": {"POSITION": 0}}]},
               {"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36}]})");
}
std::string text_of(json d) {
  std::string bytes;
  for (const float f : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) bytes += surface_test::raw(f);
  d["buffers"][0]["uri"] = "data:application/octet-stream;base64," + surface_test::base64(bytes);
  return d.dump();
}

TEST(ReadAssembly, TakesNodesOfAGltf) {
  const std::string text = text_of(scene());
  const AssemblyParts parts = parse_assembly(text, "arm.gltf");
  EXPECT_THAT(names_of(parts), ElementsAre("bolt", "nut", "cylinder"));
  EXPECT_EQ(parts.parts[0].mesh.vertices[0], (Point3{1, 0, 0}));
  const PolygonMesh whole = parse_mesh(text, std::string("arm.gltf"));
  TriangleMesh mesh{whole.vertices, {}};
  for (std::size_t f = 0; f + 1 < whole.first.size(); ++f)
    mesh.triangles.push_back({whole.corners[3 * f], whole.corners[3 * f + 1], whole.corners[3 * f + 2]});
  expect_whole(parts, mesh);
}

TEST(ReadAssembly, LeavesOutANodeThatCannotBeRead) {
  json bad = scene();
  bad["meshes"][1]["primitives"][0]["attributes"]["POSITION"] = 7;
  const AssemblyParts parts = parse_assembly(text_of(bad), "arm.gltf");
  EXPECT_THAT(names_of(parts), ElementsAre("bolt", "cylinder"));
  ASSERT_EQ(parts.unread.size(), 1U);
  EXPECT_EQ(parts.unread[0].name, "nut");
  EXPECT_THAT(parts.unread[0].why, HasSubstr("accessors[7]"));
  EXPECT_THROW((void)parse_mesh(text_of(bad), std::string("arm.gltf")), MeshFileError);
}

TEST(ReadAssembly, NamesANodeThatIsItsOwnChild) {
  json bad = scene();
  bad["nodes"][2]["children"] = {0};
  try {
    (void)parse_assembly(text_of(bad), "arm.gltf");
    ADD_FAILURE() << "it was read";
  } catch (const MeshFileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("nodes[0] is reached twice (\"arm\")"));
  }
}

TEST(ReadAssembly, TakesItemsOfA3mf) {
  const std::string mesh =
      "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/></vertices>"
      "<triangles><triangle v1='0' v2='1' v3='2'/></triangles></mesh></object>";
  const std::string bad =
      "<object id='3' name='lid'><mesh><vertices/><triangles><triangle v1='0' v2='1' v3='2'/>"
      "</triangles></mesh></object>";
  const std::string package = surface_test::package_of(surface_test::model_of(
      "<object id='1' name='bolt'>" + mesh + "<object id='2'>" + mesh + bad,
      "<item objectid='1'/><item objectid='1' transform='1 0 0 0 1 0 0 0 1 5 0 0'/><item objectid='2'/>"
      "<item objectid='3'/>"));
  const AssemblyParts parts = parse_assembly(package, "box.3mf");
  EXPECT_THAT(names_of(parts), ElementsAre("bolt", "bolt", "object 2"));
  EXPECT_EQ(parts.parts[1].mesh.vertices[0], (Point3{5, 0, 0}));
  ASSERT_EQ(parts.unread.size(), 1U);
  EXPECT_EQ(parts.unread[0].name, "lid");
}

}  // namespace
}  // namespace plumb
