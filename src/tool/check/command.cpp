#include "tool/check/command.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "plumb/certify/thread_limit.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "tool/check/report.hpp"
#include "tool/check/shard.hpp"
#include "tool/mesh/bent_faces.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/mesh/sample_part.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

/// Checks a mesh; of what is found each part is said as soon as it is known, where text is wanted.
class Checker {
 public:
  Checker(const CheckSettings& settings, bool says, bool brief) : settings_(settings), says_(says), brief_(brief) {}

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
  void refuse(UnreadMesh mesh) {
    if (says_ && brief_) say(text_brief(mesh));
    unread_.push_back(std::move(mesh));
  }
  void say_total() const {
    if (!says_ || brief_) return;
    if (!unread_.empty() && !checks_.empty()) say("\n" + text_unread(unread_));
    if (checks_.size() < 2) return;
    say("\n");
    say(text_total(checks_, style_));
  }
  [[nodiscard]] const std::vector<MeshCheck>& checks() const { return checks_; }
  [[nodiscard]] const std::vector<UnreadMesh>& unread() const { return unread_; }

 private:
  void take(const TriangleMesh& mesh, MeshCheck check) {
    check_mesh(mesh, settings_, check, [&](CheckStep step) {
      if (!says_) return;
      if (brief_) {
        if (step == CheckStep::mesh) say(text_brief(check)), flush_output();
        return;
      }
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
  const bool says_, brief_;
  const Style style_{stdout};
  std::vector<MeshCheck> checks_;
  std::vector<UnreadMesh> unread_;
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
  if (options.shard.asked()) return run_check_shard(options);
  if (!options.nearer_than && std::ranges::count(options.fail_on_defect, "close-vertices") != 0)
    throw Error("--fail-on-defect close-vertices needs a length; give it by '--nearer-than LENGTH'");
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
  settings.nearer_than = options.nearer_than;
  settings.decisions =
      !options.brief || options.json || options.chart || !options.fail_on_wrong.empty() || options.verify;
  Checker checker(settings, !outputs.on_standard_output(), options.brief);
  if (options.meshes.words.empty()) checker.check_sample();
  if (!outputs.on_standard_output() && !options.brief)
    for (const std::string& remark : inputs.remarks) say(remark);
  const bool all_good = each_mesh(
      inputs, options.meshes.reading(),
      [&](InputMesh input) {
        outputs.require_not_read(input.load.files_beside);
        checker.check(std::move(input));
      },
      [&](UnreadMesh mesh) { checker.refuse(std::move(mesh)); });
  checker.say_total();
  const std::vector<MeshCheck>& checks = checker.checks();
  if (options.json) {
    // A file's name may be any bytes; JSON is UTF-8.
    const std::string text = json_report(checks, {inputs.passed_over, checker.unread()}, limit.threads())
                                 .dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    outputs.write("--json", text + "\n");
  }
  if (options.chart) outputs.write("--chart", chart_svg(checks));
  const bool fails = any_wrong(checks, options.fail_on_wrong) || any_defect(checks, options.fail_on_defect);
  if (!is_any_named(options.meshes, checker.unread())) outputs.keep();
  if (!all_good) return 2;
  return fails ? 1 : 0;
}

}  // namespace plumb::tool
