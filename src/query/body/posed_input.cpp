#include "query/body/posed_input.hpp"

#include "figure/basic/finite_parts.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/weighted_pose.hpp"

namespace plumb::query {
namespace {

std::string part_name(std::string_view name, std::string_view part) { return std::string(name).append(part); }

void require_pose(std::string_view, const std::string&, std::monostate) {}

template <class Matrix>
requires requires(const Matrix& by) { by.columns; }
void require_pose(std::string_view function, const std::string& name, const Matrix* pose) {
  const std::string c0 = name + ".columns[0]", c1 = name + ".columns[1]", c2 = name + ".columns[2]",
                    t = name + ".translation";
  const auto& c = pose->columns;
  if constexpr (std::tuple_size_v<decltype(pose->columns)> == 3) {
    require_finite_parts(function, {c0, c1, c2, t}, c[0], c[1], c[2], pose->translation);
  } else {
    require_finite_parts(function, {c0, c1, t}, c[0], c[1], pose->translation);
  }
}

void require_turn(std::string_view function, const std::string& name, const Rotation& q, bool is_flat) {
  constexpr std::array parts{".w", ".x", ".y", ".z"};
  const std::array numbers{q.w, q.x, q.y, q.z};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string part = name + parts[i];
    require_finite_parts(function, {part}, numbers[i]);
  }
  if (q.w != 0 || q.x != 0 || q.y != 0 || q.z != 0) return;
  throw InvalidShape(std::string(function).append(": ").append(name).append(
      is_flat ? " is zero, which is no turn; give Rotation2{1, 0} for none"
              : " is zero, which is no turn; give Rotation{1, 0, 0, 0} for none"));
}

/// Nothing is named where there is nothing to say: a sum is a real number where all its parts are.
bool is_real_turn(const RigidPose& p) {
  const auto& [w, x, y, z] = p.turn;
  const Vector3& t = p.translation;
  return is_real(w + x + y + z + t.x + t.y + t.z) && (w != 0 || x != 0 || y != 0 || z != 0);
}

template <class Rigid>
requires requires(const Rigid& by) { by.turn; }
void require_pose(std::string_view function, const std::string& name, const Rigid* pose) {
  const std::string t = name + ".translation";
  require_turn(function, name + ".turn", rotation_of(pose->turn), std::is_same_v<Rigid, RigidPose2>);
  require_finite_parts(function, {t}, pose->translation);
}

template <class Chain>
requires requires(const Chain& by) { by.links; }
void require_pose(std::string_view function, const std::string& name, const Chain* pose) {
  for (std::size_t i = 0; i < pose->links.size(); ++i)
    require_pose(function, name + ".links[" + std::to_string(i) + "]", &pose->links[i]);
}

}  // namespace

void require_posed(std::string_view function, std::string_view name, const PosedView& figure) {
  if (figure.pose.stands()) return require_figure(function, name, figure.figure);
  require_figure(function, part_name(name, ".shape"), figure.figure);
  const auto* rigid = std::get_if<const RigidPose*>(&figure.pose.by);
  if (rigid != nullptr && is_real_turn(**rigid)) return;
  std::visit([&](const auto& by) { require_pose(function, part_name(name, ".pose"), by); }, figure.pose.by);
}

void require_posed(std::string_view function, const PosedView& a, const PosedView& b) {
  const bool alike = a.figure.kind == b.figure.kind;
  require_posed(function, alike ? "a" : spoken(a.figure), a);
  require_posed(function, alike ? "b" : spoken(b.figure), b);
}

}  // namespace plumb::query
