// What does an experiment find, quickly?  And does what holds for all hold for it: of ours nothing fails, whatever can
// fail was tried, by every method the same, and pictures are whole.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "lab/stability/experiment.hpp"

namespace plumb::lab::stability {

struct Found {
  std::map<std::string, std::map<std::string, std::vector<Count>>> scenes;  // what each method failed at, by scene
  std::map<std::string, std::uint64_t> failures;                            // over all scenes: "double: rays that ..."
  std::set<std::string> pictures;

  /// How often the method failed at question number `count` of the scene.
  [[nodiscard]] std::uint64_t in(const std::string& scene, const std::string& method, std::size_t count) const {
    return scenes.at(scene).at(method).at(count).failures;
  }
};

inline void expect_like(const std::vector<Count>& counts, const std::vector<Count>& first, const std::string& where) {
  ASSERT_EQ(counts.size(), first.size()) << where;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    EXPECT_EQ(counts[i].failure, first[i].failure) << where;
    EXPECT_LE(counts[i].failures, counts[i].of) << where << counts[i].failure;
  }
}

inline Found found_by(const Experiment& experiment, std::uint64_t start = 2026) {
  Found found;
  for (const Scene& scene : experiment.scenes({.seed = start, .quick = true, .ccd = {}, .models = {}})) {
    const std::string here = experiment.name + ", " + scene.name + ", start " + std::to_string(start) + ", ";
    EXPECT_FALSE(found.scenes.contains(scene.name)) << here;
    const Findings findings = scene.run();
    std::uint64_t tried = 0;
    for (const MethodOutcome& o : findings.outcomes) {
      expect_like(o.counts, findings.outcomes[0].counts, here + o.method + ": ");
      found.scenes[scene.name][o.method] = o.counts;
      for (const Count& c : o.counts) {
        found.failures[o.method + ": " + c.failure] += c.failures;
        if (!o.exact) continue;
        EXPECT_EQ(c.failures, 0U) << here << o.method << ": " << c.failure;
        tried += c.of;
      }
    }
    EXPECT_GE(tried, 15U) << here;
    for (const Picture& p : findings.pictures) {
      EXPECT_TRUE(found.pictures.insert(p.name).second) << p.name;
      EXPECT_TRUE(p.svg.starts_with("<svg ") && p.svg.ends_with("</svg>\n")) << p.name;
      EXPECT_EQ(p.svg.find("nan"), std::string::npos) << p.name;
      EXPECT_NE(p.caption, "");
    }
  }
  return found;
}

}  // namespace plumb::lab::stability
