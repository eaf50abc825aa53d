#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual collect_manual() {
  return {"plumb collect",
          "what was found of a folder of models, of all shards",
          {"plumb collect [OPTION]... DIR"},
          {{"DESCRIPTION", R"(
Reads what runs of 'plumb check --shard I/N' wrote into DIR, and tells
how many models have which verdict and which defects, how long their
processes took, and which models are the worst: those that crashed, took
too long or too much memory or cannot be read come first, then those
with the most defects.

The digest is a hash of what was found of each model, in the order of
their names. It is the same for any number of shards, on any machine
and in any order; times and the words of errors do not count.

Shards that are missing or were stopped are told by their numbers; start
them again with the same options, and they go on.)"}},
          {{"EXIT STATUS", exit_status("A shard is missing, or not at its end. The others are collected.")},
           {"EXAMPLES", R"(
plumb collect found
       The table, the twenty worst and the digest.

plumb collect found --page found.html --csv found.csv
       The worst as a page, and every model as a row.)"}}};
}

}  // namespace plumb::tool
