// Manual pages that man shows without a warning, and scripts by which shells complete what the parser takes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tool/run_program.hpp"
#include "tool/terminal/suggestion.hpp"

namespace plumb::tool {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

bool has(const std::string& program) { return run("command -v " + program).code == 0; }
const char* const mend = "is needed by this test; './bootstrap test' installs what tests need";

std::multiset<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::multiset<std::string> words;
  for (std::string word; in >> word;) words.insert(word);
  return words;
}

TEST(ManualPages, AreSoundAndHaveTheWordsOfTheHelp) {
  ASSERT_TRUE(has("groff")) << mend;
  for (const std::string& command : commands()) {
    const Outcome page = run("$PLUMB help --roff " + command + " | groff -man -ww -Kutf8 -Tascii -rLL=200n -P-cbou");
    EXPECT_EQ(page.code, 0);
    EXPECT_EQ(page.err, "") << command;
    const auto shown = words_of(page.out);
    for (const std::string& word : words_of(run("$PLUMB " + command + " --help").out)) {
      if (word == "plumb") continue;  // the page of a command is named plumb-COMMAND
      EXPECT_GE(shown.count(word), 1U) << command << ": " << word;
    }
  }
  EXPECT_EQ(run("$PLUMB help --roff | groff -man -ww -Tutf8 >/dev/null").err, "");
}

TEST(ManualPages, NameTheFormatsThatAreReadOnce) {
  const std::string all = "OBJ, OFF, STL, PLY, 3MF, glTF";
  EXPECT_THAT(run("$PLUMB help check").out, HasSubstr(all));
  for (const std::string command : {"boolean", "bounds", "bvh", "clash", "plan", "section", "convert", "intersect",
                                    "distance", "inside", "nearest", "pairs", "repair", "resolve", "split"}) {
    EXPECT_THAT(run("$PLUMB help " + command).out,
                AllOf(HasSubstr("as `plumb check`"), Not(HasSubstr("PLY; text or binary"))))
        << command;
  }
}

TEST(ManualPages, AreWrittenWhereManAndShellsLook) {
  const Folder folder;
  EXPECT_THAT(run("$PLUMB help --write-pages " + (folder / "share")).out, HasSubstr("35 files"));
  EXPECT_EQ(content(folder / "share/man/man1/plumb.1"), run("$PLUMB help --roff").out);
  for (const std::string& command : commands())
    EXPECT_EQ(content(folder / ("share/man/man1/plumb-" + command + ".1")), run("$PLUMB help --roff " + command).out);
  EXPECT_EQ(content(folder / "share/bash-completion/completions/plumb"), run("$PLUMB completion bash").out);
  EXPECT_EQ(content(folder / "share/zsh/site-functions/_plumb"), run("$PLUMB completion zsh").out);
  EXPECT_EQ(content(folder / "share/fish/vendor_completions.d/plumb.fish"), run("$PLUMB completion fish").out);
  if (has("man")) {
    const Outcome shown = run("MANPATH=" + (folder / "share/man") + " MANWIDTH=80 man plumb-check | cat");
    EXPECT_THAT(shown.out, AllOf(HasSubstr("PLUMB-CHECK(1)"), HasSubstr("--fail-on-wrong METHOD")));
  }
}

/// What bash offers for the last of the words, in a folder with two files and a folder.
std::vector<std::string> offered(const std::vector<std::string>& words) {
  const Folder folder;
  std::string line =
      "cd " + (folder / "") +
      " && touch part.obj 'two words.stl' && mkdir deep && source <(\"$PLUMB\" completion bash) && COMP_WORDS=(";
  for (const std::string& word : words) line += " '" + word + "'";
  line += ") && COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) && _plumb && printf '%s\\n' \"${COMPREPLY[@]}\"";
  std::ofstream(folder / ".script") << line;
  const Outcome o = run("bash -eu " + (folder / ".script"));
  EXPECT_EQ(o.err, "");
  std::istringstream in(o.out);
  std::vector<std::string> lines;
  for (std::string text; std::getline(in, text);) {
    if (!text.empty()) lines.push_back(text);
  }
  return lines;
}

