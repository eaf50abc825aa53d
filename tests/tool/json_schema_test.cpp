// Reports as JSON: every command of either program that writes one writes what docs/plumb.schema.json says, on meshes that are
// closed and open, meet and do not, on tables of boxes and points, with few options and with many; and the schema notices each
// member that is misspelt or of another kind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

const std::string schema = PLUMB_SOURCE_DIR "/docs/plumb.schema.json";

/// Debian's Python has the validator: python3-jsonschema.
Outcome validated(const std::string& option, const std::string& files) {
  return run("/usr/bin/python3 " PLUMB_SOURCE_DIR "/tests/tool/validate_report.py " + option + schema + " " + files);
}

/// A cube, one moved away, one that crosses the first, an open square, a flat sliver; boxes and points.
void put_inputs(const Folder& folder) {
  const auto cube = [&](const std::string& name, double x) {
    std::ofstream out(folder / name);
    for (const char* const at : {"0 0", "1 0", "1 1", "0 1"}) {
      const std::string y = std::string(at).substr(0, 1), z = std::string(at).substr(2);
      out << "v " << x << ' ' << y << ' ' << z << "\nv " << x + 1 << ' ' << y << ' ' << z << '\n';
    }
    out << "f 1 3 4 2\nf 7 8 6 5\nf 1 2 8 7\nf 5 6 4 3\nf 1 7 5 3\nf 2 4 6 8\n";
  };
  cube("cube.obj", 0);
  cube("far.obj", 30);
  cube("crossing.obj", 0.5);
  std::ofstream(folder / "open.obj") << "v 0 0 0\nv 0.1 0 0\nv 0.1 0.3 0\nv 0 0.3 0.1\nf 1 2 3\nf 1 3 4\n";
  std::ofstream(folder / "sliver.off") << "OFF\n3 1 0\n0 0 0\n0.1 0.1 0.1\n0.3 0.3 0.3\n3 0 1 2\n";
  std::ofstream(folder / "boxes.csv") << "0,0,0,1,1,1\n0.5,0.5,0.5,2,2,2\n1,0,0,2,1,1\n";
  std::ofstream(folder / "flat_boxes.csv") << "0,0,1,1\n0.1,0.1,2,2\n";
  std::ofstream(folder / "points.csv") << "0,0,0\n1,1,1\n0.1,0,0\n1,0,0\n";
  std::filesystem::create_directory(folder / "shards");
  std::ofstream(folder / "questions.txt") << "relate | ball3 0 0 0 1 | ball3 2 0 0 1 = disjoint\n"
                                          << "distance | point3 0 0 0 | point3 3 4 0\n";
  std::ofstream(folder / "model.csg") << "difference() { cube(3); translate([0.1, 0.1, 0.1]) import(\"cube.obj\"); }\n";
  std::ofstream(folder / "shards/check.2-of-2.jsonl")
      << R"({"command":"check","corpus":"parts","plumb":"0","settings":{},"shard":2,"shards":2})" << '\n'
      << R"({"model":"a.obj","verdict":"faulty","defects":["open"],"faults":{"open edges":3},"triangles":1})" << '\n'
      << R"({"model":"b.obj","verdict":"timeout","why":"took more than 1 s","measured":{"seconds":1,"peak_mib":9}})"
      << '\n';
  std::ofstream(folder / "probes.txt") << "0.5 0.5 0.5\n0 0 0\n2 2 2\n";
}

/// By command, what it is asked.
const std::map<std::string, std::vector<std::string>>& asked() {
  static const std::map<std::string, std::vector<std::string>> all{
      {"boolean",
       {"union cube.obj far.obj -o u.obj", "intersection cube.obj far.obj -o i.obj",
        "symmetric cube.obj cube.obj far.obj -o s.obj", "difference --rounds 1 cube.obj crossing.obj -o d.obj"}},
      {"bounds", {"cube.obj open.obj --placements 20", "sliver.off --placements 5"}},
      {"bsp", {"cube.obj", "cube.obj --planes faces", "--leaves pieces open.obj", "--leaves none sliver.off"}},
      {"bvh", {"cube.obj", "open.obj --method linear", "cube.obj --split-share 0.5"}},
      {"check", {"cube.obj open.obj sliver.off", "--verify cube.obj crossing.obj", "--all open.obj"}},
      {"clash",
       {"cube.obj crossing.obj far.obj", "--clearance 50 cube.obj cube.obj far.obj open.obj",
        "--ignore overlapping cube.obj crossing.obj"}},
      {"collect", {"shards", "--worst 1 shards"}},
      {"convex", {"cube.obj far.obj", "cube.obj crossing.obj", "cube.obj open.obj", "cube.obj cube.obj"}},
      {"closest",
       {"cube.obj probes.txt", "--within 0.5 cube.obj probes.txt --point 0.1,0,0",
        "cube.obj --point 9,9,9 --within 1"}},
      {"csg", {"model.csg -o c.obj"}},
      {"distance", {"cube.obj far.obj", "cube.obj crossing.obj"}},
      {"hausdorff",
       {"cube.obj far.obj", "--from --absolute 0.5 cube.obj crossing.obj", "--relative 0 cube.obj open.obj"}},
      {"inside",
       {"--point 0.5,0.5,0.5 --point 0.1,0,0 cube.obj", "--points probes.txt cube.obj", "--point 1,2,3 open.obj"}},
      {"intersect",
       {"cube.obj", "cube.obj far.obj", "cube.obj crossing.obj", "cube.obj crossing.obj --common",
        "cube.obj crossing.obj --overlapping", "cube.obj crossing.obj --first", "cube.obj crossing.obj --count"}},
      {"nearest", {"points.csv points.csv", "-k 3 points.csv points.csv --ties", "--within 1 points.csv cube.obj"}},
      {"pairs", {"boxes.csv", "boxes.csv boxes.csv --no-touching", "flat_boxes.csv --count", "cube.obj far.obj"}},
      {"parts", {"cube.obj", "--most 1 cube.obj", "--concavity 0.5 cube.obj"}},
      {"plan", {"cube.obj open.obj --placements 5", "sliver.off cube.obj --all --placements 5"}},
      {"ray",
       {"--ray 0.5,0.5,5,0,0,-1 cube.obj", "--ray 0.1,0.5,5,0,0,1 --all cube.obj", "--segment 0,0,9,0,0,8 cube.obj"}},
      {"repair",
       {"--dry-run cube.obj", "--dry-run --tolerance 0.1 open.obj sliver.off", "-o mended.obj open.obj",
        "--dry-run --only weld crossing.obj"}},
      {"replay", {"questions.txt", "--prove questions.txt"}},
      {"resolve", {"cube.obj -o r.obj", "--rule odd --merge far.obj -o q.obj"}},
      {"section", {"--plane z=0.5 cube.obj", "--plane z=0 --plane x=0.1 cube.obj", "--plane 1,1,1,0.5 open.obj"}},
      {"split", {"cube.obj --plane z=0.5 -o p.obj", "cube.obj --by crossing.obj -o o.obj --other n.obj"}},
  };
  return all;
}

