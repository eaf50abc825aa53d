#include "halfspace_clip.hpp"

#include <algorithm>
#include <vector>

#include "axis_body.hpp"
#include "running_error.hpp"

namespace plumb::query {
namespace {

using namespace axes;

constexpr std::size_t most_corners = 24;

struct Side {
  Vector3 normal;
  double offset;
};

std::vector<Side> sides_of(const FlatView& v) {
  std::vector<Side> sides;
  with_shape(v, [&](const auto& s) {
    if constexpr (requires { s.halfspaces; }) {
      for (const auto& h : s.halfspaces) sides.push_back({in_space(h.normal), h.offset});
    } else if constexpr (requires { s.directions; }) {
      for (std::size_t i = 0; i < s.min.size(); ++i) {
        const Vector3 d = in_space(s.directions.all()[i]);
        sides.push_back({d, s.max[i]});
        sides.push_back({{-d.x, -d.y, -d.z}, -s.min[i]});
      }
    }
  });
  return sides;
}

/// How far each point is beyond a side, and what moving along the edge that goes on adds.
struct Beyond {
  std::array<Running, 8> of_point;
  Running along;
};

bool is_negative(const Running& x) { return x.upper() < 0; }
bool is_positive(const Running& x) { return x.lower() > 0; }

/// Weights of the points.
using Mix = std::array<double, 8>;

double beyond(const Beyond& side, const Mix& mix, std::size_t points) {
  double sum = 0;
  for (std::size_t i = 0; i < points; ++i) sum += mix[i] * side.of_point[i].value;
  return sum;
}

/// What is left of the corners; cut thin where they become too many.
std::vector<Mix> cut(const std::vector<Mix>& corners, const Beyond& side, std::size_t points) {
  std::vector<double> at;
  for (const Mix& m : corners) at.push_back(beyond(side, m, points));
  if (std::ranges::all_of(at, [](double x) { return x <= 0; })) return corners;
  std::vector<Mix> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (at[i] <= 0) kept.push_back(corners[i]);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < corners.size() && kept.size() < most_corners; ++j) {
      if (!(at[i] > 0 && at[j] < 0)) continue;
      const double t = at[i] / (at[i] - at[j]);
      Mix between{};
      for (std::size_t k = 0; k < points; ++k) between[k] = corners[i][k] + t * (corners[j][k] - corners[i][k]);
      kept.push_back(between);
    }
  }
  return kept;
}

bool has_common_mix(const std::vector<Beyond>& sides, std::size_t points) {
  std::vector<Mix> corners(points, Mix{});
  for (std::size_t i = 0; i < points; ++i) corners[i][i] = 1;
  for (const Beyond& side : sides) {
    corners = cut(corners, side, points);
    if (corners.empty()) return false;
  }
  constexpr double of_all = 0x1p-10;  // so that no weight is zero
  Mix middle{};
  for (std::size_t k = 0; k < points; ++k) {
    for (const Mix& m : corners) middle[k] += m[k];
    middle[k] = middle[k] / static_cast<double>(corners.size()) + of_all;
    if (!(middle[k] > 0)) return false;
  }
  return std::ranges::all_of(sides, [&](const Beyond& side) {
    Running sum(0.0);
    for (std::size_t k = 0; k < points; ++k) sum = sum + Running(middle[k]) * side.of_point[k];
    return is_negative(sum);
  });
}

/// Of a line or ray: how far along it a point is strictly within all.
bool has_common_place(const std::vector<Beyond>& sides, bool is_ray) {
  double from = is_ray ? 0 : -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
  for (const Beyond& side : sides) {
    const double at = side.of_point[0].value, along = side.along.value;
    if (along > 0) to = std::min(to, -at / along);
    if (along < 0) from = std::max(from, -at / along);
  }
  const bool starts = from > -std::numeric_limits<double>::infinity(),
             ends = to < std::numeric_limits<double>::infinity();
  const double t = starts && ends ? from + (to - from) / 2
                   : starts       ? from + (magnitude_of(from) + 1)
                   : ends         ? to - (magnitude_of(to) + 1)
                                  : 1;
  if (!(t - t == 0) || (is_ray && !(t > 0))) return false;
  return std::ranges::all_of(
      sides, [&](const Beyond& side) { return is_negative(side.of_point[0] + Running(t) * side.along); });
}

std::optional<Relation> relate_body(const std::vector<Side>& all, const AxisBody<Running>& body) {
  const bool goes_on = body.edge_count > 0 && body.ends[0] != EdgeEnd::none;
  if (goes_on && body.edge_count > 1) return {};
  std::vector<Beyond> sides;
  for (const Side& side : all) {
    const core::Vec<Running> n = core::vec<Running>(side.normal);
    Beyond b;
    bool apart = true;
    for (std::size_t i = 0; i < body.point_count; ++i) {
      b.of_point[i] = core::dot(n, body.points[i]) - Running(side.offset);
      apart = apart && is_positive(b.of_point[i]);
    }
    if (goes_on) {
      b.along = core::dot(n, body.edges[0]);
      apart = apart && body.ends[0] == EdgeEnd::one && is_positive(b.along);
    }
    if (apart) return Relation::disjoint;
    sides.push_back(b);
  }
  const bool proved =
      goes_on ? has_common_place(sides, body.ends[0] == EdgeEnd::one) : has_common_mix(sides, body.point_count);
  return proved ? std::optional(Relation::overlapping) : std::nullopt;
}

}  // namespace

std::optional<Relation> relate_by_clipping(const FlatView& halfspaces, const FlatView& other) {
  return with_shape(other, [&](const auto& s) -> std::optional<Relation> {
    if constexpr (has_body<std::remove_cvref_t<decltype(s)>>) {
      return relate_body(sides_of(halfspaces), axis_body_of<Running>(s, {0, 0, 0}));
    } else {
      return {};
    }
  });
}

}  // namespace plumb::query
