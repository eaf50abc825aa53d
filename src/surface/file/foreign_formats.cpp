#include "surface/file/foreign_formats.hpp"

#include <algorithm>
#include <array>

#include "surface/file/text_lines.hpp"

namespace plumb::surface {
namespace {

using std::string_view_literals::operator""sv;

struct ForeignFormat {
  std::string_view name, kind;
  std::array<std::string_view, 4> extensions;  // lower case
  std::string_view mark;                       // with which the content begins; may be empty
  std::string_view mend;
};

constexpr std::string_view solids = "CAD format of curved solids, no mesh", scene_format = "scene format, not read",
                           cells = "format of volume cells, not read",
                           packed_file = "packed file, of which gzip's are read";
constexpr std::string_view by_cad = "export STL or 3MF from the CAD program that wrote it";
constexpr std::string_view by_blender = "convert it to glTF or OBJ with Blender or `assimp export`";
constexpr std::string_view by_meshio = "convert its surface to STL or PLY with meshio or ParaView";
constexpr std::array<ForeignFormat, 28> formats{{
    {"STEP",
     solids,
     {".step", ".stp", ".p21", ".stpz"},
     "ISO-10303-21;"sv,
     "convert it with `gmsh part.step -2 -o part.stl` or FreeCAD"},
    {"IGES", solids, {".iges", ".igs"}, "", "convert it with `gmsh part.iges -2 -o part.stl` or FreeCAD"},
    {"BREP", solids, {".brep", ".brp"}, "DBRep_DrawableShape", "convert it with `gmsh part.brep -2 -o part.stl`"},
    {"FreeCAD", solids, {".fcstd"}, "", "export STL, OBJ or 3MF from FreeCAD"},
    {"Parasolid", solids, {".x_t", ".x_b", ".xmt_txt"}, "**ABCDEFGHIJKLMNOPQRSTUVWXYZ", by_cad},
    {"ACIS", solids, {".sat", ".sab"}, "", by_cad},
    {"JT", solids, {".jt"}, "", by_cad},
    {"SolidWorks", solids, {".sldprt", ".sldasm"}, "", by_cad},
    {"Inventor", solids, {".ipt", ".iam"}, "", by_cad},
    {"CATIA", solids, {".catpart", ".catproduct"}, "V5_CFV2", by_cad},
    {"Rhino", solids, {".3dm"}, "3D Geometry File Format", "export STL, OBJ or 3MF from Rhino"},
    {"DWG", solids, {".dwg"}, "AC10", by_cad},
    {"DXF", "drawing format, not read", {".dxf"}, "", by_cad},
    {"OpenSCAD", "program that makes a mesh, not read", {".scad"}, "", "run `openscad -o part.stl part.scad`"},
    {"FBX", scene_format, {".fbx"}, "Kaydara FBX Binary", by_blender},
    {"Blender", scene_format, {".blend"}, "BLENDER", "export OBJ, STL or glTF from Blender"},
    {"COLLADA", scene_format, {".dae"}, "", by_blender},
    {"3DS", scene_format, {".3ds"}, "", by_blender},
    {"VRML or X3D", scene_format, {".wrl", ".x3d", ".x3dv"}, "#VRML", by_blender},
    {"USD", scene_format, {".usd", ".usda", ".usdc", ".usdz"}, "PXR-USDC", by_blender},
    {"VTK", cells, {".vtk", ".vtu", ".vtp"}, "# vtk DataFile", by_meshio},
    {"bzip2", packed_file, {".bz2"}, "BZh91AY&SY", "unpack it with `bunzip2`"},
    {"xz",
     packed_file,
     {".xz", ".txz"},
     "\xFD"
     "7zXZ",
     "unpack it with `unxz`"},
    {"Zstandard", packed_file, {".zst"}, "\x28\xB5\x2F\xFD", "unpack it with `unzstd`"},
    {"LZ4", packed_file, {".lz4"}, "\x04\x22\x4D\x18", "unpack it with `unlz4`"},
    {"7-Zip", packed_file, {".7z"}, "7z\xBC\xAF\x27\x1C", "unpack it with `7z x`"},
    {"compress", packed_file, {".z"}, "\x1F\x9D", "unpack it with `uncompress`"},
    {"Gmsh's own", cells, {".msh"}, "$MeshFormat", "write its surface with `gmsh part.msh -2 -o part.stl`"},
}};

std::string said_of(const ForeignFormat& f) {
  std::string text = "this is ";
  return text.append(f.name).append(", a ").append(f.kind).append(": ").append(f.mend);
}

// IGES has no magic word: its first line has an S in column 73 and the number 1 after it.
bool is_iges(std::string_view bytes) {
  return bytes.size() > 80 && bytes[72] == 'S' &&
         bytes.substr(73, 7).find_first_not_of(" 01") == std::string_view::npos && bytes[79] == '1' &&
         bytes.substr(0, 72).find('\n') == std::string_view::npos;
}

}  // namespace

std::optional<std::string> foreign_by_content(std::string_view bytes) {
  for (const ForeignFormat& f : formats)
    if ((!f.mark.empty() && bytes.starts_with(f.mark)) || (f.name == "IGES" && is_iges(bytes))) return said_of(f);
  return std::nullopt;
}

std::optional<std::string> packer_by_content(std::string_view bytes) {
  for (const ForeignFormat& f : formats)
    if (f.kind == packed_file && bytes.starts_with(f.mark)) return said_of(f);
  return std::nullopt;
}

std::optional<std::string> foreign_by_extension(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  if (extension.empty()) return std::nullopt;
  for (const ForeignFormat& f : formats)
    if (std::find(f.extensions.begin(), f.extensions.end(), extension) != f.extensions.end()) return said_of(f);
  return std::nullopt;
}

}  // namespace plumb::surface
