// The program as a user meets it: help, version, exit codes, messages, outputs that cannot be written, colors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/catalog.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

void expect_refusal(const Outcome& o, const std::string& words) {
  EXPECT_EQ(o.code, 2) << o.err;
  EXPECT_EQ(o.out, "");
  EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words)));
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
}

TEST(Help, IsAManualPageOfEightyColumns) {
  std::vector<std::string> pages = commands();
  EXPECT_GE(pages.size(), 19U);
  pages.emplace_back("");
  for (const std::string& command : pages) {
    const Outcome o = run("$PLUMB " + command + " --help");
    EXPECT_EQ(o.code, 0);
    EXPECT_EQ(o.err, "");
    for (const char* section : {"NAME\n", "\nSYNOPSIS\n", "\nDESCRIPTION\n", "\nOPTIONS\n", "\nEXIT STATUS\n"}) {
      EXPECT_THAT(o.out, HasSubstr(section)) << command;
    }
    EXPECT_THAT(o.out, HasSubstr("plumb " + command));
    std::istringstream lines(o.out);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), 80U) << line;
      EXPECT_TRUE(line.empty() || line.back() != ' ') << '"' << line << '"';
    }
    EXPECT_EQ(run("$PLUMB " + command + " -h").out, o.out);
  }
}

TEST(Help, TellsEveryOptionAndPredicate) {
  const std::string check = run("$PLUMB check --help").out;
  for (const char* name : {"MESH", "--json [FILE]", "--chart [FILE]", "--threads N", "--verify",
                           "--fail-on-wrong METHOD", "--write-sample FILE", "float32", "long-double", "interval"}) {
    EXPECT_THAT(check, HasSubstr(name));
  }
  const std::string sign = run("$PLUMB sign --help").out;
  for (const CatalogEntry& e : classics()) EXPECT_THAT(sign, HasSubstr("       " + std::string(e.name) + " ax ay"));
  for (const CatalogEntry& e : catalog()) EXPECT_THAT(sign, HasSubstr("       " + std::string(e.name) + " a"));
  EXPECT_EQ(run("$PLUMB sign orient2d 0 0 --help").out, sign);
}

TEST(Help, ShowsExamplesThatDoWhatTheySay) {
  std::istringstream lines(run("$PLUMB sign --help").out);
  int examples = 0;
  std::string command;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("       plumb sign orient") || line.starts_with("       echo ")) {
      command = line.substr(7);
      command.replace(command.find("plumb"), 5, "$PLUMB");
    } else if (!command.empty()) {
      const Outcome o = run(command);
      EXPECT_EQ(o.code, 0) << command;
      const std::size_t begin = line.find("Prints \"") + 8;
      if (begin != std::string::npos + 8) {
        EXPECT_EQ(o.out, line.substr(begin, line.find('"', begin) - begin) + "\n");
      } else {
        EXPECT_THAT(o.out, StartsWith("0 ")) << command;  // the square's corners
      }
      command.clear();
      ++examples;
    }
  }
  EXPECT_EQ(examples, 3);
}

TEST(Version, IsOneLine) {
  for (const std::string line :
       {"--version", "-V", "check -V", "check part.obj --version", "pairs -V", "sign orient2d 0 0 -V", "help -V"}) {
    const Outcome o = run("$PLUMB " + line);
    EXPECT_EQ(o.code, 0) << line;
    EXPECT_THAT(o.out, testing::MatchesRegex("plumb [0-9]+\\.[0-9]+\\.[0-9]+\n")) << line;
  }
}

/// What is written behind `plumb`, and words of the refusal.
using Refusals = std::vector<std::pair<std::string, std::string>>;

void expect_refusals(const Refusals& refusals) {
  for (const auto& [line, words] : refusals) {
    SCOPED_TRACE(line);
    expect_refusal(run("$PLUMB " + line), words);
  }
}

