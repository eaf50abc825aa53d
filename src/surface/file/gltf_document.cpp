#include "surface/file/gltf_document.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "surface/file/byte_reader.hpp"
#include "surface/file/gltf_uri.hpp"

namespace plumb::surface {
namespace {

constexpr std::uint64_t u8 = 5121, u16 = 5123, u32 = 5125, f32 = 5126;

std::uint64_t size_of(std::uint64_t component) {
  return component == u8 ? 1 : component == u16 ? 2 : component == u32 || component == f32 ? 4 : 0;
}

// Bytes in little-endian order, as glTF has them.
template <class T>
T number_at(const char* bytes) {
  std::uint32_t x = 0;
  for (std::size_t i = sizeof(T); i-- > 0;) x = (x << 8U) | static_cast<unsigned char>(bytes[i]);
  if constexpr (std::is_same_v<T, float>)
    return std::bit_cast<float>(x);
  else
    return static_cast<T>(x);
}

}  // namespace

GltfDocument::GltfDocument(Parse& parse, Assembly& assembly) : parse_(parse), assembly_(assembly) {
  if (parse.bytes.starts_with("glTF")) {
    parse.report.encoding = MeshEncoding::binary_little_endian;
    read_glb();
  } else {
    read_json(parse.bytes);
  }
  const auto asset = root_.find("asset");
  const std::string version = asset != root_.end() && asset->is_object() ? asset->value("version", Json()).dump() : "";
  if (!version.starts_with("\"2."))
    fail(MeshFileProblem::unsupported, "asset.version",
         "is " + (version.empty() ? "missing" : in_quotes(version)) + ", expected 2.0; export it as glTF 2");
}

void GltfDocument::fail(MeshFileProblem problem, const std::string& where, const std::string& text) const {
  fail_at_file(problem, parse_.file, where + " " + text);
}

void GltfDocument::read_glb() {
  ByteReader reader(parse_.bytes, parse_.file, 4, std::endian::little);
  const auto version = reader.read<std::uint32_t>("the version");
  if (version != 2)
    reader.fail(MeshFileProblem::unsupported,
                "binary glTF of version " + std::to_string(version) + ", expected 2; export it as glTF 2");
  const auto length = reader.read<std::uint32_t>("the length");
  if (length < parse_.bytes.size() && length >= reader.offset() && parse_.lenient()) {
    parse_.pass_over_at_byte("appendices behind the last chunk", length, bytes_text(parse_.bytes.size() - length));
    reader.end_at(length);
  } else if (length != parse_.bytes.size()) {
    reader.fail(length > parse_.bytes.size() ? MeshFileProblem::truncated : MeshFileProblem::syntax,
                "claims " + std::to_string(length) + " bytes in all, but the file has " +
                    std::to_string(parse_.bytes.size()) + "; fetch or export it again");
  }
  std::optional<std::string_view> text;
  while (reader.left() != 0) {
    const auto size = reader.read<std::uint32_t>("a chunk's length");
    const auto type = reader.read<std::uint32_t>("a chunk's type");
    reader.require(size, 1, "the bytes of a chunk");
    const std::string_view chunk = reader.rest().substr(0, size);
    constexpr std::uint32_t json_type = 0x4E4F534A, binary_type = 0x004E4942;
    if (type == json_type && !text) text = chunk;
    if (type == binary_type && !binary_) binary_ = chunk;
    reader.skip(size, 1, "the bytes of a chunk");
  }
  if (!text) reader.fail(MeshFileProblem::truncated, "the file ends here, expected a chunk of JSON; export it again");
  read_json(*text);
}

void GltfDocument::read_json(std::string_view text) {
  // A value follows a bracket, a comma or a colon: more memory than these take, the document will not.
  const auto values = static_cast<std::uint64_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return c == ',' || c == '{' || c == '[' || c == ':'; }));
  assembly_.charge(values, 96);
  try {
    root_ = Json::parse(text);
  } catch (const Json::exception& e) {
    fail_at_file(MeshFileProblem::syntax, parse_.file,
                 std::string("this is no JSON (") + in_quotes(e.what()) + "), expected a glTF; export it again");
  }
  if (!root_.is_object())
    fail_at_file(MeshFileProblem::syntax, parse_.file, "the JSON is no object, expected a glTF; export it again");
}

std::uint64_t GltfDocument::size(const std::string& list) const {
  const auto at = root_.find(list);
  return at == root_.end() || !at->is_array() ? 0 : at->size();
}

const GltfDocument::Json& GltfDocument::element(const std::string& list, std::uint64_t index,
                                                const std::string& named_by) const {
  if (index >= size(list))
    fail(MeshFileProblem::bad_index, named_by,
         "names " + list + "[" + std::to_string(index) + "], but there are " + std::to_string(size(list)) +
             "; export it again");
  const Json& found = root_[list][index];
  if (!found.is_object())
    fail(MeshFileProblem::syntax, list + "[" + std::to_string(index) + "]", "is no object; export it again");
  return found;
}

