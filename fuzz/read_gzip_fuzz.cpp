// Any bytes as a gzip file; and packed, in two members, as what they are: the same mesh, or none.
#include <filesystem>
#include <optional>
#include <string>

#include "mesh_round_trip.hpp"
#include "surface/file/gunzip.hpp"
#include "surface/file/gzipped.hpp"

namespace plumb::fuzz {
namespace {

/// The mesh, or none where the bytes are refused.
std::optional<PolygonMesh> read(std::string_view bytes, const char* name) try {
  const ReadOptions little{.most_bytes = std::uint64_t{1} << 20};
  PolygonMesh mesh = parse_mesh(bytes, std::filesystem::path(name), nullptr, little);
  require_sound(mesh);
  return mesh;
} catch (const Error&) {
  return std::nullopt;
}

bool agree(const std::optional<PolygonMesh>& l, const std::optional<PolygonMesh>& r) {
  return l.has_value() == r.has_value() && (!l || same(*l, *r));
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb::fuzz;
  using plumb::surface_test::gzipped;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  read(bytes, "fuzz.obj.gz");
  if (size == 0 || plumb::surface::is_gzip(bytes)) return 0;  // what is packed twice stays packed once
  const std::size_t cut = data[size - 1] % size, damaged = data[size / 2];
  std::string packed = gzipped(bytes.substr(0, cut)) + gzipped(bytes.substr(cut)) + std::string(size % 3, '\0');
  const auto plain = read(bytes, "fuzz.obj"), unpacked = read(packed, "fuzz.obj.gz");
  require(agree(plain, unpacked), "what is packed reads as what is not");
  packed[2 + damaged % (packed.size() - 2)] ^= static_cast<char>(1 + damaged % 255);
  const auto after = read(packed, "fuzz.obj.gz");
  require(!after || agree(plain, after), "what is damaged is refused, or its contents are not");
  return 0;
}
