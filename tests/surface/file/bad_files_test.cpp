// What is said about each way in which a file can be wrong: kind, line or byte, words, and the mend.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "plumb/surface/file/read_mesh.hpp"
#include "surface/file/sample_files.hpp"

namespace plumb {
namespace {

using enum MeshFileProblem;
using surface_test::raw;

struct BadFile {
  MeshFormat format;
  std::string bytes;
  MeshFileProblem problem;
  std::optional<std::uint64_t> line, byte;
  std::vector<std::string> words;
};

void expect_refused(const std::vector<BadFile>& files) {
  for (const auto& bad : files) {
    SCOPED_TRACE(bad.bytes);
    try {
      parse_mesh(bad.bytes, bad.format, "part.x");
      ADD_FAILURE() << "was read";
    } catch (const MeshFileError& error) {
      const std::string text = error.what();
      EXPECT_EQ(error.problem, bad.problem) << text;
      EXPECT_EQ(error.line, bad.line) << text;
      EXPECT_EQ(error.byte, bad.byte) << text;
      EXPECT_EQ(error.file, "part.x");
      std::string place = "part.x";
      if (bad.line) place.append(":").append(std::to_string(*bad.line));
      if (bad.byte) place.append(": byte ").append(std::to_string(*bad.byte));
      EXPECT_EQ(text.substr(0, place.size() + 2), place + ": ");
      for (const auto& word : bad.words) EXPECT_NE(text.find(word), std::string::npos) << text << "\n  lacks " << word;
      EXPECT_NE(text.find("; "), std::string::npos) << "no mend in: " << text;
      EXPECT_NE(text.find("expected"), std::string::npos) << text;
    }
  }
}

TEST(BadFiles, Obj) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto obj = [](const std::string& bytes, MeshFileProblem problem, std::optional<std::uint64_t> line,
                      std::vector<std::string> words) {
    return BadFile{MeshFormat::obj, bytes, problem, line, std::nullopt, std::move(words)};
  };
  expect_refused({
      obj("", empty_file, {}, {"is empty (0 bytes)"}),
      obj("# only a comment\n", empty_mesh, {}, {"no vertex was found"}),
      obj("\n\n", empty_mesh, {}, {"no vertex"}),
      obj(triangle, empty_mesh, {}, {"3 vertices but no face"}),
      obj(triangle + "f 1 2\n", empty_mesh, {}, {"no face of three corners"}),
      obj("v 1 2\n", syntax, 1, {"coordinate z was expected"}),
      obj("\nv 1 2,5 0\n", bad_number, 2, {"coordinate y is \"2,5\"", "decimal sign is a point"}),
      obj("v 1 2 nan\n", bad_number, 1, {"coordinate z is \"nan\"", "finite"}),
      obj("v -inf 2 3\n", bad_number, 1, {"coordinate x is \"-inf\"", "finite"}),
      obj("v 1 2 1e309\n", bad_number, 1, {"beyond the largest double"}),
      obj("v 1 2 0x1p3\n", bad_number, 1, {"\"0x1p3\""}),
      obj(triangle + "f 1 2 4\n", bad_index, 4, {"names vertex 4", "has 3", "1 to 3"}),
      obj("f 1 2 9\r\nf 1 2 3\r\n" + triangle, bad_index, 1, {"names vertex 9"}),
      obj(triangle + "\\\n\\\nf 1 2\\\n 99999999999999999999\n", syntax, 4, {"99999999999999999999"}),
      obj(triangle + "f 1 2 5000000000\n", bad_index, 4, {"5000000000"}),
      obj(triangle + "f 0 1 2\n", bad_index, 4, {"vertex 0", "numbers from 1"}),
      obj(triangle + "f -1 -2 -4\n", bad_index, 4, {"vertex -4", "at least -3"}),
      obj(triangle + "f\n", syntax, 4, {"first corner"}),
      obj(triangle + "f 1/ 2 3\n", syntax, 4, {"\"1/\"", "7/1"}),
      obj(triangle + "f 1/2/3/4 2 3\n", syntax, 4, {"\"1/2/3/4\""}),
      obj(triangle + "f //1 2 3\n", syntax, 4, {"\"//1\""}),
      obj(triangle + "f 1.0 2 3\n", syntax, 4, {"\"1.0\""}),
      obj(triangle + "f 1 2 3 three\n", syntax, 4, {"\"three\""}),
      obj(std::string("\x7f"
                      "ELF\0\1\2",
                      7),
          syntax, 1, {"binary data"}),
  });
}

TEST(BadFiles, Off) {
  const auto off = [](const std::string& bytes, MeshFileProblem problem, std::optional<std::uint64_t> line,
                      std::vector<std::string> words) {
    return BadFile{MeshFormat::off, bytes, problem, line, std::nullopt, std::move(words)};
  };
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  expect_refused({
      off("", empty_file, {}, {"0 bytes"}),
      off("# nothing\n", empty_mesh, {}, {"no vertex"}),
      off("OFF\n0 0 0\n", empty_mesh, {}, {"no vertex"}),
      off("OFF\n3 0 0\n" + vertices, empty_mesh, {}, {"3 vertices but no face"}),
      off("OFF\n", truncated, 1, {"numbers of vertices and faces"}),
      off("FOO\n3 1 0\n", syntax, 1, {"\"FOO\"", "expected OFF"}),
      off("4OFF\n3 1 0\n", unsupported, 1, {"three dimensions"}),
      off("nOFF\n5\n3 1 0\n", unsupported, 1, {"three dimensions"}),
      off("OFF BINARY\n\0\0\0\3", unsupported, 1, {"binary OFF"}),
      off("OFF\n3\n", syntax, 2, {"number of faces"}),
      off("OFF\n3 1 x\n", syntax, 2, {"number of edges"}),
      off("OFF\n-3 1 0\n", syntax, 2, {"\"-3\""}),
      off("OFF\n3 1 0\n0 0 0\n1 0 0\n", truncated, 4, {"vertex 3 of the 3", "cut short"}),
      off("OFF\n3 2 0\n" + vertices + "3 0 1 2\n", truncated, 6, {"face 2 of the 2"}),
      off("OFF\n3 1 0\n0 0\n", syntax, 3, {"coordinate z"}),
      off("OFF\n3 1 0\n0 0 #\n", syntax, 3, {"coordinate z"}),
      off("OFF\n3 1 0\n" + vertices + "3 0 1 3\n", bad_index, 6, {"\"3\"", "below 3"}),
      off("OFF\n3 1 0\n" + vertices + "3 0 1 -1\n", bad_index, 6, {"\"-1\""}),
      off("OFF\n3 1 0\n" + vertices + "3 0 1\n", syntax, 6, {"a vertex number was expected"}),
      off("OFF\n3 1 0\n" + vertices + "4294967299 0 1 2\n", syntax, 6, {"a vertex number"}),
      off("OFF\n3 1 0\n" + vertices + "x 0 1 2\n", syntax, 6, {"number of corners is \"x\""}),
      off("OFF\n3 1 0\n" + vertices + "3 0 1 2\n3 2 1 0\n", syntax, 7, {"after the last face"}),
  });
}

TEST(BadFiles, Stl) {
  const auto at_line = [](const std::string& bytes, MeshFileProblem problem, std::uint64_t line,
                          std::vector<std::string> words) {
    return BadFile{MeshFormat::stl, bytes, problem, line, std::nullopt, std::move(words)};
  };
  const auto at_byte = [](const std::string& bytes, MeshFileProblem problem, std::uint64_t byte,
                          std::vector<std::string> words) {
    return BadFile{MeshFormat::stl, bytes, problem, std::nullopt, byte, std::move(words)};
  };
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  const std::string header(80, 'x'), triangle(50, '\0');
  expect_refused({
      {MeshFormat::stl, "", empty_file, {}, {}, {"0 bytes"}},
      {MeshFormat::stl, "solid x\nendsolid x\n", empty_mesh, {}, {}, {"no vertex"}},
      {MeshFormat::stl, header + raw(0U), empty_mesh, {}, {}, {"no vertex"}},
      at_line("solid", truncated, 1, {"`facet` or `endsolid`"}),
      at_line("solid a\nfaset\n", syntax, 2, {"\"faset\""}),
      at_line("solid a\n" + facet + "vertex 1 1 1\n", syntax, 7, {"\"vertex\"", "`endloop`"}),
      at_line("solid a\n" + facet + "endloop\nendfacet\n", truncated, 8, {"cut short"}),
      at_line("solid a\n" + facet + "endloop\nendfacet\nendsolid\nmore", syntax, 10, {"\"more\"", "`solid`"}),
      at_line("solid a\nfacet normal 0 0 1 outer loop\nvertex 0 0\n", syntax, 3, {"coordinate z"}),
      at_line("solid a\nfacet normal 0 0 1 outer loop\nvertex 0 0 1e999\n", bad_number, 3, {"largest double"}),
      at_line("solid a\nfacet normal 0 0 1 outer loop\nvertex 0 NaN 0\n", bad_number, 3, {"coordinate y is \"NaN\""}),
      at_byte("garbage", truncated, 7, {"is this an STL file?"}),
      at_byte(header + raw(2U) + triangle, truncated, 80, {"claims 2 triangles", "184 bytes", "has 134"}),
      at_byte("solid " + header.substr(6) + raw(2U) + triangle, truncated, 80, {"claims 2 triangles"}),
      at_byte(header + raw(4294967295U) + triangle, truncated, 80, {"claims 4294967295 triangles"}),
      at_byte(header + raw(1U) + triangle + "x", syntax, 80, {"claims 1 triangles", "has 135", "appended"}),
      at_byte(header + raw(1U) + std::string(16, '\0') + raw(NAN) + std::string(30, '\0'), bad_number, 100,
              {"triangle 0 is NaN"}),
      at_byte(header + raw(1U) + std::string(44, '\0') + raw(-INFINITY) + "..", bad_number, 128, {"infinite"}),
  });
}

}  // namespace
}  // namespace plumb
