// Does `plumb bvh` say of a mesh's trees what the library says, draw them, and refuse what it cannot do?
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/space/bvh/tree_file.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/bvh/command.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

std::string in(const Folder& folder) {
  write_mesh(folder / "torus.obj", solids::torus(4, 1, 40, 20));
  return "cd " + (folder / "") + " && $PLUMB bvh ";
}

TEST(BvhCommand, SaysWhatTheLibrarySays) {
  const Folder folder;
  const json said = json::parse(run(in(folder) + "--method all --json - torus.obj").out);
  EXPECT_EQ(said.at("program"), "plumb bvh");
  EXPECT_EQ(said.at("meshes")[0].at("triangles"), 1600);
  EXPECT_EQ(said.at("left_out"), json::array());
  ASSERT_EQ(said.at("trees").size(), bvh_methods.size());
  const TriangleMesh mesh = solids::torus(4, 1, 40, 20);
  for (std::size_t m = 0; m < bvh_methods.size(); ++m) {
    const json& tree = said.at("trees")[m];
    const Bvh bvh = build_bvh(mesh, {.method = bvh_methods[m]});
    const TreeCost cost = cost_of(bvh.tree);
    EXPECT_EQ(tree.at("method"), word_of(bvh_methods[m]));
    EXPECT_EQ(tree.at("nodes"), cost.nodes);
    EXPECT_EQ(tree.at("leaves"), cost.leaves);
    EXPECT_EQ(tree.at("depth"), cost.depth);
    EXPECT_EQ(tree.at("cost"), cost.total(1, 0.5));
    EXPECT_EQ(tree.at("bytes"), memory_of(bvh));
    EXPECT_GE(tree.at("build_ms"), 0);
    EXPECT_EQ(tree.at("levels").size(), cost.depth + 1);
  }
}

