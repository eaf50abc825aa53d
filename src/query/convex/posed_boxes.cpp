#include "query/convex/posed_boxes.hpp"

#include <algorithm>
#include <array>

#include "arith/running_error.hpp"
#include "arith/sparse_vec.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/short_dyadic.hpp"
#include "plumb/certify/determinant_sign.hpp"
#include "query/body/parting_axes.hpp"
#include "query/body/upright_box.hpp"
#include "query/body/weighted_pose.hpp"

namespace plumb::query {
namespace {

using arith::sparse_cross, arith::sparse_dot, arith::sparse_product, arith::sparse_sum, arith::sparse_difference;

/// A box as it is given: axes, lengths as differences of two numbers, and twice its middle as their sum.
struct NamedBox {
  std::array<Vector3, 3> axes;
  std::array<std::array<double, 2>, 3> length;
  std::array<std::array<double, 2>, 3> middle;
  bool is_upright;  // its axes are those of space
};
std::optional<NamedBox> named_box(const FigureView& v) {
  if (v.dimension != 3) return {};
  if (v.kind == FigureKind::aabb) {
    const auto& [low, high] = *static_cast<const Aabb3*>(v.shape);
    return NamedBox{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                    {{{high.x, -low.x}, {high.y, -low.y}, {high.z, -low.z}}},
                    {{{low.x, high.x}, {low.y, high.y}, {low.z, high.z}}},
                    true};
  }
  if (v.kind == FigureKind::obb) {
    const Obb3& b = *static_cast<const Obb3*>(v.shape);
    const Point3& c = b.center;
    return NamedBox{b.axes,
                    {{{b.half.x, b.half.x}, {b.half.y, b.half.y}, {b.half.z, b.half.z}}},
                    {{{c.x, c.x}, {c.y, c.y}, {c.z, c.z}}},
                    b.axes == identity_pose.columns};
  }
  return {};
}

/// Both boxes, all of it times both weights: their axes and lengths along them, and twice the way between their middles.
template <class T>
struct TwoBoxes {
  std::array<std::array<Vec3<T>, 3>, 2> axes;
  std::array<std::array<T, 3>, 2> length;
  Vec3<T> way;
};

template <class T>
T sum_of_two(const std::array<double, 2>& two) {
  return sparse_sum(T(two[0]), T(two[1]));
}
template <class T>
Vec3<T> sum_of_two(const std::array<std::array<double, 2>, 3>& two) {
  return {sum_of_two<T>(two[0]), sum_of_two<T>(two[1]), sum_of_two<T>(two[2])};
}
template <class T>
Vec3<T> turned_under(const WeightedPose<T>& pose, const Vec3<T>& v) {
  const auto& [x, y, z] = pose.columns;
  return sparse_sum(sparse_sum(sparse_scaled(x, v.x), sparse_scaled(y, v.y)), sparse_scaled(z, v.z));
}

template <class T>
T without_sign(const T& x) {
  if constexpr (std::is_same_v<T, Running>) {
    return magnitude(x);
  } else if constexpr (std::is_same_v<T, BigDyadic>) {
    return x.sign() == Sign::negative ? BigDyadic(0.0) - x : x;
  } else {
    return x.sign() == Unsure{Sign::negative} ? -x : x;
  }
}
/// How far boxes of axes of space that are turned alike are apart along one of their own axes, twice; they see one another
/// as they would unturned, by the way between them turned back.
template <class T>
struct OwnGap {
  T gap, reach;
  explicit OwnGap(const std::array<NamedBox, 2>& box, const RigidPose& a, const RigidPose& b, const TurnMatrix& turn,
                  std::size_t k)
      : gap(0.0), reach(0.0) {
    const Vec3<T> way = sparse_difference(arith::vec<T>(b.translation), arith::vec<T>(a.translation));
    const T weight(turn.weight), along = sparse_dot(arith::vec<T>(turn.columns[k]), way);
    const T middles = sparse_difference(sum_of_two<T>(box[1].middle[k]), sum_of_two<T>(box[0].middle[k]));
    reach = sparse_sum(sum_of_two<T>(box[0].length[k]), sum_of_two<T>(box[1].length[k]));
    if (turn.weight != 1) reach = sparse_product(reach, weight);
    const T apart = sparse_sum(turn.weight == 1 ? middles : sparse_product(middles, weight), sparse_sum(along, along));
    gap = sparse_difference(without_sign(apart), reach);
  }
};

/// Space sees them so.
template <class T>
TwoBoxes<T> as_space_sees(const std::array<NamedBox, 2>& box, const std::array<AnyPoseView, 2>& by) {
  const std::array pose{weighted_pose<T>(by[0]), weighted_pose<T>(by[1])};
  TwoBoxes<T> two;
  std::array<Vec3<T>, 2> middle;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto with_other_weight = [&](const T& x) {
      return pose[1 - i].has_weight ? sparse_product(x, pose[1 - i].weight) : x;
    };
    const Vec3<T> given = sum_of_two<T>(box[i].middle);
    Vec3<T>& m = middle[i];
    m = pose[i].stands ? given : turned_under(pose[i], given);
    if (!pose[i].stands) m = sparse_sum(m, sparse_sum(pose[i].translation, pose[i].translation));
    m = {with_other_weight(m.x), with_other_weight(m.y), with_other_weight(m.z)};
    for (std::size_t k = 0; k < 3; ++k) {
      // The image of an axis of space is a column.
      two.axes[i][k] = pose[i].stands      ? arith::vec<T>(box[i].axes[k])
                       : box[i].is_upright ? pose[i].columns[k]
                                           : turned_under(pose[i], arith::vec<T>(box[i].axes[k]));
      two.length[i][k] = with_other_weight(sum_of_two<T>(box[i].length[k]));
    }
  }
  two.way = sparse_difference(middle[1], middle[0]);
  return two;
}

/// A pair of the six axes, 0 to 2 of the first box and 3 to 5 of the second, whose cross product the boxes are seen along.
struct AxisPair {
  std::size_t first, second;
};

template <class T>
const Vec3<T>& box_axis(const TwoBoxes<T>& two, std::size_t k) {
  return two.axes[k / 3][k % 3];
}
template <class T>
Vec3<T> across_axes(const TwoBoxes<T>& two, const AxisPair& of) {
  return sparse_cross(box_axis(two, of.first), box_axis(two, of.second));
}
/// How far they are apart along n, twice.
template <class T>
T gap_along(const TwoBoxes<T>& two, const Vec3<T>& n, const AxisPair& of) {
  T reach(0.0);
  for (std::size_t k = 0; k < 6; ++k) {
    if (k == of.first || k == of.second) continue;  // at right angles to n
    const T along = without_sign(sparse_dot(n, box_axis(two, k)));
    reach = sparse_sum(reach, sparse_product(along, two.length[k / 3][k % 3]));
  }
  return sparse_difference(without_sign(sparse_dot(n, two.way)), reach);
}

template <class T>
bool is_zero_vector(const Vec3<T>& v) {
  return certainly_zero(v.x) && certainly_zero(v.y) && certainly_zero(v.z);
}
bool is_above_zero(const Running& size) { return certain_sign(size) > 0; }

/// Finite, with an inside, for certain.
bool are_solid_boxes(const TwoBoxes<Running>& two) {
  Running sum = magnitude(two.way.x) + magnitude(two.way.y) + magnitude(two.way.z);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_above_zero(two.length[i][k])) return false;
      const Vec3<Running>& axis = two.axes[i][k];
      sum = sum + two.length[i][k] + magnitude(axis.x) + magnitude(axis.y) + magnitude(axis.z);
    }
    const auto& [u, v, w] = two.axes[i];
    if (!is_above_zero(magnitude(sparse_dot(sparse_cross(u, v), w)))) return false;
  }
  return sum.upper() - sum.upper() == 0;
}

