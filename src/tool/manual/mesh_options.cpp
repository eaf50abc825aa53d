#include "tool/manual/command.hpp"

namespace plumb::tool {

void add_meshes(CLI::App* parser, MeshArguments& meshes, const std::string& about) {
  parser->add_option("MESH", meshes.words, "Mesh files, folders of them, or '-' for standard input; " + about);
  add_reading(parser, meshes);
}

void add_reading(CLI::App* parser, MeshArguments& meshes) {
  parser->add_flag(
      "--strict", meshes.strict,
      "Refuse a mesh with text that has no meaning in its format, such as a misspelt line of an OBJ; without "
      "this option it is passed over and told.");
  parser->add_flag(
      "--lenient", meshes.lenient,
      "Read a mesh that is not quite as its format has it, as other programs do (bytes after the last facet, "
      "a wrong count, an STL without normals or endsolid), and tell what was passed over.");
  parser
      ->add_option(
          "--unpacked", meshes.unpacked_mib,
          "How many MiB a packed mesh may unpack to, and its parts make; when not given 4096, and no more than "
          "250 times the file, of which 16 MiB are free.")
      ->check(CLI::Range(1U, 1U << 24))
      ->type_name("MIB");
}

void add_tree(CLI::App* parser, std::optional<std::string>& file) {
  parser->add_option("--tree", file, "Take the mesh's tree from this file of 'plumb bvh --out', and build none.")
      ->type_name("FILE");
}

void add_obj(CLI::App* parser, ObjOutput& obj, const std::string& about) {
  add_output(parser, "--obj", obj.path, about);
  parser->add_flag("--overwrite", obj.overwrite, "Replace the file of --obj where it is there.");
}

}  // namespace plumb::tool
