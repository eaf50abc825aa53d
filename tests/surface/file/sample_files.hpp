// One tetrahedron in every dialect that is read, for tests that ask the same of all of them.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/surface/file/mesh_file.hpp"
#include "plumb/surface/file/write_mesh.hpp"

namespace plumb::surface_test {

struct SampleFile {
  std::string name;
  MeshFormat format;
  std::string bytes;
  bool binary = false;
};

inline PolygonMesh tetrahedron() {
  return to_polygons({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
}

// Bytes of a number in the order asked for.
template <class T>
std::string raw(T value, bool big = false) {
  std::string bytes(sizeof(T), '\0');
  const auto source = std::bit_cast<std::array<char, sizeof(T)>>(value);
  for (std::size_t k = 0; k < sizeof(T); ++k) bytes[big ? sizeof(T) - 1 - k : k] = source[k];
  return bytes;
}

// Float coordinates, a color, an element in between that nobody knows, short lists of unsigned short.
inline std::string odd_ply(bool big) {
  std::string bytes =
      std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
      "_endian 1.0\r\ncomment end_header\r\nelement vertex 4\r\nproperty uchar red\r\nproperty float z\r\n"
      "property short x\r\nproperty list ushort double trail\r\nproperty char y\r\nelement edge 2\r\n"
      "property int a\r\nproperty float64 b\r\nelement material 1\r\nproperty list uint8 int16 what\r\n"
      "element face 4\r\nproperty float w\r\nproperty list short ushort vertex_index\r\nend_header\r\n";
  const PolygonMesh mesh = tetrahedron();
  for (const Point3& p : mesh.vertices)
    bytes += raw<std::uint8_t>(200) + raw(static_cast<float>(p.z), big) + raw(static_cast<std::int16_t>(p.x), big) +
             raw<std::uint16_t>(1, big) + raw(2.5, big) + raw(static_cast<std::int8_t>(p.y));
  bytes += std::string(24, 'e') + raw<std::uint8_t>(2) + "\1\2\3\4";
  for (std::size_t f = 0; f < 4; ++f) {
    bytes += raw(1.5F, big) + raw<std::int16_t>(3, big);
    for (std::size_t k = 0; k < 3; ++k) bytes += raw(static_cast<std::uint16_t>(mesh.corners[3 * f + k]), big);
  }
  return bytes;
}

inline std::vector<SampleFile> sample_files() {
  const PolygonMesh mesh = tetrahedron();
  using enum MeshEncoding;
  std::vector<SampleFile> files;
  files.push_back({"plain.obj", MeshFormat::obj, format_mesh(mesh, MeshFormat::obj)});
  files.push_back(
      {"decorated.obj", MeshFormat::obj,
       "\xEF\xBB\xBF# a comment C:\\\r\nmtllib a.mtl\r\no part\r\nf 1//1 3//1 2//1\r\nv 0 0 0 1\r\nvn 0 0 1\r\n"
       "v 1 0 0 0.5 0.5 0.5 # color\r\nvt 0 0\r\nv +0 1.0e0 0\r\nv 0 \\\r\n 0 .5\r\nusemtl x\r\ns off\r\n"
       "f -4/1 -3/1 -1/1\r\nf 2/1/1 \\\r\n3/1/1 4/1/1\r\ng\r\nl 1 2\r\np 1\r\nf 1 2\r\nfo 3 1 4"});
  files.push_back(
      {"old_mac.obj", MeshFormat::obj, "v 0 0 0\rv 1 0 0\rv 0 1 0\rv 0 0 0.5\rf 1 3 2\rf 1 2 4\rf 2 3 4\rf 3 1 4\r"});
  files.push_back({"plain.off", MeshFormat::off, format_mesh(mesh, MeshFormat::off)});
  files.push_back(
      {"colored.off", MeshFormat::off,
       "# made by hand\nSTCNOFF 4 4 # six edges\n0 0 0 0 0 1 255 0 0 1 .5 .5\n1 0 0 0 0 1 255 0 0 1 .5 .5\n\n"
       "0 1 0\n0 0 0.5\n3 0 2 1 255 0 0\n3 0 1 3\n2 0 1\n# the rest\n3 1 2 3 0.1 0.2 0.3\n3 2 0 3\n"});
  files.back().bytes.replace(files.back().bytes.find("4 4 #"), 3, "4 5");
  files.push_back(
      {"glued.off", MeshFormat::off, "OFF4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 0.5\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"});
  files.push_back(
      {"headless.off", MeshFormat::off, "4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 0.5\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"});
  files.push_back({"plain.stl", MeshFormat::stl, format_mesh(mesh, MeshFormat::stl)});
  files.push_back({"binary.stl", MeshFormat::stl, format_mesh(mesh, MeshFormat::stl, binary_little_endian), true});
  files.push_back({"binary_solid.stl", MeshFormat::stl, files.back().bytes, true});
  files.back().bytes.replace(0, 24, "solid facet normal 0 0 1");
  std::string shouting = files[7].bytes;
  for (char& c : shouting) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c == '\n' ? '\r' : c);
  files.push_back({"shouting.stl", MeshFormat::stl, "\n " + shouting + "\rsolid\rendsolid"});
  files.push_back({"ascii.ply", MeshFormat::ply, format_mesh(mesh, MeshFormat::ply, ascii)});
  files.push_back({"little.ply", MeshFormat::ply, format_mesh(mesh, MeshFormat::ply), true});
  files.push_back({"big.ply", MeshFormat::ply, format_mesh(mesh, MeshFormat::ply, binary_big_endian), true});
  files.push_back({"odd_little.ply", MeshFormat::ply, odd_ply(false), true});
  files.push_back({"odd_big.ply", MeshFormat::ply, odd_ply(true), true});
  files.push_back(
      {"odd_ascii.ply", MeshFormat::ply,
       "ply\nformat ascii 1.0\nobj_info x\nelement nothing 4000000000\nelement vertex 4\n"
       "property list uchar int tags\nproperty double y\nproperty double x\nproperty int flag\n"
       "property float z\nelement face 4\nproperty list uchar int vertex_indices\nproperty uchar red\n"
       "end_header\n0 0 0 7 0\n2 9 9 0 1 7 0\n0 1 0 7 0\n1 5 0 0 7 0.5\n\n3 0 2 1 255\n3 0 1 3 0\n3 1 2 3 0\n"
       "3 2 0 3 0\n"});
  files.push_back({"one_line.stl", MeshFormat::stl, files[7].bytes});
  for (char& c : files.back().bytes) c = c == '\n' ? ' ' : c;
  files.push_back({"two_a_line.off", MeshFormat::off,
                   "OFF 4 4 6\n0 0 0 1 0 0\n0 1 0 0 0 0.5\n3 0 2 1 3 0 1 3\n3 1 2 3 3 2 0\n3\n"});
  files.push_back({"wrapped.ply", MeshFormat::ply,
                   "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                   "element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 0\n0 0 1 0 0 0 0.5 3\n"
                   "0 2 1 3 0 1 3 3\t1 2\r\n3 3 2 0 3"});
  return files;
}

}  // namespace plumb::surface_test
