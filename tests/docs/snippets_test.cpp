// Does everything that README.md and docs/*.md show work as shown?  docs/index.md, "How these pages are tested", tells
// the reader what is done with each kind of block.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>

#include "docs/markdown.hpp"
#include "tool/run_program.hpp"

namespace plumb::docs {
namespace {

using tool::Folder, tool::Outcome;

const fs::path tree = PLUMB_SOURCE_DIR;

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// Does `text` read as `shown`, in which "..." stands for anything?
bool reads_as(const std::string& text, const std::string& shown) {
  std::size_t at = 0, from = 0;
  for (bool first = true;; first = false) {
    const std::size_t dots = shown.find("...", from);
    const std::string piece = shown.substr(from, dots == shown.npos ? shown.npos : dots - from);
    const bool last = dots == shown.npos;
    const std::size_t found = last && !first ? text.size() < at + piece.size() ? text.npos : text.size() - piece.size()
                                             : text.find(piece, at);
    if (found == text.npos || (first && found != 0) || text.compare(found, piece.size(), piece) != 0) return false;
    at = found + piece.size();
    if (last) return at == text.size();
    from = dots + 3;
  }
}

TEST(Snippets, DotsStandForAnything) {
  EXPECT_TRUE(reads_as("a b c\n", "a b c\n"));
  EXPECT_TRUE(reads_as("a b c\n", "a ... c\n"));
  EXPECT_TRUE(reads_as("a b c\nd\n", "a ...\nd\n"));
  EXPECT_TRUE(reads_as("a b c\n", "...\n"));
  EXPECT_FALSE(reads_as("a b c\n", "a b\n"));
  EXPECT_FALSE(reads_as("a b c\n", "b c\n"));
  EXPECT_FALSE(reads_as("a b c\n", "... b\n"));
  EXPECT_FALSE(reads_as("a b c\n", "a ... d ...\n"));
  EXPECT_FALSE(reads_as("ab\n", "ab...b\n"));
}

constexpr auto faces =
    "#include <cmath>\n#include <plumb/degenerate.hpp>\n#include <plumb/figure.hpp>\n#include <plumb/predicates.hpp>\n"
    "#include <plumb/query.hpp>\n#include <plumb/space.hpp>\n#include <plumb/surface.hpp>\n";

/// An option by which the face that the text includes is read before it, which is done once for all pages.  Nothing changes
/// of what the text sees; where it defines something first, nothing is read.
std::string face_read_before(const std::string& text) {
  static const Folder folder;
  if (text.find("#define ") != text.npos) return {};
  for (const std::string face : {"plumb", "world", "surface", "space", "query", "figure", "degenerate", "predicates"}) {
    const std::string include = "#include <plumb/" + face + ".hpp>\n";
    if (text.find(include) == text.npos) continue;
    const std::string header = folder / (face + ".hpp");
    if (!fs::exists(header)) {
      write(header, include);
      const Outcome read = tool::run(PLUMB_COMPILE " " PLUMB_INCLUDES " -x c++-header '" + header + "'");
      EXPECT_EQ(read.code, 0) << read.err;
    }
    return " -include '" + header + "'";
  }
  return {};
}

/// A block of statements says at its beginning what it includes.
struct Parts {
  std::string includes, statements;
};
Parts parts_of(const std::string& text) {
  Parts parts;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const bool include = line.starts_with("#include ");
    (include ? parts.includes : parts.statements) += line + '\n';
    if (include) parts.statements += '\n';  // lines keep their numbers
  }
  return parts;
}

std::string as_function(const Document& document, const Block& block, const std::string& name) {
  return "int " + name + "() {\n#line " + std::to_string(block.line) + " \"" + document.path.string() + "\"\n" +
         parts_of(block.text).statements + "return 0;\n}\n";
}

/// Preset names of CMakePresets.json.
bool is_preset(const std::string& name) {
  return text_of(tree / "CMakePresets.json").find("\"name\": \"" + name + "\"") != std::string::npos;
}

/// Commands that build the whole tree are run by .ci/run, not here: they are looked up.  Nothing for other commands.
std::optional<bool> looked_up(const std::string& line) {
  std::istringstream words(line);
  std::string word, next;
  words >> word >> next;
  if (word == "./bootstrap") return text_of(tree / "bootstrap").find("\n  " + next + ")\n") != std::string::npos;
  if (const std::size_t at = line.find("--preset "); at != line.npos) {
    std::istringstream(line.substr(at + 9)) >> next;
    return is_preset(next);
  }
  if (word.starts_with("build/") && is_preset(word.substr(6, word.find('/', 6) - 6))) return true;
  return std::nullopt;
}

/// The command with a reader's places put where the test has them, for this compiler and the sanitizers of this build.
std::string placed(std::string line) {
  const std::pair<std::string_view, std::string_view> places[]{
      {"cmake --install build/demo ", "cmake --install " PLUMB_BINARY_DIR " "},
      {"-DPLUMB_SOURCES=", "-DCMAKE_UNITY_BUILD=" PLUMB_UNITY " -DPLUMB_SOURCES="},
      {"$HOME/src/plumb", PLUMB_SOURCE_DIR},
      {"-DCMAKE_PREFIX_PATH=", "-DCMAKE_CXX_FLAGS='" PLUMB_SANITIZE_FLAGS "' -DCMAKE_PREFIX_PATH="},
      {"$HOME/plumb", "$PWD/installed"},
      {"g++ -std", PLUMB_CXX " " PLUMB_SANITIZE_FLAGS " -std"}};
  for (const auto& [shown, here] : places) {
    if (const std::size_t at = line.find(shown); at != line.npos) line.replace(at, shown.size(), here);
  }
  return line;
}

/// A program that the command runs, that not everyone has, and that is not installed here.
std::string missing_tool(const std::string& line) {
  for (const std::string name : {"doxygen", "gappa", "python3"}) {
    const bool runs = line.starts_with(name + " ") || line.ends_with("| " + name);
    if (runs && tool::run("command -v " + name).code != 0) return name;
  }
  return {};
}

/// Of the remark "file NAME" "file".
std::string about_of(const Block& block) { return block.remark.substr(0, block.remark.rfind(' ')); }

bool is_run(const Block& block) {
  const std::string about = about_of(block);
  return block.remark != "fragment" && about != "from" && about != "file" && about != "add to" &&
         block.language != "text" && block.language != "";
}
bool is_whole(const Block& block) { return block.text.find("int main(") != std::string::npos; }

class Documents : public testing::TestWithParam<fs::path> {
 protected:
  static void SetUpTestSuite() {
    ::unsetenv("GTEST_BRIEF");  // a reader's tests tell of themselves
    ::setenv("CXX", PLUMB_CXX, 1);
    faces_ = std::make_unique<Folder>();
    // A reader's project that builds our sources takes over what this build has compiled by the same commands.
    write(launcher(), "#!/bin/sh\nexec bash '" PLUMB_SOURCE_DIR "/tests/house/take_over.sh' '" PLUMB_BINARY_DIR
                      "' '.*' '" PLUMB_LAUNCHER "' \"$@\"\n");
    fs::permissions(launcher(), fs::perms::owner_all);
    ::setenv("CMAKE_CXX_COMPILER_LAUNCHER", launcher().c_str(), 1);
    write(header(), faces);
    const Outcome read = tool::run(PLUMB_COMPILE " " PLUMB_INCLUDES " -x c++-header '" + header() + "'");
    ASSERT_EQ(read.code, 0) << read.err;
  }
  static void TearDownTestSuite() { faces_.reset(); }
  static std::string header() { return *faces_ / "faces.hpp"; }
  static std::string launcher() { return *faces_ / "launcher"; }

