#include <iterator>

#include "tool/convert/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command convert_command(CLI::App& program) {
  const auto options = std::make_shared<ConvertOptions>();
  ConvertOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("convert", "Write a mesh file in another format.");
  parser->add_option("FROM TO", o.files.words,
                     "The mesh file to read, and the one to write; '-' is standard input, and standard output.");
  add_reading(parser, o.files);
  const auto one_of = [](const auto& names) {
    return CLI::IsMember(std::vector<std::string>(std::begin(names), std::end(names)), CLI::ignore_case);
  };
  parser->add_option("--format", o.format, "Of the file to write: obj, off, stl or ply; else its extension tells.")
      ->transform(one_of(format_names))
      ->type_name("FORMAT");
  parser
      ->add_option("--encoding", o.encoding,
                   "Of the file to write: ascii, binary or binary-big-endian; else ascii, and binary for PLY.")
      ->transform(one_of(encoding_names))
      ->type_name("ENCODING");
  parser->add_flag("--overwrite", o.overwrite, "Replace the file to write where it is there.");
  return {parser, convert_manual, [options] { return run_convert(*options); }, &o.files.words};
}

}  // namespace plumb::tool
