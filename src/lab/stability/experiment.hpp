// Where do methods fail, and what does the user see of it?  An experiment: scenes, each tried by the float ways and the
// exact one, whose failures are counted in the user's terms ("hulls that lost an extreme point") and pictured.
//
// Laws: (1) every number is counted, none is typed in; (2) every loop that may not end is bounded, and counted when it
// ran into its bound; (3) the exact method fails nothing, anywhere; (4) same settings, same findings, bit for bit.
// Source: RTCD 11.2, 11.3.
// Cost: all experiments in seconds when quick, in minutes in full.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "lab/trial/terms.hpp"
#include "plumb/arith/rigid_pose.hpp"

namespace plumb::lab::stability {

/// How often a method failed in one way, out of how many trials in which it could have.
struct Count {
  std::string failure;  // plural, as a column's head: "hulls that lost an extreme point"
  std::uint64_t failures = 0, of = 0;
};

/// Methods are named as in src/lab/trial: float32, double, absolute, relative, long-double, exact ...
struct MethodOutcome {
  std::string method;
  std::vector<Count> counts;  // of all methods of a scene the same failures, in the same order
  bool exact = false;         // one of ours: any failure is a bug, and the laboratory exits with 1
};

/// A whole SVG with the classes of chart_style (src/tool/drawing/chart.hpp), so that it suits light and dark pages.
struct Picture {
  std::string name;  // of the file, without folder and extension, unique: "orient2d-grid"
  std::string caption, svg;
};

struct Findings {
  std::vector<MethodOutcome> outcomes;
  std::vector<Picture> pictures;
};

/// A part of an experiment with a table of its own; running it is one step of the progress bar.
struct Scene {
  std::string name, about;
  std::function<Findings()> run;
};

struct Settings {
  std::uint64_t seed = 2026;
  bool quick = false;
  std::optional<std::string> ccd, models;  // folders of real queries and meshes, which are tried as well where given
};

/// `scenes` reads the folders that settings name, so that a bad file is told of at once, and leaves all other work to
/// the scenes' `run`.
struct Experiment {
  std::string name, question, source;
  std::function<std::vector<Scene>(const Settings&)> scenes;
};

/// The hull of eight corners under a rigid pose.
struct WorldBody {
  std::array<Point3, 8> corners;
  std::optional<Vector3> half;  // of a box about the origin, whose corners these are
  RigidPose pose;
};
using BodyPairs = std::set<std::array<std::uint32_t, 2>>;  // by their numbers, the lower one first

/// A library's collision world: all bodies are handed over at once; which of them meet, as it says.
struct WorldRival {
  std::string name;
  std::function<BodyPairs(std::span<const WorldBody> bodies)> ask;
};

Experiment grid_experiment();
Experiment hull_experiment();
Experiment space_hull_experiment();
Experiment segment_experiment();
Experiment sweep_experiment();
Experiment location_experiment();
Experiment leak_experiment();
Experiment box_experiment();
Experiment convex_experiment();
Experiment move_experiment();
Experiment pose_experiment();
Experiment distance_experiment();
Experiment ball_experiment();
Experiment motion_experiment();
Experiment touch_experiment();
Experiment neighbor_experiment();
Experiment walk_experiment();
Experiment triangulation_experiment();
Experiment welding_experiment();
Experiment boolean_experiment();
Experiment world_experiment(std::vector<WorldRival> rivals = {});

/// In the order of the report.  The worlds of other libraries are asked as well; plumb-lab has none.
inline std::vector<Experiment> all_experiments(const std::vector<WorldRival>& worlds = {}) {
  return {grid_experiment(),       hull_experiment(),          space_hull_experiment(), segment_experiment(),
          sweep_experiment(),      location_experiment(),      leak_experiment(),       box_experiment(),
          convex_experiment(),     move_experiment(),          pose_experiment(),       distance_experiment(),
          ball_experiment(),       motion_experiment(),        touch_experiment(),      neighbor_experiment(),
          walk_experiment(),       triangulation_experiment(), welding_experiment(),    boolean_experiment(),
          world_experiment(worlds)};
}

}  // namespace plumb::lab::stability
