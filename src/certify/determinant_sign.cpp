#include "plumb/certify/determinant_sign.hpp"

#include "plumb/certify/sign_of.hpp"

namespace plumb {
namespace {

template <Formula F, std::size_t N>
Sign of_rows(const Rows<N>& rows) {
  return std::apply([](const auto&... row) { return sign_of(F{}, row...); }, rows);
}

}  // namespace

Sign determinant_sign(const Rows<2>& rows) { return of_rows<predicates::Determinant2>(rows); }
Sign determinant_sign(const Rows<3>& rows) { return of_rows<predicates::Determinant3>(rows); }
Sign determinant_sign(const Rows<4>& rows) { return of_rows<predicates::Determinant4>(rows); }
Sign determinant_sign(const Rows<5>& rows) { return of_rows<predicates::Determinant5>(rows); }

}  // namespace plumb
