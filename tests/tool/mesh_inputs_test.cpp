// Every command that reads meshes takes the same names for them: files, folders, standard input, packed or not.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "certify/sanitized.hpp"
#include "surface/file/gzipped.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

void put(const std::string& path, const std::string& text) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

/// Commands of any number of meshes, as fast as they go.
const std::vector<std::string> readers{"check", "plan --placements 3", "bounds --placements 3"};

/// Those of one mesh as well, with the rest of what they need before and behind it.
std::vector<std::string> lines_of_all(const std::string& mesh, const std::string& new_file) {
  std::vector<std::string> lines{"section --plane z=0 " + mesh, "ray --ray 0,0,1,0,0,-1 " + mesh,
                                 "convert " + mesh + " " + new_file};
  for (const std::string& reader : readers) lines.push_back(reader + " " + mesh);
  return lines;
}

std::vector<std::string> names_in(const json& report) {
  std::vector<std::string> names;
  for (const json& mesh : report.at("meshes")) names.push_back(mesh.at("mesh"));
  return names;
}

TEST(MeshInputs, AreFoundInFoldersByEveryCommand) {
  const Folder folder;
  put(folder / "parts/a.obj", triangle);
  put(folder / "parts/deep/b.obj.gz", surface_test::gzipped(triangle));
  put(folder / "parts/notes.txt", "nothing");
  for (const std::string& reader : readers) {
    const std::string line = "cd " + (folder / "") + " && $PLUMB " + reader + " parts";
    const Outcome o = run(line);
    EXPECT_EQ(o.code, 0) << reader << ": " << o.err;
    EXPECT_THAT(o.out, StartsWith("parts: 2 meshes; passed over, no meshes by their names: parts/notes.txt\n"));
    const json report = json::parse(run(line + " --json -").out);
    EXPECT_THAT(names_in(report), testing::ElementsAre("parts/a.obj", "parts/deep/b.obj.gz")) << reader;
    EXPECT_EQ(report.at("passed_over"), json({"parts/notes.txt"})) << reader;
  }
}

TEST(MeshInputs, MayBeStandardInput) {
  const Folder folder;
  for (const std::string& line : lines_of_all("-", folder / "new.ply")) {
    const Outcome o = run("$PLUMB " + line, surface_test::gzipped(triangle));
    EXPECT_EQ(o.code, 0) << line << ": " << o.err;
    EXPECT_THAT(o.out, HasSubstr("standard input")) << line;
    EXPECT_THAT(run("rm -f " + (folder / "new.ply") + "; $PLUMB " + line + " <&-").err,
                HasSubstr("cannot read standard input"))
        << line;
  }
  for (const std::string& reader : readers)
    EXPECT_THAT(run("$PLUMB " + reader + " - -", triangle).err, HasSubstr("'-' stands twice")) << reader;
}

TEST(MeshInputs, AreRefusedWhereAFolderHoldsNone) {
  const Folder folder;
  put(folder / "parts/notes.txt", "nothing");
  put(folder / "good.obj", triangle);
  for (const std::string& reader : readers) {
    const Outcome o = run("$PLUMB " + reader + " " + (folder / "parts") + " " + (folder / "good.obj"));
    EXPECT_EQ(o.code, 2) << reader;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: " + (folder / "parts")), HasSubstr("holds no mesh"))) << reader;
    if (reader.starts_with("plan")) {
      EXPECT_EQ(o.out, "");  // a scene without one of its meshes is another scene
    } else {
      EXPECT_THAT(o.out, HasSubstr("good.obj")) << reader;
    }
  }
}

TEST(MeshInputs, ThatAreTooLargeNameTheOptionThatTakesThem) {
  const Folder folder;
  const std::string bomb = folder / "bomb.obj.gz", small = folder / "new.ply";
  const std::size_t megabytes = battery::sanitized ? 2 : 40;  // which is beyond what is taken without a word
  const std::string below = " --unpacked " + std::to_string(megabytes - 1),
                    enough = " --unpacked " + std::to_string(megabytes + 1);
  put(bomb, surface_test::gzipped(triangle + std::string(megabytes << 20, '\n')));
  for (const std::string& line : lines_of_all(bomb, small)) {
    const Outcome o = run("$PLUMB " + line + (battery::sanitized ? below : ""));
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: " + bomb + ": unpacks to more than "),
                             testing::EndsWith("; '--unpacked MIB' raises it\n")));
    EXPECT_EQ(run("$PLUMB " + line + below).code, 2) << line;
    const Outcome taken = run("$PLUMB " + line + enough);
    EXPECT_EQ(taken.code, 0) << line << ": " << taken.err;
  }
}

