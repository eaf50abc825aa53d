#include "tool/manual/command.hpp"

namespace plumb::tool {

void add_meshes(CLI::App* parser, MeshArguments& meshes, const std::string& about) {
  parser->add_option("MESH", meshes.words, "Mesh files, folders of them, or '-' for standard input; " + about);
  add_unpacked(parser, meshes.unpacked_mib);
}

void add_unpacked(CLI::App* parser, std::optional<std::uint32_t>& unpacked_mib) {
  parser
      ->add_option(
          "--unpacked", unpacked_mib,
          "How many MiB a packed mesh may unpack to, and its parts make; when not given 4096, and no more than "
          "250 times the file, of which 16 MiB are free.")
      ->check(CLI::Range(1U, 1U << 24))
      ->type_name("MIB");
}

void add_obj(CLI::App* parser, ObjOutput& obj, const std::string& about) {
  add_output(parser, "--obj", obj.path, about);
  parser->add_flag("--overwrite", obj.overwrite, "Replace the file of --obj where it is there.");
}

}  // namespace plumb::tool