TEST(BvhCommand, DividesLongTriangles) {
  const Folder folder;
  TriangleMesh fan;
  for (std::uint32_t i = 0; i < 100; ++i) {
    fan.vertices.insert(fan.vertices.end(), {{0, 0.5 * i, 0}, {90, 90 + 0.5 * i, 90}, {0, 0.5 * i + 0.25, 0}});
    fan.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  write_mesh(folder / "fan.obj", fan);
  const std::string at = "cd " + (folder / "") + " && $PLUMB bvh ";
  const json whole = json::parse(run(at + "--json - fan.obj").out),
             parts = json::parse(run(at + "--split-share 1 --json - fan.obj").out);
  const Bvh bvh = build_bvh(fan, {.split_share = 1});
  EXPECT_EQ(whole.at("split_share"), 0);
  EXPECT_EQ(whole.at("trees")[0].at("slots"), 100);
  EXPECT_EQ(parts.at("split_share"), 1);
  EXPECT_EQ(parts.at("trees")[0].at("slots"), bvh.slots());
  EXPECT_GT(bvh.slots(), 100u);
  EXPECT_EQ(parts.at("trees")[0].at("nodes"), cost_of(bvh.tree).nodes);
  EXPECT_LT(parts.at("trees")[0].at("cost"), whole.at("trees")[0].at("cost"));
  EXPECT_THAT(run(at + "--split-share 1 fan.obj").out,
              HasSubstr("\nbinned: " + std::to_string(bvh.slots()) + " parts of 100 triangles\n"));
  EXPECT_THAT(run(at + "fan.obj").out, Not(HasSubstr("parts of")));
  EXPECT_EQ(run(at + "--split-share 1 --svg tree.svg fan.obj").code, 0);
  EXPECT_THAT(content(folder / "tree.svg"), HasSubstr(std::to_string(cost_of(bvh.tree).nodes) + " nodes"));
}

TEST(BvhCommand, PrintsARowAMethod) {
  const Folder folder;
  const std::string at = in(folder), all = run(at + "--method all torus.obj").out;
  EXPECT_THAT(all, AllOf(StartsWith("torus.obj: 800 vertices, 1600 triangles, closed\nmethod "), HasSubstr("\nbinned "),
                         HasSubstr("\nobject-median "), HasSubstr("\nnearest-pairs ")));
  const std::string one = run(at + "torus.obj").out;
  EXPECT_THAT(one, AllOf(HasSubstr("\nbinned "), Not(HasSubstr("linear"))));
  EXPECT_THAT(run(at + "--method spatial-median - <torus.obj").out,
              AllOf(StartsWith("standard input: "), HasSubstr("\nspatial-median "), Not(HasSubstr("binned"))));
}

TEST(BvhCommand, LeavesTheQuadraticBuilderOutOfBigMeshes) {
  const TriangleMesh big = solids::torus(4, 1, 101, 100);
  BvhArguments arguments;
  arguments.method = "all";
  const BvhReport report = bvh_report(arguments, {"big", {}, big, true});
  EXPECT_EQ(report.left_out, (std::vector<BvhMethod>{BvhMethod::nearest_pairs}));
  EXPECT_EQ(report.trees.size(), bvh_methods.size() - 1);
  EXPECT_THAT(bvh_text(report, Style(false)),
              HasSubstr("\nnearest-pairs is quadratic and left out of so many triangle"));
}

TEST(BvhLevels, SumUpToTheCost) {
  for (const BvhMethod method : bvh_methods) {
    for (const TriangleMesh& mesh : {solids::torus(4, 1, 30, 12), solids::box({0, 0, 0}, {1, 0, 0}), TriangleMesh{}}) {
      const BoxTree tree = build_bvh(mesh, {.method = method}).tree;
      const TreeCost cost = cost_of(tree);
      TreeLevel sum;
      const std::vector<TreeLevel> levels = levels_of(tree);
      for (const TreeLevel& level : levels) {
        sum.nodes += level.nodes;
        sum.leaves += level.leaves;
        sum.nodes_met += level.nodes_met;
        sum.items_met += level.items_met;
      }
      EXPECT_EQ(sum.nodes, cost.nodes);
      EXPECT_EQ(sum.leaves, cost.leaves);
      EXPECT_NEAR(sum.nodes_met, cost.nodes_met, 1e-9 * cost.nodes_met);
      EXPECT_NEAR(sum.items_met, cost.items_met, 1e-9 * cost.items_met);
      if (!levels.empty()) {
        EXPECT_EQ(levels.size(), cost.depth + std::size_t{1});
        EXPECT_EQ(levels[0].nodes, 1U);
      }
    }
  }
}

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t many = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++many;
  return many;
}

TEST(BvhDrawing, HasABoxANodeOfACutAndABarADepth) {
  const Folder folder;
  EXPECT_EQ(run(in(folder) + "--svg tree.svg torus.obj").code, 0);
  const std::string svg = content(folder / "tree.svg");
  EXPECT_THAT(svg, AllOf(StartsWith("<svg"), HasSubstr("<title>The tree of torus.obj, binned</title>"),
                         HasSubstr("x to the right and y up"), HasSubstr("depth 1: 2 boxes"), HasSubstr("</svg>\n")));
  const BoxTree tree = build_bvh(solids::torus(4, 1, 40, 20)).tree;
  const std::size_t depths = levels_of(tree).size();
  EXPECT_EQ(times(svg, "<g><title>depth "), depths);
  // A cut has as many boxes as it has items to hold apart: each inner node above it adds one.
  std::map<std::uint32_t, std::size_t> inner_above;
  const std::vector<std::uint32_t> depth = depths_of(tree);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (tree.nodes[i].is_leaf()) continue;
    for (std::uint32_t d = depth[i] + 1; d < depths; ++d) ++inner_above[d];
  }
  std::size_t boxes = 0;
  for (const std::uint32_t d : {1U, 2U, 3U, 4U, 5U, 6U, 8U, 10U}) {
    if (d >= depths) continue;
    EXPECT_THAT(svg, HasSubstr("depth " + std::to_string(d) + ": " + std::to_string(inner_above[d] + 1) + " boxes<"));
    boxes += inner_above[d] + 1;
  }
  EXPECT_EQ(times(svg, "<rect class=\"box ") + times(svg, "<rect class=\"leaf "), boxes);
}

