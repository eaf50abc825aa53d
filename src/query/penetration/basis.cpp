#include "query/penetration/basis.hpp"

namespace plumb::query::parting {
namespace {

/// Is the point outside of the affine hull of these?
bool leads_out(const Difference& d, const Basis& of, const Ends& e) {
  const auto from_first = [&]<class T>(const Ends& to) { return d.between<T>(of[0], to); };
  if (of.size() == 3) {
    return sign_of([&]<class T>() -> T {
             return dot(cross(from_first.template operator()<T>(of[1]), from_first.template operator()<T>(of[2])),
                        from_first.template operator()<T>(e));
           }) != Sign::zero;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Sign s = sign_of([&]<class T>() -> T {
      const Vec<T> way = from_first.template operator()<T>(e);
      return along_axis(of.size() == 1 ? way : cross(from_first.template operator()<T>(of[1]), way), axis);
    });
    if (s != Sign::zero) return true;
  }
  return false;
}

}  // namespace

void extend(Basis& of, const Difference& d, const Ends& e) {
  if (of.size() < 4 && (of.size() == 0 || leads_out(d, of, e))) of.add(e);
}

Basis affine_basis_among(const Difference& d, std::span<const Ends> named) {
  Basis of;
  for (const Ends& e : named) extend(of, d, e);
  return of;
}

Basis affine_basis(const Difference& d, std::span<const Ends> named) {
  Basis of = affine_basis_among(d, named);
  if (of.size() == 0) of.add({0, 0});
  // Every difference is the first one, a way between corners of one body, and one between corners of the other.
  const Ends first = of[0];
  for (std::uint32_t i = 0; i < d.a.size() && of.size() < 4; ++i) extend(of, d, {i, first[1]});
  for (std::uint32_t j = 0; j < d.b.size() && of.size() < 4; ++j) extend(of, d, {first[0], j});
  return of;
}

}  // namespace plumb::query::parting
