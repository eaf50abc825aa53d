// Do `plumb pairs` and `plumb nearest` count what they do not keep, and say where an input or an answer is too long?  Are
// rows read in every form that files have, and refused with what is wrong?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "plumb/arith/error.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/row_files.hpp"
#include "tool/rows/decimal_rows.hpp"
#include "tool/rows/named_rows.hpp"
#include "tool/rows/npy.hpp"
#include "tool/rows/number_table.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

std::string at(const Folder& folder, const std::string& command) {
  return "cd " + (folder / "") + " && $PLUMB " + command + " ";
}

/// So many lines, which say all the same.
std::string times_over(int many, const std::string& line) {
  std::string text;
  for (int i = 0; i < many; ++i) text += line + "\n";
  return text;
}

void expect_refusals(const Folder& folder, std::initializer_list<std::pair<const char*, const char*>> refusals) {
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at(folder, line));
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_EQ(o.out, "") << line;
    EXPECT_THAT(o.err, HasSubstr(words)) << line;
  }
}

TEST(PairsLimits, CountedOrKeptAndNoMore) {
  const Folder folder;
  std::ofstream(folder / "equal.csv") << times_over(300, "0,0,1,1");  // 44,850 pairs
  const Outcome counted = run(at(folder, "pairs") + "equal.csv --most 10");
  EXPECT_EQ(counted.code, 0);
  EXPECT_THAT(counted.out, HasSubstr("44,850 pairs meet: 0 touch, 44,850 overlap\n"));
  for (const char* options : {"--count", "--count --threads 1", "--count --method sort-and-sweep"}) {
    EXPECT_THAT(run(at(folder, "pairs") + "equal.csv " + options).out, HasSubstr("44,850 pairs meet")) << options;
  }
  EXPECT_EQ(json::parse(run(at(folder, "pairs") + "equal.csv --count --most 1 --json").out).at("overlapping"), 44'850);
  EXPECT_EQ(run(at(folder, "pairs") + "equal.csv --out kept.npy --most 44850").code, 0);
  EXPECT_THAT(run(at(folder, "pairs") + "equal.csv --count --most 44850 --method octree").out,
              HasSubstr("44,850 pairs"));
  expect_refusals(folder,
                  {{"pairs equal.csv --out other.npy --most 44849", "more than 44,849 pairs, 44,850 at least"},
                   {"pairs equal.csv --json --most 10", "so many are kept at the most; leave out --all and"},
                   {"pairs equal.csv --out other.npy --most 44849 --method octree", "and so many are kept at the most"},
                   {"pairs equal.csv equal.csv --count --most 89999 --method box-tree",
                    "the method box-tree keeps all that it finds, so many at the most; leave out --method"},
                   {"pairs equal.csv --all --count", "--count and --all exclude each other"},
                   {"pairs equal.csv --out other.npy --count", "--count and --out exclude each other"},
                   {"pairs equal.csv --most 1.5", "'1.5' is no whole number from 1 to "},
                   {"pairs equal.csv --json ''", "--json: the file's name is empty; name one, or '-' for"},
                   {"pairs /dev/zero", "cannot read /dev/zero: it is a device, expected a file or a pipe"}});
  EXPECT_FALSE(std::ifstream(folder / "other.npy").good());
}

TEST(NearestLimits, CountedOrKeptAndNoMore) {
  const Folder folder;
  std::ofstream(folder / "equal.csv") << times_over(300, "0.5,0.25");
  std::ofstream(folder / "queries.csv") << times_over(70, "1,1") + "0.5,0.25\n";
  const std::string nearest = at(folder, "nearest") + "equal.csv queries.csv ";
  // 71 queries, each with 300 answers.
  for (const char* options : {"--within 2 ", "--ties ", "--ties -k 5 "}) {
    const Outcome counted = run(nearest + options + "--most 10");
    EXPECT_EQ(counted.code, 0) << counted.err;
    EXPECT_THAT(counted.out, HasSubstr("         0          9  0.9013878188659973\nand 21,290 more;")) << options;
    EXPECT_EQ(run(nearest + options + "--threads 1 | grep -v ms").out, run(nearest + options + "| grep -v ms").out);
    const json all = json::parse(run(nearest + options + "--json").out);
    for (const json& list : all.at("indices")) EXPECT_EQ(list.size(), 300U);
    EXPECT_EQ(all.at("distances")[69][299], 0.9013878188659973);
    EXPECT_EQ(all.at("distances")[70][299], 0.0);
    const Outcome refused = run(nearest + options + "--most 21299 --out near.npy --overwrite");
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("more than 21,299 answers, 21")) << options;
    EXPECT_EQ(run(nearest + options + "--most 21300 --out near.npy --overwrite").code, 0);
  }
  EXPECT_THAT(run(nearest + "--ties").out, HasSubstr("71 queries have more points that are exactly as near"));
  expect_refusals(folder, {{"nearest -k 1.5 equal.csv queries.csv", "'1.5' is no whole number from 1 to 4294967295"},
                           {"nearest -k 0 equal.csv queries.csv", "'0' is no whole number from 1 to 4294967295"},
                           {"nearest /dev/zero queries.csv", "cannot read /dev/zero: it is a device"}});
}