/// By command of either program, what writes a report into a folder.
const std::map<std::string, std::vector<std::string>>& asked_of_folders() {
  static const std::string ours = "$PLUMB fuzz --library " PLUMB_FOREIGN "/wrong.so --cases 60 --generator near_half ";
  static const std::map<std::string, std::vector<std::string>> all{
      {"fuzz",
       {ours + "--kind orient3d --symbol naive_orient3d --generator uniform",
        ours + "--kind incircle --symbol naive_incircle --range 1000 --grid 1",
        ours + "--kind point-in-polygon --symbol crossing_polygon"}},
      {"chart",
       {"$PLUMB_LAB chart --quick --task orient2d --task smallest-ball --class degenerate_long",
        "$PLUMB_LAB chart --quick --task closest-hit --class vertices_and_edges"}},
      {"stability", {"$PLUMB_LAB stability --quick --experiment sweeps --experiment grid"}},
  };
  return all;
}

/// Whether what the line wrote is as the schema says, and would not be if any of its members were misspelt.
void expect_valid(const std::string& files) {
  for (const std::string option : {"", "--misspell "}) {
    const Outcome checked = validated(option, files);
    EXPECT_EQ(checked.code, 0) << checked.out << checked.err;
  }
}

TEST(JsonSchema, SaysWhatEveryCommandWrites) {
  const Folder folder;
  put_inputs(folder);
  for (const std::string& command : commands()) {
    if (run("$PLUMB help " + command).out.find("--json") == std::string::npos) continue;
    ASSERT_TRUE(asked().contains(command)) << command << " writes JSON that nobody looks at here";
    std::string files;
    int number = 0;
    for (const std::string& arguments : asked().at(command)) {
      const std::string file = folder / (command + std::to_string(number++) + ".json");
      const Outcome o = run("cd " + (folder / "") + " && $PLUMB " + command + " -q " + arguments + " --json " + file);
      ASSERT_LE(o.code, 1) << command << ' ' << arguments << ": " << o.err;
      files += file + ' ';
    }
    expect_valid(files);
  }
}

TEST(JsonSchema, SaysWhatIsInEveryFolder) {
  const Folder folder;
  int number = 0;
  for (const std::string program : {"$PLUMB", "$PLUMB_LAB"}) {
    if (program == "$PLUMB_LAB" && tested_laboratory().empty()) continue;
    for (const std::string& command : commands(program)) {
      const std::string page = run(program + " help " + command).out;
      if (page.find("--out DIR") == std::string::npos || page.find(command + ".json") == std::string::npos) continue;
      ASSERT_TRUE(asked_of_folders().contains(command)) << command << " writes JSON that nobody looks at here";
      std::string files;
      for (const std::string& line : asked_of_folders().at(command)) {
        const std::string out = folder / std::to_string(number++);
        const Outcome o = run(line + " -q --out " + out);
        ASSERT_LE(o.code, 1) << line << ": " << o.err;
        files += out + "/" + command + ".json ";
      }
      expect_valid(files);
    }
  }
  EXPECT_GE(number, 3);
}

TEST(JsonSchema, RefusesWhatIsNoReport) {
  const Folder folder;
  std::ofstream(folder / "nobody.json") << R"({"program": "plumb nobody"})";
  std::ofstream(folder / "nothing.json") << "{}";
  std::ofstream(folder / "bare.json") << R"({"program": "plumb fuzz"})";
  for (const std::string name : {"nobody.json", "nothing.json", "bare.json"})
    EXPECT_EQ(validated("", folder / name).code, 1) << name;
}

}  // namespace
}  // namespace plumb::tool