TEST(BvhDrawing, TakesMeshesOfEveryShape) {
  const std::vector<TriangleMesh> meshes{{},
                                         {{{1, 2, 3}}, {}},
                                         {{{1, 2, 3}}, {{0, 0, 0}}},
                                         solids::box({0, 0, 0}, {1, 0, 0}),
                                         solids::box({0, -1, 0}, {0, 5, 1}),
                                         solids::box({-1e300, 0, 0}, {1e300, 1e-300, 3}),
                                         solids::box({0, 0, 0}, {5e-324, 5e-324, 5e-324})};
  for (const TriangleMesh& mesh : meshes) {
    for (const BvhMethod method : {BvhMethod::binned, BvhMethod::linear}) {
      const std::string svg = tree_svg("<a & b>", build_bvh(mesh, {.method = method}).tree, method);
      EXPECT_THAT(svg, AllOf(HasSubstr("&lt;a &amp; b&gt;"), Not(HasSubstr("nan")), Not(HasSubstr("inf")),
                             Not(HasSubstr("=\"-"))));
    }
  }
}

TEST(BvhDrawing, ReplacesNoFileUnasked) {
  const Folder folder;
  const std::string at = in(folder);
  std::ofstream(folder / "tree.svg") << "precious";
  const Outcome there = run(at + "--svg tree.svg torus.obj");
  EXPECT_EQ(there.code, 2);
  EXPECT_THAT(there.err, HasSubstr("--svg: tree.svg is there already and is kept; give another name, or --overwrite"));
  EXPECT_EQ(content(folder / "tree.svg"), "precious");
  EXPECT_EQ(run(at + "--svg tree.svg --overwrite torus.obj").code, 0);
  EXPECT_THAT(content(folder / "tree.svg"), StartsWith("<svg"));
  const std::string mesh = content(folder / "torus.obj");
  EXPECT_EQ(run(at + "--overwrite torus.obj --svg torus.obj").code, 2);
  EXPECT_EQ(content(folder / "torus.obj"), mesh);
  EXPECT_THAT(run(at + "torus.obj --svg").out, StartsWith("<svg"));
}

// The tree is the library's; each command that takes it answers as without it.
TEST(BvhCommand, KeepsATreeForOtherCommands) {
  const Folder folder;
  const std::string at = in(folder), program = "cd " + (folder / "") + " && $PLUMB ";
  EXPECT_EQ(run(at + "--method sweep --split-share 0.5 --out torus.bvh torus.obj").code, 0);
  const TriangleMesh mesh = solids::torus(4, 1, 40, 20);
  EXPECT_EQ(content(folder / "torus.bvh"),
            bvh_bytes(build_bvh(mesh, {.method = BvhMethod::sweep, .split_share = 0.5F})));
  EXPECT_EQ(run(at + "--method sweep --split-share 0.5 --out - torus.obj").out, content(folder / "torus.bvh"));
  for (const char* question : {"ray --all --ray 9,0.5,0.1,-1,0,0 --ray 9,9,9,1,0,0",
                               "closest --point 9,1,2 --point 0,0,0", "inside --point 4,0,0 --point 0,0,0"}) {
    const Outcome built = run(program + question + " torus.obj"),
                  kept = run(program + question + " --tree torus.bvh torus.obj");
    EXPECT_EQ(kept.code, 0) << kept.err;
    EXPECT_EQ(kept.out, built.out) << question;
  }
}

TEST(BvhCommand, ReplacesNoTreeUnasked) {
  const Folder folder;
  const std::string at = in(folder);
  std::ofstream(folder / "torus.bvh") << "precious";
  const Outcome there = run(at + "--out torus.bvh torus.obj");
  EXPECT_EQ(there.code, 2);
  EXPECT_THAT(there.err, HasSubstr("--out: torus.bvh is there already and is kept"));
  EXPECT_EQ(content(folder / "torus.bvh"), "precious");
  EXPECT_EQ(run(at + "--out torus.bvh --overwrite torus.obj").code, 0);
  EXPECT_THAT(content(folder / "torus.bvh"), StartsWith("plumbbvh"));
}

