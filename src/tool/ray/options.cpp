#include "tool/manual/command.hpp"
#include "tool/ray/command.hpp"

namespace plumb::tool {

Command ray_command(CLI::App& program) {
  const auto options = std::make_shared<RayOptions>();
  RayOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("ray", "Say which triangles rays hit, first and in order.");
  parser->add_option("MESH", o.meshes.words, "The mesh file; '-' is standard input.");
  add_reading(parser, o.meshes);
  parser->add_option("--ray", o.rays, "Shoot this ray: its origin and its direction; repeatable.")
      ->allow_extra_args(false)
      ->type_name("OX,OY,OZ,DX,DY,DZ");
  parser->add_option("--segment", o.segments, "Shoot from one point to another, no farther; repeatable.")
      ->allow_extra_args(false)
      ->type_name("AX,AY,AZ,BX,BY,BZ");
  parser->add_option("--rays", o.ray_file, "Shoot the rays of this table, one a line; '-' is standard input.")
      ->type_name("FILE");
  parser->add_option("--segments", o.segment_file, "The same of segments.")->type_name("FILE");
  add_tree(parser, o.tree);
  parser->add_flag("--all", o.all, "Say every hit of a ray; without this option, the first.");
  add_output(parser, "--json", o.json, "Write every hit as JSON");
  add_obj(parser, o.obj, "Write the triangles that are said to be hit as OBJ");
  return {parser, ray_manual, [options] { return run_ray(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
