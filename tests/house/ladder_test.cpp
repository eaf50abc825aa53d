// Does this tree keep the house's rules, and would the check notice if it did not?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "house/rules.hpp"

namespace plumb::house {
namespace {

namespace fs = std::filesystem;

TEST(House, ThisTreeKeepsTheRules) { EXPECT_THAT(breaches(PLUMB_SOURCE_DIR), testing::IsEmpty()); }

/// A small tree that keeps every rule.
class SmallTree : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "plumb-house-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    tree_ = pattern;
    for (const std::string& name : top_level) {
      if (name.find('.') == std::string::npos && name != "bootstrap" && name != "LICENSE") {
        fs::create_directory(tree_ / name);
      } else {
        write(name, "");
      }
    }
    write("predicates/orient.hpp", "#include <array>\n#include \"plumb/predicates/determinant.hpp\"\n");
    write("predicates/determinant.hpp", "");
    write("include/plumb/arith/rational.hpp", "#include <gmpxx.h>\n");
    write("include/plumb/arith/sign.hpp", "#include <optional>\n");
    write("include/plumb/certify/decide.hpp",
          "#include \"plumb/arith/sign.hpp\"\n#include \"plumb/predicates/orient.hpp\"\n");
    write("include/plumb/certify/cgal_kernel.hpp",
          "#include <CGAL/enum.h>\n#include \"plumb/certify/cgal_signs.hpp\"\n");
    write("include/plumb/predicates.hpp",
          "// tool/report.hpp, predicates/orient.hpp, geometry/sphere.hpp, certify/all.hpp, certify/cgal_kernel.hpp, "
          "certify/from_c.hpp, certify/mesh.hpp, certify/odd.hpp,\n"
          "// certify/slow.hpp, figure/basic/fit.hpp, degenerate/points.hpp, query/ray/hit.hpp, "
          "query/ray/seen.hpp\n#include "
          "\"plumb/certify/decide.hpp\"\n");
    write("include/plumb/certify/detail/stage.hpp",
          "namespace plumb {\nnamespace certify {\n}  // namespace certify\n");
    write("include/plumb/surface.hpp",
          "#include \"plumb/surface/file/mesh.hpp\"  // surface/file/cgal.hpp, surface/file/hull.hpp\n");
    write("include/plumb/surface/file/mesh.hpp", "#include \"plumb/predicates.hpp\"\n");
    write("include/plumb/plumb.hpp", "#include \"plumb/surface.hpp\"\n");
    write("src/surface/file/read.cpp",
          "#include \"plumb/surface/file/mesh.hpp\"\n#include \"surface/file/parser.hpp\"\n");
    write("src/figure/basic/near.hpp",
          "constexpr double thin = 0x1p-40;  // a guess\nx *= 0x1p-9;  // powers of two\n");
    write("src/tool/mesh/near.hpp", "constexpr double thin = 0x1p-40;\n");
    write("src/surface/file/parser.hpp", "");
    write("include/plumb/classic.h", "");
    write("src/classic/classic.cpp", "#include \"plumb/classic.h\"\n#include \"plumb/certify/decide.hpp\"\n");
    write("src/install.cmake", "");
    write("include/plumb/query/ray/seen.hpp",
          "namespace plumb::query {\nstruct Hit {\n};\nstruct Other;\n}  // namespace plumb::query\n");
    write("src/query/ray/seen.cpp",
          "namespace plumb::query {\nnamespace {\nstruct Part {};\nusing Hits = int;\n}  // namespace\n"
          "struct Other {};\ntemplate <>\nstruct Hit<int> {};\n}  // namespace plumb::query\n");
    write("src/query/overlap/seen.cpp",
          "namespace plumb::query {\nnamespace {\nstruct Part {};\nusing Hits = int;\n}  // namespace\n"
          "#if 1\nstruct Other {};\n#endif\n}  // namespace plumb::query\n");
    write("src/python/signs.cpp", "#include \"tool/mesh/near.hpp\"\n#include <pybind11/pybind11.h>\n");
    write("src/tool/program/main.cpp", "#include \"tool/mesh/report.hpp\"\n#include <fmt/core.h>\n");
    write("tests/oracle/cgal.cpp", "#include <CGAL/Gmpq.h>\n");
    write("docs/examples/cgal/main.cpp", "#include <CGAL/enum.h>\n#include <plumb/certify/cgal_kernel.hpp>\n");
    write(".clang-format", "");
    write("build/release/anything_common.txt", "");
  }
  void TearDown() override { fs::remove_all(tree_); }

