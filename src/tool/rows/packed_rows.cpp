#include "tool/rows/packed_rows.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "plumb/arith/error.hpp"
#include "surface/file/foreign_formats.hpp"
#include "surface/file/gunzip.hpp"
#include "surface/file/mesh_parsers.hpp"
#include "surface/file/text_lines.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

void require_no_archive(const std::string& file, std::string_view bytes) {
  const std::string ending = surface::lower_case(std::filesystem::path(file).extension().string());
  if (ending == ".npz")
    throw Error(fmt::format(
        "{}: this is an archive of NumPy's arrays (.npz); write the one that is meant by numpy.save", printable(file)));
  if (ending == ".zip" || bytes.starts_with("PK\3\4"))
    throw Error(fmt::format("{}: this is a zip archive, expected one file of rows; unpack it", printable(file)));
}

std::optional<std::string> unpacked_rows(std::string_view bytes, const std::string& name, const ReadOptions& reading) {
  if (const auto packer = surface::packer_by_content(bytes)) throw Error(fmt::format("{}: {}", name, *packer));
  if (!surface::is_gzip(bytes)) return {};
  try {
    return surface::gunzip(bytes, name, surface::unpacked_limit(bytes.size(), reading));
  } catch (const MeshFileError& e) {
    if (e.problem != MeshFileProblem::too_large) throw;
    throw Error(fmt::format("{}; '--unpacked MIB' raises it", e.what()));
  }
}

std::string name_within(const std::string& file) {
  const std::filesystem::path path(file);
  return surface::lower_case(path.extension().string()) == ".gz" ? path.stem().string() : file;
}

}  // namespace plumb::tool
