// Continuous collision detection (CCD): do they meet while every vertex moves linearly, and when first?  Vertex against
// triangle, edge against edge.
//
// These are the tests of cloth and contact solvers: the times at which four moving points are in one plane are the
// roots of a cubic, and at each root it is asked whether the points are where they meet.
// Laws: (1) exact for all finite doubles, as figures are closed sets: no contact is missed and none invented, whether
// points rest, edges are parallel, everything stays in one plane, figures are degenerate, roots are multiple, or the
// contact is at time 0 or 1.  (2) Swapping the figures changes nothing, nor do powers of two and exact translations.
// (3) Reversing time keeps the answer of intersects.  (4) With a separation d > 0 they meet where their distance is at
// most d, exactly.  (5) At time 0 the features are those that are nearest then; later, those that meet; first those of
// the lowest dimension, then those of the lowest number, a vertex of a before one of b.
// A coordinate or separation that is NaN or infinite throws NonFinite, a negative separation InvalidShape.
// Source: RTCD 5.5; Provot 1997; Brochu, Edwards and Bridson 2012 for what exactness asks.
// Cost: comparisons of coordinates or the cubic's signs, below 100 ns, for what stays apart; below a microsecond for
// most contacts; 1 to 5 us where an edge or an end is met exactly, or all is within one plane; some 20 us where an
// exact time is asked for.  With a separation some 0.3 us, and a few us for its time; 200 us where doubles do not tell.
// Nothing is allocated, but for exact times, separations that doubles do not tell, and exponents hundreds apart.
// Bounded by a fixed number of operations, and of bits by which a root is told from another, on integers of that
// length.
#pragma once

#include <optional>

#include "plumb/arith/root.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/query/time_of_impact/motion.hpp"

namespace plumb {

struct ContactOptions {
  double separation = 0;  // how near counts as contact
};

bool intersects(const Moving<Point3>& a, const Moving<Triangle3>& b, const ContactOptions& options = {});
bool intersects(const Moving<Triangle3>& a, const Moving<Point3>& b, const ContactOptions& options = {});
bool intersects(const Moving<Segment3>& a, const Moving<Segment3>& b, const ContactOptions& options = {});

std::optional<Contact> first_contact(const Moving<Point3>& a, const Moving<Triangle3>& b,
                                     const ContactOptions& options = {});
std::optional<Contact> first_contact(const Moving<Triangle3>& a, const Moving<Point3>& b,
                                     const ContactOptions& options = {});
std::optional<Contact> first_contact(const Moving<Segment3>& a, const Moving<Segment3>& b,
                                     const ContactOptions& options = {});

/// The exact time.
std::optional<Root> first_contact_time(const Moving<Point3>& a, const Moving<Triangle3>& b,
                                       const ContactOptions& options = {});
std::optional<Root> first_contact_time(const Moving<Triangle3>& a, const Moving<Point3>& b,
                                       const ContactOptions& options = {});
std::optional<Root> first_contact_time(const Moving<Segment3>& a, const Moving<Segment3>& b,
                                       const ContactOptions& options = {});

}  // namespace plumb
