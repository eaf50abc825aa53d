#include "query/penetration/basis.hpp"

namespace plumb::query::parting {
namespace {

template <class T>
T part(const Vec<T>& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// Is the point outside of the affine hull of these?
bool leads_out(const Difference& d, const std::vector<Ends>& of, const Ends& e) {
  const auto from_first = [&]<class T>(const Ends& to) { return d.at<T>(to) - d.at<T>(of[0]); };
  if (of.size() == 3) {
    return sign_of([&]<class T>() -> T {
             return dot(cross(from_first.template operator()<T>(of[1]), from_first.template operator()<T>(of[2])),
                        from_first.template operator()<T>(e));
           }) != Sign::zero;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Sign s = sign_of([&]<class T>() -> T {
      const Vec<T> way = from_first.template operator()<T>(e);
      return part(of.size() == 1 ? way : cross(from_first.template operator()<T>(of[1]), way), axis);
    });
    if (s != Sign::zero) return true;
  }
  return false;
}

}  // namespace

std::vector<Ends> affine_basis_among(const Difference& d, std::span<const Ends> named) {
  std::vector<Ends> of;
  for (const Ends& e : named) {
    if (of.size() < 4 && (of.empty() || leads_out(d, of, e))) of.push_back(e);
  }
  return of;
}

std::vector<Ends> affine_basis(const Difference& d, std::span<const Ends> named) {
  std::vector<Ends> of = affine_basis_among(d, named);
  if (of.empty()) of.push_back({0, 0});
  // Every difference is the first one, a way between corners of one body, and one between corners of the other.
  const Ends first = of[0];
  const auto take = [&](const Ends& e) {
    if (leads_out(d, of, e)) of.push_back(e);
  };
  for (std::uint32_t i = 0; i < d.a.size() && of.size() < 4; ++i) take({i, first[1]});
  for (std::uint32_t j = 0; j < d.b.size() && of.size() < 4; ++j) take({first[0], j});
  return of;
}

}  // namespace plumb::query::parting
