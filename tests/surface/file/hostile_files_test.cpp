// Files made to hurt: cut anywhere, with bytes changed, random, or claiming more than they hold.  The reader refuses or
// gives a sound mesh, and asks for memory in proportion to the file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>
#include <optional>
#include <random>

#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "surface/file/sample_files.hpp"

namespace {

// What this program asked for since it last set these to zero.
std::size_t largest_request = 0;

void* counted_or_null(std::size_t size) {
  largest_request = std::max(largest_request, size);
  return std::malloc(size);
}

void* counted(std::size_t size) {
  if (void* memory = counted_or_null(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted_or_null(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted_or_null(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace plumb {
namespace {

using surface_test::raw;
using surface_test::sample_files;

enum class Outcome { sound, refused };

Outcome read_bounded(std::string_view bytes, MeshFormat format, Strictness strictness,
                     std::optional<PolygonMesh>& mesh) {
  largest_request = 0;
  mesh.reset();
  try {
    mesh = parse_mesh(bytes, format, "x", nullptr, {.strictness = strictness});
    EXPECT_GE(mesh->first.size(), 2U);
    EXPECT_EQ(mesh->first.back(), mesh->corners.size());
    for (const std::uint32_t corner : mesh->corners) EXPECT_LT(corner, mesh->vertices.size());
    for (const Point3& p : mesh->vertices) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    EXPECT_EQ(triangulate(*mesh).triangles.size(), mesh->corners.size() - 2 * (mesh->first.size() - 1));
  } catch (const MeshFileError& e) {
    EXPECT_TRUE(std::string_view(e.what()).starts_with("x:")) << e.what();
    const bool of_all = e.problem == MeshFileProblem::empty_file || e.problem == MeshFileProblem::empty_mesh;
    EXPECT_TRUE(of_all || e.line || e.byte) << e.what();
  }
  EXPECT_LE(largest_request, 4096 + 32 * bytes.size());
  return mesh ? Outcome::sound : Outcome::refused;
}

/// As it is read usually.  Whatever a stricter way takes, a laxer one reads alike.
Outcome read_bounded(std::string_view bytes, MeshFormat format) {
  std::optional<PolygonMesh> strict, usual, lenient;
  read_bounded(bytes, format, Strictness::strict, strict);
  const Outcome outcome = read_bounded(bytes, format, Strictness::usual, usual);
  read_bounded(bytes, format, Strictness::lenient, lenient);
  const auto agrees = [](const std::optional<PolygonMesh>& l, const std::optional<PolygonMesh>& r) {
    return !l || (r && l->vertices == r->vertices && l->corners == r->corners && l->first == r->first);
  };
  EXPECT_TRUE(agrees(strict, usual) && agrees(usual, lenient)) << bytes;
  return outcome;
}

TEST(HostileFiles, CutAnywhere) {
  for (const auto& file : sample_files()) {
    SCOPED_TRACE(file.name);
    for (std::size_t size = 0; size < file.bytes.size(); ++size) {
      const Outcome outcome = read_bounded(std::string_view(file.bytes).substr(0, size), file.format);
      if (file.binary) {
        EXPECT_EQ(outcome, Outcome::refused) << "cut to " << size;
      }
    }
    EXPECT_EQ(read_bounded(file.bytes, file.format), Outcome::sound);
  }
}

TEST(HostileFiles, AnyOneByteChanged) {
  for (const auto& file : sample_files()) {
    SCOPED_TRACE(file.name);
    std::string bytes = file.bytes;
    for (std::size_t at = 0; at < bytes.size(); ++at)
      for (const char c : {'\0', '\xff', '9', '-', '\n', ' '}) {
        bytes[at] = c;
        read_bounded(bytes, file.format);
        bytes[at] = file.bytes[at];
      }
  }
}

TEST(HostileFiles, Garbage) {
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes;
    for (std::size_t size = random() % 300; size > 0; --size) bytes += static_cast<char>(random());
    for (const auto format : {MeshFormat::obj, MeshFormat::off, MeshFormat::stl, MeshFormat::ply})
      EXPECT_EQ(read_bounded(bytes, format), Outcome::refused);
  }
}

TEST(HostileFiles, ClaimsCostNothing) {
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string faces = "property list uint uint vertex_indices\nend_header\n";
  for (const char* encoding : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string head = std::string("ply\nformat ") + encoding + " 1.0\n";
    for (const char* count : {"4000000000", "9223372036854775807"}) {
      const std::string claim = head + "element vertex " + count + "\n" + xyz + "element face 1\n" + faces;
      EXPECT_EQ(read_bounded(claim + std::string(100, '0'), MeshFormat::ply), Outcome::refused);
      const std::string nothing = head + "element nothing " + count + "\nelement vertex 1\n" + xyz;
      EXPECT_EQ(read_bounded(nothing + "element face " + count + "\n" + faces + "0 0 0 0 0 0\n", MeshFormat::ply),
                Outcome::refused);
    }
  }
  const std::string long_list = "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + xyz + "element face 1\n" +
                                faces + std::string(12, '\0') + raw(4294967295U) + std::string(64, '\0');
  EXPECT_EQ(read_bounded(long_list, MeshFormat::ply), Outcome::refused);
  EXPECT_EQ(read_bounded("OFF\n4000000000 4000000000 0\n0 0 0\n", MeshFormat::off), Outcome::refused);
  EXPECT_EQ(read_bounded("OFF\n1 1 0\n0 0 0\n4000000000 0 0 0 0 0\n", MeshFormat::off), Outcome::refused);
  EXPECT_EQ(read_bounded(std::string(80, ' ') + raw(4294967295U) + std::string(50, '\0'), MeshFormat::stl),
            Outcome::refused);
  EXPECT_EQ(read_bounded("v 0 0 0\nf 1 4294967296 -1\n", MeshFormat::obj), Outcome::refused);
}

std::string words_of(const std::filesystem::path& path, MeshFileProblem problem) {
  try {
    read_mesh(path);
  } catch (const MeshFileError& error) {
    EXPECT_EQ(error.problem, problem) << error.what();
    return error.what();
  }
  ADD_FAILURE() << path << " was read";
  return "";
}

TEST(HostileFiles, NotEvenAFile) {
  const auto folder = std::filesystem::temp_directory_path() / "plumb_hostile_test.obj";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "empty.stl") << "";
  std::ofstream(folder / "notes.txt") << "Dear reader,\n";
  const auto has = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
  EXPECT_TRUE(has(words_of(folder / "none.obj", MeshFileProblem::missing), "there is no such file"));
  EXPECT_TRUE(has(words_of(folder / "empty.stl" / "x.obj", MeshFileProblem::missing), "there is no such file"));
  EXPECT_TRUE(has(words_of(folder, MeshFileProblem::unreadable), "is a directory"));
  EXPECT_TRUE(has(words_of("/dev/zero", MeshFileProblem::unreadable), "is a device"));
  if (std::filesystem::exists("/proc/self/mem")) {
    EXPECT_TRUE(has(words_of("/proc/self/mem", MeshFileProblem::unreadable), "cannot be read: Input/output error"));
  } else {
    std::puts("No /proc here: a file whose reading fails half-way is skipped.");
  }
  EXPECT_TRUE(has(words_of(folder / "empty.stl", MeshFileProblem::empty_file), "is empty (0 bytes)"));
  EXPECT_TRUE(has(words_of(folder / "notes.txt", MeshFileProblem::unknown_format), "tells the format"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace plumb
