#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual clash_manual() {
  return {"plumb clash",
          "which parts of an assembly are in each other's way?",
          {"plumb clash [OPTION]... MESH...", "plumb clash --shard I/N --out DIR [OPTION]... FOLDER"},
          {{"DESCRIPTION", R"(
Reads each MESH as `plumb check` does, takes its parts (the nodes of a
glTF, the items of a 3MF's build, the objects of an OBJ or, where it has
none, its groups; of any other file its mesh; of a folder all files in
it), and holds each part against every other. Parts of one name are told
apart by numbers: bolt, bolt#2.

A part whose mesh is closed is a solid, any other a sheet. Of each pair
one word is said, and all of it is decided exactly:

within clearance  apart, but at most as far as --clearance
touching          in contact, and nothing of one inside of the other
overlapping       something of one is inside of the other
piercing through  and one, less the other, falls into more pieces
enclosed          one is inside of the other
duplicate         two parts are the same

With it come a place, and of solids the volume that they have in common
and the depth: the length of the least translation that frees two convex
parts; of others two lengths, none shorter than the first does, and one
as long as the second. Pairs that are the same in another place are
asked once.

A part that cannot be read is told by its name; all others are asked.

With --shard each file of a folder is an assembly of its own, and one of
N parts of them is looked at, each file by a process of its own, as
`plumb check --shard` does; `plumb collect` tells what was found. The
verdicts are clear, clashing where a clash is listed, and those that
every shard has; nothing is measured.)"}},
          {{"EXIT STATUS", exit_status("A clash is listed, and --fail-on-found was given.")},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb clash --ignore touching --json clashes.json machine.glb
       All that is more than contact.

plumb clash --page clashes.html machine.glb
       The list and the scene, to be looked at in a browser.

plumb clash --clearance 0.5 --rule 'bolt*,plate*: ignore touching' parts/
       What is nearer than 0.5, but not bolts that fit.

plumb clash --ignore touching --shard 3/10 --out found machines/
       A tenth of many machines.)"}}};
}

}  // namespace plumb::tool
