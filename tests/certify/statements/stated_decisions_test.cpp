// Is every decision that is stated over worlds held by a test?  Its derived bounds are recorded, and given to Gappa.
//
// Laws: (1) a file of the library that declares scales is included by a test that compares its bounds with
// tests/certify/statements/golden_statements.txt, and by one that has them proved; each name there is one of some test.
// (2) Each name there has mutants that are noticed, and a share of decisions that is promised by family; those of pairs
// have a share, and the mutants of their statement; those of integers have a share.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// By its path from `top` on.
using Texts = std::map<std::string, std::string>;
Texts texts_below(const fs::path& top) {
  Texts all;
  for (const auto& entry : fs::recursive_directory_iterator(top)) {
    const std::string extension = entry.path().extension().string();
    if (!entry.is_regular_file() || (extension != ".hpp" && extension != ".cpp")) continue;
    std::ifstream in(entry.path());
    all[fs::relative(entry.path(), top).generic_string()] = {std::istreambuf_iterator<char>(in), {}};
  }
  return all;
}

bool states_a_decision(const std::string& text) {
  static const std::regex scales(R"(\bScales(\s+\w+)?(\{|\s=))");
  return text.find("Scales") != std::string::npos && std::regex_search(text, scales);
}
bool is_included(const std::string& path, const Texts& tests, const std::string& beside) {
  return std::ranges::any_of(tests, [&](const auto& test) {
    return test.first.ends_with("_test.cpp") && test.second.find("#include \"" + path + "\"") != std::string::npos &&
           test.second.find(beside) != std::string::npos;
  });
}
/// The decisions of which no test looks at the bounds.
std::vector<std::string> unheld(const Texts& library, const Texts& tests) {
  std::vector<std::string> all;
  for (const auto& [path, text] : library) {
    if (path.starts_with("tool/") || path.starts_with("certify/") || !states_a_decision(text)) continue;
    if (!is_included(path, tests, "expect_golden(")) all.push_back(path + ": recorded by none");
    if (!is_included(path, tests, "expect_proved(")) all.push_back(path + ": proved by none");
  }
  return all;
}

std::string without_ending(std::string name, const std::string& ending) {
  return name.ends_with(ending) ? name.substr(0, name.size() - ending.size()) : name;
}

TEST(StatedDecisions, AreRecordedAndProved) {
  const fs::path tree = PLUMB_SOURCE_DIR;
  const Texts library = texts_below(tree / "src");
  EXPECT_GE(std::ranges::count_if(library, [](const auto& file) { return states_a_decision(file.second); }), 12);
  EXPECT_THAT(unheld(library, texts_below(tree / "tests")), testing::IsEmpty());
}

TEST(StatedDecisions, EachNameThatIsRecordedIsOneOfATest) {
  const Texts tests = texts_below(fs::path(PLUMB_SOURCE_DIR) / "tests");
  std::ifstream file(PLUMB_SOURCE_DIR "/tests/certify/statements/golden_statements.txt");
  int lines = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    ++lines;
    const std::string quoted = '"' + without_ending(line.substr(0, line.find(' ')), "_pairs") + '"';
    const auto has_it = [&](const auto& test) { return test.second.find(quoted) != std::string::npos; };
    EXPECT_TRUE(std::ranges::any_of(tests, has_it)) << line;
  }
  EXPECT_GE(lines, 130);
}

