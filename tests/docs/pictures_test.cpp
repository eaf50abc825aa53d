// Do all renderers draw our pictures alike?  Lines have a width in the picture's own unit, for few know strokes that do
// not scale (`vector-effect`): where it is passed over, a line one pixel wide becomes one of the unit, and a small part
// a dark rectangle.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tool/svg_lines.hpp"

namespace plumb::docs {
namespace {

namespace fs = std::filesystem;
const fs::path tree = PLUMB_SOURCE_DIR;

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Pictures, HaveLinesOfAShareOfTheirSize) {
  std::size_t pictures = 0, lines = 0;
  for (const fs::directory_entry& file : fs::recursive_directory_iterator(tree / "docs")) {
    if (file.path().extension() != ".svg") continue;
    ++pictures;
    const tool::SvgLines drawn = tool::svg_lines(content(file.path()));
    lines += drawn.widths.size();
    EXPECT_TRUE(drawn.in_pixels || !drawn.widths.empty()) << file.path() << " leaves lines a width of one unit";
    for (const double width : drawn.widths) {
      EXPECT_LE(width, drawn.larger_side / 50) << file.path();
      EXPECT_TRUE(drawn.in_pixels || width >= drawn.larger_side / 2000) << file.path();
    }
  }
  EXPECT_GT(pictures, 100U);
  EXPECT_GT(lines, 100U);
}

TEST(Pictures, DependOnNoVectorEffect) {
  std::size_t files = 0;
  for (const char* folder : {"docs", "src", "include"}) {
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(tree / folder)) {
      if (!file.is_regular_file()) continue;
      ++files;
      EXPECT_EQ(content(file.path()).find("vector-effect"), std::string::npos) << file.path();
    }
  }
  EXPECT_GT(files, 1000U);
}

}  // namespace
}  // namespace plumb::docs
