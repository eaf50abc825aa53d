#include "query/body/pair_questions.hpp"

#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/separation/separation.hpp"

namespace plumb::pair_cases {
namespace {

template <class A, class B>
Relation relate_of(const void* a, const void* b) {
  return relate(*static_cast<const A*>(a), *static_cast<const B*>(b));
}
template <class A, class B>
bool intersects_of(const void* a, const void* b) {
  return intersects(*static_cast<const A*>(a), *static_cast<const B*>(b));
}
template <class A, class B>
double distance_of(const void* a, const void* b) {
  return distance(*static_cast<const A*>(a), *static_cast<const B*>(b));
}
template <class A, class B>
ExactDistance exact_distance_of(const void* a, const void* b) {
  return exact_distance(*static_cast<const A*>(a), *static_cast<const B*>(b));
}
Closest in_space(const Closest& c) { return c; }
Closest in_space(const Closest2& c) {
  return {{c.on_a.x, c.on_a.y, 0}, {c.on_b.x, c.on_b.y, 0}, c.distance, c.feature_a, c.feature_b};
}
template <class A, class B>
Closest closest_points_of(const void* a, const void* b) {
  const auto& p = *static_cast<const A*>(a);
  const auto& q = *static_cast<const B*>(b);
  if constexpr (requires { closest_points(p, q, WhichPair::first); }) {
    return in_space(closest_points(p, q, WhichPair::first));
  } else {
    return in_space(closest_points(p, q));
  }
}
template <class A, class B>
Closest any_closest_points_of(const void* a, const void* b) {
  return in_space(closest_points(*static_cast<const A*>(a), *static_cast<const B*>(b)));
}

template <class A, class B>
consteval PairQuestions questions() {
  PairQuestions q{&relate_of<A, B>, &intersects_of<A, B>, nullptr, nullptr, nullptr, nullptr};
  if constexpr (HasDistance<A, B>) {
    q.distance = &distance_of<A, B>;
    q.exact_distance = &exact_distance_of<A, B>;
    q.closest_points = &closest_points_of<A, B>;
    q.any_closest_points = &any_closest_points_of<A, B>;
  }
  return q;
}

struct Functions {
  FigureKind a, b;
  PairQuestions forth, back;
  bool is_posed, is_separated;
};
template <class A, class B>
consteval Functions functions() {
  if constexpr (RelatedPair<A, B> && !OtherWayRound<A, B>) {
    using By = std::conditional_t<figure_dimension<A> == 2, Pose2, Pose>;
    return {figure_kind<A>,
            figure_kind<B>,
            questions<A, B>(),
            questions<B, A>(),
            query::PosedPair<Posed<A, By>, B>,
            query::SeparatedPair<A, B> || query::SeparatedPair<B, A>};
  } else {
    return {figure_kind<A>, figure_kind<B>, {}, {}, false, false};
  }
}

template <class A, class... Bs>
constexpr std::array<Functions, sizeof...(Bs)> functions_of_first{functions<A, Bs>()...};

template <class... Shapes>
std::vector<PairRow> rows_of(Types<Shapes...>, int dimension) {
  std::vector<PairRow> rows;
  for (const std::span<const Functions> first :
       {std::span<const Functions>(functions_of_first<Shapes, Shapes...>)...}) {
    for (const Functions& f : first) {
      if (f.forth.relate != nullptr)
        rows.push_back(
            {&figure_row(f.a, dimension), &figure_row(f.b, dimension), f.forth, f.back, f.is_posed, f.is_separated});
    }
  }
  return rows;
}

}  // namespace

const std::vector<PairRow>& pairs_of(Plane all) {
  static const std::vector<PairRow> rows = rows_of(all, 2);
  return rows;
}
const std::vector<PairRow>& pairs_of(Space all) {
  static const std::vector<PairRow> rows = rows_of(all, 3);
  return rows;
}

}  // namespace plumb::pair_cases
