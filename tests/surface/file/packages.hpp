// Small 3MF and glTF files, made by the tests from what matters in them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "surface/file/sample_files.hpp"
#include "surface/file/zipped.hpp"

namespace plumb::surface_test {

/// A tetrahedron as the mesh of a 3MF object.
inline const std::string tetrahedron_object =
    "<object id=\"1\" type=\"model\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
    "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"0.5\"/></vertices><triangles>"
    "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/>"
    "<triangle v1=\"2\" v2=\"0\" v3=\"3\"/></triangles></mesh></object>";

inline std::string model_of(const std::string& objects, const std::string& items,
                            const std::string& attributes = "unit=\"millimeter\"") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model " + attributes +
         " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>" + objects +
         "</resources><build>" + items + "</build></model>";
}

inline const std::string relations =
    "<?xml version=\"1.0\"?><Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"r\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";

inline std::string package_of(const std::string& model, std::vector<ZipEntry> more = {}) {
  more.insert(more.begin(), {{"_rels/.rels", relations}, {"3D/3dmodel.model", model}});
  return zipped(more);
}

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63U];
  }
  return text;
}

inline std::string glb_of(std::string json, std::string binary) {
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  const auto chunk = [](std::uint32_t type, const std::string& bytes) {
    return raw(static_cast<std::uint32_t>(bytes.size())) + raw(type) + bytes;
  };
  std::string chunks = chunk(0x4E4F534A, json);
  if (!binary.empty()) chunks += chunk(0x004E4942, binary);
  return "glTF" + raw(2U) + raw(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

}  // namespace plumb::surface_test
