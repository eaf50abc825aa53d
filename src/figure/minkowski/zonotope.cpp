#include "figure/minkowski/zonotope.hpp"

#include <algorithm>
#include <vector>

namespace plumb {
namespace {

BigDyadic dot(const BigVector& u, const BigVector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
BigVector cross(const BigVector& u, const BigVector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
bool is_zero(const BigVector& v) {
  return std::ranges::all_of(v, [](const BigDyadic& x) { return x.sign() == Sign::zero; });
}
BigDyadic size(const BigDyadic& x) { return x.sign() == Sign::negative ? BigDyadic(0) - x : x; }

// Against the slab that the zonotope fills along a normal which is not zero.
class Slabs {
 public:
  Slabs(const BigVector& center, std::span<const BigVector> generators) : center_(center), generators_(generators) {}

  void add(const BigVector& normal) {
    BigDyadic gap = size(dot(center_, normal));
    for (const BigVector& g : generators_) gap = gap - size(dot(g, normal));
    outside_ = outside_ || gap.sign() == Sign::positive;
    on_boundary_ = on_boundary_ || gap.sign() == Sign::zero;
  }
  [[nodiscard]] Relation relation() const {
    return outside_ ? Relation::disjoint : on_boundary_ ? Relation::touching : Relation::overlapping;
  }

 private:
  const BigVector& center_;
  std::span<const BigVector> generators_;
  bool outside_ = false, on_boundary_ = false;
};

}  // namespace

Relation locate_origin(const BigVector& center, std::span<const BigVector> generators) {
  std::vector<BigVector> g;
  std::ranges::copy_if(generators, std::back_inserter(g), [](const BigVector& v) { return !is_zero(v); });
  if (g.empty()) return is_zero(center) ? Relation::overlapping : Relation::disjoint;
  Slabs slabs(center, g);
  BigVector normal{};  // of the plane of the generators found so far
  bool full = false;
  for (const BigVector& v : g) {
    if (is_zero(normal)) {
      normal = cross(g.front(), v);
    } else {
      full = full || dot(normal, v).sign() != Sign::zero;
    }
  }
  if (is_zero(normal)) {  // all on one line
    if (!is_zero(cross(g.front(), center))) return Relation::disjoint;
    slabs.add(g.front());
    return slabs.relation();
  }
  if (!full) {  // all in one plane
    if (dot(normal, center).sign() != Sign::zero) return Relation::disjoint;
    for (const BigVector& v : g) slabs.add(cross(normal, v));
    return slabs.relation();
  }
  for (std::size_t i = 0; i < g.size(); ++i) {
    for (std::size_t j = i + 1; j < g.size(); ++j) {
      if (const BigVector n = cross(g[i], g[j]); !is_zero(n)) slabs.add(n);
    }
  }
  return slabs.relation();
}

}  // namespace plumb
