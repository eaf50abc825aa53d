#include "query/body/posed_input.hpp"

#include "figure/basic/finite_parts.hpp"
#include "query/body/figure_input.hpp"

namespace plumb::query {
namespace {

std::string part_name(std::string_view name, std::string_view part) { return std::string(name).append(part); }

}  // namespace

void require_posed(std::string_view function, std::string_view name, const PosedView& figure) {
  if (figure.in_space == nullptr && figure.in_plane == nullptr) return require_figure(function, name, figure.figure);
  require_figure(function, part_name(name, ".shape"), figure.figure);
  const std::string c0 = part_name(name, ".pose.columns[0]"), c1 = part_name(name, ".pose.columns[1]"),
                    c2 = part_name(name, ".pose.columns[2]"), t = part_name(name, ".pose.translation");
  if (figure.in_space != nullptr) {
    const auto& [c, by] = *figure.in_space;
    require_finite_parts(function, {c0, c1, c2, t}, c[0], c[1], c[2], by);
  } else {
    const auto& [c, by] = *figure.in_plane;
    require_finite_parts(function, {c0, c1, t}, c[0], c[1], by);
  }
}

void require_posed(std::string_view function, const PosedView& a, const PosedView& b) {
  const bool alike = a.figure.kind == b.figure.kind;
  require_posed(function, alike ? "a" : spoken(a.figure), a);
  require_posed(function, alike ? "b" : spoken(b.figure), b);
}

}  // namespace plumb::query
