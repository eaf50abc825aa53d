// Which questions has each pair of the table, and how are they asked without types?  The public functions, each called
// by its name for the two types.
//
// Laws: pairs in the order of on_pairs; what a pair does not answer is nullptr.
// Cost: a call by pointer; the functions are instantiated in pair_questions.cpp, once for all tests.
#pragma once

#include <span>
#include <vector>

#include "plumb/query/closest/closest.hpp"
#include "query/body/any_figure.hpp"

namespace plumb::pair_cases {

/// Of figures of two types in this order.
struct PairQuestions {
  Relation (*relate)(const void*, const void*);
  bool (*intersects)(const void*, const void*);
  double (*distance)(const void*, const void*);
  ExactDistance (*exact_distance)(const void*, const void*);
  Closest (*closest_points)(const void*, const void*);  // of figures of the plane in the plane z = 0; the first pair
  Closest (*any_closest_points)(const void*, const void*);  // without an option: of those that meet any common point
};

struct PairRow {
  const FigureRow *a, *b;
  PairQuestions forth, back;  // of a and b, of b and a
  bool is_posed;              // relate takes them under poses
  bool is_separated;          // closest_points tells one pair by the law of query/separation/separation.hpp

  [[nodiscard]] int dimension() const { return a->dimension; }
  [[nodiscard]] std::string name() const {
    return std::string(name_of(a->kind)) + " and " + std::string(name_of(b->kind));
  }
};

const std::vector<PairRow>& pairs_of(Plane);
const std::vector<PairRow>& pairs_of(Space);

struct AnyPair {
  AnyFigure a, b;
};
/// As pair_of<A, B> draws them.
inline AnyPair pair_of(const PairRow& row, Material& m) {
  if (row.a->kind == FigureKind::point) {  // near to what is there
    AnyFigure b = figure(*row.b, m);
    AnyFigure a = figure(*row.a, m);
    return {std::move(a), std::move(b)};
  }
  AnyFigure a = figure(*row.a, m);
  AnyFigure b = near_figure(*row.b, m);
  return {std::move(a), std::move(b)};
}

/// The line that replays a failure.
inline std::string about(const Material& m, const AnyFigure& a, const AnyFigure& b) {
  return m.about() + a.numbers() + b.numbers();
}

inline Relation relate(const PairRow& row, const AnyFigure& a, const AnyFigure& b) {
  return row.forth.relate(a.shape(), b.shape());
}
inline Relation relate_back(const PairRow& row, const AnyFigure& b, const AnyFigure& a) {
  return row.back.relate(b.shape(), a.shape());
}
inline bool intersects(const PairRow& row, const AnyFigure& a, const AnyFigure& b) {
  return row.forth.intersects(a.shape(), b.shape());
}
inline bool intersects_back(const PairRow& row, const AnyFigure& b, const AnyFigure& a) {
  return row.back.intersects(b.shape(), a.shape());
}

}  // namespace plumb::pair_cases
