// Outputs arrive whole, only when the run succeeded, and never in the place of what was not asked to be replaced.
#include "tool/terminal/output_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>

#include "plumb/arith/error.hpp"
#include "tool/run_program.hpp"
#include "tool/terminal/held_signals.hpp"
#include "tool/terminal/mesh_name.hpp"
#include "tool/terminal/write_folder.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::ptrdiff_t files_in(const std::string& folder) { return std::distance(fs::directory_iterator(folder), {}); }

/// One line on standard error, and nothing else.
void expect_refusal(const Outcome& o, const std::string& words) {
  EXPECT_EQ(o.code, 2) << o.out << o.err;
  EXPECT_EQ(o.out, "");
  EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words)));
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
}

std::string message(const std::string& path, surface::Replacing replacing = surface::Replacing::yes) {
  try {
    keep_files({{path, std::string(100, 'x'), replacing}});
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(Outputs, NeverReplaceAMesh) {
  const Folder folder;
  const std::string mesh = folder / "part.obj", hidden = folder / "part", old = folder / "old.json";
  put(mesh, kTriangle);
  put(hidden, kTriangle);
  put(old, "old");
  put(folder / "binary", std::string(80, '\0') + std::string(4, '\0'));  // a binary STL of no triangles
  put(folder / "scene", "glTF\x02");
  fs::create_symlink("part.obj", folder / "link.json");
  fs::create_hard_link(mesh, folder / "hard.json");
  for (const std::string command : {"check", "plan", "bounds"}) {
    for (const std::string option : {"--json", "--chart"}) {
      const std::string start = "$PLUMB " + command + " " + option;
      expect_refusal(run(start + " " + mesh), "is the name of a mesh");
      expect_refusal(run(start + "=" + mesh + " " + mesh), "which this run reads");
      expect_refusal(run(start + " " + (folder / "new.STL.gz") + " " + mesh), "is the name of a mesh");
      for (const std::string name : {"part", "binary", "scene"})
        expect_refusal(run(start + " " + (folder / name) + " " + mesh), "is a mesh by its content");
      for (const std::string name : {"./part.obj", "link.json", "hard.json"})
        expect_refusal(run("cd " + (folder / "") + " && " + start + " " + name + " part.obj"), "which this run reads");
      expect_refusal(run(start + " " + old + " - < " + old), old);
    }
  }
  expect_refusal(run("$PLUMB proof orient2d --out " + mesh), "is the name of a mesh");
  EXPECT_EQ(content(mesh), kTriangle);
  EXPECT_EQ(content(hidden), kTriangle);
  EXPECT_EQ(content(old), "old");
  EXPECT_EQ(files_in(folder / ""), 7);
}

TEST(Outputs, SayWhatToWriteInstead) {
  const Folder folder;
  put(folder / "part.obj", kTriangle);
  expect_refusal(run("cd " + (folder / "") + " && $PLUMB check --json part.obj"),
                 "--json takes the name of the file to write, and part.obj is the name of a mesh, which is kept; write "
                 "'--json REPORT part.obj', or '--json - part.obj' for standard output");
}

TEST(Outputs, OfASampleReplaceNothing) {
  const Folder folder;
  put(folder / "mine.obj", kTriangle);
  fs::create_symlink("mine.obj", folder / "link.obj");
  expect_refusal(run("$PLUMB check --write-sample " + (folder / "mine.obj")), "is there already");
  expect_refusal(run("$PLUMB check --write-sample " + (folder / "link.obj")), "is there already");
  EXPECT_EQ(content(folder / "mine.obj"), kTriangle);
  EXPECT_EQ(run("$PLUMB check --write-sample " + (folder / "new.obj")).code, 0);
  EXPECT_THAT(content(folder / "new.obj"), HasSubstr("f "));
  EXPECT_THAT(message(folder / "mine.obj", surface::Replacing::no), HasSubstr("exists"));
  EXPECT_EQ(message(folder / "second.obj", surface::Replacing::no), "no error");
  EXPECT_EQ(files_in(folder / ""), 4);
}

TEST(Outputs, ArriveOnlyWhenTheRunSucceeded) {
  const Folder folder;
  const std::string old = folder / "old.json", mesh = folder / "part.obj";
  put(old, "old");
  put(mesh, kTriangle);
  for (const std::string command : {"check", "plan", "bounds"}) {
    for (const std::string option : {"--json ", "--chart "}) {
      const std::string start = "$PLUMB " + command + " " + option;
      expect_refusal(run(start + old + " " + (folder / "nope.obj")), "nope.obj");
      EXPECT_EQ(run(start + old + " " + mesh + " " + (folder / "nope.obj")).code, 2);
      EXPECT_EQ(run(start + old + " " + mesh + " >/dev/full").code, 2);
      EXPECT_EQ(content(old), "old") << start;
      EXPECT_EQ(run(start + (folder / "new.json") + " " + (folder / "nope.obj")).code, 2);
      EXPECT_EQ(files_in(folder / ""), 2) << start;
    }
  }
  // An answer, not a failure: of points in one plane, which floats take out of it.
  put(mesh, "v 0 0 0\nv 0.1 0.2 0.3\nv 0.7 0.1 0.8\nv 0.8 0.3 1.1\nv 1.5 0.4 1.9\nf 1 3 2\nf 2 3 4\nf 4 3 5\n");
  EXPECT_EQ(run("$PLUMB check --fail-on-wrong float32 --json " + old + " " + mesh).code, 1);
  EXPECT_THAT(content(old), StartsWith("{"));
}

TEST(Outputs, SurviveAnInterruption) {
  const Folder folder;
  put(folder / "old.json", "old");
  for (const std::string signal : {"TERM", "HUP"}) {  // a shell's background keeps SIGINT from what runs there
    const Outcome o =
        run("$PLUMB check --verify --json " + (folder / "old.json") + " & sleep 0.1; kill -" + signal + " $!; wait $!");
    EXPECT_GT(o.code, 128) << signal;
    EXPECT_EQ(content(folder / "old.json"), "old");
    EXPECT_EQ(files_in(folder / ""), 1);
  }
}

TEST(Outputs, OfAStoppedRunLeaveNoFolder) {
  const Folder folder;
  put(folder / "part.obj", kTriangle);
  const std::vector<std::string> stopped = {
      "$PLUMB section --plane z=0.5 --out " + (folder / "new") + " " + (folder / "part.obj") + " >/dev/full",
      "ulimit -f 0; exec $PLUMB section -q --plane z=0 --out " + (folder / "new") + " " + (folder / "part.obj")};
  for (const std::string& line : stopped) {
    EXPECT_GT(run(line).code, 1) << line;
    EXPECT_EQ(files_in(folder / ""), 1) << line;
  }
}

TEST(Outputs, LargerThanAFileMayBeAreRefused) {
  const Folder folder;
  put(folder / "old.json", "old");
  put(folder / "part.obj", kTriangle);
  expect_refusal(run("ulimit -f 8; exec $PLUMB check -q --json " + (folder / "old.json") + " " + (folder / "part.obj")),
                 "File too large");
  EXPECT_EQ(content(folder / "old.json"), "old");
  EXPECT_EQ(files_in(folder / ""), 2);
}

TEST(Outputs, AreRemovedBeforeASignalIsObeyed) {
  const Folder folder;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_EXIT(
        {
          const HeldSignals held;
          const surface::StagedFile staged(folder / "new.json", "text");
          std::raise(signal);
          if (files_in(folder / "") != 1 || !HeldSignals::arrived()) std::_Exit(3);
        },
        testing::KilledBySignal(signal), "");
    EXPECT_EQ(files_in(folder / ""), 0);
  }
}

TEST(Outputs, KeepModesAndLinks) {
  const Folder folder;
  const std::string old = folder / "old.json", link = folder / "link.json";
  put(old, "old");
  fs::permissions(old, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::create_symlink("old.json", link);
  fs::create_symlink("fresh.json", folder / "dangling.json");
  EXPECT_EQ(message(link), "no error");
  EXPECT_EQ(message(folder / "dangling.json"), "no error");
  EXPECT_TRUE(fs::is_symlink(link) && fs::is_symlink(folder / "dangling.json"));
  EXPECT_EQ(content(old), std::string(100, 'x'));
  EXPECT_EQ(content(folder / "fresh.json"), std::string(100, 'x'));
  struct stat status {};
  ASSERT_EQ(::stat(old.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
  const mode_t mask = ::umask(0027);
  EXPECT_EQ(message(folder / "new.json"), "no error");
  ::umask(mask);
  ASSERT_EQ(::stat((folder / "new.json").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(Outputs, GoIntoPipesAndStreams) {
  const Folder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(run("$PLUMB proof orient2d --out " + (folder / "pipe") + " & cat " + (folder / "pipe")).out,
              HasSubstr("orient2d"));
  const std::string script = run("$PLUMB proof orient2d").out;
  EXPECT_EQ(run("$PLUMB proof orient2d --out /dev/stdout").out, script);
  EXPECT_EQ(run("$PLUMB proof orient2d --out /dev/stderr 2>&1 >/dev/null").out, script);
  EXPECT_EQ(run("$PLUMB proof orient2d --out /dev/null").out, "");
  const std::string file = folder / "file";  // which standard output already is
  EXPECT_EQ(run("{ echo first; $PLUMB proof orient2d --out " + file + "; echo last; } > " + file).code, 0);
  EXPECT_EQ(content(file), "first\n" + script + "last\n");
  put(folder / "part.obj", kTriangle);
  EXPECT_THAT(run("$PLUMB check --json /dev/stdout " + (folder / "part.obj")).out, StartsWith("{"));
}

TEST(Outputs, AreNotOneFileTwice) {
  const Folder folder;
  for (const std::string pair :
       {"a --chart a", "a --chart ./a", "a --chart link", "- --chart -", "- --chart /dev/stdout"}) {
    fs::remove(folder / "link");
    fs::create_symlink("a", folder / "link");
    expect_refusal(run("cd " + (folder / "") + " && $PLUMB check --json " + pair),
                   "--json and --chart name the same output");
  }
}

TEST(Outputs, NameWhatCannotBeWritten) {
  const Folder folder;
  EXPECT_THAT(message("/dev/full"), AllOf(HasSubstr("/dev/full"), HasSubstr("No space")));
  EXPECT_THAT(message(folder / "no/such"), HasSubstr("No such file"));
  EXPECT_THAT(message("/tmp"), AllOf(HasSubstr("/tmp"), HasSubstr("directory")));
  EXPECT_THAT(message(""), HasSubstr("No such file"));
  EXPECT_EQ(message(folder / std::string(255, 'x')), "no error");
}

std::string names_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  std::string all;
  for (const std::string& name : names) all += name + " ";
  return all;
}

TEST(Reports, LeaveOthersFilesAlone) {
  const Folder folder;
  put(folder / "notes.txt", "mine");
  write_report(folder / "", "chart", {{"chart.txt", "one"}, {"a.svg", "one"}, {"b.svg", "one"}});
  write_report(folder / "", "fuzz", {{"case-1.obj", "one"}});
  put(folder / "c.svg", "mine");
  write_report(folder / "", "chart", {{"chart.txt", "two"}, {"b.svg", "two"}});  // a.svg was the older report's
  EXPECT_EQ(names_in(folder / ""), ".plumb-chart-files .plumb-fuzz-files b.svg c.svg case-1.obj chart.txt notes.txt ");
  EXPECT_EQ(content(folder / "chart.txt") + content(folder / "b.svg"), "twotwo");
  try {
    write_report(folder / "", "chart", {{"chart.txt", "three"}, {"c.svg", "three"}});
    FAIL() << "somebody's file was replaced";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("c.svg is there already and is none of an older report's files"));
  }
  EXPECT_EQ(content(folder / "chart.txt") + content(folder / "c.svg") + content(folder / "notes.txt"), "twominemine");
}

TEST(Reports, ArriveWhereTheReaderOfStandardOutputLeft) {
  const Folder folder;
  put(folder / "part.obj", kTriangle);
  // The reader is gone before the first word.
  run("{ sleep 0.2; exec $PLUMB section --plane z=0 --out " + (folder / "r") + " " + (folder / "part.obj") +
      "; } | true");
  EXPECT_THAT(content(folder / "r/section-0001.svg"), StartsWith("<svg"));
}

TEST(Reports, NeedAFolder) {
  const Folder folder;
  put(folder / "part.obj", kTriangle);
  put(folder / "file", "mine");
  expect_refusal(run("$PLUMB section --plane z=0 " + (folder / "part.obj") + " --out " + (folder / "file")),
                 "file: Not a directory");
  expect_refusal(run("$PLUMB help --write-pages " + (folder / "file")), "cannot write into " + (folder / "file"));
  run("$PLUMB help --write-pages " + (folder / "share") + " >/dev/full");
  EXPECT_EQ(files_in(folder / ""), 2);
  EXPECT_EQ(content(folder / "file"), "mine");
}

TEST(Reports, TrustNoListBeyondTheirFolder) {
  const Folder folder;
  fs::create_directories(folder / "r/deep");
  put(folder / "outside", "mine");
  put(folder / "r/deep/inside", "mine");
  put(folder / "r/.plumb-chart-files", "../outside\ndeep/inside\ndeep\n..\n.\n\n" + (folder / "outside") + "\n");
  write_report(folder / "r", "chart", {{"chart.txt", "one"}});
  EXPECT_EQ(content(folder / "outside") + content(folder / "r/deep/inside"), "minemine");
}

TEST(Reports, RefuseBeforeTheyWork) {
  const Folder folder;
  const std::string mesh = folder / "part.obj";
  put(mesh, kTriangle);
  put(folder / "section-0001.svg", "mine");
  const std::string words =
      "is there already and is none of an older report's files; give another folder, or remove it";
  expect_refusal(run("$PLUMB section --plane z=0 " + mesh + " --out " + (folder / "")), words);
  EXPECT_EQ(files_in(folder / ""), 2);
}

TEST(MeshName, IsThatOfAnyFormat) {
  for (const char* const name : {"a.obj", "a.OBJ", "b/a.stl", "a.3mf", "a.gltf", "a.step.gz", "a.ply.zip"})
    EXPECT_NE(why_mesh(name), "") << name;
  for (const char* const name : {"a.json", "a.svg", "obj", "a.obj.json", "a.gz", "a.svg.gz", ".obj"})
    EXPECT_EQ(why_mesh(name), "") << name;
}

}  // namespace
}  // namespace plumb::tool
