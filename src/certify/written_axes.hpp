// The statements over three axes, written down: what is claimed of their derived bounds (plumb/certify/judged_proofs.hpp).
//
// Laws: those of certify/exact_axes.hpp; a leaf of a scale of each axis has the power of its own.
// Source: docs/proof.md, "What a machine has checked".
// Cost: microseconds an operation.
#pragma once

#include <string>
#include <vector>

#include "certify/exact_axes.hpp"
#include "plumb/certify/judged_proofs.hpp"

namespace plumb::certify::written {

template <int highest, Scales of>
class AxesWorld : public exact_axes::ExactAxes<Number, WorldKind::rationals> {
 public:
  using Given = exact_axes::Axes<double>;
  using Numbers = exact_axes::Axes<Number>;

  template <std::size_t scale = 0>
  Numbers number(const Given& a) {
    return {world_.template number<scale>(a.x, 0), world_.template number<scale>(a.y, 1),
            world_.template number<scale>(a.z, 2)};
  }
  template <std::size_t scale = 0>
  Numbers number(const Vector3& v) {
    return number<scale>(given(v));
  }
  template <std::size_t scale = 0>
  Numbers difference(const Given& b, const Given& a) {
    return {world_.template difference<scale>(b.x, a.x, 0), world_.template difference<scale>(b.y, a.y, 1),
            world_.template difference<scale>(b.z, a.z, 2)};
  }
  template <std::size_t scale = 0>
  Numbers difference_within(const Given& b, const Given& a, const Numbers&, const Numbers&) {
    return {world_.template difference_within<scale>(b.x, a.x, 0),
            world_.template difference_within<scale>(b.y, a.y, 1),
            world_.template difference_within<scale>(b.z, a.z, 2)};
  }
  template <std::size_t over>
  Numbers weight(const Given& a) {
    return {world_.template weight<over>(a.x, 0), world_.template weight<over>(a.y, 1),
            world_.template weight<over>(a.z, 2)};
  }
  [[nodiscard]] const Book& book() const { return world_.book(); }

 private:
  World<highest, of> world_;
};

/// Of what the statement judges on this input, a claim for each bound.
template <class Statement, class... Input>
std::vector<std::string> axes_proofs(std::string_view name, const Statement& statement, const Input&... input) {
  AxesWorld<Statement::highest, Statement::scales> world;
  static_cast<void>(statement(world, input...));
  return world.book().scripts(name);
}

}  // namespace plumb::certify::written
