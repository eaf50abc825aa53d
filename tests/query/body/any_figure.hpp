// A figure of any kind: what tests of all pairs draw, map and rename, without its type.
//
// Laws: it draws what figure<Shape> and near_figure<Shape> draw of the same material, and maps and renames as
// mapped<Shape> and renamed<Shape> do.
// Cost: a call by pointer.  What is compiled for a kind is compiled in any_figure.cpp, once for all tests, where a
// lambda for each of some 390 pairs would be compiled in every test.
#pragma once

#include <memory>

#include "query/body/pair_moves.hpp"
#include "query/body/pair_types.hpp"

namespace plumb::pair_cases {

/// Of one type; what is returned is new, and dropped by `drop`.
struct FigureRow {
  FigureKind kind;
  int dimension;
  const void* (*figure)(Material&);
  const void* (*near_figure)(Material&);
  const void* (*degenerate)(Material&);
  const void* (*renamed)(Material&, const void*);
  const void* (*mapped)(const void*, Map&);
  const void* (*spoiled)(Material&, const void*);
  std::string (*numbers)(const void*);
  void (*drop)(const void*);
};

class AnyFigure {
 public:
  AnyFigure(const FigureRow& row, const void* shape) : row_(&row), shape_(shape, row.drop) {}

  [[nodiscard]] const FigureRow& row() const { return *row_; }
  [[nodiscard]] const void* shape() const { return shape_.get(); }
  [[nodiscard]] query::FigureView view() const { return {row_->kind, row_->dimension, shape_.get()}; }
  [[nodiscard]] std::string numbers() const { return row_->numbers(shape_.get()); }

 private:
  const FigureRow* row_;
  std::unique_ptr<const void, void (*)(const void*)> shape_;
};

inline AnyFigure figure(const FigureRow& row, Material& m) { return {row, row.figure(m)}; }
inline AnyFigure near_figure(const FigureRow& row, Material& m) { return {row, row.near_figure(m)}; }
/// One of query/body/degenerate_forms.hpp.
inline AnyFigure degenerate(const FigureRow& row, Material& m) { return {row, row.degenerate(m)}; }
inline AnyFigure renamed(Material& m, const AnyFigure& s) { return {s.row(), s.row().renamed(m, s.shape())}; }
inline AnyFigure mapped(const AnyFigure& s, Map& map) { return {s.row(), s.row().mapped(s.shape(), map)}; }
/// One of its numbers is no longer real.
inline AnyFigure spoiled(Material& m, const AnyFigure& s) { return {s.row(), s.row().spoiled(m, s.shape())}; }

/// The row of a figure that the table knows.
const FigureRow& figure_row(FigureKind kind, int dimension);

/// What f says of a figure that is one of these, told its type: instantiated once a kind.
template <class R, class First, class... Others, class F>
R on_kind(Types<First, Others...>, const AnyFigure& s, const F& f) {
  if constexpr (sizeof...(Others) > 0) {
    if (s.row().kind != figure_kind<First> || s.row().dimension != figure_dimension<First>)
      return on_kind<R>(Types<Others...>{}, s, f);
  }
  return f(*static_cast<const First*>(s.shape()));
}

}  // namespace plumb::pair_cases