std::uint64_t GltfDocument::whole(const Json& of, const std::string& key, const std::string& where,
                                  std::optional<std::uint64_t> otherwise) const {
  const auto at = of.find(key);
  if (at == of.end() && otherwise) return *otherwise;
  constexpr std::uint64_t largest = std::uint64_t{1} << 53;  // so that a sum or product with bytes cannot overflow
  if (at == of.end() || !at->is_number_unsigned() || at->get<std::uint64_t>() > largest)
    fail(MeshFileProblem::syntax, where,
         "has " + (at == of.end() ? "no " + key : key + " " + in_quotes(at->dump())) +
             ", expected a whole number; export it again");
  return at->get<std::uint64_t>();
}

std::string GltfDocument::read_uri(const std::string& uri, const std::string& where, std::uint64_t length) {
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(',');
    const std::string_view head = std::string_view(uri).substr(0, comma);
    if (comma == std::string::npos || !head.ends_with(";base64"))
      fail(MeshFileProblem::syntax, where, "has a data URI that is not in base64; export it again");
    auto bytes = from_base64(std::string_view(uri).substr(comma + 1));
    if (!bytes) fail(MeshFileProblem::syntax, where, "has a data URI that is no base64; export it again");
    return std::move(*bytes);
  }
  if (parse_.folder.empty())
    fail(MeshFileProblem::unreadable, where,
         "names the file " + in_quotes(uri) + ", but this glTF has no folder; read it by its name, or as GLB");
  const auto path = file_beside(parse_.folder, uri);
  if (!path)
    fail(MeshFileProblem::unreadable, where,
         "names " + in_quotes(uri) + ", expected a file in the glTF's own folder; put it there");
  auto bytes = bytes_of(*path, length);
  if (!bytes)
    fail(MeshFileProblem::missing, where, "names " + in_quotes(uri) + ", which cannot be read; put it beside the glTF");
  assembly_.also_read(bytes->size());
  parse_.report.files_beside.push_back(*path);
  return std::move(*bytes);
}

std::string_view GltfDocument::buffer(std::uint64_t index) {
  const std::string where = "buffers[" + std::to_string(index) + "]";
  const Json& b = element("buffers", index, where);
  const std::uint64_t length = whole(b, "byteLength", where);
  const auto uri = b.find("uri");
  std::string_view bytes;
  if (uri != b.end() && uri->is_string()) {
    auto known = buffers_.find(index);
    if (known == buffers_.end())
      known = buffers_.emplace(index, read_uri(uri->get<std::string>(), where, length)).first;
    bytes = known->second;
  } else if (index == 0 && binary_) {
    bytes = *binary_;
  } else {
    fail(MeshFileProblem::syntax, where, "has neither a URI nor a chunk of this file; export it again");
  }
  if (bytes.size() < length)
    fail(MeshFileProblem::truncated, where,
         "claims " + std::to_string(length) + " bytes, but " + std::to_string(bytes.size()) +
             " are there; fetch or export it again");
  return bytes.substr(0, length);
}