TEST(Completion, OfBashOffersWhatTheParserTakes) {
  ASSERT_TRUE(has("bash")) << mend;
  EXPECT_THAT(offered({"plumb", "ch"}), ElementsAre("check"));
  EXPECT_THAT(offered({"plumb", ""}), IsSupersetOf(commands()));
  EXPECT_THAT(offered({"plumb", "--v"}), ElementsAre("--version"));
  EXPECT_THAT(offered({"plumb", "check", "--js"}), ElementsAre("--json"));
  EXPECT_THAT(offered({"plumb", "check", "-"}), IsSupersetOf({"--json", "--chart", "--verify", "--help", "-h"}));
  EXPECT_THAT(offered({"plumb", "check", "--fail-on-wrong", "lo"}), ElementsAre("long-double"));
  EXPECT_THAT(offered({"plumb", "check", "--fail-on-wrong", "=", "lo"}), ElementsAre("long-double"));
  EXPECT_THAT(offered({"plumb", "check", "--fail-on-wrong", "="}), Contains("float32"));
  EXPECT_THAT(offered({"plumb", "check", "pa"}), ElementsAre("part.obj"));
  EXPECT_THAT(offered({"plumb", "check", "part.obj", "two"}), ElementsAre("two words.stl"));
  EXPECT_THAT(offered({"plumb", "check", "--json", "p"}), ElementsAre("part.obj"));
  EXPECT_THAT(offered({"plumb", "check", "--threads", ""}), IsEmpty());
  EXPECT_THAT(offered({"plumb", "section", "--out", ""}), ElementsAre("deep"));
  EXPECT_THAT(offered({"plumb", "proof", "insph"}), Contains("insphere"));
  EXPECT_THAT(offered({"plumb", "sign", "orient2"}), Contains("orient2d"));
  EXPECT_THAT(offered({"plumb", "help", "doc"}), ElementsAre("doctor"));
  EXPECT_THAT(offered({"plumb", "completion", ""}), ElementsAre("bash", "zsh", "fish"));
  EXPECT_THAT(offered({"plumb", "fuzz", "--kind", "compare_distance2"}), ElementsAre("compare_distance2d"));
  EXPECT_THAT(offered({"plumb", "doctor", ""}), IsEmpty());
}

TEST(Completion, IsSoundForEveryShell) {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const std::string script = run("$PLUMB completion " + shell).out;
    for (const std::string& command : commands()) EXPECT_THAT(script, HasSubstr(command)) << shell;
    for (const char* const word : {"fail-on-wrong", "long-double", "write-pages", "orient3d"})
      EXPECT_THAT(script, HasSubstr(word)) << shell;
    const Folder folder;
    EXPECT_EQ(run("$PLUMB completion " + shell + " > " + (folder / "script")).code, 0);
    EXPECT_EQ(run(shell + " -n " + (folder / "script")).code, 0) << shell << " " << mend;
  }
  EXPECT_EQ(run("$PLUMB completion tcsh").code, 2);
}

TEST(Completion, OfFishAndZshOffersTheSame) {
  {
    ASSERT_TRUE(has("fish")) << mend;
    const auto fish = [](const std::string& line) {
      return run("fish -c '$PLUMB completion fish | source; complete -C \"" + line + "\"'").out;
    };
    EXPECT_THAT(fish("plumb che"), HasSubstr("check"));
    EXPECT_THAT(fish("plumb check --js"), HasSubstr("--json"));
    EXPECT_THAT(fish("plumb check --fail-on-wrong lo"), HasSubstr("long-double"));
    EXPECT_THAT(fish("plumb sign orient2"), HasSubstr("orient2d"));
  }
  {
    ASSERT_TRUE(has("zsh")) << mend;
    EXPECT_EQ(run("zsh -fc 'autoload -Uz compinit && compinit -u -D; source <($PLUMB completion zsh); "
                  "[[ $_comps[plumb] == _plumb ]]'")
                  .code,
              0);
  }
}

TEST(Suggestion, IsTheNearestKnownWord) {
  const std::vector<std::string> known{"bounds", "chart", "check", "plan"};
  EXPECT_EQ(nearest_word("chekc", known), "check");
  EXPECT_EQ(nearest_word("chec", known), "check");
  EXPECT_EQ(nearest_word("cherk", known), "check");
  EXPECT_EQ(nearest_word("pln", known), "plan");
  EXPECT_EQ(nearest_word("bou", known), "bounds");
  EXPECT_EQ(nearest_word("--fail", {"--all", "--fail-on-wrong"}), "--fail-on-wrong");
  EXPECT_EQ(nearest_word("frobnicate", known), "");
  EXPECT_EQ(nearest_word("", known), "");
  EXPECT_EQ(nearest_word(std::string(100'000, 'c'), known), "");
}

}  // namespace
}  // namespace plumb::tool
