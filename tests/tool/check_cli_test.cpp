// `plumb check` as a user meets it: reports, files written and refused, exit codes, the sample, the replay of what it
// found.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "certify/sanitized.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "surface/file/gzipped.hpp"
#include "surface/file/packages.hpp"
#include "tool/check/command.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

json report_of(const std::string& arguments, int code = 0) {
  const Outcome o = run("$PLUMB check --json - " + arguments);
  EXPECT_EQ(o.code, code) << o.err;
  return json::parse(o.out);
}

const char* const triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// Of the embedded part, for all tests that read it: it takes ten seconds where it is watched.
const Outcome& embedded() {
  static const Outcome once = run("$PLUMB check");
  return once;
}
const json& embedded_report() {
  static const json once = report_of("--verify").at("meshes").at(0);
  return once;
}

TEST(Check, RunsOnTheEmbeddedPartWhenGivenNothing) {
  const Outcome& o = embedded();
  EXPECT_EQ(o.code, 0);
  EXPECT_EQ(o.err, "");  // no progress bar where nobody looks
  EXPECT_THAT(o.out, Not(HasSubstr("\033")));
  for (const std::string_view method : method_names) EXPECT_THAT(o.out, HasSubstr(std::string(method)));
  for (const char* name : {"orient2d", "orient3d", "incircle", "insphere"}) EXPECT_THAT(o.out, HasSubstr(name));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A rough square sheet of 2 n^2 triangles.
TriangleMesh sheet(std::uint32_t n) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j)
      mesh.vertices.push_back({i / 7.0, j / 7.0, (i * i % 11 + j * j % 13) / 64.0});
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return mesh;
}

TEST(Check, OpensWithAVerdictOfFourLines) {
  const std::vector<std::string> lines = lines_of(embedded().out);
  ASSERT_GT(lines.size(), 6U);
  EXPECT_EQ(lines[0], "embedded flange");
  EXPECT_EQ(lines[1],
            "  surface     2 shells, not closed, oriented, touching itself (67 vertices lie where another is: "
            "triangles that meet "
            "there share none, and touch), with degenerate triangles");
  EXPECT_EQ(lines[2],
            "  wrong       12 triangles of zero area; 67 repeated vertices; 6 vertices on edges (T-junctions); 133 "
            "open edges; "
            "1 edge of more than two faces; 575 pairs of triangles that touch");
  EXPECT_THAT(lines[3], AllOf(StartsWith("  in floats   wrong signs in 153,641 decisions: float32 "),
                              HasSubstr("double "), HasSubstr("; none: interval")));
  EXPECT_THAT(lines[4], AllOf(StartsWith("  to do       collapse triangles of zero area; weld repeated vertices; "),
                              HasSubstr("take signs exactly")));
  EXPECT_EQ(lines[5], "");
  const json verdict = embedded_report().at("verdict");
  EXPECT_EQ("  surface     " + std::string(verdict.at("surface_is")), lines[1]);
  EXPECT_EQ("  wrong       " + std::string(verdict.at("faults")), lines[2]);
  EXPECT_EQ("  in floats   " + std::string(verdict.at("floats")), lines[3]);
  EXPECT_THAT(std::string(verdict.at("advice")), HasSubstr("take signs exactly"));
}

