#include <cstddef>
#include <utility>

#include "query/time_of_impact/quick_search.hpp"

namespace plumb::query::quick {
namespace {

using T = Approximate;
enum class FacetKind : unsigned char { none, face_of_a, face_of_b, edges };

/// What bounds the differences of points of b and of a along a normal: features of both.
struct Facet {
  FacetKind kind = FacetKind::none;
  std::size_t a = 0, b = 0;
};

/// The window of time that directions leave, and what plain doubles prove about it.
class Window {
 public:
  /// Differences reach from low to high along a direction, and the motion goes by `speed`.  False: they never meet.
  template <class W, class L, class H, class S>
  [[gnu::always_inline]] inline bool narrow(const W& w, L low, H high, S speed, Facet facet) {
    if (speed.value < 0) {
      const L turned = negated(low);
      low = negated(high), high = turned, speed = negated(speed);
    }
    if (!w.certain()) within_ = false;
    if (w.positive(low) && w.positive(low - speed)) return !w.certain();
    if (w.negative(high) && w.negative(high - speed)) return !w.certain();
    within_ = within_ && w.negative(low) && w.positive(high);
    if (!w.positive(speed) || !w.certain()) return true;
    const double enters = low.value / speed.value, leaves = high.value / speed.value;  // guesses
    if (enters > from_) from_ = enters, entered_ = {w, low, speed}, first_ = facet;
    if (leaves < to_) to_ = leaves, left_ = {w, high, speed};
    if (!(from_ > to_)) return true;
    return (entered_.at() * left_.speed() - left_.at() * entered_.speed()).sign() != Unsure{Sign::positive};
  }
  [[nodiscard]] const Facet& first() const { return first_; }
  [[nodiscard]] bool open() const { return from_ <= to_; }
  /// The differences reach surely beyond the origin along all directions, which is so of solid ones only.
  [[nodiscard]] bool within() const { return within_; }

 private:
  /// Numbers, and how far off they were before they were rounded last.
  struct End {
    double where, fast, doubt_where = 0, doubt_fast = 0;