/// Tells the box where its axes in space are doubles.
std::optional<PosedBox> box_in_space(const NamedBox& box, const RigidPose& by) {
  const auto turn = exact_matrix(by.turn);
  if (!turn) return {};
  const bool stands = turn->columns == identity_pose.columns;
  if (!box.is_upright && !stands) return {};
  PosedBox b{};
  b.columns = turn->columns, b.weight = turn->weight, b.at = by.translation;
  b.axes = box.is_upright ? turn->columns : box.axes;
  for (std::size_t k = 0; k < 3; ++k) {
    b.length[k] = {-box.length[k][0], box.length[k][1]}, b.local[k] = {-box.middle[k][0], box.middle[k][1]};
  }
  return b;
}

/// Nothing of other poses.
const RigidPose* rigid_pose(const AnyPoseView& by) {
  static constexpr RigidPose none{};
  if (by.stands()) return &none;
  const auto* pose = std::get_if<const RigidPose*>(&by.by);
  return pose != nullptr ? *pose : nullptr;
}

Relation relate_upright(const UprightBox& a, const UprightBox& b) {
  Relation r = Relation::overlapping;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto above = b.low[k].against(a.high[k]), below = a.low[k].against(b.high[k]);
    if (above > 0 || below > 0) return Relation::disjoint;
    if (above == 0 || below == 0) r = Relation::touching;
  }
  return r;
}

/// Touching where they are level along an axis of their own and nowhere apart.
std::optional<Relation> relate_turned_alike(const std::array<NamedBox, 2>& box, const RigidPose& a,
                                            const RigidPose& b) {
  const auto turn = exact_matrix(a.turn);
  if (!turn) return {};
  Relation r = Relation::overlapping;
  for (std::size_t k = 0; k < 3; ++k) {
    const OwnGap<Running> near(box, a, b, *turn, k);
    const auto is_above_zero = [&](std::size_t i) { return certain_sign(sum_of_two<Running>(box[i].length[k])) > 0; };
    const double size = near.reach.upper() + near.gap.upper();
    if (size - size != 0 || !is_above_zero(0) || !is_above_zero(1)) return {};
    int gap = certain_sign(near.gap);
    if (gap == 0) {
      const Unsure<Sign> fine = OwnGap<ShortDyadic>(box, a, b, *turn, k).gap.sign();
      gap = static_cast<int>(fine.certain() ? fine.value() : OwnGap<BigDyadic>(box, a, b, *turn, k).gap.sign());
      if (gap == 0) r = std::min(r, Relation::touching);
    }
    if (gap > 0) r = Relation::disjoint;
  }
  return r;
}

