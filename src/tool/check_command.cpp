#include "check_command.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "check_report.hpp"
#include "plumb/surface/write_mesh.hpp"
#include "sample_part.hpp"

namespace plumb::tool {
namespace {

MeshCheck check_file(const std::string& path, const CheckSettings& settings) {
  MeshCheck check;
  check.name = path;
  check.from_file = true;
  check_mesh(read_mesh(path, &check.load), settings, check);
  return check;
}

MeshCheck check_sample(const CheckSettings& settings) {
  MeshCheck check;
  check.name = "embedded flange";
  check_mesh(sample_part(), settings, check);
  return check;
}

bool any_wrong(const std::vector<MeshCheck>& checks, const std::vector<std::string>& methods) {
  return std::ranges::any_of(checks, [&](const MeshCheck& c) {
    const Comparison total = c.total();
    if (total.refuted != 0) return true;
    return std::ranges::any_of(methods,
                               [&](const std::string& name) { return total.method[method_number(name)].wrong() != 0; });
  });
}

}  // namespace

int run_check(const CheckOptions& options) {
  if (options.write_sample) {
    write_mesh(*options.write_sample, sample_part());
    if (options.meshes.empty() && !options.json && !options.chart && options.fail_on_wrong.empty() && !options.verify)
      return 0;
  }
  if (options.json && options.json == options.chart) throw Error("--json and --chart name the same output");
  for (const auto& output : {options.json, options.chart}) {
    if (output) require_writable(*output);  // before minutes of work, not after
  }
  const unsigned threads =
      options.threads != 0 ? options.threads : static_cast<unsigned>(tbb::info::default_concurrency());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const CheckSettings settings{options.verify};
  const Style style(stdout);
  const bool text_wanted = options.json != "-" && options.chart != "-";  // standard output is for one of them alone
  std::vector<MeshCheck> checks;
  const auto add = [&](MeshCheck check) {
    if (text_wanted) {
      if (!checks.empty()) say("\n");
      say(text_report(check, style));
    }
    checks.push_back(std::move(check));
  };
  if (options.meshes.empty()) add(check_sample(settings));
  bool bad_input = false;
  for (const std::string& path : options.meshes) {
    try {
      add(check_file(path, settings));
    } catch (const MeshFileError& e) {  // the other meshes are still worth checking
      complain(e.what());
      bad_input = true;
    }
  }
  if (text_wanted && checks.size() > 1) {
    say("\n");
    say(text_total(checks, style));
  }
  if (options.json) {
    // A file's name may be any bytes; JSON is UTF-8.
    const std::string text = json_report(checks, threads).dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    write_text_file(*options.json, text + "\n");
  }
  if (options.chart) write_text_file(*options.chart, chart_svg(checks));
  if (bad_input) return 2;
  return any_wrong(checks, options.fail_on_wrong) ? 1 : 0;
}

}  // namespace plumb::tool