    End(double of_where, double of_fast) : where(of_where), fast(of_fast) {}
    template <class W, class A, class S>
    End(const W& w, const A& of_where, const S& of_fast)
        : where(of_where.value),
          fast(of_fast.value),
          doubt_where(w.template doubt<A::track>()),
          doubt_fast(w.template doubt<S::track>()) {}
    [[nodiscard]] Running at() const { return Running::rounded(where, doubt_where); }
    [[nodiscard]] Running speed() const { return Running::rounded(fast, doubt_fast); }
  };
  double from_ = 0, to_ = 1;
  bool within_ = true;
  Facet first_;
  End entered_{0, 1}, left_{1, 1};
};

template <class Hull>
constexpr unsigned mask_of_face(std::size_t i) {
  const auto [u, v] = Hull::of_face(i);
  return Hull::is_triangle ? 7U : 1U << u | 1U << v;
}
template <class Hull>
auto normal_of_face(const Hull& hull, std::size_t i) {
  const auto [u, v] = Hull::of_face(i);
  return cross(hull.way(u), hull.way(v));
}

/// Asks every direction that can bound the differences; false where they never meet.
template <class A, class B>
bool narrowed(const MotionSearch<A, B>& s, Window& window) {
  using HullA = typename MotionSearch<A, B>::HullA;
  using HullB = typename MotionSearch<A, B>::HullB;
  const auto motion = known_motion(s);
  const auto ask = [&](const Vec3<double>& x, const Vec3<double>& y, const Facet& facet) {
    MotionWorld<> w;
    w.template number<0>(s.size), w.template number<1>(largest_of(x)), w.template number<2>(largest_of(y));
    const auto n = outer(known<1>(x), known<2>(y));
    const auto [low, high] = reaches_along(n, motion);
    return window.narrow(w, low, high, inner(n, motion.by), facet);
  };
  for (std::size_t i = 0; i < HullA::face_count; ++i) {
    const auto [u, v] = HullA::of_face(i);
    if (!ask(s.a.way(u), s.a.way(v), {FacetKind::face_of_a, i, 0})) return false;
  }
  for (std::size_t i = 0; i < HullB::face_count; ++i) {
    const auto [u, v] = HullB::of_face(i);
    if (!ask(s.b.way(u), s.b.way(v), {FacetKind::face_of_b, 0, i})) return false;
  }
  for (std::size_t i = 0; i < HullA::way_count; ++i) {
    for (std::size_t j = 0; j < HullB::way_count; ++j) {
      if (!ask(s.a.way(i), s.b.way(j), {FacetKind::edges, i, j})) return false;
    }
  }
  return true;
}

/// A piece of the plane that the motion crosses: corner + x t + y u, t and u from 0 to 1, of a triangle t + u <= 1.
template <class N>
struct FacetPiece {
  Vec3<N> corner, x, y;
};

/// The features of a facet of the differences.
struct FacetEnds {
  unsigned a = 0, b = 0;  // vertices
  bool sure = true;       // the only ones that far
};

template <class N, class A, class B>
FacetPiece<N> piece_of(const A& a, const B& b, const Facet& facet, const FacetEnds& ends) {
  const Vec3<N> apart = between<N>(a.place, b.place);
  const auto corner = [&](unsigned of_a, unsigned of_b) { return apart + b.at(of_b) - a.at(of_a); };
  const Vec3<N> none{N(0.0), N(0.0), N(0.0)};
  if (facet.kind == FacetKind::edges) {
    return {corner(A::upper(ends.a, facet.a), ends.b), a.whole_way(facet.a), b.whole_way(facet.b)};
  }
  if (facet.kind == FacetKind::face_of_a) {
    const auto [u, v] = A::of_face(facet.a);
    if constexpr (A::is_triangle) return {corner(1, ends.b), a.way(0), none - a.way(1)};
    return {corner(A::upper(A::upper(ends.a, u), v), ends.b), a.whole_way(u), a.whole_way(v)};
  }
  const auto [u, v] = B::of_face(facet.b);
  if constexpr (B::is_triangle) return {corner(ends.a, 1), none - b.way(0), b.way(1)};
  return {corner(ends.a, ends.b), b.whole_way(u), b.whole_way(v)};
}

template <class N>
struct FacetCrossing {
  N gap, speed;
};
template <class N>
FacetCrossing<N> crossing(const FacetPiece<N>& p, const Vec3<N>& velocity) {
  const Vec3<N> n = cross(p.x, p.y);
  return {dot(p.corner, n), dot(velocity, n)};
}

/// Does the motion surely cross the piece, surely not, or who knows?
MotionVerdict crosses(const FacetPiece<T>& p, const Vec3<T>& velocity, bool triangle) {
  const auto [gap, speed] = crossing(p, velocity);
  const int side = certain_sign(speed), ahead = certain_sign(gap);
  if (ahead != 0 && certain_sign(gap - speed) == ahead) return MotionVerdict::no;
  if (side == 0) return MotionVerdict::unsure;
  const T x = dot(p.corner, cross(velocity, p.y)), y = dot(p.corner, cross(p.x, velocity));
  bool inside = true;
  const auto ask = [&](const T& value) {
    const int s = certain_sign(value) * side;
    inside &= s > 0;
    return s >= 0;
  };
  const bool may = ask(gap) && ask(speed - gap) && ask(x) && ask(y) &&
                   (triangle ? ask((speed - x) - y) : ask(speed - x) && ask(speed - y));
  return !may ? MotionVerdict::no : inside ? MotionVerdict::yes : MotionVerdict::unsure;
}

/// Over another number type, the same question.
template <class N, class A, class B>
FacetCrossing<N> precisely(const Translating<A>& a, const Translating<B>& b, const Facet& facet,
                           const FacetEnds& ends) {
  return crossing(piece_of<N>(hull_of<N>(a.shape), hull_of<N>(b.shape), facet, ends), velocity<N>(a.by, b.by));
}

FacetEnds ends_of(const auto& pair, const Facet& facet, const Vec3<T>& n) {
  using A = decltype(pair.a);
  using B = decltype(pair.b);
  const bool edges = facet.kind == FacetKind::edges;
  const unsigned of_a = edges ? 1U << facet.a : facet.kind == FacetKind::face_of_a ? mask_of_face<A>(facet.a) : 0;
  const unsigned of_b = edges ? 1U << facet.b : facet.kind == FacetKind::face_of_b ? mask_of_face<B>(facet.b) : 0;
  const auto [end_a, sure_a] = pair.a.farthest(n, of_a);
  const auto [end_b, sure_b] = pair.b.farthest({opposite(n.x), opposite(n.y), opposite(n.z)}, of_b);
  return {end_a, end_b, sure_a && sure_b};
}

template <class A, class B>
std::pair<Feature, Feature> features(const Facet& facet, const FacetEnds& ends) {
  switch (facet.kind) {
    case FacetKind::edges:
      return {A::edge(facet.a, ends.a), B::edge(facet.b, ends.b)};
    case FacetKind::face_of_a:
      return {A::face(facet.a, ends.a), B::vertex(ends.b)};
    default:
      return {A::vertex(ends.a), B::face(facet.b, ends.b)};
  }
}

template <ContactWanted asked, class A, class B>
Answer along_facet(const Translating<A>& a, const Translating<B>& b, const auto& pair, const Facet& facet) {
  using HullA = decltype(pair.a);
  using HullB = decltype(pair.b);
  Vec3<T> n = facet.kind == FacetKind::edges       ? cross(pair.a.way(facet.a), pair.b.way(facet.b))
              : facet.kind == FacetKind::face_of_a ? normal_of_face(pair.a, facet.a)
                                                   : normal_of_face(pair.b, facet.b);
  if (dot(n, pair.by).value < 0) n = {opposite(n.x), opposite(n.y), opposite(n.z)};
  const FacetEnds ends = ends_of(pair, facet, n);
  const bool triangle = (facet.kind == FacetKind::face_of_a && HullA::is_triangle) ||
                        (facet.kind == FacetKind::face_of_b && HullB::is_triangle);
  const MotionVerdict told = crosses(piece_of<T>(pair.a, pair.b, facet, ends), pair.by, triangle);
  constexpr bool flat = HullA::dimension + HullB::dimension == 2;
  if (told != MotionVerdict::yes) return {flat ? told : MotionVerdict::unsure};
  if constexpr (asked == ContactWanted::whether) return {told};
  if (!ends.sure) return unsure;
  const std::pair<Feature, Feature> meeting = features<HullA, HullB>(facet, ends);
  const auto time = [&]<class N>(N) {
    const FacetCrossing<N> c = precisely<N>(a, b, facet, ends);
    return at(quotient(c.gap, c.speed), meeting.first, meeting.second);
  };
  const Answer answer = time(Pairs(0.0));
  return answer.told == MotionVerdict::yes ? answer : time(Ball(0.0));
}

}  // namespace

template <ContactWanted asked, Flat A, Flat B>
requires(rank_of<A> <= rank_of<B> && !(std::same_as<A, Aabb3> && std::same_as<B, Aabb3>)) Answer
    contact(const Translating<A>& a, const Translating<B>& b) {
  using Pair = Moved<T, A, B>;
  constexpr std::size_t dimension = Pair::HullA::dimension + Pair::HullB::dimension;
  if constexpr (dimension == 0) {
    const Pair pair(a, b);
    const Vec3<T> n = cross(pair.by, pair.apart);
    return certain_sign(n.x) != 0 || certain_sign(n.y) != 0 || certain_sign(n.z) != 0 ? no : unsure;
  } else if constexpr (dimension == 1) {
    const Pair pair(a, b);
    return {certain_sign(dot(cross(pair.by, pair.b.way(0)), pair.apart)) != 0 ? MotionVerdict::no
                                                                              : MotionVerdict::unsure};
  } else if constexpr (dimension == 2) {
    return along_facet<asked>(a, b, Pair(a, b), {rank_of<A> == 0 ? FacetKind::face_of_b : FacetKind::edges, 0, 0});
  } else {
    MotionSearch<A, B> search(a, b);
    // Most that never meet are far from it.
    constexpr int sweeps = 2;
    for (int i = 0; i < sweeps; ++i) {
      if (search.apart_along()) return no;
      search.sweep(true);
    }
    Window window;
    if (!narrowed(search, window)) return no;
    if (window.within()) return overlap;
    if (!window.open()) return unsure;
    if (window.first().kind == FacetKind::none) return {MotionVerdict::starts};
    return along_facet<asked>(a, b, Pair(a, b), window.first());
  }
}
PLUMB_QUICK_PAIR(Point3, Point3)
PLUMB_QUICK_PAIR(Point3, Segment3)
PLUMB_QUICK_PAIR(Point3, Triangle3)
PLUMB_QUICK_PAIR(Point3, Aabb3)
PLUMB_QUICK_PAIR(Point3, Obb3)
PLUMB_QUICK_PAIR(Segment3, Segment3)
PLUMB_QUICK_PAIR(Segment3, Triangle3)
PLUMB_QUICK_PAIR(Segment3, Aabb3)
PLUMB_QUICK_PAIR(Segment3, Obb3)
PLUMB_QUICK_PAIR(Triangle3, Triangle3)
PLUMB_QUICK_PAIR(Triangle3, Aabb3)
PLUMB_QUICK_PAIR(Triangle3, Obb3)
PLUMB_QUICK_PAIR(Aabb3, Obb3)
PLUMB_QUICK_PAIR(Obb3, Obb3)

}  // namespace plumb::query::quick
