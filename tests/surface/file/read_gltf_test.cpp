// What is read from glTF and GLB: buffers of every kind, primitives, nodes, sparse accessors; and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "plumb/arith/rational.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "surface/file/packages.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using surface_test::base64;
using surface_test::glb_of;
using surface_test::raw;
using testing::HasSubstr;
using testing::StartsWith;
using enum MeshFileProblem;

PolygonMesh read(const std::string& bytes, LoadReport* report = nullptr) {
  return parse_mesh(bytes, std::filesystem::path("part.gltf"), report);
}

void expect_error(const std::string& bytes, MeshFileProblem problem, const std::string& words) {
  try {
    read(bytes);
    ADD_FAILURE() << "it was read, expected " << words;
  } catch (const MeshFileError& e) {
    EXPECT_EQ(e.problem, problem) << e.what();
    EXPECT_THAT(e.what(), StartsWith("part.gltf: "));
    EXPECT_THAT(e.what(), HasSubstr(words));
  }
}

std::string floats(const std::vector<float>& x) {
  std::string bytes;
  for (const float f : x) bytes += raw(f);
  return bytes;
}

template <class Int>
std::string integers(const std::vector<Int>& x) {
  std::string bytes;
  for (const Int i : x) bytes += raw(i);
  return bytes;
}

/// One mesh of one primitive: accessor 0 has the positions of a tetrahedron, accessor 1 its twelve corners in 16 bits.
const std::vector<float> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.1F};
const std::string tetrahedron_bytes = floats(points) + integers<std::uint16_t>({0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3});

json document() {
  return json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
    "buffers": [{"byteLength": 72}]})");
}