// A tree of another mesh, of a moved copy, of fewer triangles; a file that is cut off, changed, or none.
TEST(BvhCommand, TreesThatAreNotOfTheMeshAreRefused) {
  const Folder folder;
  const std::string at = in(folder), program = "cd " + (folder / "") + " && $PLUMB ";
  ASSERT_EQ(run(at + "--out torus.bvh torus.obj").code, 0);
  const std::string bytes = content(folder / "torus.bvh");
  const auto keep = [&](const std::string& name, const std::string& what) { std::ofstream(folder / name) << what; };
  keep("cut.bvh", bytes.substr(0, bytes.size() - 5));
  keep("short.bvh", bytes.substr(0, 20));
  std::string changed = bytes;
  changed[bytes.size() / 2] = static_cast<char>(changed[bytes.size() / 2] ^ 4);
  keep("changed.bvh", changed);
  TriangleMesh moved = solids::torus(4, 1, 40, 20), fewer = moved;
  moved.vertices[7].x += 1;
  fewer.triangles.pop_back();
  keep("moved.bvh", bvh_bytes(build_bvh(moved)));
  keep("fewer.bvh", bvh_bytes(build_bvh(fewer)));
  keep("compact.bvh", "plumbcmp" + bytes.substr(8));
  const std::pair<const char*, const char*> refusals[] = {
      {"cut.bvh", "cut.bvh: "},
      {"short.bvh", "short.bvh: "},
      {"changed.bvh", "changed.bvh: "},
      {"compact.bvh", "compact.bvh: "},
      {"none.bvh", "none.bvh: "},
      {"torus.obj", "torus.obj: "},
      {"-", "--tree: a tree is read from a file"},
      {"moved.bvh", "--tree: moved.bvh is the tree of another mesh than torus.obj"},
      {"fewer.bvh", "--tree: fewer.bvh is the tree of another mesh than torus.obj"}};
  for (const auto& [file, words] : refusals) {
    for (const char* question : {"ray --ray 9,0.5,0.1,-1,0,0", "closest --point 9,1,2", "inside --point 4,0,0"}) {
      const Outcome o = run(program + question + " --tree " + file + " torus.obj");
      EXPECT_EQ(o.code, 2) << file;
      EXPECT_EQ(o.out, "") << file;
      EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << file;
    }
  }
  const Outcome o = run(program + "ray --ray 9,0,0,-1,0,0 --tree torus.bvh --json torus.bvh torus.obj");
  EXPECT_EQ(o.code, 2);
  EXPECT_EQ(content(folder / "torus.bvh"), bytes);
}

TEST(BvhCommand, RefusesWhatItCannotDo) {
  const Folder folder;
  const std::string at = in(folder);
  const std::pair<const char*, const char*> refusals[] = {
      {"", "one MESH is needed"},
      {"torus.obj torus.obj", "one MESH is needed"},
      {"none.obj", "none.obj"},
      {"--method best torus.obj", "--method"},
      {"--split-share -1 torus.obj", "--split-share"},
      {"--split-share 17 torus.obj", "--split-share"},
      {"--split-share nan torus.obj", "split_share"},
      {"--method all --svg t.svg torus.obj", "--svg draws one tree"},
      {"--method all --out t.bvh torus.obj", "--out keeps one tree"},
      {"--out t.obj torus.obj", "is the name of a mesh"},
      {"--svg t.obj torus.obj", "is the name of a mesh"},
      {"--svg torus.obj", "torus.obj"},
      {"--json no/t.json torus.obj", "no/t.json"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_EQ(o.out, "") << line;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << line;
  }
  EXPECT_EQ(run("ls " + (folder / "")).out, "torus.obj\n");
}

}  // namespace
}  // namespace plumb::tool
