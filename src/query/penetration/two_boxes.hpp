// Two boxes, as they stand or under poses: which of their axes are the groups of their sum of edges, and what do doubles tell along normals of
// two groups?
//
// Laws: what is told is exact; nothing where doubles do not tell it.
// Source: query/penetration/box_axes.hpp.
// Cost: some 50 operations; nothing is searched.
#pragma once

#include "arith/sparse_vec.hpp"
#include "plumb/certify/determinant_sign.hpp"
#include "query/penetration/edge_sum.hpp"
#include "query/penetration/near_axes.hpp"

namespace plumb::query::parting {

/// The axis of space that a normal is along by zeros, and whether it leads up.
struct AlongAxis {
  int axis;
  Sign up;
};
inline std::optional<AlongAxis> axis_of(const Vec<Running>& n) {
  const std::array is_zero{certainly_zero(n.x), certainly_zero(n.y), certainly_zero(n.z)};
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_along = is_zero[(k + 1) % 3] && is_zero[(k + 2) % 3] && !is_zero[k];
    const auto axis = static_cast<int>(k);
    const int up = is_along ? certain_sign(along_axis(n, axis)) : 0;
    if (up != 0) return AlongAxis{axis, static_cast<Sign>(up)};
  }
  return {};
}

/// What is along a normal of two groups, as far as doubles tell.
struct RoughSigns {
  std::optional<Sign> overlap, middle;
  std::array<std::optional<Sign>, 6> along{};
};
/// Tells nothing where the body is no such box.
template <class Box>
std::optional<Box> box_of(const CoreCorners& c) {
  if constexpr (std::same_as<Box, GivenBox>) {
    return c.given_box();
  } else {
    return c.posed_box();
  }
}
/// Two boxes as they stand or under poses, each of whose edges has a length.
template <class Box>
class Boxes {
 public:
  static std::optional<Boxes> of(const EdgeSum& sum) {
    const Difference& d = sum.difference();
    if (sum.edges().size() != 6) return {};
    const auto a = box_of<Box>(d.a);
    if (!a) return {};
    const auto b = box_of<Box>(d.b);
    if (!b) return {};
    Boxes boxes{sum, *a, *b};
    for (std::size_t k = 6; k-- > 0;) {
      const SumEdge& e = sum.edges()[k];
      boxes.first_[e.group] = 3 * e.body + e.bit;
    }
    return boxes;
  }
  [[nodiscard]] const Box& a() const { return a_; }
  [[nodiscard]] const Box& b() const { return b_; }

  /// The pair by the numbers of the fifteen axes' statement.
  [[nodiscard]] NearAxes::Pair pair(const std::array<std::uint32_t, 2>& of) const {
    return {first_[of[0]], first_[of[1]]};
  }
  [[nodiscard]] const Vector3& axis(std::uint32_t k) const { return (k < 3 ? a_ : b_).axes[k % 3]; }
  [[nodiscard]] std::optional<AlongAxis> along_space(const NearAxes::Pair& p) const {
    return axis_of(arith::sparse_cross(arith::vec<Running>(axis(p[0])), arith::vec<Running>(axis(p[1]))));
  }
  [[nodiscard]] RoughSigns rough_signs(const typename NearAxesOf<Box>::Told& told) const {
    const auto known = [](Sign s) { return s == Sign::zero ? std::nullopt : std::optional(s); };
    RoughSigns rough{known(told.overlap), known(told.middle)};
    for (std::uint32_t g = 0; g < sum_.groups(); ++g) rough.along[g] = known(told.along[first_[g]]);
    return rough;
  }
  /// Is a sign of a normal of two groups unknown?
  [[nodiscard]] bool lacks(const RoughSigns& rough, const std::array<std::uint32_t, 2>& of) const {
    bool lacks_any = !rough.overlap || !rough.middle;
    for (std::uint32_t g = 0; g < sum_.groups(); ++g)
      lacks_any = lacks_any || (g != of[0] && g != of[1] && !rough.along[g]);
    return lacks_any;
  }
  /// With what is known of this normal.
  void fill(RoughSigns& rough, const NearAxisSigns& fine) const {
    const auto take = [](std::optional<Sign>& to, Sign s) {
      if (!to && s != Sign::zero) to = s;
    };
    take(rough.overlap, fine.overlap), take(rough.middle, fine.middle);
    for (std::uint32_t g = 0; g < sum_.groups(); ++g) take(rough.along[g], fine.along[first_[g]]);
  }
  /// And with what doubles left open: what leads where is a determinant, and where that and the middle are known how far the
  /// boxes overlap is one as well.
  void settle(RoughSigns& rough, const std::array<std::uint32_t, 2>& of) const {
    const auto row = [](const Vector3& v) { return std::array{v.x, v.y, v.z}; };
    const Vector3 &u = axis(first_[of[0]]), &v = axis(first_[of[1]]);
    for (std::uint32_t g = 0; g < sum_.groups(); ++g) {
      if (g == of[0] || g == of[1] || rough.along[g]) continue;
      rough.along[g] = determinant_sign({row(u), row(v), row(axis(first_[g]))});
    }
    if (!rough.overlap && rough.middle) rough.overlap = exact_overlap(rough, of);
  }
  /// The square of what two edges span, from that of their axes.
  [[nodiscard]] double area(const NearAxes::Pair& p, double of_axes) const {
    const auto length = [&](std::uint32_t k) {
      const GivenBox::Ends& e = (k < 3 ? a_ : b_).length[k % 3];
      const double beside = (k < 3 ? b_ : a_).weight;  // of the pose of the other
      return (e.to - e.from) * (e.to - e.from) * beside * beside;
    };
    return of_axes * length(p[0]) * length(p[1]);
  }

 private:
  Boxes(const EdgeSum& sum, const Box& a, const Box& b) : sum_(sum), a_(a), b_(b) {}

  /// The way from the middle to what is farthest along n, times n; nothing where integers of the stack do not hold it.
  [[nodiscard]] std::optional<Sign> exact_overlap(const RoughSigns& rough,
                                                  const std::array<std::uint32_t, 2>& of) const {
    IntegerWorld w;
    const auto vector = [&](const Vector3& v) { return vec_of(w.number(v.x), w.number(v.y), w.number(v.z)); };
    const auto c = middle_difference(w, a_, b_);
    auto far = *rough.middle == Sign::positive ? Vec<StackDyadic>{negated(c.x), negated(c.y), negated(c.z)} : c;
    for (const SumEdge& e : sum_.edges()) {
      const Sign along = e.group == of[0] || e.group == of[1] ? Sign::zero : *rough.along[e.group];
      if (along == Sign::zero) continue;
      const std::uint32_t k = 3 * e.body + e.bit;
      const auto length = e.body == 0 ? length_beside(w, a_.length[e.bit], b_) : length_beside(w, b_.length[e.bit], a_);
      const auto edge = vector(axis(k)) * length;
      far = (along == Sign::positive) == !e.against ? far + edge : far - edge;
    }
    const auto overlap = arith::dot(arith::cross(vector(axis(first_[of[0]])), vector(axis(first_[of[1]]))), far);
    const Sign s = w.sign(overlap);
    return w.certain() ? std::optional(s) : std::nullopt;
  }

  const EdgeSum& sum_;
  Box a_, b_;
  std::array<std::uint32_t, 6> first_{};
};

}  // namespace plumb::query::parting
