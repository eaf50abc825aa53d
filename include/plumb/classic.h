/* Which side, inside or outside?  The classic C interface of robust predicates, on Plumb's signs.
 *
 * A program written for that interface links against libplumb_classic unchanged, by its own declarations or by these:
 * four predicates over arrays of coordinates, whose results have the sign of the exact value.
 *
 * Laws:
 * (1) The sign is exact for all finite doubles, zero included: nothing overflows or underflows on the way.
 * (2) The magnitude is that of the exact determinant (twice an area, six times a volume, ...), less than a thousandth
 *     of it off, and as a rule the last bits only.  It is infinite where the determinant is beyond all doubles, and the
 *     nearest subnormal, but not zero, where it is below all others.
 * (3) A coordinate that is NaN or infinite gives NaN.
 * (4) No state, no initialization: every function may be called by any thread at any time.
 *
 * Source: the public-domain predicates of J. R. Shewchuk, whose names and signs these are.  Cost: that of the signs in
 * plumb/predicates.hpp; where a sign is hard to get and not zero, a few hundred nanoseconds for the magnitude.
 */
#ifndef PLUMB_CLASSIC_H
#define PLUMB_CLASSIC_H

#ifdef __cplusplus
extern "C" {
#endif

/* Does nothing; for programs that call it. */
void exactinit(void);

/* Positive when a, b, c (2 coordinates each) turn counterclockwise. */
double orient2d(const double* pa, const double* pb, const double* pc);

/* Positive when d lies below the plane of a, b, c (3 coordinates each), where 'above' sees them counterclockwise. */
double orient3d(const double* pa, const double* pb, const double* pc, const double* pd);

/* For counterclockwise a, b, c (2 coordinates each) positive when d is inside their circle. */
double incircle(const double* pa, const double* pb, const double* pc, const double* pd);

/* For orient3d(a, b, c, d) > 0 (3 coordinates each) positive when e is inside their sphere. */
double insphere(const double* pa, const double* pb, const double* pc, const double* pd, const double* pe);

/* The same, with the magnitude as near as a double can be: the exact determinant rounded once. */
double orient2dexact(const double* pa, const double* pb, const double* pc);
double orient3dexact(const double* pa, const double* pb, const double* pc, const double* pd);
double incircleexact(const double* pa, const double* pb, const double* pc, const double* pd);
double insphereexact(const double* pa, const double* pb, const double* pc, const double* pd, const double* pe);

/* Another name of these: there is no slower way. */
double orient2dslow(const double* pa, const double* pb, const double* pc);
double orient3dslow(const double* pa, const double* pb, const double* pc, const double* pd);
double incircleslow(const double* pa, const double* pb, const double* pc, const double* pd);
double insphereslow(const double* pa, const double* pb, const double* pc, const double* pd, const double* pe);

/* Plain floating point: fast, and wrong where points are nearly degenerate. */
double orient2dfast(const double* pa, const double* pb, const double* pc);
double orient3dfast(const double* pa, const double* pb, const double* pc, const double* pd);
double incirclefast(const double* pa, const double* pb, const double* pc, const double* pd);
double inspherefast(const double* pa, const double* pb, const double* pc, const double* pd, const double* pe);

#ifdef __cplusplus
}
#endif

#endif
