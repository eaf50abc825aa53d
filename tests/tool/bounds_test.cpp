// Does `plumb bounds` say what rate_bounds finds, in text, JSON and picture, and in words what it cannot rate?
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/bounds/command.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;
using testing::AllOf, testing::HasSubstr, testing::Not, testing::StartsWith;

/// A rod, and a rod with a plate at its end.
TriangleMesh rod(bool with_plate) {
  TriangleMesh mesh;
  const auto add_box = [&](double x, double y, double z, double from) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < 8; ++i)
      mesh.vertices.push_back({(i & 1) != 0 ? from + x : from, (i & 2) != 0 ? y : -y, (i & 4) != 0 ? z : -z});
    for (const auto& [a, b, c] : {TriangleMesh::Triangle{0, 2, 1},
                                  {1, 2, 3},
                                  {4, 5, 6},
                                  {5, 7, 6},
                                  {0, 1, 4},
                                  {1, 5, 4},
                                  {2, 6, 3},
                                  {3, 6, 7},
                                  {0, 4, 2},
                                  {2, 4, 6},
                                  {1, 3, 5},
                                  {3, 7, 5}})
      mesh.triangles.push_back({first + a, first + b, first + c});
  };
  add_box(10, 1, 1, 0);
  if (with_plate) add_box(1, 5, 5, 10);
  return mesh;
}

TEST(Bounds, TextJsonAndChartAgree) {
  const Folder folder;
  write_mesh(folder / "rod.obj", rod(false));
  write_mesh(folder / "nail.off", rod(true));
  const Outcome o =
      run("cd '" + (folder / "") + "'; $PLUMB bounds rod.obj nail.off --placements 60 --json b.json --chart b.svg");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, AllOf(StartsWith("rod.obj\n"), HasSubstr("\nnail.off\n"), HasSubstr("medians over 2 meshes"),
                           HasSubstr("16 vertices, 12 on the hull")));
  const json j = json::parse(content(folder / "b.json"));
  ASSERT_EQ(j["meshes"].size(), 2);
  for (std::size_t m = 0; m < 2; ++m) {
    const json& mesh = j["meshes"][m];
    EXPECT_EQ(mesh["placements"], 60);
    const auto again = rate_bounds(rod(m == 1).vertices, {.placements = 60});
    EXPECT_EQ(mesh["hulls_apart"], again.hulls_apart());
    ASSERT_EQ(mesh["kinds"].size(), bound_kinds.size());
    for (std::size_t k = 0; k < bound_kinds.size(); ++k) {
      const json& kind = mesh["kinds"][k];
      EXPECT_EQ(kind["kind"], name_of(bound_kinds[k]));
      EXPECT_EQ(kind["tightness"], again.kinds[k].tightness);
      EXPECT_EQ(kind["overlapping"], again.kinds[k].overlapping);
      EXPECT_EQ(kind["false_overlaps"], again.kinds[k].false_overlaps);
      EXPECT_GT(kind["test_ns"], 0);
      EXPECT_EQ(j["medians"][k]["tightness"], (j["meshes"][0]["kinds"][k]["tightness"].get<double>() +
                                               j["meshes"][1]["kinds"][k]["tightness"].get<double>()) /
                                                  2);
    }
  }
  const std::string chart = content(folder / "b.svg");
  EXPECT_THAT(chart, AllOf(StartsWith("<svg "), HasSubstr("60 placements"), HasSubstr("nail.off, obb: ")));
  for (const BoundKind kind : bound_kinds) EXPECT_THAT(chart, HasSubstr(">" + std::string(name_of(kind)) + "</text>"));
  EXPECT_EQ(std::count(chart.begin(), chart.end(), '\n') > 100, true);
}

TEST(Bounds, ExpectedCostDecidesWhatIsMarked) {
  MeshBounds mesh{"rod", 8, rate_bounds(rod(false).vertices, {.placements = 50}), 1'000};
  for (BoundRating& r : mesh.ratings.kinds) r.test_ns = 10;
  mesh.ratings.kinds[4].test_ns = 5;  // the oriented box, which overlaps no more than it must
  EXPECT_EQ(mesh.expected_ns(4), 5 + mesh.ratings.kinds[4].overlapping / 50.0 * 1'000);
  EXPECT_EQ(mesh.false_share(4), 0);
  EXPECT_EQ(mesh.false_share(0), 1);  // spheres meet in all placements
  const std::string text = bounds_text(mesh, Style(false));
  EXPECT_THAT(text, testing::ContainsRegex("obb .*  <\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '<'), 1);
  EXPECT_THAT(bounds_text(mesh, Style(true)), HasSubstr("\033[32m"));
}

TEST(Bounds, ChartsAnything) {
  EXPECT_THAT(bounds_chart({}), AllOf(StartsWith("<svg "), HasSubstr("</svg>")));
  MeshBounds flat{"a<b&c", 4, rate_bounds(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {.placements = 3}), 1};
  const std::string chart = bounds_chart({&flat, 1});
  EXPECT_THAT(chart, AllOf(HasSubstr("a&lt;b&amp;c"), Not(HasSubstr("\"inf")), Not(HasSubstr("\"nan"))));
  EXPECT_THAT(bounds_json({&flat, 1}).dump(), HasSubstr("\"tightness\":null"));
}

TEST(Bounds, BadInputIsNamed) {
  const Folder folder;
  write_mesh(folder / "rod.obj", rod(false));
  const std::string at = "cd '" + (folder / "") + "'; ";
  const Outcome missing = run(at + "$PLUMB bounds nowhere.obj rod.obj --placements 5");
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.err, HasSubstr("nowhere.obj"));
  EXPECT_THAT(missing.out, HasSubstr("rod.obj"));  // the other is still rated
  const Outcome same = run(at + "$PLUMB bounds rod.obj --json x --chart x");
  EXPECT_EQ(same.code, 2);
  EXPECT_THAT(same.err, HasSubstr("the same output"));
  EXPECT_EQ(run(at + "$PLUMB bounds rod.obj --placements 0").code, 2);
  EXPECT_EQ(run(at + "$PLUMB bounds rod.obj --refined -1").code, 2);
  const Outcome only_json = run(at + "$PLUMB bounds rod.obj --placements 5 --json -");
  EXPECT_EQ(only_json.code, 0) << only_json.err;
  EXPECT_EQ(json::parse(only_json.out)["meshes"][0]["mesh"], "rod.obj");
}

TEST(Bounds, RatesTheEmbeddedPartWithoutAMesh) {
  const Outcome o = run("$PLUMB bounds --placements 3");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, StartsWith("embedded flange\n"));
}

}  // namespace
}  // namespace plumb::tool