  void SetUp() override {
    fs::create_directory(folder_ / "bin");
    fs::create_symlink(PLUMB_PROGRAM, folder_ / "bin/plumb");
    fs::create_symlink(PLUMB_LAB_PROGRAM, folder_ / "bin/plumb-lab");
    fs::create_directory_symlink(tree / "docs", folder_ / "docs");
    fs::create_directory_symlink(tree / "include", folder_ / "include");
    fs::create_directory_symlink(tree / "predicates", folder_ / "predicates");
  }

  [[nodiscard]] Outcome run_here(const std::string& lines) const {
    return tool::run("cd '" + (folder_ / "") + "'; PATH='" + (folder_ / "bin") + "':$PATH; set -e\n" + lines);
  }

  Outcome run_commands(const Block& block) const {
    std::string lines;
    std::istringstream in(block.text);
    for (std::string line; std::getline(in, line);) {
      if (const std::string missing = missing_tool(line); !missing.empty()) {
        std::cout << "skipped, " << missing << " is not installed: " << line << '\n';
      } else if (const auto known = looked_up(line)) {
        EXPECT_TRUE(*known) << line;
      } else {
        lines += placed(line) + '\n';
      }
    }
    return run_here(lines);
  }

  // A whole program as it is; statements as a function of one that has all those of the page, after the faces, which
  // the compiler reads once for all pages.
  Outcome run_program(const Document& document, const Block& block) {
    const bool whole = is_whole(block);
    const Parts parts = parts_of(block.text);
    main_ = whole ? block.text : parts.includes + "int main() {\n" + parts.statements + "}\n";
    write(folder_ / "main.cpp", main_);
    if (!whole) {
      if (!statements_) statements_ = build(statements_of(document), "statements", " -include '" + header() + "'");
      return statements_->code == 0 ? run_here("./statements " + std::to_string(block.line)) : *statements_;
    }
    const Outcome built = build(main_, "program", face_read_before(main_));
    return built.code == 0 ? run_here("./program") : built;
  }

