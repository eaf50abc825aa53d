// What is said about broken PLY files: the header by line, ASCII data by line, binary data by byte.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "plumb/surface/file/read_mesh.hpp"
#include "surface/file/sample_files.hpp"

namespace plumb {
namespace {

using enum MeshFileProblem;
using surface_test::raw;

void expect_refused(const std::string& bytes, MeshFileProblem problem, std::optional<std::uint64_t> line,
                    std::optional<std::uint64_t> byte, const std::string& words) {
  SCOPED_TRACE(bytes);
  try {
    parse_mesh(bytes, MeshFormat::ply, "part.ply");
    ADD_FAILURE() << "was read";
  } catch (const MeshFileError& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.problem, problem) << text;
    EXPECT_EQ(error.line, line) << text;
    EXPECT_EQ(error.byte, byte) << text;
    EXPECT_NE(text.find(words), std::string::npos) << text;
    EXPECT_NE(text.find("expected"), std::string::npos) << text;
  }
}

const std::string kAscii = "ply\nformat ascii 1.0\n", kLittle = "ply\nformat binary_little_endian 1.0\n";
const std::string kVertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\n", kEnd = "end_header\n";
const std::string kPoints = "0 0 0\n1 0 0\n0 1 0\n";

TEST(BadPly, Header) {
  const auto refused = [](const std::string& bytes, std::uint64_t line, const std::string& words,
                          MeshFileProblem problem = syntax) { expect_refused(bytes, problem, line, {}, words); };
  refused("plx\n", 1, "\"plx\"");
  refused("ply\n", 1, "expected `end_header`", truncated);
  refused("ply\nformat ascii 1.0\nelement vertex 3\n", 3, "`end_header`", truncated);
  refused("ply\nformat ascii 2.0\n", 2, "\"2.0\"", unsupported);
  refused("ply\nformat binary 1.0\n", 2, "\"binary\"");
  refused("ply\nformat ascii\n", 2, "the version 1.0");
  refused("ply\n" + kVertex + kFace + kEnd, 8, "the line `format`");
  refused(kAscii + "elephant vertex 3\n", 3, "\"elephant\"");
  refused(kAscii + "property float x\n", 3, "before any element");
  refused(kAscii + "element vertex\n", 3, "the element's count");
  refused(kAscii + "element vertex -3\n", 3, "\"-3\"");
  refused(kAscii + "element vertex 99999999999999999999\n", 3, "99999999999999999999");
  refused(kAscii + kVertex + "element vertex 3\n", 7, "twice");
  refused(kAscii + kVertex + "property float x\n", 7, "twice");
  refused(kAscii + "element vertex 3\nproperty quad x\n", 4, "\"quad\"");
  refused(kAscii + "element vertex 3\nproperty float\n", 4, "the property's name");
  refused(kAscii + "element vertex 3\nproperty list uchar float x\n", 4, "is a list");
  refused(kAscii + "element face 3\nproperty int vertex_indices\n", 4, "expected a list");
  refused(kAscii + "element face 3\nproperty list uchar float vertex_indices\n", 4, "no integer type");
  refused(kAscii + "element face 3\nproperty list float int vertex_indices\n", 4, "list's length is no integer");
  refused(kAscii + kFace + kEnd, 5, "expected element vertex");
  refused(kAscii + "element vertex 1\nproperty float x\nproperty float z\n" + kEnd, 6, "property y of element vertex");
  refused(kAscii + kVertex + "element face 1\nproperty int color\n" + kEnd, 9, "list vertex_indices of element face");
}

TEST(BadPly, AsciiData) {
  const std::string head = kAscii + kVertex + kFace + kEnd;  // nine lines
  const auto refused = [&](const std::string& data, MeshFileProblem problem, std::uint64_t line,
                           const std::string& words) { expect_refused(head + data, problem, line, {}, words); };
  refused("", truncated, 10, "\"vertex\" 1 of the 3");
  refused("0 0 0\n1 0 0\n", truncated, 11, "\"vertex\" 3 of the 3");
  refused(kPoints, truncated, 12, "\"face\" 1 of the 1");
  refused("0 0\n", syntax, 10, "coordinate z");
  refused("0 0 0 0\n", syntax, 10, "after the properties");
  refused("\n0 nan 0\n", bad_number, 11, "coordinate y is \"nan\"");
  refused(kPoints + "3 0 1\n", syntax, 13, "an entry of list \"vertex_indices\"");
  refused(kPoints + "3 0 1 3\n", bad_index, 13, "below 3");
  refused(kPoints + "3 0 1 -1\n", bad_index, 13, "\"-1\"");
  refused(kPoints + "-3 0 1 2\n", syntax, 13, "the list's length is \"-3\"");
  refused(kPoints + "3 0 1 2\n3 0 1 2\n", syntax, 14, "after the last element");
  expect_refused(head + kPoints + "2 0 1\n", empty_mesh, {}, {}, "3 vertices but no face");
  expect_refused(kAscii + kVertex + kEnd + kPoints, empty_mesh, {}, {}, "no face");
}

TEST(BadPly, BinaryData) {
  const std::string head = kLittle + kVertex + kFace + kEnd;
  const std::uint64_t at = head.size();
  const std::string points(36, '\0');
  const auto refused = [&](const std::string& data, MeshFileProblem problem, std::uint64_t byte,
                           const std::string& words) { expect_refused(head + data, problem, {}, at + byte, words); };
  refused("", truncated, 0, "3 times 12 bytes, but only 0");
  refused(std::string(35, '\0'), truncated, 0, "only 35");
  refused(points, truncated, 36, "expected an integer");
  refused(points + "\3" + raw(0) + raw(1), truncated, 37, "the entries of a list");
  refused(points + "\3" + raw(0) + raw(1) + raw(3), bad_index, 45, "is 3, expected from 0 and below 3");
  refused(points + "\3" + raw(0) + raw(-1) + raw(2), bad_index, 41, "is -1");
  refused(points + "\3" + raw(0) + raw(1) + raw(2) + "junk", syntax, 49, "4 more bytes");
  refused(raw(1.0F) + raw(NAN) + std::string(28, '\0'), bad_number, 4, "coordinate y of vertex 0 is NaN");
  refused(raw(1.0F) + raw(2.0F) + raw(-INFINITY) + std::string(24, '\0'), bad_number, 8, "is infinite");
  const std::string signed_head = kLittle + kVertex + "element face 1\nproperty list char int vertex_index\n" + kEnd;
  expect_refused(signed_head + points + "\xff", syntax, {}, signed_head.size() + 36, "the list's length is -1");
}

}  // namespace
}  // namespace plumb