TEST(MeshInputs, AreReadStrictlyOrLenientlyByEveryCommand) {
  const Folder folder;
  const std::string odd = folder / "odd.obj", open = folder / "open.stl", new_file = folder / "new.ply";
  put(odd, triangle + "f1 2 3\n");
  put(open, "solid x\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n");
  put(folder / "points.csv", "0,0,0\n");
  const auto lines_of = [&](const std::string& mesh) {
    std::vector<std::string> lines = lines_of_all(mesh, "--overwrite " + new_file);
    for (const char* const before : {"bvh ", "intersect ", "pairs ", "inside --point 0,0,1 "})
      lines.push_back(before + mesh);
    lines.push_back("distance " + mesh + " " + mesh);
    lines.push_back("convex " + mesh + " " + mesh);
    lines.push_back("nearest " + mesh + " " + (folder / "points.csv"));
    return lines;
  };
  for (const std::string& line : lines_of(odd)) {
    const Outcome usual = run("$PLUMB " + line);
    EXPECT_EQ(usual.code, 0) << line << ": " << usual.err;
    EXPECT_THAT(usual.err, HasSubstr("plumb: " + odd +
                                     ": passed over lines that are no statement of OBJ: 1, in line 5: \"f1 2 3\"\n"))
        << line;
    const Outcome strict = run("$PLUMB " + line + " --strict");
    EXPECT_EQ(strict.code, 2) << line;
    EXPECT_THAT(strict.err, StartsWith("plumb: " + odd + ":5: found \"f1 2 3\"")) << line;
  }
  for (const std::string& line : lines_of(open)) {
    const Outcome usual = run("$PLUMB " + line);
    EXPECT_EQ(usual.code, 2) << line;
    EXPECT_THAT(usual.err, StartsWith("plumb: " + open + ":3: found \"outer\", expected `normal`")) << line;
    const Outcome lenient = run("$PLUMB " + line + " --lenient");
    EXPECT_EQ(lenient.code, 0) << line << ": " << lenient.err;
    EXPECT_THAT(lenient.err, AllOf(HasSubstr("passed over facets without a normal: 1, in line 2"),
                                   HasSubstr("passed over solids without `endsolid`: 1, in line 8: the file ends\n")))
        << line;
    EXPECT_THAT(run("$PLUMB " + line + " --lenient --strict").err,
                HasSubstr("--strict and --lenient exclude each other"))
        << line;
  }
  const json file = json::parse(run("$PLUMB check --lenient --json - " + open).out).at("meshes")[0].at("load");
  EXPECT_EQ(file.at("passed_over_text")[0],
            json({{"what", "facets without a normal"}, {"count", 1}, {"line", 2}, {"first", "\"facet\""}}));
  EXPECT_THAT(run("$PLUMB check --lenient " + open).out,
              HasSubstr("\n  passed over facets without a normal: 1, in line 2"));
}

/// A glTF of one triangle whose coordinates are in a file beside it.
void put_gltf(const std::string& path) {
  std::string bytes;
  for (const float x : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F})
    bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
  put(path + ".points", bytes);
  const std::string uri = std::filesystem::path(path).filename().string() + ".points";
  put(path, R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
    "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
                uri + "\"}]}");
}

TEST(MeshInputs, AreNotReplacedInAnyOfTheirFiles) {
  const Folder folder;
  const std::string mesh = folder / "scene.gltf", buffer = mesh + ".points", link = folder / "link.json";
  put_gltf(mesh);
  std::filesystem::create_symlink("scene.gltf.points", link);
  const std::string before = content(buffer);
  std::vector<std::string> lines{"section --plane z=0 --svg " + buffer + " " + mesh,
                                 "convert --overwrite --format obj " + mesh + " " + buffer};
  for (const std::string& reader : readers) {
    lines.push_back(reader + " --json " + buffer + " " + mesh);
    lines.push_back(reader + " --chart " + link + " " + mesh);
  }
  for (const std::string& line : lines) {
    const Outcome o = run("$PLUMB " + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_THAT(o.err, HasSubstr("which this run reads; give another name")) << line;
    EXPECT_EQ(content(buffer), before) << line;
  }
  EXPECT_EQ(run("$PLUMB check " + mesh).code, 0);
  // In a folder that is read, what it links to is read as well.
  put(folder / "data", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::filesystem::create_directory(folder / "parts");
  std::filesystem::create_symlink("../data", folder / "parts/a.obj");
  for (const std::string& reader : readers)
    EXPECT_THAT(run("$PLUMB " + reader + " --json " + (folder / "data") + " " + (folder / "parts")).err,
                HasSubstr("which this run reads"))
        << reader;
}

}  // namespace
}  // namespace plumb::tool