/// The names that a test gives such a call: call("name"); call of("name"), of_other("other").
std::set<std::string> named(const Texts& tests, const std::string& call) {
  static const std::regex first(R"re(^(<[^<>"]*>)?(\s\w+)?\(\s*"(\w+)")re"), next(R"re(^\),\s*\w+\("(\w+)")re");
  std::set<std::string> all;
  for (const auto& [path, text] : tests) {
    if (!path.ends_with("_test.cpp") || path.starts_with("certify/statements/stated_decisions_")) continue;
    for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
      std::string rest = text.substr(at + call.size(), 1000);
      std::smatch found;
      if (!std::regex_search(rest, found, first)) continue;
      all.insert(found[3]);
      while (std::regex_search(rest = found.suffix(), found, next)) all.insert(found[1]);
    }
  }
  return all;
}
/// The names of golden_statements.txt, and of promised_shares.txt.
struct Recorded {
  std::set<std::string> bounds, shares;
};
std::set<std::string> first_words(const fs::path& file) {
  std::set<std::string> all;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line[0] != '#') all.insert(line.substr(0, line.find(' ')));
  }
  return all;
}
/// What is missing of the decisions whose bounds are recorded.
std::vector<std::string> missing(const Recorded& recorded, const Texts& tests) {
  const std::set<std::string> mutants = named(tests, "expect_noticed");
  std::set<std::string> shares = named(tests, "PromisedShare");
  shares.merge(named(tests, "expect_share"));
  std::vector<std::string> all;
  for (const std::string& name : recorded.bounds) {
    if (!mutants.contains(without_ending(name, "_pairs"))) all.push_back(name + ": no mutants");
    if (!shares.contains(name)) all.push_back(name + ": no test of its share");
    if (!recorded.shares.contains(name)) all.push_back(name + ": no promised share");
  }
  for (const std::string& name : recorded.shares) {
    if (!recorded.bounds.contains(without_ending(name, "_integers")))
      all.push_back(name + ": a promise without a statement");
  }
  return all;
}
TEST(StatedDecisions, HaveMutantsAndAPromisedShare) {
  const fs::path tests = fs::path(PLUMB_SOURCE_DIR) / "tests", here = tests / "certify/statements";
  const Recorded recorded{first_words(here / "golden_statements.txt"), first_words(here / "promised_shares.txt")};
  EXPECT_GE(recorded.bounds.size(), 70U);
  EXPECT_THAT(missing(recorded, texts_below(tests)), testing::IsEmpty());
}
TEST(StatedDecisions, AMissingMutantOrShareIsNoticed) {
  const Recorded recorded{{"box", "box_pairs", "ray", "triangle"},
                          {"box", "box_integers", "box_pairs", "ray", "sphere"}};
  const Texts tests{{"query/box_test.cpp", "expect_noticed(\"box\", f()); PromisedShare share(\"box\");\n"},
                    {"query/ray_test.cpp",
                     "mutants::expect_noticed(\n    \"triangle\", g());\n"
                     "expect_share<12>(\"ray\", Ray{}, draw);\n"},
                    {"query/none.hpp", "expect_noticed(\"ray\", h());\n"}};
  EXPECT_THAT(
      missing(recorded, tests),
      testing::ElementsAre("box_pairs: no test of its share", "ray: no mutants", "triangle: no test of its share",
                           "triangle: no promised share", "sphere: a promise without a statement"));
}

TEST(StatedDecisions, OneThatIsForgottenIsNoticed) {
  const Texts library{{"query/ray/passed.hpp", "static constexpr Scales scales{.count = 2};\n"},
                      {"query/ray/other.hpp", "using W = Floats<double, 4, Scales{.count = 3}>;\n"},
                      {"query/ray/third.hpp", "inline constexpr Scales scales = given;\n"},
                      {"query/ray/none.hpp", "// Scales are told apart.\nauto s = Statement::scales;\n"}};
  const Texts tests{{"query/ray/passed_test.cpp", "#include \"query/ray/passed.hpp\"\nexpect_golden(expect_proved("},
                    {"query/ray/other_test.cpp", "#include \"query/ray/other.hpp\"\nexpect_golden("},
                    {"query/ray/third.hpp", "#include \"query/ray/third.hpp\"\nexpect_golden(expect_proved("}};
  EXPECT_THAT(unheld(library, tests),
              testing::ElementsAre("query/ray/other.hpp: proved by none", "query/ray/third.hpp: recorded by none",
                                   "query/ray/third.hpp: proved by none"));
}

}  // namespace
}  // namespace plumb