// A pipe may never end: what is longer than the limit is refused when so much has been read.
TEST(InputLimits, EndWhatIsTooLong) {
  const Folder folder;
  std::ofstream(folder / "some.csv") << times_over(1000, "0,0");
  EXPECT_EQ(bytes_of_input(folder / "some.csv", 4000).size(), 4000U);
  try {
    (void)bytes_of_input(folder / "some.csv", 3999);
    ADD_FAILURE() << "was read";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("some.csv: it is longer than 0 MiB, which is the most that is read"));
  }
}

TEST(Npy, IsReadInEveryOrder) {
  const std::vector<double> values{1, 2, 3, 4, 5, 6};
  const std::vector<std::size_t> shape{2, 3};
  EXPECT_EQ(read_npy(npy_of(values, shape), "a").values, values);
  EXPECT_EQ(read_npy(npy_of(values, shape), "a").shape, shape);
  for (const bool big : {false, true}) {
    std::string doubles, floats, columns;
    for (const double x : values) {
      doubles += bytes_of(x, big);
      floats += bytes_of(static_cast<float>(x), big);
    }
    for (const double x : {1.0, 4.0, 2.0, 5.0, 3.0, 6.0}) columns += bytes_of(x, big);
    const std::string order = big ? ">" : "<";
    const std::string rest = "', 'fortran_order': False, 'shape': (2, 3), }\n";
    EXPECT_EQ(read_npy(npy_with("{'descr': '" + order + "f8" + rest, doubles), "a").values, values);
    EXPECT_EQ(read_npy(npy_with("{'descr': '" + order + "f4" + rest, floats, 2), "a").values, values);
    const std::string other = "{\"shape\":(2L,3L),\"fortran_order\":True,\"descr\":\"" + order + "f8\"}";
    EXPECT_EQ(read_npy(npy_with(other, columns, 3), "a").values, values);
  }
}