  void write(const std::string& path, const std::string& text) {
    fs::create_directories((tree_ / path).parent_path());
    std::ofstream(tree_ / path) << text;
  }

  fs::path tree_;
};

MATCHER_P2(Is, file, what, "") { return arg.file == file && arg.what.find(what) != std::string::npos; }

TEST_F(SmallTree, IsWithoutBreach) { EXPECT_THAT(breaches(tree_), testing::IsEmpty()); }

TEST_F(SmallTree, EveryBreachIsNoticedAlone) {
  struct Case {
    std::string path, text, what;
  };
  const std::vector<Case> cases = {
      {"notes.md", "", "not a name of the top level"},
      {"cmake/flags.cmake", "", "not a name of the top level"},
      {"include/other.hpp", "", "no rung"},
      {"include/plumb/sphere.hpp", "", "no rung"},
      {"include/plumb/tool/report.hpp", "", "no rung"},
      {"include/plumb/predicates/orient.hpp", "", "no rung"},
      {"include/plumb/geometry/sphere.hpp", "", "no rung"},
      {"src/geometry/sphere.cpp", "", "no rung"},
      {"src/sphere.cpp", "", "no rung"},
      {"predicates/orient.cpp", "", "no rung"},
      {"predicates/circle.hpp", "#include \"plumb/arith/sign.hpp\"\n", "later folder"},
      {"include/plumb/arith/filter.hpp", "# include \"plumb/certify/decide.hpp\"\n", "later folder"},
      {"include/plumb/certify/all.hpp", "#include \"plumb/plumb.hpp\"\n", "later folder"},
      {"include/plumb/certify/mesh.hpp", "  #include \"plumb/surface.hpp\"\n", "later folder"},
      {"include/plumb/surface.h", "", "no rung"},
      {"include/plumb/certify/from_c.hpp", "#include \"plumb/classic.h\"\n", "later folder"},
      {"include/plumb/certify/odd.hpp", "#include \"plumb/geometry/sphere.hpp\"\n", "no rung"},
      {"include/plumb/query.hpp", "#include \"plumb/space/grid.hpp\"\n", "later folder"},
      {"src/arith/filter.cpp", "#include \"surface/file/parser.hpp\"\n", "later folder"},
      {"src/world/scene.cpp", "#include \"tool/report.hpp\"\n", "later folder"},
      {"src/world/scene.cpp", "#include \"../surface/file/parser.hpp\"\n", "climbs"},
      {"predicates/circle.hpp", "#include <gmp.h>\n", "stays in arith"},
      {"include/plumb/certify/slow.hpp", "#include <gmpxx.h>\n", "stays in arith"},
      {"include/plumb/figure/basic/fit.hpp", "#include <Eigen/Dense>\n", "stays at the edge"},
      {"include/plumb/figure/basic/fit.hpp", "#include <fmt/core.h>\n", "the program's"},
      {"include/plumb/degenerate/points.hpp", "#include <rapidcheck.h>\n", "stays in its bridge"},
      {"src/certify/slow.cpp", "#include <CGAL/Gmpq.h>\n", "oracles and rivals"},
      {"include/plumb/surface/file/cgal.hpp", "#include <CGAL/enum.h>\n", "oracles and rivals"},
      {"docs/examples/slicer/main.cpp", "#include <CGAL/enum.h>\n", "oracles and rivals"},
      {"src/query/body/roots.cpp", "#include \"plumb/arith/gmp.hpp\"\n", "for its users alone"},
      {"include/plumb/surface/file/hull.hpp", "#include \"plumb/certify/cgal_kernel.hpp\"\n", "for its users alone"},
      {"tests/certify/law_test.cpp", "#include <boost/multiprecision/gmp.hpp>\n", "oracles and rivals"},
      {"src/tool/mesh/hull.cpp", "#include <libqhull_r/qhull_ra.h>\n", "rivals only"},
      {"tests/oracle/boxes.cpp", "#include <fcl/math/bv/OBB.h>\n", "rivals only"},
      {"include/plumb/figure.hpp", "#include \"plumb/arith/rational.hpp\"\n", "brings gmpxx.h along"},
      {"src/surface/file/utils.hpp", "", "says nothing"},
      {"tests/tool/string_helpers.hpp", "", "says nothing"},
      {"src/tool/mesh/long.cpp", std::string(501, '\n'), "501 lines"},
      {"src/query/roots.cpp", "", "no room of query"},
      {"src/figure/odds/roots.cpp", "", "no room of figure"},
      {"include/plumb/query/ray/hit.hpp", "#include \"plumb/query/kinds/hit.hpp\"\n", "later room"},
      {"src/query/body/corner.cpp", "#include \"query/ray/numbers.hpp\"\n", "later room"},
      {"src/surface/file/odd.cpp", "#include \"parser.hpp\"\n", "without its folder"},
      {"src/surface/file/odd.cpp", "#include <plumb/surface.hpp>\n", "in brackets"},
      {"src/surface/file/odd.cpp", "namespace plumb {\nnamespace {\n}  // namespace\nnamespace mesh {\n",
       "plumb::mesh"},
      {"src/surface/file/odd.cpp", "namespace plumb::query {\n}  // namespace plumb::query\n", "not of its folder"},
      {"src/surface/file/odd.cpp", "namespace surface {\n}  // namespace surface\n", "not of its folder"},
      {"include/plumb/surface/file/odd.hpp", "", "named by no face"},
      {"src/query/ray/near.cpp", "constexpr double off = 0x1p-40;\n", "types a bound in line 1"},
      {"src/certify/near.cpp", "\n// A root and a product: together less than 3 u.\n", "types a bound in line 2"},
      {"src/space/bvh/near.cpp", "constexpr double off = 0x1p-40;\n", "types a bound in line 1"},
      {"src/surface/file/near.cpp", "\n// No area is off by at most six times that.\n", "types a bound in line 2"},
      {"src/figure/basic/near.cpp", "// A guess.\n\n\n\n\nbool near = x < 3 * filter_constant<F>();\n", "in line 6"},
      {"src/query/ray/near.cpp", "int f() {\n  __builtin_unreachable();\n}\n", "has no end in line 2"},
      {"src/query/ray/near.cpp", "namespace plumb::query {\nstruct Hit {};\n}  // namespace plumb::query\n",
       "names a type Hit, as does include/plumb/query/ray/seen.hpp"},
      {"src/query/ray/near.cpp",
       "namespace plumb::query {\ntemplate <class T>\nclass Hit final : public T {\n}  // namespace plumb::query\n",
       "names a type Hit"},
      {"src/query/ray/near.cpp", "namespace plumb {\nnamespace query {\nusing Hit = int;\n", "names a type Hit"},
      {"src/query/ray/told.cpp", "namespace plumb::query {\nnamespace {\nstruct Part {\n",
       "names a type Part, as does src/query/ray/seen.cpp"},
      {"tests/oracle/report.txt", std::string(200'001, ' '), "200001 bytes"},
  };
  for (const Case& c : cases) {
    write(c.path, c.text);
    const std::vector<Breach> found = breaches(tree_);
    ASSERT_EQ(found.size(), 1u) << c.path << " " << c.text << testing::PrintToString(found);
    EXPECT_TRUE(c.path.starts_with(found[0].file)) << found[0];  // the file, or a folder on the way to it
    EXPECT_THAT(found[0].what, testing::HasSubstr(c.what)) << c.path;
    fs::remove(tree_ / c.path);
    fs::path folder = (tree_ / c.path).parent_path();
    for (; folder != tree_ && fs::is_empty(folder); folder = folder.parent_path()) fs::remove(folder);
    ASSERT_THAT(breaches(tree_), testing::IsEmpty()) << "after " << c.path;
  }
}

TEST_F(SmallTree, ACrowdIsNoticed) {
  for (std::size_t i = 0; i < most_files; ++i) write("src/world/part_" + std::to_string(i) + ".cpp", "");
  EXPECT_THAT(breaches(tree_), testing::IsEmpty());
  write("src/world/part_more.cpp", "");
  EXPECT_THAT(breaches(tree_), testing::ElementsAre(Is("src/world", "61 files")));
}

TEST_F(SmallTree, EveryNameOfTheTopLevelIsNeeded) {
  for (const std::string& name : top_level) {
    fs::rename(tree_ / name, tree_ / ".elsewhere");
    EXPECT_THAT(breaches(tree_), testing::Contains(Is(name, "missing from the top level")));
    fs::rename(tree_ / ".elsewhere", tree_ / name);
  }
}

}  // namespace
}  // namespace plumb::house