TEST(Check, SaysOfASoundMeshThatNothingIsWrong) {
  const Folder folder;
  put(folder / "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const std::vector<std::string> lines = lines_of(run("$PLUMB check " + (folder / "t.obj")).out);
  ASSERT_GT(lines.size(), 5U);
  EXPECT_EQ(lines[1], "  surface     closed, oriented, free of self-intersections, free of degenerate triangles");
  EXPECT_EQ(lines[2], "  wrong       nothing");
  EXPECT_THAT(lines[3], StartsWith("  in floats   no method took a wrong sign in "));
  EXPECT_THAT(lines[4], StartsWith("  to do       any arithmetic did here; exact signs are certain"));
}

TEST(Check, CountsPolygonsThatLieInNoPlane) {
  const Folder folder;
  // One plane, one bent by the last bit of a coordinate, and one whose first three corners are on a line.
  put(folder / "quads.obj",
      "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 0 1 1.0000000000000002\nv 0.5 0 1\nv 1 0 1.5\n"
      "f 1 2 3 4\nf 1 2 3 5\nf 1 6 2 3 4\nf 1 6 2 3 7\n");
  const json mesh = report_of(folder / "quads.obj").at("meshes").at(0);
  EXPECT_EQ(mesh.at("bent_faces"), 2);
  EXPECT_THAT(std::string(mesh.at("verdict").at("faults")), HasSubstr("2 polygons whose corners lie in no one plane"));
}

TEST(Check, AsksTheInexactMethodsOfABigMeshASample) {
  if (battery::sanitized) GTEST_SKIP() << "half a million decisions; decision_sample_test draws samples";
  const Folder folder;
  const std::string file = folder / "sheet.ply";
  write_mesh(file, sheet(70));  // 9800 faces, each seen from sixteen points
  const json whole = report_of("--all " + file).at("meshes").at(0), mesh = report_of(file).at("meshes").at(0);
  EXPECT_FALSE(whole.contains("sample"));
  const json sample = mesh.at("sample");
  EXPECT_EQ(sample.at("of_each_kind"), 100'000);
  EXPECT_EQ(sample.at("of"), whole.at("total").at("decisions"));
  const std::uint64_t left_out = 16 * 9800 - 100'000;
  EXPECT_EQ(sample.at("decisions").get<std::uint64_t>() + left_out, sample.at("of").get<std::uint64_t>());
  for (std::size_t m = 0; m < method_count; ++m) {
    const json few = mesh.at("total").at("methods").at(m), all = whole.at("total").at("methods").at(m);
    EXPECT_EQ(few.at("decisions"), sample.at(is_asked(m, Asked::exact) ? "of" : "decisions"));
    EXPECT_EQ(all.at("decisions"), sample.at("of"));
    EXPECT_LE(few.at("wrong"), all.at("wrong"));
  }
  EXPECT_THAT(run("$PLUMB check " + file).out,
              AllOf(HasSubstr("decisions, a sample over the whole mesh"), HasSubstr("at most 100,000 of each kind")));
  EXPECT_EQ(mesh.at("total").at("stages"), whole.at("total").at("stages"));
}

#ifdef NDEBUG
TEST(Check, TakesSecondsForAMillionTriangles) {
  if (battery::sanitized) GTEST_SKIP() << "what is watched takes its time";
  const Folder folder;
  write_mesh(folder / "big.ply", sheet(708));
  rusage before{}, after{};
  ::getrusage(RUSAGE_CHILDREN, &before);
  EXPECT_EQ(run("$PLUMB check " + (folder / "big.ply")).code, 0);
  ::getrusage(RUSAGE_CHILDREN, &after);
  EXPECT_LT(after.ru_utime.tv_sec - before.ru_utime.tv_sec, 20);  // of all threads together
}
#endif

TEST(Check, FindsFloatsWrongAndTheExactSignsRight) {
  const json& total = embedded_report().at("total");
  std::set<std::string> seen;
  for (const json& m : total.at("methods")) {
    const std::string name = m.at("method");
    seen.insert(name);
    const int wrong = m.at("wrong");
    if (name == "exact" || name == "plan" || name == "interval") {
      EXPECT_EQ(wrong, 0) << name;
    } else if (name != "long-double") {  // which is wide enough on some processors
      EXPECT_GT(wrong, 0) << name;
    }
    EXPECT_EQ(m.at("decisions"), total.at("decisions"));
  }
  EXPECT_EQ(seen.size(), method_names.size());
}

TEST(Check, GivesTheSameAnswersOnEveryNumberOfThreads) {
  const auto without_times = [](json report) {
    json answers = json::array();
    for (const json& m : report.at("meshes").at(0).at("total").at("methods")) {
      answers.push_back({m.at("method"), m.at("wrong"), m.at("unsure"), m.at("zeros_missed"), m.at("zeros_invented"),
                         m.contains("worst") ? m.at("worst") : json()});
    }
    return answers;
  };
  const Folder folder;
  const std::string mesh = " " + (folder / "sheet.ply");
  write_mesh(folder / "sheet.ply", sheet(battery::sanitized ? 6 : 30));
  const json one = without_times(report_of("--threads 1" + mesh));
  EXPECT_GT(one.at(0).at(1), 0);
  EXPECT_EQ(one, without_times(report_of("--threads 2" + mesh)));
  EXPECT_EQ(one, without_times(report_of("--threads 7" + mesh)));
}

TEST(Check, FailsOnWrongSignsWhereAskedTo) {
  const Folder folder;
  write_mesh(folder / "sheet.ply", sheet(3));
  const std::string check = "$PLUMB check " + (folder / "sheet.ply");
  EXPECT_EQ(run(check + " --fail-on-wrong double").code, 1);
  EXPECT_EQ(run(check + " --fail-on-wrong exact").code, 0);
  EXPECT_EQ(run(check + " --fail-on-wrong exact --fail-on-wrong float32").code, 1);
  EXPECT_EQ(run(check + " --fail-on-wrong interval --verify").code, 0);
}

TEST(Check, NamesWorstCasesThatSignReplays) {
  int replayed = 0;
  for (const json& m : embedded_report().at("total").at("methods")) {
    if (!m.contains("worst") || m.at("worst").is_null()) continue;
    const std::string line = m.at("worst").at("case");
    const Outcome o = run("$PLUMB sign", line + "\n");
    EXPECT_EQ(o.code, 0) << line;  // its "= sign" is the exact one
    EXPECT_EQ(o.out.front(), line.back());
    ++replayed;
  }
  EXPECT_GE(replayed, 4);
}

TEST(Check, ReadsItsOwnSampleFromEveryFormat) {
  if (battery::sanitized) GTEST_SKIP() << "a minute; sample_part_test and surface/ read every format";
  const Folder folder;
  const json& own = embedded_report();
  for (const std::string name : {"s.obj", "s.off", "s.ply", "s.stl"}) {
    EXPECT_EQ(run("$PLUMB check --write-sample " + (folder / name)).code, 0);
    const json read = report_of(folder / name).at("meshes").at(0);
    EXPECT_EQ(read.at("triangles"), own.at("triangles")) << name;
    EXPECT_EQ(read.at("statistics").at("zero_area_triangles"), 12) << name;
    if (name == "s.stl") continue;  // it knows no indices: what was repeated is merged
    for (const char* part : {"statistics", "lattice", "edge_bends"})
      EXPECT_EQ(read.at(part), own.at(part)) << name << part;
  }
}

TEST(Check, ChecksSeveralMeshesAndDrawsThem) {
  const Folder folder;
  put(folder / "one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write_mesh(folder / "-s.obj", sheet(3));
  const std::string chart = folder / "chart.svg", report = folder / "report.json";
  const Outcome o = run("$PLUMB check " + (folder / "one.obj") + " --chart " + chart + " --json " + report + " -- " +
                        (folder / "-s.obj"));
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("one.obj"), HasSubstr("-s.obj")));
  EXPECT_EQ(json::parse(content(report)).at("meshes").size(), 2U);
  EXPECT_THAT(content(chart), AllOf(StartsWith("<svg"), HasSubstr(">exact"), HasSubstr(">float32")));
}

TEST(Check, TakesNamesOfAnyBytes) {
  const Folder folder;
  const std::string mesh = folder / "na\xFF\xFEme.obj", chart = folder / "chart.svg";
  put(mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const json report = report_of(mesh);
  EXPECT_THAT(std::string(report.at("meshes").at(0).at("mesh")), testing::EndsWith("na\uFFFD\uFFFDme.obj"));
  EXPECT_EQ(run("$PLUMB check --chart " + chart + " " + mesh).code, 0);
  EXPECT_THAT(content(chart), AllOf(HasSubstr("na\uFFFD\uFFFDme.obj"), Not(HasSubstr("\xFF"))));
}

TEST(Check, RefusesEachBadFileInItsOwnWords) {
  const Folder folder;
  put(folder / "empty.obj", "");
  put(folder / "text.obj", "hello\n");
  put(folder / "points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  put(folder / "index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  put(folder / "number.obj", "v 0 0 0\nv 1 0 zero\nv 0 1 0\nf 1 2 3\n");
  put(folder / "nan.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n");
  put(folder / "short.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n");
  std::set<std::string> words;
  for (const std::string name :
       {"missing.obj", "empty.obj", "text.obj", "points.obj", "index.obj", "number.obj", "nan.obj", "short.ply"}) {
    const Outcome o = run("$PLUMB check " + (folder / name));
    EXPECT_EQ(o.code, 2) << name;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: " + (folder / name)), testing::EndsWith("\n"))) << name;
    words.insert(o.err.substr(o.err.find(": ", 8)));
  }
  EXPECT_EQ(words.size(), 8U);
  EXPECT_THAT(run("$PLUMB check " + (folder / "index.obj")).err, HasSubstr("index.obj:4: "));
}

TEST(Check, ChecksEveryMeshInAFolder) {
  const Folder folder;
  for (const char* name : {"b.obj", "A.OBJ", "sub/deep/c.obj"}) {
    std::filesystem::create_directories(std::filesystem::path(folder / name).parent_path());
    put(folder / name, triangle);
  }
  put(folder / "d.obj.gz", surface_test::gzipped(triangle));
  put(folder / "notes.txt", "v is no vertex here");
  put(folder / "sub/part.step", "ISO-10303-21;");
  std::filesystem::create_directory_symlink(folder / ".", folder / "sub/round");
  const json report = report_of(folder / ".");
  std::vector<std::string> names;
  for (const json& mesh : report.at("meshes")) names.push_back(mesh.at("mesh"));
  EXPECT_THAT(names, testing::ElementsAre(folder / "./A.OBJ", folder / "./b.obj", folder / "./d.obj.gz",
                                          folder / "./sub/deep/c.obj"));
  EXPECT_EQ(report.at("passed_over"),
            json({folder / "./notes.txt", folder / "./sub/part.step", folder / "./sub/round"}));
  const Outcome o = run("$PLUMB check " + (folder / "."));
  EXPECT_THAT(lines_of(o.out).front(),
              AllOf(HasSubstr("4 meshes; passed over, no meshes by their names: "), HasSubstr("notes.txt")));
  EXPECT_THAT(o.out, HasSubstr("all 4 meshes"));

  put(folder / "bad.obj", "f 1 2 3\n");  // the others are checked
  const Outcome bad = run("$PLUMB check " + (folder / "."));
  EXPECT_EQ(bad.code, 2);
  EXPECT_THAT(bad.err, HasSubstr("bad.obj:1: "));
  EXPECT_THAT(bad.out, HasSubstr("all 4 meshes"));
}

TEST(Check, ReportsOnAFolderOfWhichSomeCannotBeRead) {
  const Folder folder;
  std::filesystem::create_directory(folder / "parts");
  put(folder / "parts/a.obj", triangle);
  put(folder / "parts/b.obj", "f 1 2 3\n");
  put(folder / "parts/c.stl", "");
  put(folder / "parts/d.obj", triangle);
  const std::string check = "cd " + (folder / "") + " && $PLUMB check ";
  const Outcome brief = run(check + "--brief parts");
  EXPECT_EQ(brief.code, 2);
  const std::vector<std::string> lines = lines_of(brief.out);
  ASSERT_EQ(lines.size(), 4U);
  const std::string open =
      ": not closed, oriented, free of self-intersections, free of degenerate triangles; 3 open edges";
  EXPECT_EQ(lines[0], "parts/a.obj" + open);
  EXPECT_THAT(lines[1], StartsWith("parts/b.obj: not read: parts/b.obj:1: "));
  EXPECT_THAT(lines[2], StartsWith("parts/c.stl: not read: "));
  EXPECT_EQ(lines[3], "parts/d.obj" + open);

  const Outcome whole = run(check + "parts --json report.json --chart chart.svg");
  EXPECT_EQ(whole.code, 2);
  EXPECT_THAT(whole.out, HasSubstr("\n2 meshes were not read\n  parts/b.obj:1: "));
  const json report = json::parse(content(folder / "report.json"));
  EXPECT_EQ(report.at("meshes").size(), 2U);
  EXPECT_EQ(report.at("not_read").size(), 2U);
  EXPECT_EQ(report.at("not_read")[0].at("mesh"), "parts/b.obj");
  EXPECT_THAT(std::string(report.at("not_read")[0].at("error")), StartsWith("parts/b.obj:1: "));
  EXPECT_THAT(content(folder / "chart.svg"), StartsWith("<svg"));
  // What is named and cannot be read is another thing: nothing is replaced then.
  EXPECT_EQ(run(check + "parts missing.obj --json report.json --brief").code, 2);
  EXPECT_EQ(json::parse(content(folder / "report.json")), report);
}

TEST(Check, TellsARatioOfTimesOnlyWhereItWasMeasured) {
  const Folder folder;
  write_mesh(folder / "few.obj", sheet(6));
  write_mesh(folder / "many.obj", sheet(30));
  const auto advice = [&](const char* file) {
    return std::string(report_of(folder / file).at("meshes").at(0).at("verdict").at("advice"));
  };
  EXPECT_THAT(advice("few.obj"), AllOf(HasSubstr("exact"), Not(HasSubstr("times the time"))));
  EXPECT_THAT(advice("many.obj"), HasSubstr("times the time of double"));
}

TEST(Check, RefusesAFolderWithoutMeshes) {
  const Folder folder;
  put(folder / "notes.txt", "nothing");
  const Outcome o = run("$PLUMB check " + (folder / "."));
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, AllOf(StartsWith("plumb: " + (folder / ".")), HasSubstr("holds no mesh")));
}

TEST(Check, ReadsStandardInput) {
  const Folder folder;
  write_mesh(folder / "t.ply", sheet(3));
  for (const char* pack : {"cat", "gzip -c"}) {
    const Outcome o = run(pack + (" " + (folder / "t.ply")) + " | $PLUMB check -");
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_EQ(lines_of(o.out).front(), "standard input");
    EXPECT_THAT(o.out, HasSubstr("PLY, binary little endian"));
  }
  EXPECT_THAT(run("$PLUMB check -", "hello").err, StartsWith("plumb: standard input: neither the name"));
  EXPECT_THAT(run("$PLUMB check -", "").err, HasSubstr("standard input: the file is empty"));
  EXPECT_THAT(run("$PLUMB check - -", triangle).err, HasSubstr("stands twice"));
  EXPECT_EQ(run("$PLUMB check - <&-").code, 2);
}

TEST(Check, BoundsWhatAPackedMeshUnpacksTo) {
  const Folder folder;
  const std::size_t megabytes = battery::sanitized ? 4 : 40;
  put(folder / "bomb.obj.gz", surface_test::gzipped(triangle + std::string(megabytes << 20, '\n')));
  const std::string file = folder / "bomb.obj.gz", enough = "--unpacked " + std::to_string(megabytes + 1) + " ";
  const std::string below = "$PLUMB check --unpacked " + std::to_string(megabytes - 1) + " ";
  const Outcome o = run(battery::sanitized ? below + file : "$PLUMB check " + file);
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, AllOf(StartsWith("plumb: " + file + ": unpacks to more than "), HasSubstr("raise the limit")));
  EXPECT_EQ(run("$PLUMB check " + enough + file).code, 0);
  EXPECT_EQ(run(below + file).code, 2);
  const json read = report_of(enough + file).at("meshes").at(0).at("load");
  EXPECT_EQ(read.at("bytes"), (megabytes << 20) + std::string(triangle).size());
  EXPECT_EQ(read.at("packed_bytes"), std::filesystem::file_size(file));
}

TEST(Check, WritesAReportOverAnOldOne) {
  const Folder folder;
  put(folder / "t.obj", triangle);
  const std::string write = "$PLUMB check --json " + (folder / "report.json") + " " + (folder / "t.obj");
  EXPECT_EQ(run(write).code, 0);
  EXPECT_EQ(run(write).err, "");  // JSON alone makes no glTF of it
}

TEST(Check, ReadsPackagesWithTheirUnitsAndParts) {
  const Folder folder;
  const std::string turned = "<item objectid=\"1\" transform=\"0.1 0 0 0 1 0 0 0 1 0 0 0\"/>";
  put(folder / "t.3mf", surface_test::package_of(surface_test::model_of(surface_test::tetrahedron_object, turned)));
  EXPECT_THAT(run("$PLUMB check " + (folder / "t.3mf")).out,
              AllOf(HasSubstr("  file        3MF, ASCII"), HasSubstr("1 placed mesh; the unit is the millimeter"),
                    HasSubstr("12 coordinates made by transforms, 0 of them rounded")));
  const json file = report_of(folder / "t.3mf").at("meshes").at(0).at("load");
  EXPECT_EQ(file.at("unit"), "millimeter");
  EXPECT_EQ(file.at("transformed_coordinates"), 12);
  EXPECT_EQ(run("$PLUMB check - <" + (folder / "t.3mf")).code, 0);
}

TEST(Check, SaysOfForeignFormatsWhatConvertsThem) {
  const Folder folder;
  put(folder / "part.step", "ISO-10303-21;\nHEADER;\n");
  put(folder / "named.stl", "ISO-10303-21;\nHEADER;\n");
  for (const char* name : {"part.step", "named.stl"}) {
    const Outcome o = run("$PLUMB check " + (folder / name));
    EXPECT_EQ(o.code, 2);
    EXPECT_EQ(lines_of(o.err).size(), 1U);
    EXPECT_THAT(o.err, HasSubstr("this is STEP, a CAD format of curved solids, no mesh: convert it with `gmsh"));
  }
}

TEST(Check, ChecksTheOtherMeshesBesideABadOne) {
  const Folder folder;
  put(folder / "one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome o = run("$PLUMB check " + (folder / "missing.obj") + " " + (folder / "one.obj"));
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("missing.obj"));
  EXPECT_THAT(o.out, HasSubstr("one.obj"));
}

TEST(Check, NamesAMissingFileWithoutItsControlCharacters) {
  const Outcome o = run("$PLUMB check \"$(printf 'red\\033[31m.obj')\"");
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("red?[31m.obj"));
}

