// Exact signs of the classic predicates, by names, arguments and signs those of robust-predicates: see README.md.
import text from './signs.js';

const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
// What it imports is called when memory grows, which asks for nothing here, or when it gives up.
const imports = {};
const compiled = await WebAssembly.compile(bytes);
for (const {module: from, name} of WebAssembly.Module.imports(compiled)) {
  imports[from] ??= {};
  imports[from][name] = name.includes('memory_growth') ? () => {} : () => { throw new Error(`plumb: ${name}`); };
}
const signs = (await WebAssembly.instantiate(compiled, imports)).exports;
signs._initialize?.();

// The y axis of robust-predicates points down: orient2d and insphere have the other sign there than in the classic C code,
// incircle and orient3d the same.  0 - x is x's negative, but of zero it is zero.
export const orient2d = (ax, ay, bx, by, cx, cy) => 0 - signs.js_orient2d(ax, ay, bx, by, cx, cy);
export const orient2dexact = (ax, ay, bx, by, cx, cy) => 0 - signs.js_orient2dexact(ax, ay, bx, by, cx, cy);
export const orient2dfast = (ax, ay, bx, by, cx, cy) => 0 - signs.js_orient2dfast(ax, ay, bx, by, cx, cy);

export const incircle = signs.js_incircle;
export const incircleexact = signs.js_incircleexact;
export const incirclefast = signs.js_incirclefast;

export const orient3d = signs.js_orient3d;
export const orient3dexact = signs.js_orient3dexact;
export const orient3dfast = signs.js_orient3dfast;

export const insphere = (ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez) =>
  0 - signs.js_insphere(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez);
export const insphereexact = (ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez) =>
  0 - signs.js_insphereexact(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez);
export const inspherefast = (ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez) =>
  0 - signs.js_inspherefast(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez);
