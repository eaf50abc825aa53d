#include "tool/convert/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "plumb/arith/error.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/mesh/load_text.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

WriteOptions write_options(const ConvertOptions& options) {
  constexpr std::array formats{MeshFormat::obj, MeshFormat::off, MeshFormat::stl, MeshFormat::ply};
  constexpr std::array encodings{MeshEncoding::ascii, MeshEncoding::binary_little_endian,
                                 MeshEncoding::binary_big_endian};
  WriteOptions write;
  if (options.format) {
    const auto at = std::ranges::find(format_names, *options.format);
    write.format = formats.at(static_cast<std::size_t>(at - std::begin(format_names)));
  }
  if (options.encoding) {
    const auto at = std::ranges::find(encoding_names, *options.encoding);
    write.encoding = encodings.at(static_cast<std::size_t>(at - std::begin(encoding_names)));
  }
  return write;
}

}  // namespace

int run_convert(const ConvertOptions& options) {
  if (options.files.words.size() != 2)
    throw Error("convert: two files are needed, the one to read and the one to write; 'plumb convert --help' explains");
  const std::string &from = options.files.words[0], &to = options.files.words[1];
  OutputFiles outputs({from});
  outputs.promise_mesh("TO", to, options.overwrite ? surface::Replacing::yes : surface::Replacing::no,
                       "give another name, or --overwrite to replace it");
  const WriteOptions write = write_options(options);
  format_mesh(PolygonMesh{}, to, write);  // a format that cannot be written is refused before anything is read
  LoadReport report;
  const PolygonMesh mesh = read_input(from, &report, options.files.reading());
  outputs.require_not_read(report.files_beside);
  outputs.write("TO", format_mesh(mesh, to, write));
  if (!outputs.on_standard_output()) {
    const bool triangulated =
        write.format.value_or(format_by_extension(to).value_or(MeshFormat::obj)) == MeshFormat::stl;
    say(fmt::format("{} -> {}\n{}", printable(name_of_input(from)), printable(to), load_text(report, triangulated)));
  }
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool
