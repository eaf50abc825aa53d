#include "query/penetration/edge_sum.hpp"

namespace plumb::query::parting {
namespace {

std::optional<int> coordinate_axis(const Vector3& v) {
  if ((v.x != 0) + (v.y != 0) + (v.z != 0) != 1) return {};
  return v.x != 0 ? 0 : v.y != 0 ? 1 : 2;
}

/// 1 or -1 of axes that are parallel without arithmetic, else 0.  `axis`: the one of space that v is along.
int alike(const Vector3& u, const Vector3& v, const std::optional<int>& axis) {
  if (!axis) {
    if (u.x == v.x && u.y == v.y && u.z == v.z) return 1;
    return u.x == -v.x && u.y == -v.y && u.z == -v.z ? -1 : 0;
  }
  const double of_u = *axis == 0 ? u.x : *axis == 1 ? u.y : u.z;
  if (of_u == 0 || axis != coordinate_axis(u)) return 0;
  const double x = u.x + u.y + u.z, y = v.x + v.y + v.z;  // but one of them is not zero
  return (x > 0) == (y > 0) ? 1 : -1;
}

bool turns_alike(const AnyPoseView& p, const AnyPoseView& q) {
  if (p.stands() && q.stands()) return true;
  if (p == q) return true;
  return std::visit(
      []<class P, class Q>(const P& of_p, const Q& of_q) {
        if constexpr (!std::is_same_v<P, Q>) {
          return false;
        } else if constexpr (requires { of_p->columns; }) {
          return of_p->columns == of_q->columns;
        } else if constexpr (requires { of_p->turn; }) {
          return of_p->turn == of_q->turn;
        } else {
          return false;
        }
      },
      p.by, q.by);
}

}  // namespace

EdgeSum::EdgeSum(const Difference& d) : of_(d) {
  for (std::uint32_t k = 0; k < d.a.edges(); ++k) add(0, d.a, k);
  for (std::uint32_t k = 0; k < d.b.edges(); ++k) add(1, d.b, k);
}

void EdgeSum::add(std::uint32_t body, const CoreCorners& c, std::uint32_t bit) {
  const auto in_space = c.axis_in_space(bit), along = in_space ? in_space : c.axis_of_edge(bit);
  const AnyPoseView pose = in_space ? AnyPoseView() : c.pose();
  if (along && *along == Vector3{}) return;
  const std::optional<int> axis = along ? coordinate_axis(*along) : std::nullopt;
  for (std::uint32_t g = 0; g < groups_ && along; ++g) {
    if (!along_[g]) continue;
    if (const int way = alike(*along_[g], *along, axis); way != 0 && turns_alike(pose_[g], pose)) {
      edges_[size_++] = {body, bit, g, way < 0};
      return;
    }
  }
  const auto g = static_cast<std::uint32_t>(groups_++);
  along_[g] = along, pose_[g] = pose;
  if (c.stands()) axis_[g] = axis;
  edges_[size_++] = {body, bit, g, false};
}

bool EdgeSum::has_its_own(std::uint32_t body) const {
  std::uint32_t groups = 0;
  std::size_t count = 0;
  for (const SumEdge& e : edges()) {
    if (e.body != body) continue;
    if ((groups >> e.group & 1) != 0) return false;
    groups |= 1U << e.group, ++count;
  }
  return count == (body == 0 ? of_.a : of_.b).edges();
}

}  // namespace plumb::query::parting