TEST(Usage, IsRefusedInItsOwnWords) {
  expect_refusals({{"", "a command is needed"},
                   {"frobnicate", "frobnicate"},
                   {"check --frobnicate", "'plumb check --help' explains"},
                   {"check --threads", "--threads needs a value: write '--threads N'; 'plumb check --help' explains"},
                   {"section --plane", "--plane needs a value: write '--plane PLANE'"},
                   {"section --out", "--out needs a value: write '--out DIR'"},
                   {"check --threads 0", "--threads"},
                   {"check --threads -3", "--threads"},
                   {"check --threads many", "many"},
                   {"fuzz --seed many", "--seed = many;"},
                   {"check --fail-on-wrong luck", "luck not in"},
                   {"doctor -- now", "doctor takes no argument now"},
                   {"sign --frobnicate orient2d", "--frobnicate"}});
}

TEST(Help, OfACommandIsFoundByItsName) {
  EXPECT_EQ(run("$PLUMB help").out, run("$PLUMB --help").out);
  for (const std::string command : {"check", "sign", "help", "completion"})
    EXPECT_EQ(run("$PLUMB help " + command).out, run("$PLUMB " + command + " --help").out);
  expect_refusal(run("$PLUMB help chekc"), "there is no command chekc (did you mean check?)");
}

TEST(Help, IsNotThatOfSomethingElse) {
  for (const std::string line :
       {"nonsense --help", "--help nonsense", "nonsense -h", "nonsense --version", "-V nonsense"})
    expect_refusal(run("$PLUMB " + line), "there is no command nonsense; 'plumb help' explains");
}

TEST(Usage, IsSuggestedWhereItIsNear) {
  expect_refusals({{"chekc part.obj", "there is no command chekc (did you mean check?)"},
                   {"chekc --help", "there is no command chekc (did you mean check?)"},
                   {"check --jsno r.json", "there is no option --jsno (did you mean --json?)"},
                   {"check --jsno=r.json", "there is no option --jsno (did you mean --json?)"},
                   {"check --fail", "there is no option --fail (did you mean --fail-on-wrong?)"},
                   {"sign --quite orient2d", "there is no option --quite (did you mean --quiet?)"},
                   {"--versoin", "there is no option --versoin (did you mean --version?)"},
                   {"proof orient2e", "did you mean orient2d?"},
                   {"doctor now", "doctor takes no argument now"}});
}

TEST(Usage, SaysWhatThereIsInsteadOfWhatThereIsNot) {
  expect_refusals({{"chart --quick", "plumb-lab"},
                   {"stability", "plumb-lab"},
                   {"vectors --out x", "plumb-lab"},
                   {"booleans a.obj b.obj", "'plumb intersect A B' finds where two meshes cross"},
                   {"union a.obj", "'plumb section' cuts one by planes"},
                   {"mend a.obj", "'plumb repair' mends meshes"},
                   {"decompose a.obj", "'plumb parts'"},
                   {"simulate", "'plumb pairs'"}});
  for (const auto& [words, what] : std::vector<std::pair<std::string, std::string>>{
           {"booleans boolean-union Boolean unions difference subtract intersections csgs",
            "unites, intersects and subtracts"},
           {"offset thicken minkowski_sum", "meshes are not offset"},
           {"mend fix fix_normals heal clean weld fill-holes", "'plumb repair' mends meshes"},
           {"simplify decimate remesh", "meshes are not simplified"},
           {"convex-decomposition convex_decomposition decompose V-HACD convex-parts", "'plumb parts' parts solids"},
           {"scenes simulation collide collisions physics", "scenes are not played"},
           {"hulls convex-hull", "the library makes hulls"},
           {"python", "'import plumb' is the Python module"}}) {
    std::istringstream each(words);
    for (std::string word; each >> word;) {
      expect_refusal(run("$PLUMB " + word + " a.obj"), "there is no command " + word + ": ");
      EXPECT_THAT(run("$PLUMB help " + word).err, HasSubstr(what)) << word;
    }
  }
  for (const std::string near : {"boolena", "intersec", "pari", "chek", "planes"})
    EXPECT_THAT(run("$PLUMB " + near).err, Not(HasSubstr(" yet"))) << near;
}

