#include "tool/drawing/search_view.hpp"

#include <nlohmann/json.hpp>

namespace plumb::tool {
namespace {

nlohmann::json triple(const Point3& p) { return {p.x, p.y, p.z}; }

}  // namespace

Point3 weighted(std::span<const Point3> corners, const GjkStep& step) {
  Point3 sum{0, 0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double w = step.weight[i];
    sum = {sum.x + w * corners[i].x, sum.y + w * corners[i].y, sum.z + w * corners[i].z};
  }
  return sum;
}

nlohmann::json drawn_steps(std::span<const GjkStep> steps, std::span<const Point3> corners_of_a,
                           std::span<const Point3> corners_of_b) {
  using nlohmann::json;
  json all = json::array();
  for (const GjkStep& step : steps) {
    std::vector<Point3> of_a, of_b, differences;
    json simplex = json::array(), pairs = json::array();
    for (std::uint32_t i = 0; i < step.simplex.size; ++i) {
      const auto& [a, b] = step.simplex.corners[i];
      const Point3 &p = corners_of_a[a], &q = corners_of_b[b];
      of_a.push_back(p), of_b.push_back(q), differences.push_back({p.x - q.x, p.y - q.y, p.z - q.z});
      simplex.push_back(triple(differences.back()));
      pairs.push_back(step.simplex.corners[i]);
    }
    all.push_back({{"simplex", std::move(simplex)},
                   {"pairs", std::move(pairs)},
                   {"nearest", triple(weighted(differences, step))},
                   {"between", {triple(weighted(of_a, step)), triple(weighted(of_b, step))}}});
  }
  return all;
}

}  // namespace plumb::tool
