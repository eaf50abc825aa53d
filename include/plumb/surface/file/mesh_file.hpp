// Which mesh files are known, how is one recognized, and what can be wrong with it?
//
// A file may be packed by gzip: then what it holds is looked at, and the extension before `.gz`.
// Laws: the content outranks the extension where the content is unmistakable (the magic words of PLY, OFF, GLB and zip
// archives, which 3MF is, JSON with an "asset", which glTF is, the exact length of a binary STL, an STL that is text);
// OBJ has no mark and is believed by its extension or its first word.  3MF and glTF are read, not written.
// Every error names the file, the line (text) or the byte (binary) where there is one, what was found, what was
// expected, and the mend.
// Source: the formats as their authors published them.
// Cost: recognition looks at the first few lines only, but looks for the asset of a glTF.  Nothing is searched but
// the file's first lines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "plumb/arith/error.hpp"

namespace plumb {

enum class MeshFormat { obj, off, stl, ply, three_mf, gltf };
enum class MeshEncoding { ascii, binary_little_endian, binary_big_endian };

std::string_view name_of(MeshFormat format);      // "OBJ"
std::string_view name_of(MeshEncoding encoding);  // "binary little endian"

/// By what follows the last dot, upper or lower case.
std::optional<MeshFormat> format_by_extension(const std::string& path);

/// By the bytes alone.
std::optional<MeshFormat> format_by_content(std::string_view bytes);

/// What the two together say of unpacked bytes; nothing when neither knows.
std::optional<MeshFormat> recognize_format(const std::string& path, std::string_view bytes);

enum class MeshFileProblem {
  missing,            // there is no such file
  unreadable,         // a directory, no permission, a failing disk
  unknown_format,     // neither extension nor content tells what it is
  unsupported,        // a known dialect that is not read, or an encoding the format does not have
  empty_file,         // no bytes
  empty_mesh,         // well formed, but without vertices or without faces
  syntax,             // something else was expected here
  bad_number,         // not a number, not finite, or beyond the largest double
  bad_index,          // a face names a vertex that is not there
  truncated,          // the file ends before it has said what it promised
  too_large,          // it unpacks or multiplies to more than ReadOptions allow
  unwritable,         // the file cannot be created or filled
  not_representable,  // the format cannot hold this coordinate
};

struct MeshFileError : Error {
  MeshFileError(MeshFileProblem problem, std::string_view file, std::optional<std::uint64_t> line,
                std::optional<std::uint64_t> byte, const std::string& text);
  MeshFileProblem problem;
  std::string file;
  std::optional<std::uint64_t> line;  // from 1, in text
  std::optional<std::uint64_t> byte;  // from 0, in binary data
};

}  // namespace plumb