TEST(Usage, TakesWhatOtherToolsTake) {
  const std::string script = run("$PLUMB proof orient2d").out;
  EXPECT_THAT(script, HasSubstr("orient2d"));
  for (const std::string line :
       {"proof --out=- orient2d", "proof orient2d --out -", "proof --out=- -- orient2d",
        "proof --out /no/such --out - orient2d", "--no-color proof orient2d", "proof orient2d --no-color"})
    EXPECT_EQ(run("$PLUMB " + line).out, script) << line;
  EXPECT_EQ(run("$PLUMB sign orient2d 0 0 1 0 0 1 --no-color").out, "+ filter\n");
  EXPECT_EQ(run("$PLUMB sign -- orient2d 0 0 1 0 0 -1").out, "- filter\n");
  const Folder folder;
  std::ofstream(folder / "plan") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";  // a file with a command's name
  EXPECT_EQ(run("cd " + (folder / "") + " && $PLUMB check plan").code, 0);
}

TEST(Usage, TakesNoNameOfAnOutputForStandardOutput) {
  const Folder folder;
  const std::string at = "cd " + (folder / "") + " && ";
  std::ofstream(folder / "part.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const char* line : {"check part.obj --json", "check --json --verify part.obj", "check --json -- part.obj",
                           "bounds --placements 3 part.obj --json", "section --plane z=0 part.obj --json"}) {
    const Outcome o = run(at + "$PLUMB " + line);
    EXPECT_EQ(o.code, 0) << line << ": " << o.err;
    EXPECT_THAT(o.out, StartsWith("{")) << line;
  }
  EXPECT_EQ(run("$PLUMB proof orient2d --out").out, run("$PLUMB proof orient2d").out);
  EXPECT_THAT(run(at + "$PLUMB section part.obj --svg --plane z=0").out, StartsWith("<svg"));
  expect_refusal(run(at + "$PLUMB check part.obj --json --chart"), "--json and --chart name the same output");
  expect_refusal(run(at + "$PLUMB check --json part.obj"), "--json takes the name of the file to write");
  expect_refusal(run(at + "$PLUMB check --json . part.obj"), "--json takes the name of the file to write, and . is a");
  EXPECT_EQ(run(at + "ls").out, "part.obj\n");
}

/// Three triangles of one plane, of which floats say that they are not: the part that `check` brings along takes ten
/// seconds where it is watched.
std::string tilted(const Folder& folder) {
  std::ofstream(folder / "tilted.obj") << "v 0 0 0\nv 0.1 0.2 0.3\nv 0.7 0.1 0.8\nv 0.8 0.3 1.1\nv 1.5 0.4 1.9\n"
                                          "f 1 3 2\nf 2 3 4\nf 4 3 5\n";
  return folder / "tilted.obj";
}

TEST(Quiet, LeavesTheStatusAndTheFiles) {
  const Folder folder;
  const std::string mesh = " " + tilted(folder);
  const Outcome o = run("$PLUMB check -q --fail-on-wrong float32 --json " + (folder / "r.json") + mesh);
  EXPECT_EQ(o.code, 1);
  EXPECT_EQ(o.out + o.err, "");
  EXPECT_THAT(content(folder / "r.json"), StartsWith("{"));
  EXPECT_THAT(run("$PLUMB check --quiet --json -" + mesh).out, StartsWith("{"));
  const Outcome sign = run("$PLUMB sign --quiet", "orient2d 0 0 1 0 0 1 = -\n");
  EXPECT_EQ(sign.code, 1);
  EXPECT_EQ(sign.out, "");
  EXPECT_EQ(run("$PLUMB check -q nope.obj").err, run("$PLUMB check nope.obj").err);
}

TEST(Doctor, FindsNothingHere) {
  const Outcome o = run("$PLUMB doctor");
  EXPECT_EQ(o.code, 0);
  EXPECT_THAT(o.out, AllOf(HasSubstr("rounding mode"), HasSubstr("subnormals"), HasSubstr("contraction"),
                           HasSubstr("fast-math"), HasSubstr("built by"), HasSubstr("instruction sets"),
                           HasSubstr("Everything is as the proofs assume."), Not(HasSubstr("BAD"))));
}

