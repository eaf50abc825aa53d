#include "halfspace_clip.hpp"

#include <algorithm>
#include <vector>

#include "arith/running_error.hpp"
#include "axis_body.hpp"

namespace plumb::query {
namespace {

using namespace axes;

constexpr std::size_t most_corners = 24;
constexpr int most_rounds = 512, proof_rounds = 32;

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

/// Does a combination of the halfspaces, with these weights, leave all points beyond?
bool proves_apart(const std::vector<Beyond>& sides, const std::vector<double>& weights, std::size_t points) {
  for (std::size_t i = 0; i < points; ++i) {
    Running sum(0.0);
    for (std::size_t h = 0; h < sides.size(); ++h) {
      if (weights[h] > 0) sum = sum + Running(weights[h]) * sides[h].of_point[i];
    }
    if (!is_positive(sum)) return false;
  }
  return true;
}

/// The game of one who names halfspaces and one who names points, each the best against all that the other named so
/// far (Brown 1951): what the first named comes near to weights that part the two sets, where there are such.
bool are_apart(const std::vector<Beyond>& sides, std::size_t points) {
  std::vector<double> named(sides.size()), against_points(sides.size());
  std::array<double, 8> against_sides{};
  std::size_t side = 0;
  for (int round = 1; round <= most_rounds; ++round) {
    named[side] += 1;
    std::size_t point = 0;
    for (std::size_t i = 0; i < points; ++i) {
      against_sides[i] += sides[side].of_point[i].value;
      if (against_sides[i] < against_sides[point]) point = i;
    }
    if (round % proof_rounds == 0 && against_sides[point] > 0 && proves_apart(sides, named, points)) return true;
    for (std::size_t h = 0; h < sides.size(); ++h) {
      against_points[h] += sides[h].of_point[point].value;
      if (against_points[h] > against_points[side]) side = h;
    }
  }
  return false;
}

/// Of a line or ray: do two halfspaces leave no place on it?
bool leave_no_place(const Beyond& ahead, const Beyond& behind) {
  return is_positive(ahead.along) && is_negative(behind.along) &&
         is_positive(ahead.along * behind.of_point[0] - behind.along * ahead.of_point[0]);
}

/// Of a line or ray, by the halfspaces that end it ahead and behind: strictly within all, beyond one of the two, or
/// neither for certain.
std::optional<Relation> relate_along(const std::vector<Beyond>& sides, bool is_ray) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double from = is_ray ? 0 : -infinity, to = infinity;
  const Beyond *ahead = nullptr, *behind = nullptr;
  for (const Beyond& side : sides) {
    const double along = side.along.value, place = -side.of_point[0].value / along;
    if (along > 0 && place < to) to = place, ahead = &side;
    if (along < 0 && place > from) from = place, behind = &side;
  }
  if (ahead != nullptr && behind != nullptr && leave_no_place(*ahead, *behind)) return Relation::disjoint;
  const double t = from > -infinity && to < infinity ? from + (to - from) / 2
                   : from > -infinity                ? from + (magnitude_of(from) + 1)
                   : to < infinity                   ? to - (magnitude_of(to) + 1)
                                                     : 1;
  if (!(t - t == 0) || (is_ray && !(t > 0))) return {};
  const bool within = std::ranges::all_of(
      sides, [&](const Beyond& side) { return is_negative(side.of_point[0] + Running(t) * side.along); });
  return within ? std::optional(Relation::overlapping) : std::nullopt;
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
  if (sides.empty()) return Relation::overlapping;
  if (goes_on) return relate_along(sides, body.ends[0] == EdgeEnd::one);
  if (has_common_mix(sides, body.point_count)) return Relation::overlapping;
  if (are_apart(sides, body.point_count)) return Relation::disjoint;
  return {};
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
