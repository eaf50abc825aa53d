// Where points and boxes come from: clouds, packed tables, and what is refused by its name.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "surface/file/gzipped.hpp"
#include "tool/matchers.hpp"
#include "tool/row_files.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

using surface_test::gzipped;

void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string at(const Folder& folder, const std::string& command) {
  return "cd " + (folder / "") + " && $PLUMB " + command + " ";
}

const std::string two_points = "0,0,0\n3,4,0\n", query = "3,4,12\n";

std::string two_points_npy() {
  std::string numbers;
  for (const double x : {0.0, 0.0, 0.0, 3.0, 4.0, 0.0}) numbers += bytes_of(x, false);
  return npy_with("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }\n", numbers);
}

TEST(RowInputs, PointsAreThoseOfAnyCloud) {
  const Folder folder;
  put(folder / "query.csv", query);
  const std::string header = "property float x\nproperty float y\nproperty float z\n";
  put(folder / "cloud.ply", "ply\nformat ascii 1.0\nelement vertex 2\n" + header + "end_header\n0 0 0\n3 4 0\n");
  put(folder / "no_faces.ply",
      "ply\nformat ascii 1.0\nelement vertex 2\n" + header +
          "element face 0\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n3 4 0\n");
  put(folder / "cloud.obj", "v 0 0 0\nv 3 4 0\n");
  put(folder / "cloud.off", "OFF\n2 0 0\n0 0 0\n3 4 0\n");
  put(folder / "cloud.obj.gz", gzipped("v 0 0 0\nv 3 4 0\n"));
  put(folder / "cloud.xyz", "0 0 0\n3 4 0\n");
  put(folder / "normals.xyz", "# x y z normal color\n0 0 0 0 0 1 255 0 0\n3 4 0 0 0 1 255 0 0\n");
  for (const char* const cloud :
       {"cloud.ply", "no_faces.ply", "cloud.obj", "cloud.off", "cloud.obj.gz", "cloud.xyz", "normals.xyz"}) {
    const Outcome o = run(at(folder, "nearest") + cloud + " query.csv --json -");
    ASSERT_EQ(o.code, 0) << cloud << ": " << o.err;
    const json said = json::parse(o.out);
    EXPECT_EQ(said.at("indices"), json::parse("[[1]]")) << cloud;
    EXPECT_EQ(said.at("distances"), json::parse("[[12.0]]")) << cloud;
    EXPECT_EQ(run(at(folder, "nearest") + "query.csv " + cloud).code, 0) << cloud;
  }
  put(folder / "columns.csv", "0,0,0,0,0,1\n");
  const Outcome o = run(at(folder, "nearest") + "columns.csv query.csv");
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("columns.csv, line 1: this has 6 numbers"));
  // Boxes are of triangles, which a cloud has not.
  EXPECT_THAT(run(at(folder, "pairs") + "cloud.ply").err, HasSubstr("no face of three corners"));
}

TEST(RowInputs, TablesMayBePackedByGzip) {
  const Folder folder;
  put(folder / "query.csv", query);
  put(folder / "points.csv.gz", gzipped(two_points));
  put(folder / "points.TXT.GZ", gzipped(two_points));
  put(folder / "points.gz", gzipped(two_points));
  put(folder / "points.npy.gz", gzipped(two_points_npy()));
  put(folder / "array.gz", gzipped(two_points_npy()));
  put(folder / "cloud.gz", gzipped("v 0 0 0\nv 3 4 0\n"));
  for (const char* const packed : {"points.csv.gz", "points.TXT.GZ", "points.gz", "points.npy.gz", "array.gz",
                                   "cloud.gz", "- < points.csv.gz", "- < points.npy.gz", "- < cloud.gz"}) {
    const Outcome o = run(at(folder, "nearest") + "--json - query.csv " + packed);
    ASSERT_EQ(o.code, 0) << packed << ": " << o.err;
    EXPECT_EQ(json::parse(o.out).at("distances"), json::parse("[[13.0],[12.0]]")) << packed;
  }
  put(folder / "boxes.csv.gz", gzipped("0,0,1,1\n1,1,2,2\n"));
  EXPECT_THAT(run(at(folder, "pairs") + "boxes.csv.gz").out, HasSubstr("boxes.csv.gz: 2 boxes in the plane"));
  put(folder / "part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THAT(run(at(folder, "inside") + "--points points.csv.gz part.obj").out, HasSubstr("2 points"));
  // What is damaged or too large is refused, with the line of what is within.
  std::string damaged = gzipped(two_points);
  damaged[damaged.size() - 6] ^= 1;
  put(folder / "damaged.csv.gz", damaged);
  put(folder / "word.csv.gz", gzipped("0,0,0\n0,one,0\n"));
  put(folder / "large.csv.gz", gzipped(std::string(std::size_t{3} << 20, '\n') + two_points));
  for (const auto& [line, words] :
       std::vector<std::pair<std::string, std::string>>{{"damaged.csv.gz query.csv", "damaged.csv.gz: byte "},
                                                        {"word.csv.gz query.csv", "word.csv.gz, line 2: 'one'"},
                                                        {"--unpacked 1 large.csv.gz query.csv", "--unpacked MIB"}}) {
    const Outcome o = run(at(folder, "nearest") + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_THAT(o.err, HasSubstr(words)) << line;
  }
  EXPECT_EQ(run(at(folder, "nearest") + "--unpacked 9 large.csv.gz query.csv").code, 0);
  EXPECT_THAT(run(at(folder, "nearest") + "--json points.csv.gz query.csv").err, HasSubstr("is that of a table"));
}

TEST(RowInputs, OfOtherPackersAreRefusedByName) {
  const Folder folder;
  put(folder / "query.csv", query);
  put(folder / "part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::pair<const char*, std::string> packers[] = {{"bzip2", "BZh91AY&SY\x01"},
                                                         {"xz",
                                                          "\xFD"
                                                          "7zXZ" +
                                                              std::string(1, '\0')},
                                                         {"Zstandard", "\x28\xB5\x2F\xFD\x04"},
                                                         {"zip", "PK\3\4...."}};
  for (const auto& [name, bytes] : packers) {
    put(folder / "points.csv", bytes);
    for (const char* const line : {"nearest points.csv query.csv", "nearest query.csv points.csv", "pairs points.csv",
                                   "inside --points points.csv part.obj"}) {
      const Outcome o = run(at(folder, line));
      EXPECT_EQ(o.code, 2) << line;
      EXPECT_THAT(o.err, AllOf(HasSubstr("points.csv: this is "), HasSubstr(name), HasSubstr("unpack it"))) << line;
    }
    if (name == std::string("zip")) continue;
    put(folder / "part.stl.packed", bytes);
    EXPECT_THAT(run(at(folder, "check") + "part.stl.packed").err, AllOf(HasSubstr(name), HasSubstr("unpack it")));
  }
  put(folder / "points.csv.zip", "PK\3\4....");
  EXPECT_THAT(run(at(folder, "nearest") + "points.csv.zip query.csv").err, HasSubstr("this is a zip archive"));
}

}  // namespace
}  // namespace plumb::tool
