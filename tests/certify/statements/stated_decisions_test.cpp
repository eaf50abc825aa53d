// Is every decision that is stated over worlds held by a test?  Its derived bounds are recorded, and given to Gappa.
//
// Law: a file of the library that declares scales is included by a test that compares its bounds with
// tests/certify/statements/golden_statements.txt, and by one that has them proved; each name there is one of some test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
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