std::string text_of(json d, const std::string& bytes = tetrahedron_bytes) {
  d["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(bytes);
  return d.dump();
}

PolygonMesh expected() {
  PolygonMesh mesh = surface_test::tetrahedron();
  mesh.vertices[3].z = double{0.1F};  // float32 widens exactly
  return mesh;
}

void expect_tetrahedron(const PolygonMesh& mesh) {
  EXPECT_EQ(mesh.vertices, expected().vertices);
  EXPECT_EQ(mesh.corners, expected().corners);
}

TEST(ReadGltf, HoldsTheTetrahedronInEveryKindOfBuffer) {
  LoadReport report;
  expect_tetrahedron(read(text_of(document()), &report));
  EXPECT_EQ(report.format, MeshFormat::gltf);
  EXPECT_EQ(report.encoding, MeshEncoding::ascii);
  EXPECT_EQ(report.unit, "meter");
  EXPECT_EQ(report.parts, 1U);
  EXPECT_EQ(report.transformed, 0U);
  expect_tetrahedron(read(glb_of(document().dump(), tetrahedron_bytes), &report));
  EXPECT_EQ(report.encoding, MeshEncoding::binary_little_endian);
  EXPECT_EQ(format_by_content(text_of(document())), MeshFormat::gltf);
  EXPECT_EQ(format_by_content("{\"program\": \"plumb check\"}"), std::nullopt);  // JSON, but no glTF
  EXPECT_EQ(format_by_extension("a.GLB"), MeshFormat::gltf);
  EXPECT_EQ(format_by_extension("a.gltf"), MeshFormat::gltf);
}

TEST(ReadGltf, ReadsFilesBesideItAndNoOthers) {
  namespace fs = std::filesystem;
  const fs::path root = fs::temp_directory_path() / "plumb_gltf_test", folder = root / "in";
  fs::remove_all(root);
  fs::create_directories(folder / "sub dir");
  const auto put = [](const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  };
  put(folder / "a b.bin", tetrahedron_bytes);
  put(folder / "sub dir" / "c.bin", tetrahedron_bytes);
  put(root / "out.bin", tetrahedron_bytes);
  fs::create_symlink(root / "out.bin", folder / "link.bin");
  const auto problem_of = [&](const std::string& uri) -> std::optional<MeshFileProblem> {
    json d = document();
    d["buffers"][0]["uri"] = uri;
    put(folder / "part.gltf", d.dump());
    try {
      expect_tetrahedron(read_polygon_mesh(folder / "part.gltf"));
    } catch (const MeshFileError& e) {
      EXPECT_THAT(e.what(), HasSubstr("buffers[0] "));
      return e.problem;
    }
    return std::nullopt;
  };
  EXPECT_EQ(problem_of("a%20b.bin"), std::nullopt);
  EXPECT_EQ(problem_of("sub%20dir/c.bin"), std::nullopt);
  EXPECT_EQ(problem_of("./a b.bin"), std::nullopt);
  EXPECT_EQ(problem_of("nothing.bin"), missing);
  EXPECT_EQ(problem_of("sub%20dir"), missing);
  for (const std::string uri : {"../out.bin", "%2e%2e/out.bin", "sub%20dir/../../out.bin", "link.bin",
                                "file:///etc/passwd", "http://example.org/a.bin", "", "a%2", "a%00b", "..\\out.bin"})
    EXPECT_EQ(problem_of(uri), unreadable) << uri;
  EXPECT_EQ(problem_of((root / "out.bin").string()), unreadable);
  // A zero byte would end the name for the system, and so would name another file.
  EXPECT_EQ(problem_of(std::string("a b.bin\0.png", 12)), unreadable);
  EXPECT_EQ(problem_of(std::string("a b.bin\0", 8)), unreadable);
  EXPECT_THROW(read_polygon_mesh((folder / "part.gltf").string() + std::string(1, '\0')), MeshFileError);
  // A file may be longer than the buffer in it, which is all that is read.
  fs::resize_file(folder / "a b.bin", std::uintmax_t{1} << 36);
  EXPECT_EQ(problem_of("a%20b.bin"), std::nullopt);
  fs::resize_file(folder / "a b.bin", 71);
  EXPECT_EQ(problem_of("a%20b.bin"), truncated);
  // What is beside it counts as its own size, by which it is bounded.
  constexpr std::uint64_t many = 1'500'000;
  put(folder / "large.bin", "");
  fs::resize_file(folder / "large.bin", 12 * many);
  json large = document();
  large["buffers"][0] = {{"byteLength", 12 * many}, {"uri", "large.bin"}};
  large["bufferViews"] = {{{"buffer", 0}, {"byteLength", 12 * many}}};
  large["accessors"] = {{{"bufferView", 0}, {"componentType", 5126}, {"count", many}, {"type", "VEC3"}}};
  large["meshes"][0]["primitives"][0].erase("indices");
  put(folder / "part.gltf", large.dump());
  EXPECT_EQ(read_polygon_mesh(folder / "part.gltf").vertices.size(), many);
  fs::remove_all(root);
  json d = document();
  d["buffers"][0]["uri"] = "a.bin";
  expect_error(d.dump(), unreadable, "this glTF has no folder");
}

TEST(ReadGltf, ReadsBuffersUpToTheirLength) {
  for (const std::size_t more : {1U, 3U, 1000U}) {
    const std::string longer = tetrahedron_bytes + std::string(more, 'x');
    expect_tetrahedron(read(text_of(document(), longer)));
    expect_tetrahedron(read(glb_of(document().dump(), longer)));
  }
}

TEST(ReadGltf, TakesIndicesOfEverySizeOrNone) {
  const std::vector<std::uint32_t> corners{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  json d = document();
  d["accessors"][1]["componentType"] = 5121;
  d["bufferViews"][1]["byteLength"] = 12;
  d["buffers"][0]["byteLength"] = 60;
  expect_tetrahedron(
      read(text_of(d, floats(points) + integers(std::vector<std::uint8_t>(corners.begin(), corners.end())))));
  d["accessors"][1]["componentType"] = 5125;
  d["bufferViews"][1]["byteLength"] = 48;
  d["buffers"][0]["byteLength"] = 96;
  expect_tetrahedron(read(text_of(d, floats(points) + integers(corners))));
  d["meshes"][0]["primitives"][0].erase("indices");
  d["accessors"][0]["count"] = 3;
  EXPECT_EQ(read(text_of(d, floats(points) + integers(corners))).corners, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(ReadGltf, CutsStripsAndFansAndPassesOverPointsAndLines) {
  json d = document();
  const auto corners_in = [&](int mode, const std::vector<std::uint16_t>& indices, LoadReport* report = nullptr) {
    d["meshes"][0]["primitives"][0]["mode"] = mode;
    d["accessors"][1]["count"] = indices.size();
    std::string bytes = floats(points) + integers(indices);
    bytes.resize(72);
    return read(text_of(d, bytes), report).corners;
  };
  using Corners = std::vector<std::uint32_t>;
  EXPECT_EQ(corners_in(5, {0, 1, 2, 3, 0}), (Corners{0, 1, 2, 1, 3, 2, 2, 3, 0}));
  EXPECT_EQ(corners_in(6, {0, 1, 2, 3}), (Corners{1, 2, 0, 2, 3, 0}));
  LoadReport report;
  EXPECT_EQ(corners_in(5, {0, 1, 2, 2, 3, 1}, &report), (Corners{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(report.dropped_faces, 2U);
  for (const int mode : {0, 1, 2, 3}) EXPECT_THROW(corners_in(mode, {0, 1, 2}), MeshFileError);  // an empty mesh
  d["meshes"][0]["primitives"][0]["mode"] = 7;
  expect_error(text_of(d), syntax, "meshes[0].primitives[0] has mode 7");
}

TEST(ReadGltf, SharesThePointsOfPrimitivesAndPlacesEveryNode) {
  json d = document();
  d["meshes"][0]["primitives"].push_back(d["meshes"][0]["primitives"][0]);
  d["nodes"] = json::parse(R"([{"mesh": 0, "children": [1]}, {"mesh": 0, "translation": [0, 0, 4]}])");
  LoadReport report;
  const PolygonMesh mesh = read(text_of(d), &report);
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.first.size() - 1, 16U);
  EXPECT_EQ(mesh.vertices[4], (Point3{0, 0, 4}));
  EXPECT_EQ(report.parts, 2U);
  EXPECT_EQ(report.transformed, 12U);
  EXPECT_EQ(report.rounded, 0U);  // 4 plus a float32 is a double
  d.erase("scenes");
  d.erase("scene");
  EXPECT_EQ(read(text_of(d)).vertices.size(), 8U);  // all roots, and what is below them
}

TEST(ReadGltf, RoundsOnceThroughAllNodes) {
  json d = document();
  d["nodes"] = json::parse(R"([
    {"matrix": [0.1, 0.2, 0.3, 0, 0.4, 0.5, 0.6, 0, 0.7, 0.8, 0.9, 0, 10.1, 10.2, 10.3, 1], "children": [1]},
    {"mesh": 0, "translation": [0.1, 0.7, 5], "rotation": [0.1, 0.2, 0.3, 0.927], "scale": [1.1, -0.3, 3]}])");
  LoadReport report;
  const PolygonMesh mesh = read(text_of(d), &report);
  using Row = std::array<Rational, 4>;
  const Rational x(0.1), y(0.2), z(0.3), w(0.927), one(1.0), two(2.0);
  const std::array<Rational, 3> scale{Rational(1.1), Rational(-0.3), Rational(3.0)};
  std::array<Row, 3> inner{
      {{one - two * (y * y + z * z), two * (x * y - z * w), two * (x * z + y * w), Rational(0.1)},
       {two * (x * y + z * w), one - two * (x * x + z * z), two * (y * z - x * w), Rational(0.7)},
       {two * (x * z - y * w), two * (y * z + x * w), one - two * (x * x + y * y), Rational(5.0)}}};
  for (Row& row : inner)
    for (std::size_t j = 0; j < 3; ++j) row[j] = row[j] * scale[j];
  const std::array<std::array<double, 4>, 3> outer{
      {{0.1, 0.4, 0.7, 10.1}, {0.2, 0.5, 0.8, 10.2}, {0.3, 0.6, 0.9, 10.3}}};
  for (std::size_t v = 0; v < 4; ++v) {
    std::array<Rational, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = inner[i][3];
      for (std::size_t j = 0; j < 3; ++j) p[i] = p[i] + inner[i][j] * Rational(double{points[3 * v + j]});
    }
    std::array<double, 3> q{};
    for (std::size_t i = 0; i < 3; ++i) {
      Rational sum(outer[i][3]);
      for (std::size_t j = 0; j < 3; ++j) sum = sum + Rational(outer[i][j]) * p[j];
      q[i] = sum.rounded();
    }
    EXPECT_EQ(mesh.vertices[v], (Point3{q[0], q[1], q[2]}));
  }
  EXPECT_EQ(report.transformed, 12U);
  EXPECT_EQ(report.rounded, 12U);
}

TEST(ReadGltf, ReadsSparseAndStridedAccessors) {
  json d = document();
  // Point 3 is replaced; the bytes follow the indices.
  const std::string bytes = tetrahedron_bytes + raw(std::uint16_t{3}) + std::string(2, '\0') + floats({7, 8, 9});
  d["buffers"][0]["byteLength"] = bytes.size();
  d["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 72}, {"byteLength", 2}});
  d["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 76}, {"byteLength", 12}});
  d["accessors"][0]["sparse"] = {
      {"count", 1}, {"indices", {{"bufferView", 2}, {"componentType", 5123}}}, {"values", {{"bufferView", 3}}}};
  EXPECT_EQ(read(text_of(d, bytes)).vertices[3], (Point3{7, 8, 9}));
  json zeros = d;
  zeros["accessors"][0].erase("bufferView");
  EXPECT_EQ(read(text_of(zeros, bytes)).vertices, (std::vector<Point3>{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {7, 8, 9}}));
  json bad = d;
  bad["accessors"][0]["sparse"]["count"] = 2;
  expect_error(text_of(bad, bytes), bad_index, "accessors[0].sparse.indices has 2 elements, which end beyond");
  bad = d;
  bad["accessors"][0]["count"] = 3;
  expect_error(text_of(bad, bytes), bad_index, "accessors[0].sparse.indices has 3 at place 0");
  bad = d;
  bad["accessors"][0]["sparse"].erase("values");
  expect_error(text_of(bad, bytes), syntax, "accessors[0].sparse has no values");

  json strided = document();
  std::string apart;
  for (std::size_t i = 0; i < 4; ++i) apart += std::string(4, 'x') + tetrahedron_bytes.substr(12 * i, 12);
  apart += tetrahedron_bytes.substr(48);
  strided["bufferViews"][0] = {{"buffer", 0}, {"byteLength", 64}, {"byteStride", 16}};
  strided["bufferViews"][1]["byteOffset"] = 64;
  strided["accessors"][0]["byteOffset"] = 4;
  strided["buffers"][0]["byteLength"] = apart.size();
  expect_tetrahedron(read(text_of(strided, apart)));
}

TEST(ReadGltf, NamesTheElementThatIsWrong) {
  const auto refused = [](const std::string& pointer, const json& value, MeshFileProblem problem,
                          const std::string& words) {
    json d = document();
    d[json::json_pointer(pointer)] = value;
    expect_error(text_of(d), problem, words);
    expect_error(glb_of(d.dump(), tetrahedron_bytes), problem, words);
  };
  refused("/asset/version", "1.0", unsupported, "asset.version is ");
  refused("/scene", 1, bad_index, "scene names scenes[1], but there are 1");
  refused("/scenes/0/nodes/0", 5, bad_index, "scenes[0] names nodes[5], but there are 1");
  refused("/scenes/0/nodes/0", -1, syntax, "scenes[0] nodes is no list of whole numbers");
  refused("/nodes/0/mesh", 1, bad_index, "nodes[0] names meshes[1]");
  refused("/nodes/0/children", {0}, syntax, "nodes[0] is reached twice");
  refused("/nodes/0/matrix", {1, 2}, syntax, "nodes[0] matrix is no list of 16 numbers");
  refused("/nodes/0/matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, unsupported, "not affine");
  refused("/nodes/0/scale", {"1", 1, 1}, syntax, "nodes[0] scale is no list of 3 numbers");
  refused("/nodes/0", {{"mesh", 0}, {"scale", {1e308, 1, 1}}, {"translation", {1e308, 0, 0}}}, bad_number,
          "meshes[0].primitives[0]: its transform takes vertex 1 beyond the largest double");
  refused("/nodes/0/extensions", {{"EXT_mesh_gpu_instancing", json::object()}}, unsupported, "bake the instances");
  refused("/meshes/0/primitives/0/attributes/POSITION", 2, bad_index, "names accessors[2]");
  refused("/meshes/0/primitives/0/extensions", {{"KHR_draco_mesh_compression", json::object()}}, unsupported, "Draco");
  refused("/bufferViews/0/extensions", {{"EXT_meshopt_compression", json::object()}}, unsupported, "bufferViews[0] ");
  refused("/accessors/0/componentType", 5122, unsupported, "accessors[0] ");
  refused("/accessors/0/componentType", 5123, unsupported, "KHR_mesh_quantization");
  refused("/accessors/0/type", "VEC2", unsupported, "accessors[0] ");
  refused("/accessors/0/count", 5, bad_index, "accessors[0] has 5 elements, which end beyond bufferViews[0]");
  refused("/accessors/0/count", 9'000'000'000'000'000ULL, bad_index, "which end beyond bufferViews[0]");
  refused("/accessors/0/count", -3, syntax, "accessors[0] has count");
  refused("/accessors/0/byteOffset", 1, bad_index, "accessors[0] ");
  refused("/accessors/0/byteOffset", 9'000'000'000'000'000ULL, bad_index, "accessors[0] ");
  refused("/accessors/1/componentType", 5126, syntax, "accessors[1] holds no indices");
  refused("/accessors/1/count", 11, syntax, "11 corners, expected three for each triangle");
  refused("/accessors/1/sparse", json::object(), unsupported, "accessors[1] holds sparse indices");
  refused("/bufferViews/0/byteStride", 0, syntax, "bufferViews[0] has a byteStride of 0");
  refused("/bufferViews/0/buffer", 1, bad_index, "buffers[1]");
  refused("/bufferViews/0/byteLength", 73, bad_index, "bufferViews[0] ends beyond its buffer");
  refused("/bufferViews/1/byteOffset", 49, bad_index, "bufferViews[1] ends beyond its buffer");
  refused("/buffers/0/byteLength", 99, truncated, "buffers[0] claims 99 bytes, but 72 are there");
  const std::string wrong =
      floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0}) + integers<std::uint16_t>(std::vector<std::uint16_t>(12, 4));
  expect_error(text_of(document(), wrong), bad_index, "meshes[0].primitives[0] has index 4 at place 0");
  std::string not_finite = tetrahedron_bytes;
  not_finite.replace(44, 4, raw(std::numeric_limits<float>::infinity()));
  expect_error(text_of(document(), not_finite), bad_number,
               "accessors[0] has a coordinate that is not finite in element 3");
  expect_error(document().dump(), syntax, "buffers[0] has neither a URI");
  json zeros = document();
  zeros["accessors"][0] = {{"componentType", 5126}, {"count", 9'000'000'000'000'000ULL}, {"type", "VEC3"}};
  expect_error(text_of(zeros), too_large, "raise the limit");
  json d = document();
  for (const std::string uri : {"data:;base64,AAA*", "data:;base64,A", "data:text/plain,hello", "data:"}) {
    d["buffers"][0]["uri"] = uri;
    expect_error(d.dump(), syntax, "buffers[0] has a data URI");
  }
}

TEST(ReadGltf, RefusesWhatIsNoGltf) {
  expect_error("{", syntax, "no JSON");
  expect_error("{}", unsupported, "asset.version is missing");
  expect_error(R"({"asset": {"version": "2.0"}})", empty_mesh, "no vertex");
  expect_error(R"({"asset": {"version": "2.0"}, "nodes": [1e999]})", syntax, "no JSON");
  expect_error("{\"a\":" + std::string(1'000'000, '['), syntax, "no JSON");
  const std::string whole = glb_of(document().dump(), tetrahedron_bytes);
  for (std::size_t size = 4; size < whole.size(); ++size) {
    const auto cut = std::string_view(whole).substr(0, size);
    EXPECT_THROW(parse_mesh(cut, MeshFormat::gltf, "cut.glb"), MeshFileError) << size;
  }
  expect_error(whole + "more", syntax, "claims ");
  json chain = document();
  chain["nodes"] = json::array();
  for (int i = 0; i < 299; ++i) chain["nodes"].push_back({{"children", {i + 1}}});
  chain["nodes"].push_back({{"mesh", 0}});
  expect_error(text_of(chain), unsupported, "flatten the nodes");
}

TEST(ReadGltf, PartsThatMultiplyMeetTheLimit) {
  json d = document();
  // 2000 nodes of one mesh of 4 x 2000 triangles are hundreds of megabytes, from a file of some 150 KB.
  for (int i = 0; i < 2000; ++i) {
    d["nodes"][static_cast<std::size_t>(i)] = {{"mesh", 0}};
    d["scenes"][0]["nodes"][static_cast<std::size_t>(i)] = i;
    d["meshes"][0]["primitives"][static_cast<std::size_t>(i)] = {{"attributes", {{"POSITION", 0}}}, {"indices", 1}};
  }
  expect_error(text_of(d), too_large, "raise the limit");
}

TEST(ReadGltf, DamagedAnywhereIsRefusedOrSound) {
  for (const std::string& whole : {text_of(document()), glb_of(document().dump(), tetrahedron_bytes)}) {
    for (std::size_t at = 0; at < whole.size(); ++at) {
      for (const int change : {1, 16}) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ change);
        try {
          const PolygonMesh mesh = parse_mesh(damaged, MeshFormat::gltf, "x");
          for (const std::uint32_t corner : mesh.corners) ASSERT_LT(corner, mesh.vertices.size());
        } catch (const MeshFileError&) {
        }
      }
    }
  }
}

}  // namespace
}  // namespace plumb
