#include "query/overlap/signs.hpp"

#include "certify/long_filter.hpp"

namespace plumb::query {
namespace {

template <Formula F>
Sign beyond_doubles(const Coordinates<F>& p) {
  if (const auto s = integer_sign<F>(p); s.certain()) return s.value();
  if (const int s = long_filter<F>(p); s != 0) return static_cast<Sign>(s);
  return decide_exactly<F>(p).sign;
}

}  // namespace

Sign sign_beyond_doubles(const Coordinates<predicates::Orient2d>& p) { return beyond_doubles<predicates::Orient2d>(p); }
Sign sign_beyond_doubles(const Coordinates<predicates::Orient3d>& p) { return beyond_doubles<predicates::Orient3d>(p); }

}  // namespace plumb::query