TEST(Check, RefusesOutputsThatCannotBeWritten) {
  const Folder folder;
  put(folder / "t.obj", triangle);
  const std::string check = "$PLUMB check " + (folder / "t.obj") + " ";
  for (const std::string option : {"--json", "--chart"}) {
    const Outcome full = run(check + option + " /dev/full");
    EXPECT_EQ(full.code, 2) << option;
    EXPECT_THAT(full.err, AllOf(StartsWith("plumb: "), HasSubstr("/dev/full"), HasSubstr("No space"))) << option;
    EXPECT_EQ(run(check + option + " /no/such/folder/file").code, 2) << option;
  }
  EXPECT_EQ(run(check + ">/dev/full").code, 2);
  EXPECT_EQ(run("$PLUMB check --write-sample /no/such/folder/file.obj").code, 2);
  EXPECT_THAT(run("$PLUMB check --write-sample /tmp/mesh.xyz").err, HasSubstr(".obj, .off, .stl or .ply"));
}

TEST(Check, UsesColorsOnATerminalOnly) {
  if (!has_terminals()) return;
  const Folder folder;
  put(folder / "t.obj", triangle);
  const Outcome o = run_on_terminal("unset NO_COLOR; $PLUMB check " + (folder / "t.obj"));
  EXPECT_EQ(o.code, 0);
  EXPECT_THAT(o.out, HasSubstr("\033["));
}

}  // namespace
}  // namespace plumb::tool