TEST(Npy, IsRefusedWithItsFault) {
  const auto fault = [](const std::string& bytes) {
    try {
      read_npy(bytes, "a.npy");
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("read");
  };
  const std::string eight(8, '\0');
  const auto with = [&](const std::string& header) { return fault(npy_with(header, eight)); };
  EXPECT_EQ(with("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 1)}"), "read");
  expect_text(with("{'descr': '<i8', 'fortran_order': False, 'shape': (1, 1)}"), {"numbers of type '<i8'"});
  expect_text(with("{'descr': '<c8', 'fortran_order': False, 'shape': (1, 1)}"), {"numbers of type '<c8'"});
  expect_text(with("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (1,)}"), {"with fields"});
  expect_text(with("{'descr': '<f8', 'fortran_order': False, 'shape': (4611686018427387904, 4)}"),
              {"larger than the whole file"});
  expect_text(with("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 1)}"), {"cut short"});
  expect_text(with("{'descr': '<f8', 'fortran_order': False, 'shape': (0, 1)}"), {"8 bytes follow the array"});
  for (const char* broken :
       {"", "{", "{}", "{'descr': '<f8'}", "{'descr': 8}", "{'descr': '<f8", "{'shape': (x)}", "{'fortran_order': 1}",
        "{'other': 1}", "{'shape': (1, 1)", "['descr']", "{'descr': '<f8', 'descr': '<f8', 'fortran_order': False}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 1)} # rows"})
    expect_text(with(broken), {"the header of this NumPy file is broken"}, {}, broken);
  expect_text(fault("\x93NUMPX"), {"no NumPy file"});
  expect_text(fault(std::string("\x93NUMPY\x04\0\0\0\0\0", 12)), {"version 4.0"});
  expect_text(fault(npy_with("{", "").substr(0, 9)), {"cut short"});
}

// Columns that no row has were read as coordinates: id,x,y as points in space.
TEST(NumberTable, HoldsColumnsToTheirNames) {
  constexpr std::array<std::string_view, 2> plane{"x", "y"};
  constexpr std::array<std::string_view, 3> space{"x", "y", "z"};
  constexpr std::array<std::string_view, 4> box{"min x", "min y", "max x", "max y"};
  constexpr std::array<std::string_view, 6> block{"min x", "min y", "min z", "max x", "max y", "max z"};
  const auto columns = [](std::string_view text, const RowMeaning& meaning) {
    try {
      return parse_table(text, "t", meaning).columns;
    } catch (const Error& e) {
      EXPECT_THAT(e.what(), HasSubstr("t: the columns are named '")) << text;
      return std::size_t{0};
    }
  };
  const RowMeaning points{"a point", "points", plane, space}, boxes{"a box", "boxes", box, block};
  for (const char* text : {"x,y\n1,2", "X;Y\n1;2", "\"x\" \"y\"\n1 2", "x\ty\r\n1\t2", " x , y \n1,2", "lon,lat\n1,2",
                           "u,v\n1,2", "_x,y2\n1,2", "points\n1 2", "# y,x\n1,2"})
    EXPECT_EQ(columns(text, points), 2U) << text;
  for (const char* text : {"x,y,z\n1,2,3", "id,lon,lat\n1,2,3"}) EXPECT_EQ(columns(text, points), 3U) << text;
  for (const char* text : {"id,x,y\n1,2,3", "x,y,id\n1,2,3", "y,x\n1,2", "z,y,x\n1,2,3", "x,z\n1,2", "x,y,z\n1,2",
                           "x,x\n1,2", "x\n1,2", "X Y ID\n1 2 3", "name\tx\ty\n1\t2\t3"})
    EXPECT_EQ(columns(text, points), 0U) << text;
  for (const char* text : {"min x,min y,max x,max y\n0,0,1,1", "xmin,ymin,xmax,ymax\n0,0,1,1",
                           "min_x min_y max_x max_y\n0 0 1 1", "left,low,right,high\n0,0,1,1"})
    EXPECT_EQ(columns(text, boxes), 4U) << text;
  for (const char* text : {"xmin,xmax,ymin,ymax\n0,0,1,1", "min x,min y,size x,size y\n0,0,1,1",
                           "id,min x,min y,min z,max x,max y\n"
                           "0,0,0,0,1,1"})
    EXPECT_EQ(columns(text, boxes), 0U) << text;
  EXPECT_THROW(parse_named_rows("id,x,y\n1,2,3", "list", point_shape), Error);
  EXPECT_THROW(parse_named_rows("z,y,x\n1,2,3", "list", point_shape), Error);
  EXPECT_EQ(parse_named_rows("a,b,c\n1,2,3", "list", point_shape).size(), 1U);
}

TEST(DecimalRows, PassOverAHeaderAndNothingElse) {
  const auto read = [](const std::string& text) {
    DecimalRows rows(text, "t");
    std::vector<std::vector<double>> all;
    while (rows.next()) all.push_back(rows.row().values);
    return all;
  };
  const std::vector<std::vector<double>> one{{1, 2}};
  for (const char* text : {"1,2", "a,b\n1,2",
                           "\xEF\xBB\xBF"
                           "a b\r\n1\t2\r\n",
                           "\"min x\"\n 1 ; 2 # c", "# a\n_x,y2\n\n1 2\n"})
    EXPECT_EQ(read(text), one) << text;
  for (const char* text : {"1,2\na,b", "a,b\nc,d\n1,2", "a,2\n1,2", "nan,nan\n1,2", "inf inf\n1 2", "1.0f\n1",
                           "a,\n1,2", ",1", "1,,2", "1,2,", "0,5;1"})
    EXPECT_THROW(read(text), Error) << text;
}

}  // namespace
}  // namespace plumb::tool