TEST(Doctor, TellsWhichVectorsBatchesTake) {
  EXPECT_THAT(run("$PLUMB doctor").out,
              testing::ContainsRegex("ok   batches +[a-z0-9]+; PLUMB_INSTRUCTION_SET chooses one of .*none"));
  EXPECT_THAT(run("PLUMB_INSTRUCTION_SET=none $PLUMB doctor").out,
              testing::ContainsRegex("batches +none, which was asked for;"));
  EXPECT_THAT(run("$PLUMB help doctor").out, HasSubstr("PLUMB_INSTRUCTION_SET\n"));
  const Outcome o = run("PLUMB_INSTRUCTION_SET=mmx $PLUMB doctor");
  EXPECT_EQ(o.code, 1);
  EXPECT_THAT(o.out, HasSubstr("PLUMB_INSTRUCTION_SET is \"mmx\", which this processor does not have; there are"));
}

TEST(Output, ThatCannotBeWrittenIsNoSuccess) {
  for (const std::string command :
       {"--version", "--help", "doctor", "proof orient2d", "sign --help", "sign orient2d 0 0 1 0 0 1"}) {
    const Outcome full = run("$PLUMB " + command + " >/dev/full");
    EXPECT_EQ(full.code, 2) << command;
    EXPECT_THAT(full.err, AllOf(StartsWith("plumb: cannot write standard output"), HasSubstr("No space"))) << command;
    const Outcome closed = run("$PLUMB " + command + " >&-");
    EXPECT_EQ(closed.code, 2) << command;
    EXPECT_THAT(closed.err, StartsWith("plumb: cannot write standard output")) << command;
  }
}

TEST(Output, OfComplaintsMayBeClosed) {
  EXPECT_EQ(run("$PLUMB check /no/such/mesh.obj 2>&-").code, 2);
  EXPECT_EQ(run("$PLUMB bad 2>/dev/full").code, 2);
}

TEST(Output, EndsQuietlyWhenItsReaderLeaves) {
  std::string cases;
  for (int i = 0; i < 20000; ++i) cases += "orient2d 0 0 1 0 0 1\n";
  const Outcome many = run("{ $PLUMB sign; echo \"exit $?\" >&2; } | head -n 1", cases);
  EXPECT_EQ(many.out, "+ filter\n");
  EXPECT_EQ(many.err, "exit 141\n");  // by SIGPIPE, as cat does
  const Folder folder;
  for (const std::string& command : {std::string("--help"), std::string("check --help"), "check " + tilted(folder),
                                     std::string("doctor"), std::string("proof insphere")})
    EXPECT_EQ(run("{ sleep 0.2; $PLUMB " + command + "; echo \"exit $?\" >&2; } | true").err, "exit 141\n") << command;
}

TEST(Output, BesideWhatIsReadArrivesWhenTheReaderLeft) {
  const Folder folder;
  const Outcome o = run("{ sleep 0.2; $PLUMB check --json " + (folder / "r.json") + " " + tilted(folder) +
                        "; echo \"exit $?\" >&2; } | true");
  EXPECT_EQ(o.err, "exit 141\n");
  EXPECT_THAT(content(folder / "r.json"), StartsWith("{"));
}

TEST(Colors, AreForTerminalsOnly) {
  EXPECT_THAT(run("$PLUMB doctor").out, Not(HasSubstr("\033")));
  EXPECT_THAT(run("TERM=xterm $PLUMB bad").err, Not(HasSubstr("\033")));
  if (!has_terminals()) return;
  EXPECT_THAT(run_on_terminal("unset NO_COLOR; $PLUMB doctor").out, HasSubstr("\033[32mok\033[0m"));
  EXPECT_THAT(run_on_terminal("unset NO_COLOR; $PLUMB --help").out, HasSubstr("\033[1mNAME\033[0m"));
  EXPECT_THAT(run_on_terminal("unset NO_COLOR; $PLUMB bad").out, HasSubstr("\033[31mplumb:\033[0m"));
  EXPECT_THAT(run_on_terminal("NO_COLOR= $PLUMB doctor").out, HasSubstr("\033["));
  EXPECT_THAT(run_on_terminal("NO_COLOR=1 $PLUMB doctor").out, Not(HasSubstr("\033")));
  EXPECT_THAT(run_on_terminal("TERM=dumb $PLUMB doctor").out, Not(HasSubstr("\033")));
}

}  // namespace
}  // namespace plumb::tool
