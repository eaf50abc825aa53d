// A tetrahedron against segments, triangles and tetrahedra: by the normals of faces, and the cross products of edges.
//
// An edge can hold a separating plane only where no corner of the other shape lies inside of both its faces.
// Source: Ganovelli, Ponchio and Rocchini 2002; RTCD 5.2.1.
#include <span>
#include <type_traits>

#include "plumb/certify/direction.hpp"
#include "plumb/predicates/line_triangle.hpp"
#include "query/body/figure_input.hpp"
#include "query/overlap/filters.hpp"
#include "query/overlap/linear3.hpp"
#include "query/overlap/pair_answer.hpp"
#include "query/overlap/signs.hpp"

namespace plumb {
namespace query {
namespace {

using TetrahedronCorners = std::array<Point3, 4>;
using Points = std::span<const Point3>;

TetrahedronCorners corners(const Tetrahedron3& t, Sign turns) {
  return turns == Sign::positive ? TetrahedronCorners{t.a, t.b, t.c, t.d} : TetrahedronCorners{t.a, t.b, t.d, t.c};
}

// With orient3d(corners) positive: is p on the inner side of the face across corner f?
Sign inside(const TetrahedronCorners& t, std::size_t f, const Point3& p) {
  TetrahedronCorners moved = t;
  moved[f] = p;
  return orient3d(moved[0], moved[1], moved[2], moved[3]);
}

// Which corners of the other shape lie strictly inside of each face, as bits; and how far in the other shape reaches.
struct Faces {
  std::array<unsigned, 4> inner{};
  Sign all = Sign::positive;
};
Faces exact_faces(const TetrahedronCorners& t, Points q) {
  Faces found;
  for (std::size_t f = 0; f < 4 && found.all != Sign::negative; ++f) {
    Sign here = Sign::negative;
    for (std::size_t m = 0; m < q.size(); ++m) {
      const Sign s = inside(t, f, q[m]);
      here = most(here, s);
      if (s == Sign::positive) found.inner[f] |= 1u << m;
    }
    found.all = least(found.all, here);
  }
  return found;
}

/// As much as is added up for the face across from the corner that all differences are taken from.
struct FourVolumes {
  static constexpr std::string_view name = "relate";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    const auto v = Volume{}(p);
    return v - v - v - v;
  }
};

// By doubles: each normal once, and of the face across from the first corner by the sum of all four volumes, which is the
// tetrahedron's.  No branch on a single sign.
template <std::size_t size>
Faces faces(const TetrahedronCorners& t, const std::array<Point3, size>& q) {
  using predicates::cross, predicates::dot;
  const std::array u{difference(t[0], t[1]), difference(t[0], t[2]), difference(t[0], t[3])};
  const std::array normals{cross(u[1], u[2]), cross(u[2], u[0]), cross(u[0], u[1])};
  const double whole = dot(u[0], normals[0]);
  std::array<std::array<double, size>, 4> volumes;  // below zero inside
  double x = 0, y = 0, z = 0, values = whole;
  const auto raise = [&](const Difference& w) {
    const auto at_least = [](double& most, double d) { most = d > most ? d : most; };
    at_least(x, magnitude_of(w.x)), at_least(y, magnitude_of(w.y)), at_least(z, magnitude_of(w.z));
  };
  for (const Difference& w : u) raise(w);
  for (std::size_t m = 0; m < size; ++m) {
    const Difference w = difference(t[0], q[m]);
    raise(w);
    for (std::size_t f = 1; f < 4; ++f) volumes[f][m] = dot(w, normals[f - 1]);
    volumes[0][m] = whole - volumes[1][m] - volumes[2][m] - volumes[3][m];
    values += volumes[0][m];
  }
  const auto alone = [](double most) { return Pair{most, most}; };
  const double error = error_bound<FourVolumes>(alone(x), alone(y), alone(z), values);
  Faces found;
  bool certain = true;
  for (std::size_t f = 0; f < 4; ++f) {
    unsigned inner = 0, outer = 0;
    for (std::size_t m = 0; m < size; ++m) {
      inner |= static_cast<unsigned>(volumes[f][m] < -error) << m;
      outer |= static_cast<unsigned>(volumes[f][m] > error) << m;
    }
    certain = certain & ((inner | outer) == (1u << size) - 1);
    found.inner[f] = inner;
    found.all = inner == 0 ? Sign::negative : found.all;
  }
  return certain ? found : exact_faces(t, q);
}

// The side of p to the plane through i along ij and uv.
Sign across(const Point3& i, const Point3& j, const Point3& u, const Point3& v, const Point3& p) {
  return sign_of(predicates::OrientSeenAlong{}, u, v, i, j, p);
}

// Along the cross product of the edge ij of a tetrahedron, with the other corners k and l, and the edge uv of q.
Sign beyond_edges(const Point3& i, const Point3& j, const Point3& k, const Point3& l, const Point3& u, const Point3& v,
                  Points q) {
  const Sign of_k = across(i, j, u, v, k), of_l = across(i, j, u, v, l);
  if (of_k * of_l == Sign::negative) return Sign::positive;
  const Sign inner = of_k != Sign::zero ? of_k : of_l;
  if (inner == Sign::zero) return Sign::positive;  // parallel edges
  Sign reach = Sign::negative;
  for (std::size_t m = 0; m < q.size() && reach != Sign::positive; ++m)
    reach = most(reach, inner * across(i, j, u, v, q[m]));
  return reach;
}

Sign beyond_edges(const TetrahedronCorners& t, const Faces& of, Points q) {
  Sign all = Sign::positive;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const std::size_t k = i != 0 ? 0 : j != 1 ? 1 : 2, l = 6 - i - j - k;  // the faces at ij lie across from k and l
      if ((of.inner[k] & of.inner[l]) != 0) continue;
      for (std::size_t u = 0; u < q.size(); ++u) {
        for (std::size_t v = u + 1; v < q.size() && all != Sign::negative; ++v)
          all = least(all, beyond_edges(t[i], t[j], t[k], t[l], q[u], q[v], q));
      }
    }
  }
  return all;
}

