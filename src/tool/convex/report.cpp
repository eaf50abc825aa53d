#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plumb/query/certificate/certificate_text.hpp"
#include "tool/convex/command.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

std::string numbers_text(const std::vector<std::uint32_t>& numbers) {
  std::string text;
  for (const std::uint32_t n : numbers) text += fmt::format("{}{}", text.empty() ? "" : " ", n);
  return text;
}

std::string hull_line(const HullOfMesh& h, const Style& style) {
  const std::string line = mesh_line(h.asked, style);
  if (!h.why) return line + "; convex\n";
  return line +
         fmt::format("; hull of {}, not convex itself: {}\n", plural(h.corners.size(), "vertex", "vertices"), *h.why);
}

std::string verdict_line(const ConvexReport& r) {
  if (r.proof.claim == Claim::disjoint) {
    const double distance = r.nearest.closest.distance;
    return distance > 0 ? fmt::format("disjoint, {} apart", distance) : "disjoint, and the distance rounds to 0";
  }
  if (r.proof.claim == Claim::touching) return "touching";
  return fmt::format("overlapping, {} deep", r.penetration->depth);
}

std::string proof_line(const ConvexReport& r) {
  if (r.proof.direction) {
    const auto& [x, y, z] = *r.proof.direction;
    return fmt::format("proved by a direction: {} {} {}", x.text(), y.text(), z.text());
  }
  return fmt::format("proved by {} of vertices around the origin of their differences",
                     plural(r.proof.pairs.size(), "pair", "pairs"));
}

}  // namespace

std::vector<std::uint32_t> nearest_corners(const ConvexReport& report, std::size_t which) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < report.nearest.simplex.size; ++i)
    numbers.push_back(report.hulls[which].hull.vertices[report.nearest.simplex.corners[i][which]]);
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

std::string convex_text(const ConvexReport& r, const Style& style) {
  std::string text;
  for (const HullOfMesh& h : r.hulls) text += hull_line(h, style);
  const bool apart = r.proof.claim == Claim::disjoint;
  text += (apart ? style.green(verdict_line(r)) : style.red(verdict_line(r))) + "\n";
  if (apart) {
    text += style.dim("  nearest point, and the vertices that it lies between\n");
    for (const std::size_t which : {0U, 1U}) {
      const auto& [x, y, z] = which == 0 ? r.nearest.closest.on_a : r.nearest.closest.on_b;
      text += fmt::format("{} {} {} {}: {}\n", "ab"[which], x, y, z, numbers_text(nearest_corners(r, which)));
    }
  } else if (r.proof.claim == Claim::overlapping) {
    const auto& [x, y, z] = r.penetration->translation;
    if (r.is_parted) {
      text += "a plane has one on each side as they are, for all of both lies in it\n";
      return text + proof_line(r) + "\n";
    }
    text += fmt::format("they no more than touch once a is moved by {} {} {}{}\n", x, y, z,
                        r.penetration->is_unique ? "" : ", which is one of several ways");
  }
  return text + proof_line(r) + "\n";
}

nlohmann::json convex_json(const ConvexReport& r) {
  using nlohmann::json;
  const auto triple = [](const auto& p) { return json{p.x, p.y, p.z}; };
  json said = origin_json("plumb convex"), hulls = json::array(), nearest = json::array(), steps = json::array();
  for (const HullOfMesh& h : r.hulls) {
    json hull = mesh_json(h.asked);
    hull["vertex_numbers"] = h.hull.vertices;
    hull["dimension"] = h.hull.dimension;
    hull["is_convex"] = !h.why;
    if (h.why) hull["flaw"] = *h.why;
    hulls.push_back(std::move(hull));
  }
  for (const std::size_t which : {0U, 1U}) {
    nearest.push_back({{"point", triple(which == 0 ? r.nearest.closest.on_a : r.nearest.closest.on_b)},
                       {"vertex_numbers", nearest_corners(r, which)}});
  }
  for (const GjkStep& step : r.steps) {
    json pairs = json::array();
    for (std::uint32_t i = 0; i < step.simplex.size; ++i) {
      const auto& [a, b] = step.simplex.corners[i];
      pairs.push_back({r.hulls[0].hull.vertices[a], r.hulls[1].hull.vertices[b]});
    }
    steps.push_back({{"vertex_numbers", std::move(pairs)}, {"square", step.square}});
  }
  said.update({{"hulls", std::move(hulls)},
               {"relation", name_of(r.proof.claim)},
               {"distance", r.nearest.closest.distance},
               {"nearest", std::move(nearest)},
               {"penetration", nullptr},
               {"steps", std::move(steps)},
               {"certificate", json::parse(convex_certificate(r))}});
  if (r.penetration) {
    said["penetration"] = {{"depth", r.penetration->depth},
                           {"direction", triple(r.penetration->direction)},
                           {"translation", triple(r.penetration->translation)},
                           {"unique", r.penetration->is_unique}};
  }
  return said;
}

std::string convex_certificate(const ConvexReport& r) {
  return with_bodies(r, [&](const auto& a, const auto& b) { return certificate_text(r.proof, a, b) + "\n"; });
}

}  // namespace plumb::tool
