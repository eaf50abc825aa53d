// What is read from 3MF: units, items, components, parts of their own, exact transforms; and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "plumb/arith/rational.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "surface/file/packages.hpp"

namespace plumb {
namespace {

using surface_test::model_of;
using surface_test::package_of;
using surface_test::relations;
using surface_test::tetrahedron_object;
using surface_test::zipped;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using enum MeshFileProblem;

PolygonMesh read(const std::string& bytes, LoadReport* report = nullptr, const ReadOptions& options = {}) {
  return parse_mesh(bytes, std::filesystem::path("part.3mf"), report, options);
}

MeshFileError error_of(const std::string& bytes, const ReadOptions& options = {}) {
  try {
    read(bytes, nullptr, options);
  } catch (const MeshFileError& e) {
    EXPECT_THAT(e.what(), StartsWith("part.3mf: "));
    return e;
  }
  ADD_FAILURE() << "it was read";
  return {missing, "", {}, {}, ""};
}

void expect_error(const std::string& bytes, MeshFileProblem problem, const std::string& words) {
  const MeshFileError e = error_of(bytes);
  EXPECT_EQ(e.problem, problem) << e.what();
  EXPECT_THAT(e.what(), HasSubstr(words));
}

std::string item(const std::string& transform = "", const std::string& id = "1") {
  return "<item objectid=\"" + id + "\"" + (transform.empty() ? "" : " transform=\"" + transform + "\"") + "/>";
}

std::string assembly(const std::string& id, const std::string& components) {
  return "<object id=\"" + id + "\"><components>" + components + "</components></object>";
}

std::string component(const std::string& id, const std::string& transform = "") {
  return "<component objectid=\"" + id + "\"" + (transform.empty() ? "" : " transform=\"" + transform + "\"") + "/>";
}

TEST(Read3mf, HoldsTheTetrahedronAsItIs) {
  LoadReport report;
  const PolygonMesh mesh = read(package_of(model_of(tetrahedron_object, item())), &report);
  const PolygonMesh expected = surface_test::tetrahedron();
  EXPECT_EQ(mesh.vertices, expected.vertices);
  EXPECT_EQ(mesh.corners, expected.corners);
  EXPECT_EQ(report.format, MeshFormat::three_mf);
  EXPECT_EQ(report.unit, "millimeter");
  EXPECT_EQ(report.parts, 1U);
  EXPECT_EQ(report.decimals, 12U);
  EXPECT_EQ(report.transformed, 0U);
  EXPECT_EQ(format_by_extension("a.3MF"), MeshFormat::three_mf);
}

TEST(Read3mf, KnowsItsUnits) {
  for (const std::string unit : {"micron", "millimeter", "centimeter", "inch", "foot", "meter"}) {
    LoadReport report;
    read(package_of(model_of(tetrahedron_object, item(), "unit=\"" + unit + "\"")), &report);
    EXPECT_EQ(report.unit, unit);
  }
  LoadReport report;
  read(package_of(model_of(tetrahedron_object, item(), "")), &report);
  EXPECT_EQ(report.unit, "millimeter");
  expect_error(package_of(model_of(tetrahedron_object, item(), "unit=\"parsec\"")), syntax, "\"parsec\"");
}

TEST(Read3mf, PlacesItemsWithTheirTransforms) {
  LoadReport report;
  const PolygonMesh mesh = read(
      package_of(model_of(tetrahedron_object, item("1 0 0 0 1 0 0 0 1 0 0 0") + item("0 2 0 -1 0 0 0 0 1 10 20 30"))),
      &report);
  ASSERT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.vertices[3], (Point3{0, 0, 0.5}));
  EXPECT_EQ(mesh.vertices[4], (Point3{10, 20, 30}));
  EXPECT_EQ(mesh.vertices[5], (Point3{10, 22, 30}));  // the image of x
  EXPECT_EQ(mesh.vertices[6], (Point3{9, 20, 30}));
  EXPECT_EQ(mesh.vertices[7], (Point3{10, 20, 30.5}));
  EXPECT_EQ(report.parts, 2U);
  EXPECT_EQ(report.transformed, 12U);  // the identity moves nothing
  EXPECT_EQ(report.rounded, 0U);
}

TEST(Read3mf, TurnsTheFacesOfAMirroredPart) {
  const PolygonMesh mesh = read(package_of(model_of(tetrahedron_object, item("-1 0 0 0 1 0 0 0 1 0 0 0"))));
  EXPECT_EQ(std::vector<std::uint32_t>(mesh.corners.begin(), mesh.corners.begin() + 3),
            (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Read3mf, RoundsEachCoordinateOnceThroughAllComponents) {
  const std::string third = "0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 0.01 0.02 0.03";
  const std::string seventh = "0.7 0 0.1 0.3 0.9 0 0 0.2 1.1 5 0.7 1e-3";
  const std::string point =
      "<object id=\"1\"><mesh><vertices><vertex x=\"0.3\" y=\"1.7\" z=\"-2.9\"/>"
      "<vertex x=\"1\" y=\"2\" z=\"3\"/><vertex x=\"1e-9\" y=\"1e9\" z=\"0.1\"/></vertices>"
      "<triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object>";
  LoadReport report;
  const PolygonMesh mesh =
      read(package_of(model_of(point + assembly("2", component("1", seventh)) + assembly("3", component("2", third)),
                               item(seventh, "3"))),
           &report);
  using Numbers = std::array<double, 12>;
  const Numbers a{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.01, 0.02, 0.03};
  const Numbers b{0.7, 0, 0.1, 0.3, 0.9, 0, 0, 0.2, 1.1, 5, 0.7, 1e-3};
  using Exact = std::array<Rational, 3>;
  const auto image = [](const Numbers& m, const Exact& p) {
    Exact q;
    for (std::size_t i = 0; i < 3; ++i)
      q[i] = p[0] * Rational(m[i]) + p[1] * Rational(m[3 + i]) + p[2] * Rational(m[6 + i]) + Rational(m[9 + i]);
    return q;
  };
  const std::vector<Point3> given{{0.3, 1.7, -2.9}, {1, 2, 3}, {1e-9, 1e9, 0.1}};
  bool rounding_twice_shows = false;
  for (std::size_t v = 0; v < given.size(); ++v) {
    const Exact start{Rational(given[v].x), Rational(given[v].y), Rational(given[v].z)};
    const Exact exact = image(b, image(a, image(b, start)));
    EXPECT_EQ(mesh.vertices[v], (Point3{exact[0].rounded(), exact[1].rounded(), exact[2].rounded()}));
    const auto rounded = [](const Exact& e) {
      return Exact{Rational(e[0].rounded()), Rational(e[1].rounded()), Rational(e[2].rounded())};
    };
    const Exact twice = rounded(image(b, rounded(image(a, rounded(image(b, start))))));
    rounding_twice_shows = rounding_twice_shows || twice != rounded(exact);
  }
  EXPECT_TRUE(rounding_twice_shows);
  EXPECT_EQ(report.transformed, 9U);
  EXPECT_EQ(report.rounded, 9U);
}

TEST(Read3mf, ReadsObjectsOfOtherParts) {
  const std::string other = model_of(tetrahedron_object, "");
  const std::string root =
      model_of(assembly("8", "<component p:path=\"/3D/Objects/object_1.model\" objectid=\"1\"/>"), item("", "8"),
               "unit=\"inch\" xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"");
  LoadReport report;
  EXPECT_EQ(read(package_of(root, {{"3D/Objects/object_1.model", other, 0, 0}}), &report).vertices.size(), 4U);
  EXPECT_EQ(report.unit, "inch");
  expect_error(package_of(root), syntax, "\"3D/Objects/object_1.model\": this part is named but not in the archive");
}

TEST(Read3mf, NamesTheElementThatIsWrong) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string objects = tetrahedron_object;
    objects.replace(objects.find(from), from.size(), to);
    return package_of(model_of(objects, item()));
  };
  expect_error(with("v2=\"2\"", "v2=\"4\""), bad_index,
               "\"3D/3dmodel.model\": object \"1\": v2 of triangle 0 is \"4\", expected a number below 4");
  expect_error(with("v2=\"2\"", "v2=\"-1\""), bad_index, "\"-1\"");
  expect_error(with("v2=\"2\"", ""), bad_index, "v2 of triangle 0");
  expect_error(with("z=\"0.5\"", "z=\"0.5mm\""), bad_number, "object \"1\": z of vertex 3 is \"0.5mm\"");
  expect_error(with("z=\"0.5\"", "z=\"1e999\""), bad_number, "z of vertex 3");
  expect_error(with("z=\"0.5\"", "z=\"nan\""), bad_number, "z of vertex 3");
  expect_error(with("</mesh>", "</mush>"), syntax, "no XML at byte ");
  expect_error(package_of(model_of(tetrahedron_object + tetrahedron_object, item())), syntax, "two objects");
  expect_error(package_of(model_of(tetrahedron_object, item("", "2"))), bad_index, "names object \"2\"");
  expect_error(package_of(model_of(tetrahedron_object, item("1 0 0 0 1 0 0 0 1 0 0"))), bad_number, "twelve numbers");
  expect_error(package_of(model_of(tetrahedron_object, item("1 0 0 0 1 0 0 0 1 0 0 0 0"))), syntax, "twelve numbers");
  expect_error(package_of(model_of(tetrahedron_object, item("1e308 0 0 1e308 0 0 1e308 0 1 1e308 1e308 1e308"))),
               bad_number, "beyond the largest double");
  expect_error(package_of(model_of(tetrahedron_object, "")), empty_mesh, "no vertex");
  expect_error(package_of("<html/>"), syntax, "its root is not <model>");
  expect_error(zipped({{"part.stl", "solid"}}), syntax, "a zip archive of meshes to be unpacked?");
  expect_error(zipped({{"_rels/.rels", "<Relationships/>"}}), syntax, "names no 3D model");
  std::string damaged = zipped({{"_rels/.rels", relations, 0, 0}});
  damaged.replace(damaged.find("3dmodel.model"), 1, "4");
  expect_error(damaged, syntax, "\"_rels/.rels\": this entry of the zip archive is damaged");
  expect_error(zipped({{"_rels/.rels", relations, 1}}), unsupported, "encrypted");
  expect_error(zipped({{"_rels/.rels", relations, 0, 12}}), unsupported, "method 12");
}

TEST(Read3mf, FindsItsPartsWhateverTheirCase) {
  EXPECT_EQ(read(zipped({{"_RELS/.rels", relations}, {"3d/3DModel.model", model_of(tetrahedron_object, item())}}))
                .vertices.size(),
            4U);
}

TEST(Read3mf, RefusesCyclesAndDepth) {
  expect_error(package_of(model_of(assembly("1", component("1")), item())), syntax, "component of itself");
  expect_error(package_of(model_of(assembly("1", component("2")) + assembly("2", component("1")), item())), syntax,
               "component of itself");
  std::string chain = tetrahedron_object;
  for (int i = 2; i <= 300; ++i) chain += assembly(std::to_string(i), component(std::to_string(i - 1)));
  expect_error(package_of(model_of(chain, item("", "300"))), unsupported, "flatten the components");
  EXPECT_EQ(read(package_of(model_of(chain, item("", "200")))).vertices.size(), 4U);
}

TEST(Read3mf, BombsMeetTheLimits) {
  // Text that unpacks, elements that fill memory, components that double, with and without a mesh at the end.
  const std::string spaces(std::size_t{64} << 20, ' ');
  EXPECT_EQ(error_of(package_of(model_of(tetrahedron_object + spaces, item()))).problem, too_large);
  std::string elements;
  for (int i = 0; i < 1'000'000; ++i) elements += "<a/>";
  EXPECT_EQ(error_of(package_of(model_of(tetrahedron_object + elements, item()))).problem, too_large);
  for (const std::string& leaf : {tetrahedron_object, assembly("1", "")}) {
    std::string doubling = leaf;
    for (int i = 2; i <= 60; ++i) {
      const std::string half = component(std::to_string(i - 1));
      doubling += assembly(std::to_string(i), half + half);
    }
    const MeshFileError e = error_of(package_of(model_of(doubling, item("", "60"))));
    EXPECT_EQ(e.problem, too_large);
    EXPECT_THAT(e.what(), HasSubstr("raise the limit"));
  }
  EXPECT_EQ(error_of(package_of(model_of(tetrahedron_object, item())), {.most_bytes = 300}).problem, too_large);
}

TEST(Read3mf, ExpandsNoEntities) {
  const std::string model = package_of("<!DOCTYPE model [<!ENTITY a \"7\"><!ENTITY b SYSTEM \"file:///etc/passwd\">]>" +
                                       model_of(tetrahedron_object, item()));
  EXPECT_EQ(read(model).vertices.size(), 4U);
  for (const std::string entity : {"&a;", "&b;"}) {
    std::string objects = tetrahedron_object;
    objects.replace(objects.find("z=\"0.5\""), 7, "z=\"" + entity + "\"");
    expect_error(package_of("<!DOCTYPE model [<!ENTITY a \"7\">]>" + model_of(objects, item())), bad_number, entity);
  }
}

TEST(Read3mf, CutOrDamagedAnywhereIsRefusedOrSound) {
  const std::string whole = package_of(model_of(tetrahedron_object, item("0.5 0 0 0 1 0 0 0 1 0 0 0")));
  for (std::size_t size = 1; size < whole.size(); ++size) EXPECT_THROW(read(whole.substr(0, size)), MeshFileError);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const int change : {1, 0x80, 0xFF}) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ change);
      try {
        const PolygonMesh mesh = read(damaged);
        for (const std::uint32_t corner : mesh.corners) ASSERT_LT(corner, mesh.vertices.size());
      } catch (const MeshFileError&) {
      }
    }
  }
}

}  // namespace
}  // namespace plumb
