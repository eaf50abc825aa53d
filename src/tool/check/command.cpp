#include "tool/check/command.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "plumb/surface/triangulate.hpp"
#include "plumb/surface/write_mesh.hpp"
#include "tool/check/report.hpp"
#include "tool/mesh/bent_faces.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/mesh/sample_part.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

/// Checks a mesh; of what is found each part is said as soon as it is known, where text is wanted.
class Checker {
 public:
  Checker(const CheckSettings& settings, const ReadOptions& reading, bool says)
      : settings_(settings), reading_(reading), says_(says) {}

  /// Everything that the argument means; false where some of it is no mesh, which was said.
  bool check_argument(const std::string& argument) {
    bool good = true;
    try {
      MeshInputs inputs = mesh_inputs(argument);
      if (says_ && !inputs.passed_over.empty()) {
        if (!checks_.empty()) say("\n");
        say(text_passed_over(argument, inputs));
      }
      passed_over_.insert(passed_over_.end(), inputs.passed_over.begin(), inputs.passed_over.end());
      for (const std::string& file : inputs.files) good = check_file(file) && good;
    } catch (const MeshFileError& e) {
      complain(e.what());
      return false;
    }
    return good;
  }
  bool check_file(const std::string& path) try {
    MeshCheck check;
    check.name = name_of_input(path);
    check.from_file = true;
    const PolygonMesh polygons = read_input(path, &check.load, reading_);
    check.bent_faces = bent_faces(polygons);
    take(triangulate(polygons, &check.load.fans), std::move(check));
    return true;
  } catch (const MeshFileError& e) {  // the other meshes are still worth checking
    complain(e.what());
    return false;
  }
  void check_sample() {
    MeshCheck check;
    check.name = "embedded flange";
    take(sample_part(), std::move(check));
  }
  void say_total() const {
    if (!says_ || checks_.size() < 2) return;
    say("\n");
    say(text_total(checks_, style_));
  }
  [[nodiscard]] const std::vector<MeshCheck>& checks() const { return checks_; }
  [[nodiscard]] const std::vector<std::string>& passed_over() const { return passed_over_; }

 private:
  void take(const TriangleMesh& mesh, MeshCheck check) {
    check_mesh(mesh, settings_, check, [&](CheckStep step) {
      if (!says_) return;
      if (step == CheckStep::mesh) {
        if (!checks_.empty()) say("\n");
        say(text_opening(check, style_));
      }
      if (step == CheckStep::inexact) say(text_verdict(check));
      if (step == CheckStep::exact) say(text_tables(check, style_));
      flush_output();
    });
    checks_.push_back(std::move(check));
  }

  const CheckSettings settings_;
  const ReadOptions reading_;
  const bool says_;
  const Style style_{stdout};
  std::vector<MeshCheck> checks_;
  std::vector<std::string> passed_over_;
};

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
  OutputFiles outputs(options.meshes);
  outputs.promise("--json", options.json);
  outputs.promise("--chart", options.chart);
  outputs.promise_new("--write-sample", options.write_sample);
  if (options.write_sample) {
    outputs.write("--write-sample", format_mesh(to_polygons(sample_part()), *options.write_sample, {}));
    if (options.meshes.empty() && !options.json && !options.chart && options.fail_on_wrong.empty() && !options.verify) {
      outputs.keep();
      return 0;
    }
  }
  if (std::ranges::count(options.meshes, "-") > 1) throw Error("'-' stands twice, but standard input is read once");
  const unsigned threads =
      options.threads != 0 ? options.threads : static_cast<unsigned>(tbb::info::default_concurrency());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  CheckSettings settings;
  settings.verify = options.verify;
  settings.all = options.all;
  ReadOptions reading;
  if (options.unpacked_mib)
    reading = {std::uint64_t{*options.unpacked_mib} << 20, std::numeric_limits<std::uint64_t>::max()};
  Checker checker(settings, reading, !outputs.on_standard_output());
  if (options.meshes.empty()) checker.check_sample();
  bool bad_input = false;
  for (const std::string& argument : options.meshes) bad_input = !checker.check_argument(argument) || bad_input;
  checker.say_total();
  const std::vector<MeshCheck>& checks = checker.checks();
  if (options.json) {
    // A file's name may be any bytes; JSON is UTF-8.
    const std::string text = json_report(checks, checker.passed_over(), threads)
                                 .dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    outputs.write("--json", text + "\n");
  }
  if (options.chart) outputs.write("--chart", chart_svg(checks));
  if (bad_input) return 2;
  outputs.keep();
  return any_wrong(checks, options.fail_on_wrong) ? 1 : 0;
}

}  // namespace plumb::tool
