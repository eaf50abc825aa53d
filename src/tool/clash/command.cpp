#include "tool/clash/command.hpp"

#include <utility>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "tool/clash/assembly.hpp"
#include "tool/clash/bcf.hpp"
#include "tool/clash/page.hpp"
#include "tool/clash/rules.hpp"
#include "tool/clash/shard.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {

int run_clash(const ClashArguments& options) {
  if (options.shard.asked()) return run_clash_shard(options);
  if (options.meshes.words.empty()) throw Error("clash: no assembly is named; 'plumb clash --help' explains");
  for (const std::string& text : options.rules) parse_clash_rule(text);  // what is wrong with them is told at once
  const MeshInputs inputs = mesh_inputs(options.meshes);
  OutputFiles outputs(inputs.files);
  outputs.promise("--json", options.json);
  outputs.promise("--csv", options.csv);
  outputs.promise("--bcf", options.bcf);
  outputs.promise_unless_there("--page", options.page, options.overwrite);
  const ThreadLimit limit(options.threads);
  const bool says = !outputs.on_standard_output();
  if (says)
    for (const std::string& remark : inputs.remarks) say(remark);
  ClashReport report;
  report.passed_over = inputs.passed_over;
  report.clearance = options.clearance;
  report.measured = !options.unmeasured;
  std::vector<TriangleMesh> meshes;
  const bool all_good = each_assembly(
      inputs, options.meshes.reading(),
      [&](InputAssembly input) {
        outputs.require_not_read(input.load.files_beside);
        add_parts(input.name, input.parts, report, meshes);
      },
      [&](UnreadMesh part) { report.unread.push_back(std::move(part)); });
  {
    constexpr std::uint64_t steps = 1000;
    Progress bar("clash", steps);
    ClashesOptions how{.measure = report.measured};
    if (bar.shown()) {
      how.progress = [&bar](double share) {
        bar.advance(static_cast<std::uint64_t>(share * steps) - bar.done());
        return true;
      };
    }
    list_clashes(options, meshes, how, report);
  }
  if (says) say(clash_text(report, options.all, Style(stdout)));
  if (options.json) outputs.write("--json", json_text(clash_json(report)));
  if (options.csv) outputs.write("--csv", clash_csv(report));
  if (options.bcf) outputs.write("--bcf", clash_bcf(report, origin_json("plumb clash").at("date").get<std::string>()));
  if (options.page) outputs.write("--page", clash_page(report, meshes));
  if (!is_any_named(options.meshes, report.unread)) outputs.keep();
  if (!all_good) return 2;
  return options.fail_on_found && !report.clashes.empty() ? 1 : 0;
}

}  // namespace plumb::tool
