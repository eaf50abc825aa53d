// Coordinates are doubles that are taken as exact; where one is NaN or infinite, so is the result NaN.
// The y axis points down, as in robust-predicates.

/** Positive where a, b, c turn counterclockwise, negative where clockwise, zero where they are on one line: exactly. */
export function orient2d(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number;
/** The same sign; the value is the exact determinant, rounded once. */
export function orient2dexact(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number;
/** In plain floating point: wrong where the points are nearly on one line. */
export function orient2dfast(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number;

/** For a, b, c counterclockwise: positive where d is outside their circle, negative inside, zero on it: exactly. */
export function incircle(
    ax: number, ay: number, bx: number, by: number, cx: number, cy: number, dx: number, dy: number): number;
/** The same sign; the value is the exact determinant, rounded once. */
export function incircleexact(
    ax: number, ay: number, bx: number, by: number, cx: number, cy: number, dx: number, dy: number): number;
/** In plain floating point: wrong where the points are nearly on one circle. */
export function incirclefast(
    ax: number, ay: number, bx: number, by: number, cx: number, cy: number, dx: number, dy: number): number;

/** Positive where d is above the plane of a, b, c, whence they appear counterclockwise; zero on the plane: exactly. */
export function orient3d(
    ax: number, ay: number, az: number, bx: number, by: number, bz: number,
    cx: number, cy: number, cz: number, dx: number, dy: number, dz: number): number;
/** The same sign; the value is the exact determinant, rounded once. */
export function orient3dexact(
    ax: number, ay: number, az: number, bx: number, by: number, bz: number,
    cx: number, cy: number, cz: number, dx: number, dy: number, dz: number): number;
/** In plain floating point: wrong where the points are nearly on one plane. */
export function orient3dfast(
    ax: number, ay: number, az: number, bx: number, by: number, bz: number,
    cx: number, cy: number, cz: number, dx: number, dy: number, dz: number): number;

/** For orient3d(a, b, c, d) > 0: positive where e is outside their sphere, negative inside, zero on it: exactly. */
export function insphere(
    ax: number, ay: number, az: number, bx: number, by: number, bz: number, cx: number, cy: number, cz: number,
    dx: number, dy: number, dz: number, ex: number, ey: number, ez: number): number;
/** The same sign; the value is the exact determinant, rounded once. */
export function insphereexact(
    ax: number, ay: number, az: number, bx: number, by: number, bz: number, cx: number, cy: number, cz: number,
    dx: number, dy: number, dz: number, ex: number, ey: number, ez: number): number;
/** In plain floating point: wrong where the points are nearly on one sphere. */
export function inspherefast(
    ax: number, ay: number, az: number, bx: number, by: number, bz: number, cx: number, cy: number, cz: number,
    dx: number, dy: number, dz: number, ex: number, ey: number, ez: number): number;