  [[nodiscard]] Outcome build(const std::string& text, const std::string& program, const std::string& options) const {
    write(folder_ / (program + ".cpp"), text);
    return run_here(PLUMB_COMPILE " -I. " PLUMB_INCLUDES + options + " '" + (folder_ / (program + ".cpp")) + "' -o " +
                    program + " " PLUMB_LIBRARIES);
  }

  // Told by their line which to run.
  static std::string statements_of(const Document& document) {
    std::string all = faces, cases;
    for (const Block& block : document.blocks) {
      if (block.language != "cpp" || !is_run(block) || is_whole(block)) continue;
      const std::string line = std::to_string(block.line), name = "block_" + line;
      all += as_function(document, block, name);
      cases += "case " + line + ": return " + name + "();\n";
    }
    return all + "#include <cstdlib>\nint main(int, char** given) {\nswitch (std::atoi(given[1])) {\n" + cases +
           "}\nreturn 1;\n}\n";
  }

  // The project of this CMakeLists.txt with the last program as main.cpp, and the page's files, against an installed
  // tree.
  Outcome build_project(const Block& block) const {
    fs::create_directory(folder_ / "project");
    for (const std::string& file : files_) fs::copy(folder_ / file, folder_ / ("project/" + file));
    write(folder_ / "project/CMakeLists.txt", block.text);
    write(folder_ / "project/main.cpp", main_);
    return run_here("cmake --install " PLUMB_BINARY_DIR
                    " --prefix prefix\n"
                    "cmake -G Ninja -S project -B project/build -DCMAKE_PREFIX_PATH=$PWD/prefix"
                    " -DCMAKE_CXX_COMPILER=" PLUMB_CXX " -DCMAKE_CXX_FLAGS='" PLUMB_SANITIZE_FLAGS
                    "'\n"
                    "cmake --build project/build");
  }

  inline static std::unique_ptr<Folder> faces_;
  Folder folder_;
  std::string main_;
  std::optional<Outcome> statements_;  // what building them said
  std::vector<std::string> files_;
};

TEST_P(Documents, RunsAsShown) {
  const Document document = read_document(GetParam());
  Outcome last;
  bool ran = false;
  for (const Block& block : document.blocks) {
    const std::string place = document.path.string() + ":" + std::to_string(block.line) + "\n" + block.text;
    const std::string about = about_of(block);
    const std::string file = block.remark.substr(block.remark.rfind(' ') + 1);
    if (about == "from") {
      EXPECT_NE(text_of(tree / file).find(block.text), std::string::npos) << place << "is not in " << file;
      std::ofstream(folder_ / fs::path(file).filename().string(), std::ios::app) << block.text << '\n';  // part by part
    } else if (about == "file") {
      write(folder_ / file, block.text);
      files_.push_back(file);
    } else if (block.language == "text" && ran) {
      EXPECT_TRUE(reads_as(last.out, block.text)) << place << "but it prints\n" << last.out;
    } else if (is_run(block)) {
      if (block.language == "sh") {
        last = run_commands(block);
      } else if (block.language == "cpp") {
        last = run_program(document, block);
      } else if (block.language == "cmake") {
        last = build_project(block);
      } else {
        ADD_FAILURE() << place << "is in a language that is not tested: " << block.language;
      }
      EXPECT_EQ(last.code, 0) << place << last.out << last.err;
      ran = true;
      continue;
    }
    ran = false;
  }
}

// With what it includes and no more: all blocks of all pages that include the same are one program, which is looked at
// and not made.
TEST(Snippets, NameTheHeadersThatTheyNeed) {
  std::map<std::string, std::string> programs;
  int number = 0;
  for (const fs::path& path : document_paths()) {
    const Document document = read_document(path);
    for (const Block& block : document.blocks) {
      if (block.language != "cpp" || !is_run(block) || is_whole(block)) continue;
      const std::string includes = parts_of(block.text).includes;
      EXPECT_NE(includes, "") << path.string() << ":" << block.line << " says not what it includes";
      programs[includes] += as_function(document, block, "block_" + std::to_string(++number));
    }
  }
  const Folder folder;
  for (const auto& [includes, functions] : programs) {
    write(folder / "blocks.cpp", includes + functions);
    const Outcome looked = tool::run(PLUMB_COMPILE " -fsyntax-only " PLUMB_INCLUDES + face_read_before(includes) +
                                     " '" + (folder / "blocks.cpp") + "'");
    EXPECT_EQ(looked.code, 0) << includes << looked.err;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Documents, testing::ValuesIn(document_paths()),
                         [](const auto& at) { return at.param.stem().string(); });

}  // namespace
}  // namespace plumb::docs
