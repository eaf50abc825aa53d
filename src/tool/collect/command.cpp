#include "tool/collect/command.hpp"

#include "plumb/arith/error.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {

int run_collect(const CollectArguments& options) {
  if (options.folders.size() != 1)
    throw Error("collect: a folder of shards is needed, one; 'plumb collect --help' explains");
  OutputFiles outputs;
  outputs.promise("--json", options.json);
  outputs.promise("--csv", options.csv);
  outputs.promise("--page", options.page);
  const Collection all = collect(options.folders[0]);
  if (!outputs.on_standard_output()) say(collection_text(all, options.worst, Style(stdout)));
  if (outputs.wants("--json")) outputs.write("--json", json_text(collection_json(all, true)));
  if (outputs.wants("--csv")) outputs.write("--csv", collection_csv(all));
  if (outputs.wants("--page")) outputs.write("--page", collection_page(all));
  outputs.keep();
  return all.unfinished.empty() ? 0 : 1;
}

}  // namespace plumb::tool
