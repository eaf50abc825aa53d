// The laboratory as a program: named in what it says, its pages and completion beside those of plumb, its reports whole or not
// there, its progress shown where a terminal can show it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "certify/sanitized.hpp"
#include "tool/run_program.hpp"

namespace plumb::lab {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;
using tool::content;
using tool::Folder;
using tool::Outcome;
using tool::run;
using tool::run_on_terminal;

void expect_refusal(const Outcome& o, const std::string& words) {
  EXPECT_EQ(o.code, 2) << o.err;
  EXPECT_EQ(o.out, "");
  EXPECT_THAT(o.err, AllOf(StartsWith("plumb-lab: "), HasSubstr(words)));
}

std::ptrdiff_t files_in(const std::string& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
}

TEST(Laboratory, NamesItselfInAllThatItSays) {
  for (const std::string line : {"--version", "vectors -V", "chart --version"})
    EXPECT_THAT(run("$PLUMB_LAB " + line).out, MatchesRegex("plumb-lab [0-9]+\\.[0-9]+\\.[0-9]+\n")) << line;
  expect_refusal(run("$PLUMB_LAB"), "one of chart, stability, vectors, help, completion; 'plumb-lab help' explains");
  expect_refusal(run("$PLUMB_LAB vectors --out"), "--out needs a value: write '--out DIR'; 'plumb-lab vectors --help'");
  expect_refusal(run("$PLUMB_LAB vectors --out . --seed many"), "--seed = many;");
  expect_refusal(run("$PLUMB_LAB chart --task orient2e"), "did you mean orient2d?");
  expect_refusal(run("$PLUMB_LAB chrat"), "(did you mean chart?)");
  for (const std::string& command : tool::commands()) {
    if (command != "help" && command != "completion")
      expect_refusal(run("$PLUMB_LAB " + command), "there is no command " + command + ": that is a command of plumb;");
  }
  for (const std::string command : {"chart", "stability", "vectors"}) {
    const Outcome page = run("$PLUMB_LAB help " + command);
    EXPECT_THAT(page.out, AllOf(HasSubstr("plumb-lab " + command), HasSubstr("EXIT STATUS")));
    EXPECT_EQ(page.out, run("$PLUMB_LAB " + command + " --help").out);
  }
}

TEST(Laboratory, HasPagesAndCompletionBesideThoseOfPlumb) {
  const Folder folder;
  EXPECT_THAT(run("$PLUMB_LAB help --write-pages " + (folder / "share")).out, HasSubstr("9 files"));
  for (const char* const page : {"plumb-lab", "plumb-lab-chart", "plumb-lab-stability", "plumb-lab-vectors"})
    EXPECT_THAT(content(folder / (std::string("share/man/man1/") + page + ".1")), HasSubstr("plumb\\-lab")) << page;
  EXPECT_EQ(content(folder / "share/bash-completion/completions/plumb-lab"), run("$PLUMB_LAB completion bash").out);
  EXPECT_EQ(content(folder / "share/zsh/site-functions/_plumb-lab"), run("$PLUMB_LAB completion zsh").out);
  EXPECT_EQ(content(folder / "share/fish/vendor_completions.d/plumb-lab.fish"), run("$PLUMB_LAB completion fish").out);
  EXPECT_THAT(run("fish -c '$PLUMB_LAB completion fish | source; complete -C \"plumb-lab chart --task orient2\"'").out,
              HasSubstr("orient2d"));
  std::ofstream(folder / "words")
      << "source <(\"$PLUMB_LAB\" completion bash); COMP_WORDS=(plumb-lab chart --task orient);"
      << " COMP_CWORD=3; _plumb-lab; printf '%s ' \"${COMPREPLY[@]}\"";
  EXPECT_EQ(run("bash -eu " + (folder / "words")).out, "orient2d orient3d ");
  EXPECT_EQ(run("zsh -fc 'autoload -Uz compinit && compinit -u -D; source <($PLUMB_LAB completion zsh); "
                "[[ $_comps[plumb-lab] == _plumb-lab ]]'")
                .code,
            0);
}

TEST(Reports, RefuseBeforeTheyWork) {
  const Folder folder;
  for (const std::string name : {"chart.json", "stability.html", "orient2d.txt"})
    std::ofstream(folder / name) << "mine";
  for (const std::string command : {"chart", "stability", "vectors"}) {  // in full: it must not begin
    expect_refusal(run("$PLUMB_LAB " + command + " --out " + (folder / "")),
                   "is there already and is none of an older report's files; give another folder, or remove it");
  }
  EXPECT_EQ(files_in(folder / ""), 3);
}

TEST(Reports, OfAStoppedRunLeaveNoFolder) {
  const Folder folder;
  EXPECT_GT(run("$PLUMB_LAB chart --out " + (folder / "new") + " & sleep 0.1; kill -TERM $!; wait $!").code, 1);
  EXPECT_EQ(files_in(folder / ""), 0);
}

TEST(Progress, IsSilentWhereTheTerminalObeysNoEscapes) {
  if (!tool::has_terminals()) return;
  const std::string fewer = battery::sanitized ? " --class uniform --class grid" : "";
  const std::string long_run = "$PLUMB_LAB chart --quick --task hull-3d" + fewer + " >/dev/null";
  EXPECT_THAT(run_on_terminal("NO_COLOR=1 " + long_run).out, AllOf(HasSubstr(" %  chart"), Not(HasSubstr("\033[3"))));
  EXPECT_EQ(run_on_terminal("TERM=dumb " + long_run).out, "");
  EXPECT_EQ(run_on_terminal("unset TERM; " + long_run).out, "");
}

}  // namespace
}  // namespace plumb::lab
