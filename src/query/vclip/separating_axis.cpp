#include "plumb/query/vclip/separating_axis.hpp"

#include <algorithm>
#include <string>

#include "arith/exact_number.hpp"
#include "plumb/arith/error.hpp"
#include "query/vclip/checked_signs.hpp"
#include "query/vclip/edge_pairs.hpp"

namespace plumb::query {
namespace vclipping {
namespace {

constexpr std::string_view axis_question = "separating_axis";

void require_volume(std::string_view of, const ClipView& v) {
  require_faces(axis_question, of, v);
  if (turn_of(v) != Sign::zero) return;
  throw InvalidShape(std::string(axis_question)
                         .append(": ")
                         .append(of)
                         .append(".pose is singular and flattens the polyhedron, which has no axes of its own then; "
                                 "ask relate or distance"));
}

std::array<Rational, 3> rational(const Vec<BigDyadic>& v) {
  return {exact_number(v.x), exact_number(v.y), exact_number(v.z)};
}

class AxisSearch {
 public:
  AxisSearch(const Solid& a, const Solid& b, CheckedSigns& sign) : a_(a), b_(b), sign_(sign) {}

  /// `as_given`: neither is under a pose.
  std::optional<SeparatingAxis> run(bool as_given) {
    if (!along_faces(a_, b_, AxisKind::face_of_a) && !along_faces(b_, a_, AxisKind::face_of_b)) across_edges(as_given);
    return found_;
  }

 private:
  /// True where it parts the two, which ends the search.
  bool take(SeparatingAxis axis) {
    const bool apart = axis.relation == Relation::disjoint;
    if (apart || !found_) found_ = std::move(axis);
    return apart;
  }

  bool along_faces(const Solid& of, const Solid& other, AxisKind kind) {
    const auto faces = static_cast<std::uint32_t>(of.mesh().first.size() - 1);
    for (std::uint32_t face = 0; face < faces; ++face) {
      const auto gap = least_height(of, face, other);
      if (gap == Sign::negative) continue;
      SeparatingAxis axis{gap == Sign::zero ? Relation::touching : Relation::disjoint, kind, {}, {}, {}};
      (kind == AxisKind::face_of_a ? axis.a : axis.b) = face;
      const Vec<BigDyadic> n = of.normal<BigDyadic>(face), none{BigDyadic(0.0), BigDyadic(0.0), BigDyadic(0.0)};
      axis.direction = rational(kind == AxisKind::face_of_a ? n : none - n);
      if (take(std::move(axis))) return true;
    }
    return false;
  }
  /// The last vertex that was below a face is likely below the next one.
  [[nodiscard]] Sign least_height(const Solid& of, std::uint32_t face, const Solid& other) {
    const auto height = [&](std::uint32_t v) {
      return sign_([&]<class T>() { return of.height(face, other.core().at<T>(v)); });
    };
    const auto size = static_cast<std::uint32_t>(other.core().size());
    if (below_ < size && height(below_) == Sign::negative) return Sign::negative;
    Sign least = Sign::positive;
    for (std::uint32_t v = 0; v < size && least != Sign::negative; ++v) {
      least = std::min(least, height(v));
      if (least == Sign::negative) below_ = v;
    }
    return least;
  }

  void across_edges(bool as_given) {
    const std::vector<SolidEdge> edges_a = edges_of(a_), edges_b = edges_of(b_);
    const auto take = [&](std::size_t i, std::size_t j) { return across(edges_a[i], edges_b[j]); };
    if (as_given) {
      sign_.check();
      FloatWorld<SpanningPairs> w;
      SpanningPairs{}(w, a_, edges_a, b_, edges_b, take);
      if (w.certain()) return;
    }
    each_spanning_pair(a_, edges_a, b_, edges_b, take);
  }

  template <class T>
  [[nodiscard]] Vec<T> axis(std::uint32_t p, std::uint32_t q) const {
    return cross(a_.place<T>(a_.next(p)) - a_.place<T>(p), b_.place<T>(b_.next(q)) - b_.place<T>(q));
  }
  bool across(const SolidEdge& on_a, const SolidEdge& on_b) {
    const std::uint32_t p = on_a.corner, q = on_b.corner;
    const Sign gap = sign_([&]<class T>() { return dot(axis<T>(p, q), b_.place<T>(q) - a_.place<T>(p)); });
    if (gap == Sign::zero && found_) return false;
    // The solid has to lie on this side of its edge along the axis, and not in one plane with both faces there: that is
    // a face's normal, or no direction.
    const auto lies = [&](const Solid& s, const SolidEdge& edge, Sign way) {
      const auto side = [&](std::uint32_t from, std::uint32_t off) {
        return sign_([&]<class T>() { return dot(axis<T>(p, q), s.place<T>(off) - s.place<T>(from)); });
      };
      const Sign left = side(edge.corner, edge.off);
      if (left == -way) return false;
      const Sign right = side(edge.twin, edge.off_twin);
      return right != -way && (left == way || right == way);
    };
    for (const Sign way : {Sign::positive, Sign::negative}) {
      if (gap == -way) continue;
      if (!lies(a_, on_a, -way) || !lies(b_, on_b, way)) continue;
      const Vec<BigDyadic> n = axis<BigDyadic>(p, q), none{BigDyadic(0.0), BigDyadic(0.0), BigDyadic(0.0)};
      return take({gap == Sign::zero ? Relation::touching : Relation::disjoint, AxisKind::edges, p, q,
                   rational(way == Sign::positive ? n : none - n)});
    }
    return false;
  }

  const Solid &a_, &b_;
  CheckedSigns& sign_;
  std::uint32_t below_ = 0;
  std::optional<SeparatingAxis> found_;
};

}  // namespace
}  // namespace vclipping

std::optional<SeparatingAxis> separating_axis_of(const ClipView& a, const ClipView& b) {
  using namespace vclipping;
  CheckedSigns sign(axis_question, a, b);
  if (!a.pose.stands() || !b.pose.stands()) sign.check();
  require_volume("a", a), require_volume("b", b);
  auto core_a = CoreCorners::of(vclipping::body_view(a)), core_b = CoreCorners::of(vclipping::body_view(b));
  bring_to_one_weight(*core_a, *core_b);
  const Solid solid_a(*a.polyhedron, *core_a, turn_of(a) == Sign::negative),
      solid_b(*b.polyhedron, *core_b, turn_of(b) == Sign::negative);
  return AxisSearch(solid_a, solid_b, sign).run(a.pose.stands() && b.pose.stands());
}

}  // namespace plumb::query