GltfDocument::Elements GltfDocument::elements(const Json& of, const std::string& view_key, std::uint64_t count,
                                              std::uint64_t size, const std::string& where) {
  const std::uint64_t index = whole(of, view_key, where);
  const std::string view_where = "bufferViews[" + std::to_string(index) + "]";
  const Json& view = element("bufferViews", index, where);
  if (const auto extensions = view.find("extensions"); extensions != view.end() && extensions->is_object())
    for (const char* packed : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
      if (extensions->contains(packed))
        fail(MeshFileProblem::unsupported, view_where,
             std::string("is packed by ") + packed + ", which is not read; unpack it with `gltf-transform copy`");
  const std::string_view all = buffer(whole(view, "buffer", view_where));
  const std::uint64_t begin = whole(view, "byteOffset", view_where, 0), length = whole(view, "byteLength", view_where);
  if (begin > all.size() || length > all.size() - begin)
    fail(MeshFileProblem::bad_index, view_where,
         "ends beyond its buffer of " + std::to_string(all.size()) + " bytes; export it again");
  const std::uint64_t stride = whole(view, "byteStride", view_where, size), offset = whole(of, "byteOffset", where, 0);
  if (stride < 1 || stride > 252)
    fail(MeshFileProblem::syntax, view_where,
         "has a byteStride of " + std::to_string(stride) + ", expected 4 to 252; export it again");
  const std::string_view bytes = all.substr(begin, length);
  const bool fits =
      count == 0 || (offset <= length && size <= length - offset && count - 1 <= (length - offset - size) / stride);
  if (!fits)
    fail(MeshFileProblem::bad_index, where,
         "has " + std::to_string(count) + " elements, which end beyond " + view_where + " of " +
             std::to_string(length) + " bytes; export it again");
  return {bytes.substr(std::min<std::uint64_t>(offset, length)), stride};
}

std::vector<std::uint32_t> GltfDocument::scalars(const Elements& from, std::uint64_t count, std::uint64_t type) const {
  std::vector<std::uint32_t> all(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const char* const at = from.at(i);
    all[i] = type == u8    ? number_at<std::uint8_t>(at)
             : type == u16 ? number_at<std::uint16_t>(at)
                           : number_at<std::uint32_t>(at);
  }
  return all;
}

std::vector<std::uint32_t> GltfDocument::indices(std::uint64_t accessor, const std::string& named_by) {
  const std::string where = "accessors[" + std::to_string(accessor) + "]";
  const Json& a = element("accessors", accessor, named_by);
  const std::uint64_t type = whole(a, "componentType", where), count = whole(a, "count", where);
  if (a.value("type", Json()) != "SCALAR" || (type != u8 && type != u16 && type != u32))
    fail(MeshFileProblem::syntax, where, "holds no indices, expected SCALAR of 8, 16 or 32 bits; export it again");
  if (a.contains("sparse") || !a.contains("bufferView"))
    fail(MeshFileProblem::unsupported, where, "holds sparse indices, expected plain ones; export it again");
  const Elements from = elements(a, "bufferView", count, size_of(type), where);
  assembly_.charge(count, sizeof(std::uint32_t));
  return scalars(from, count, type);
}

std::vector<Point3> GltfDocument::points(std::uint64_t accessor, const std::string& named_by) {
  const std::string where = "accessors[" + std::to_string(accessor) + "]";
  const Json& a = element("accessors", accessor, named_by);
  const std::uint64_t type = whole(a, "componentType", where), count = whole(a, "count", where);
  if (a.value("type", Json()) != "VEC3" || size_of(type) == 0)
    fail(MeshFileProblem::unsupported, where,
         "holds positions of another kind than float32 triples (KHR_mesh_quantization?); unpack them with "
         "`gltf-transform dequantize`");
  if (type != f32)
    fail(MeshFileProblem::unsupported, where,
         "holds positions in integers (KHR_mesh_quantization); unpack them with `gltf-transform dequantize`");
  const bool is_viewed = a.contains("bufferView");
  const Elements from = is_viewed ? elements(a, "bufferView", count, 12, where) : Elements{};
  assembly_.charge(count, sizeof(Point3));
  std::vector<Point3> points(count);
  if (is_viewed) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const char* const at = from.at(i);
      points[i] = {number_at<float>(at), number_at<float>(at + 4), number_at<float>(at + 8)};
    }
  }
  if (a.contains("sparse")) fill_sparse(a, count, where, points);
  for (std::uint64_t i = 0; i < count; ++i)
    if (const Point3& p = points[i]; !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      fail(MeshFileProblem::bad_number, where,
           "has a coordinate that is not finite in element " + std::to_string(i) + "; mend the mesh");
  return points;
}

void GltfDocument::fill_sparse(const Json& accessor, std::uint64_t count, const std::string& where,
                               std::vector<Point3>& points) {
  const Json& sparse = accessor["sparse"];
  const auto part = [&](const char* key) -> const Json& {
    const auto at = sparse.is_object() ? sparse.find(key) : sparse.end();
    if (!sparse.is_object() || at == sparse.end() || !at->is_object())
      fail(MeshFileProblem::syntax, where + ".sparse", std::string("has no ") + key + "; export it again");
    return *at;
  };
  const Json &which = part("indices"), &values = part("values");
  const std::uint64_t changed = whole(sparse, "count", where + ".sparse");
  const std::uint64_t type = whole(which, "componentType", where + ".sparse.indices");
  if (changed > count || (type != u8 && type != u16 && type != u32))
    fail(MeshFileProblem::syntax, where + ".sparse",
         "changes " + std::to_string(changed) + " of " + std::to_string(count) + " elements by indices of type " +
             std::to_string(type) + "; export it again");
  const auto at =
      scalars(elements(which, "bufferView", changed, size_of(type), where + ".sparse.indices"), changed, type);
  const Elements from = elements(values, "bufferView", changed, 12, where + ".sparse.values");
  for (std::uint64_t i = 0; i < changed; ++i) {
    if (at[i] >= count || (i > 0 && at[i] <= at[i - 1]))
      fail(MeshFileProblem::bad_index, where + ".sparse.indices",
           "has " + std::to_string(at[i]) + " at place " + std::to_string(i) + ", expected rising numbers below " +
               std::to_string(count) + "; export it again");
    const char* const x = from.at(i);
    points[at[i]] = {number_at<float>(x), number_at<float>(x + 4), number_at<float>(x + 8)};
  }
}

}  // namespace plumb::surface