bool holds_one(const Faces& of) { return (of.inner[0] & of.inner[1] & of.inner[2] & of.inner[3]) != 0; }

Relation by_axes(const Triangle3& a, const Tetrahedron3& b);

// A tetrahedron without volume is its faces together.  The inside of a face with area is in its own inside; where only
// edges are met, the diagonals may be.
template <class Figure>
Relation by_faces(const Figure& a, const Tetrahedron3& b) {
  bool met = false;
  for (const Triangle3& face :
       {Triangle3{b.b, b.c, b.d}, Triangle3{b.a, b.c, b.d}, Triangle3{b.a, b.b, b.d}, Triangle3{b.a, b.b, b.c}}) {
    Relation with_face;
    if constexpr (std::is_same_v<Figure, Tetrahedron3>) {
      with_face = by_axes(face, a);
    } else {
      with_face = plumb::relate(a, face);
    }
    if (with_face == Relation::overlapping && !collinear(face.a, face.b, face.c)) return Relation::overlapping;
    met = met || with_face != Relation::disjoint;
  }
  return met ? relate_flat(view_of(a), view_of(b)) : Relation::disjoint;
}

Relation by_axes(const Segment3& a, const Tetrahedron3& b) {
  const Sign turns = orient3d(b.a, b.b, b.c, b.d);
  if (turns == Sign::zero) return by_faces(a, b);
  const TetrahedronCorners t = corners(b, turns);
  const std::array q{a.a, a.b};
  const Faces of = faces(t, q);
  return relation(of.all == Sign::positive && !holds_one(of) ? beyond_edges(t, of, q)
                  : of.all == Sign::zero                     ? least(of.all, beyond_edges(t, of, q))
                                                             : of.all);
}

Relation by_axes(const Triangle3& a, const Tetrahedron3& b) {
  const Sign turns = orient3d(b.a, b.b, b.c, b.d);
  if (turns == Sign::zero) return by_faces(a, b);
  const TetrahedronCorners t = corners(b, turns);
  const std::array q{a.a, a.b, a.c};
  const Faces of = faces(t, q);
  if (of.all == Sign::negative) return Relation::disjoint;
  if (holds_one(of)) return relation(of.all);
  Sign low = Sign::positive, high = Sign::negative;  // of the corners over the triangle
  for (const Point3& p : t) {
    const Sign s = orient3d(a.a, a.b, a.c, p);
    low = least(low, s);
    high = most(high, s);
  }
  const bool flat = low == Sign::zero && high == Sign::zero;  // the tetrahedron is not: the triangle has no area
  const Sign all = flat ? of.all : least(of.all, least(high, -low));
  return all == Sign::negative ? Relation::disjoint : relation(least(all, beyond_edges(t, of, q)));
}

Relation by_axes(const Tetrahedron3& a, const Tetrahedron3& b) {
  const Sign turns_a = orient3d(a.a, a.b, a.c, a.d), turns_b = orient3d(b.a, b.b, b.c, b.d);
  if (turns_b == Sign::zero) return by_faces(a, b);
  if (turns_a == Sign::zero) return by_faces(b, a);
  const TetrahedronCorners p = corners(a, turns_a), q = corners(b, turns_b);
  const Faces of_a = faces(p, q);
  if (of_a.all == Sign::negative || holds_one(of_a)) return relation(of_a.all);
  const Faces of_b = faces(q, p);
  const Sign all = least(of_a.all, of_b.all);
  if (all == Sign::negative || holds_one(of_b)) return relation(all);
  return relation(least(all, beyond_edges(p, of_a, q)));
}

template <class A, class B>
Relation relate_to_tetrahedron(const A& a, const B& b, Question question) {
  require_figures(question, a, b);
  return by_axes(a, b);
}

}  // namespace

PLUMB_PAIR_ANSWERS_TO(Tetrahedron3, relate_to_tetrahedron, Segment3, Triangle3, Tetrahedron3)

}  // namespace query
}  // namespace plumb
