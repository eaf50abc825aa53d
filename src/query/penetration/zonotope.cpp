#include "query/penetration/zonotope.hpp"

namespace plumb::query::parting {

using arith::sparse_cross, arith::sparse_dot;

Zonotope::Zonotope(const EdgeSum& sum) : sum_(sum) {
  const SumParts<Approximate> parts = settled(sum.parts<Approximate>());
  const auto n = static_cast<std::uint32_t>(sum.groups());
  const auto& g = parts.group;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = i + 1; j < n; ++j) {
      const Vec<Approximate> normal = sparse_cross(g[i], g[j]);
      normal_[normals_++] = {{i, j},    running(normal),
                             Running(), running(sparse_dot(normal, parts.middle)),
                             Running(), running(sparse_dot(normal, normal))};
      for (std::uint32_t k = j + 1; k < n; ++k) {
        determinant_[1U << i | 1U << j | 1U << k] = running(sparse_dot(normal, g[k]));
      }
    }
  }
  for (std::uint32_t i = 0; i < normals_; ++i) {
    OfNormal& of = normal_[i];
    const std::uint32_t both = 1U << of.of[0] | 1U << of.of[1];
    for (std::uint32_t k = 0; k < n; ++k) {
      if ((both >> k & 1) == 0) of.reach = of.reach + magnitude(determinant_[both | 1U << k]);
    }
    of.overlap = of.reach - magnitude(of.middle);
    of.square = quotient(of.overlap * magnitude(of.overlap), of.square);
  }
}

bool Zonotope::is_parallel(std::uint32_t i) {
  const auto is_zero = [&](auto part) {
    return sign_of([&]<class T>() -> T { return part(normal<T>(i)); }) == Sign::zero;
  };
  return is_zero([](const auto& v) { return v.x; }) && is_zero([](const auto& v) { return v.y; }) &&
         is_zero([](const auto& v) { return v.z; });
}

bool Zonotope::is_independent(std::uint32_t body) const {
  if (!sum_.has_its_own(body)) return false;
  const Difference& d = sum_.difference();
  const std::size_t edges = (body == 0 ? d.a : d.b).edges();
  std::array<std::uint32_t, 3> of{};
  std::size_t size = 0;
  for (const SumEdge& e : sum_.edges()) {
    if (e.body == body) of[size++] = e.group;
  }
  const auto is_not_zero = [](const Running& x) { return certain_sign(x) != 0; };
  if (edges == 3) return is_not_zero(determinant_[1U << of[0] | 1U << of[1] | 1U << of[2]]);
  const SumParts<Running> parts = sum_.parts<Running>();
  const auto& g = parts.group;
  if (edges < 2) return edges == 0 || is_not_zero(dot(g[of[0]], g[of[0]]));
  const Vec<Running> n = cross(g[of[0]], g[of[1]]);
  return is_not_zero(n.x) || is_not_zero(n.y) || is_not_zero(n.z);
}

}  // namespace plumb::query::parting