std::optional<std::array<PosedBox, 2>> boxes_in_space(const std::array<NamedBox, 2>& box, const RigidPose& p,
                                                      const RigidPose& q) {
  const auto a = box_in_space(box[0], p);
  if (!a) return {};
  const auto b = box_in_space(box[1], q);
  if (!b) return {};
  return std::array{*a, *b};
}
/// Nothing where a gap is about zero.
std::optional<Relation> relate_in_doubles(const std::array<PosedBox, 2>& box) {
  FloatWorld<PartingAxes> world;
  const auto r = PartingAxes{}(world, box[0], box[1], PartingAxes::parallel(box[0], box[1]));
  return world.certain() ? r : std::nullopt;
}

class BoxPair {
 public:
  /// `in_space`: where all axes are doubles.
  BoxPair(const std::array<NamedBox, 2>& box, const PosedView& a, const PosedView& b,
          const std::optional<std::array<PosedBox, 2>>& in_space)
      : box_(box), by_{a.pose, b.pose}, in_space_(in_space) {}

  std::optional<Relation> relation() {
    if (!are_solid_boxes(near_)) return {};
    for (std::size_t k = 0; k < 6; ++k) {
      const std::size_t first = k / 3 * 3;
      if (is_apart({first + (k + 1) % 3, first + (k + 2) % 3})) return Relation::disjoint;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 3; j < 6; ++j) {
        if (is_apart({i, j})) return Relation::disjoint;
      }
    }
    return level_ ? Relation::touching : Relation::overlapping;
  }

 private:
  /// Notes where they are level.
  bool is_apart(const AxisPair& of) {
    const Vec3<Running> n = across_axes(near_, of);
    const int quick = certain_sign(gap_along(near_, n, of));
    if (quick != 0) return quick > 0;
    if (is_zero_vector(n) || (level_ && is_along_level(of, n))) return false;
    const Sign gap = exact_gap(of);
    if (gap == Sign::zero) level_.emplace(Level{of, n});
    return gap == Sign::positive;
  }
  /// Says so where it is known, and where the two axes are one.
  bool is_along_level(const AxisPair& of, const Vec3<Running>& n) const {
    if (!in_space_) return is_zero_vector(sparse_cross(n, level_->normal));
    const auto row = [&](std::size_t k) {
      const Vector3& v = (*in_space_)[k / 3].axes[k % 3];
      return std::array{v.x, v.y, v.z};
    };
    const auto leads = [&](std::size_t k) {
      return determinant_sign({row(level_->of.first), row(level_->of.second), row(k)}) != Sign::zero;
    };
    return !leads(of.first) && !leads(of.second);
  }
  /// Negative also where the two axes are one.
  Sign exact_gap(const AxisPair& of) {
    if (!short_) short_.emplace(as_space_sees<ShortDyadic>(box_, by_));
    const Vec3<ShortDyadic> n = across_axes(*short_, of);
    const Unsure<Sign> s = gap_along(*short_, n, of).sign();
    const bool is_lost = n.x.is_lost() || n.y.is_lost() || n.z.is_lost();
    if (!is_lost && s.certain()) return s.value() == Sign::zero && is_zero_vector(n) ? Sign::negative : s.value();
    const auto two = as_space_sees<BigDyadic>(box_, by_);
    const Vec3<BigDyadic> exact = across_axes(two, of);
    return is_zero_vector(exact) ? Sign::negative : gap_along(two, exact, of).sign();
  }

  const std::array<NamedBox, 2>& box_;
  std::array<AnyPoseView, 2> by_;
  const std::optional<std::array<PosedBox, 2>>& in_space_;
  TwoBoxes<Running> near_ = as_space_sees<Running>(box_, by_);
  std::optional<TwoBoxes<ShortDyadic>> short_;
  struct Level {
    AxisPair of;
    Vec3<Running> normal;
  };
  std::optional<Level> level_;
};

}  // namespace

std::optional<Relation> relate_posed_boxes(const PosedView& a, const PosedView& b) {
  if (const auto p = upright_box(a)) {
    if (const auto q = upright_box(b)) return relate_upright(*p, *q);
  }
  const auto first = named_box(a.figure);
  if (!first) return {};
  const auto second = named_box(b.figure);
  if (!second) return {};
  const std::array box{*first, *second};
  const RigidPose *p = rigid_pose(a.pose), *q = rigid_pose(b.pose);
  if (p != nullptr && q != nullptr && p->turn == q->turn && box[0].is_upright && box[1].is_upright) {
    if (const auto r = relate_turned_alike(box, *p, *q)) return r;
  }
  std::optional<std::array<PosedBox, 2>> in_space;
  if (p != nullptr && q != nullptr) in_space = boxes_in_space(box, *p, *q);
  if (in_space) {
    if (const auto r = relate_in_doubles(*in_space)) return r;
  }
  return BoxPair(box, a, b, in_space).relation();
}

}  // namespace plumb::query
