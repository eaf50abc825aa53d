#include "tool/check/command.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "plumb/certify/thread_limit.hpp"
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
  Checker(const CheckSettings& settings, bool says) : settings_(settings), says_(says) {}

  void check(InputMesh input) {
    MeshCheck check;
    check.name = std::move(input.name);
    check.from_file = true;
    check.bent_faces = bent_faces(input.mesh);
    check.load = input.load;
    take(triangulate(input.mesh, &check.load.fans), std::move(check));
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
  const bool says_;
  const Style style_{stdout};
  std::vector<MeshCheck> checks_;
};

bool any_wrong(const std::vector<MeshCheck>& checks, const std::vector<std::string>& methods) {
  return std::ranges::any_of(checks, [&](const MeshCheck& c) {
    const Comparison total = c.total();
    if (total.refuted != 0) return true;
    return std::ranges::any_of(methods,
                               [&](const std::string& name) { return total.method[method_number(name)].wrong() != 0; });
  });
}

bool any_defect(const std::vector<MeshCheck>& checks, const std::vector<std::string>& defects) {
  return std::ranges::any_of(checks, [&](const MeshCheck& c) {
    return std::ranges::any_of(defects, [&](const std::string& defect) { return c.surface.has(defect); });
  });
}

}  // namespace

int run_check(const CheckOptions& options) {
  const MeshInputs inputs = mesh_inputs(options.meshes);
  OutputFiles outputs(inputs.files);
  outputs.promise("--json", options.json);
  outputs.promise("--chart", options.chart);
  outputs.promise_mesh("--write-sample", options.write_sample, surface::Replacing::no);
  if (options.write_sample) {
    outputs.write("--write-sample", format_mesh(to_polygons(sample_part()), *options.write_sample, {}));
    if (options.meshes.words.empty() && !options.json && !options.chart && options.fail_on_wrong.empty() &&
        options.fail_on_defect.empty() && !options.verify) {
      outputs.keep();
      return 0;
    }
  }
  const ThreadLimit limit(options.threads);
  CheckSettings settings;
  settings.verify = options.verify;
  settings.all = options.all;
  Checker checker(settings, !outputs.on_standard_output());
  if (options.meshes.words.empty()) checker.check_sample();
  if (!outputs.on_standard_output())
    for (const std::string& remark : inputs.remarks) say(remark);
  const bool all_good = each_mesh(inputs, options.meshes.reading(), [&](InputMesh input) {
    outputs.require_not_read(input.load.files_beside);
    checker.check(std::move(input));
  });
  checker.say_total();
  const std::vector<MeshCheck>& checks = checker.checks();
  if (options.json) {
    // A file's name may be any bytes; JSON is UTF-8.
    const std::string text = json_report(checks, inputs.passed_over, limit.threads())
                                 .dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    outputs.write("--json", text + "\n");
  }
  if (options.chart) outputs.write("--chart", chart_svg(checks));
  if (!all_good) return 2;
  const bool fails = any_wrong(checks, options.fail_on_wrong) || any_defect(checks, options.fail_on_defect);
  outputs.keep();
  return fails ? 1 : 0;
}

}  // namespace plumb::tool
