#include "surface/file/print_mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "surface/file/mesh_failure.hpp"

namespace plumb::surface {
namespace {

// Text: the shortest decimals that name the doubles.
class Text {
 public:
  Text& operator<<(std::string_view words) {
    text_ += words;
    return *this;
  }
  Text& operator<<(const Point3& p) { return (((number(p.x) << " ").number(p.y)) << " ").number(p.z); }
  template <class T>
  Text& number(T value) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    text_.append(buffer.data(), end);
    return *this;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

class Bytes {
 public:
  explicit Bytes(std::string head, std::endian order) : bytes_(std::move(head)), swap_(order != std::endian::native) {}
  template <class T>
  void put(T value) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (swap_) std::reverse(raw.begin(), raw.end());
    bytes_.append(raw.data(), raw.size());
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  bool swap_;
};

std::size_t face_count(const PolygonMesh& mesh) { return mesh.first.size() - 1; }

std::span<const std::uint32_t> face(const PolygonMesh& mesh, std::size_t f) {
  return std::span(mesh.corners).subspan(mesh.first[f], mesh.first[f + 1] - mesh.first[f]);
}

void print_counted_faces(Text& text, const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < face_count(mesh); ++f) {
    text.number(face(mesh, f).size());
    for (const std::uint32_t corner : face(mesh, f)) (text << " ").number(corner);
    text << "\n";
  }
}

bool is_float(double x) {
  return std::fabs(x) <= std::numeric_limits<float>::max() && static_cast<double>(static_cast<float>(x)) == x;
}

}  // namespace

std::string print_obj(const PolygonMesh& mesh) {
  Text text;
  for (const Point3& p : mesh.vertices) text << "v " << p << "\n";
  for (std::size_t f = 0; f < face_count(mesh); ++f) {
    text << "f";
    for (const std::uint32_t corner : face(mesh, f)) (text << " ").number(std::uint64_t{corner} + 1);
    text << "\n";
  }
  return text.take();
}

std::string print_off(const PolygonMesh& mesh) {
  Text text;
  text << "OFF\n";
  (text.number(mesh.vertices.size()) << " ").number(face_count(mesh)) << " 0\n";
  for (const Point3& p : mesh.vertices) text << p << "\n";
  print_counted_faces(text, mesh);
  return text.take();
}

std::string print_ascii_stl(const TriangleMesh& mesh) {
  Text text;
  text << "solid mesh\n";
  for (const auto& t : mesh.triangles) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t corner : t) text << "vertex " << mesh.vertices[corner] << "\n";
    text << "endloop\nendfacet\n";
  }
  text << "endsolid mesh\n";
  return text.take();
}

std::string print_binary_stl(const TriangleMesh& mesh, std::string_view name) {
  constexpr std::size_t header_size = 80;
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    fail_at_file(MeshFileProblem::not_representable, name,
                 "more than 4294967295 triangles, expected fewer for binary STL; write PLY");
  Bytes bytes("binary STL" + std::string(header_size - 10, ' '), std::endian::little);
  bytes.put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) bytes.put(0.0F);
    for (const std::uint32_t corner : t) {
      const Point3& p = mesh.vertices[corner];
      for (const double x : {p.x, p.y, p.z}) {
        if (!is_float(x))
          fail_at_file(MeshFileProblem::not_representable, name,
                       "a coordinate of vertex " + std::to_string(corner) + " is no float32, expected one for binary " +
                           "STL; write ASCII STL or PLY, or round the mesh first");
        bytes.put(static_cast<float>(x));
      }
    }
    bytes.put(std::uint16_t{0});
  }
  return bytes.take();
}

std::string print_ply(const PolygonMesh& mesh, MeshEncoding encoding) {
  std::size_t most_corners = 0;
  for (std::size_t f = 0; f < face_count(mesh); ++f) most_corners = std::max(most_corners, face(mesh, f).size());
  // `int` indices, where they suffice, because some readers know no others.
  const bool short_lists = most_corners <= std::numeric_limits<std::uint8_t>::max();
  const bool signed_indices = mesh.vertices.size() <= std::size_t{std::numeric_limits<std::int32_t>::max()};
  const bool ascii = encoding == MeshEncoding::ascii, big = encoding == MeshEncoding::binary_big_endian;
  Text text;
  text << "ply\nformat " << (ascii ? "ascii" : big ? "binary_big_endian" : "binary_little_endian") << " 1.0\n";
  (text << "element vertex ").number(mesh.vertices.size()) << "\nproperty double x\nproperty double y\n";
  (text << "property double z\nelement face ").number(face_count(mesh));
  text << "\nproperty list " << (short_lists ? "uchar " : "uint ") << (signed_indices ? "int" : "uint");
  text << " vertex_indices\nend_header\n";
  if (ascii) {
    for (const Point3& p : mesh.vertices) text << p << "\n";
    print_counted_faces(text, mesh);
    return text.take();
  }
  Bytes bytes(text.take(), big ? std::endian::big : std::endian::little);
  for (const Point3& p : mesh.vertices)
    for (const double x : {p.x, p.y, p.z}) bytes.put(x);
  for (std::size_t f = 0; f < face_count(mesh); ++f) {
    const auto corners = face(mesh, f);
    if (short_lists)
      bytes.put(static_cast<std::uint8_t>(corners.size()));
    else
      bytes.put(static_cast<std::uint32_t>(corners.size()));
    for (const std::uint32_t corner : corners) bytes.put(corner);
  }
  return bytes.take();
}

}  // namespace plumb::surface
