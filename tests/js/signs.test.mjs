// Are the signs of the package those of real arithmetic, and of robust-predicates where that holds?
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {pathToFileURL} from 'node:url';
import {test} from 'node:test';

const plumb = await import(pathToFileURL(`${process.env.PLUMB_PACKAGE}/index.js`));
const require = createRequire(`${process.env.PLUMB_NODE_MODULES}/x.js`);
const robust = await import(pathToFileURL(require.resolve('robust-predicates')));

// A double as an integer, in units of 2^-1074: sums and products of such are exact.
const bits = new DataView(new ArrayBuffer(8));
function integer(x) {
  bits.setFloat64(0, x);
  const exponent = BigInt((bits.getUint16(0) >> 4) & 0x7ff);
  const fraction = bits.getBigUint64(0) & 0xfffffffffffffn;
  const size = exponent === 0n ? fraction : (fraction | 0x10000000000000n) << (exponent - 1n);
  return x < 0 ? -size : size;
}
function determinant(m) {
  if (m.length === 1) return m[0][0];
  return m.reduce((sum, row, i) => {
    if (row[0] === 0n) return sum;
    const term = row[0] * determinant(m.filter((_, k) => k !== i).map((r) => r.slice(1)));
    return i % 2 === 0 ? sum + term : sum - term;
  }, 0n);
}
// By the textbook's matrices, with signs as the package states them.
function exactSign(name, x) {
  const dimension = name.endsWith('2d') || name === 'incircle' ? 2 : 3;
  const points = [];
  for (let i = 0; i < x.length; i += dimension) points.push(x.slice(i, i + dimension).map(integer));
  const last = points.pop();
  const rows = points.map((p) => p.map((c, k) => c - last[k]));
  if (name.startsWith('in')) for (const row of rows) row.push(row.reduce((s, c) => s + c * c, 0n));
  const d = determinant(rows);
  const sign = d > 0n ? 1 : d < 0n ? -1 : 0;
  return name === 'orient2d' || name === 'insphere' ? 0 - sign : sign;
}

const arity = {orient2d: 6, incircle: 8, orient3d: 12, insphere: 15};
const names = Object.keys(arity);

// A stream of numbers that is the same every time.
let state = 1;
function random() {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return state / 2 ** 32;
}
const families = {
  uniform: () => random() * 2 - 1 + random() * 2 ** -33,
  grid: () => Math.floor(random() * 5) - 2,
  near_half: () => 0.5 + Math.floor(random() * 64) * 2 ** -53,
  tenths: () => Math.floor(random() * 4) * 0.1,
  extreme: () => (random() - 0.5) * 2 ** Math.floor(random() * 2040 - 1020),
  subnormal: () => Math.floor(random() * 9 - 4) * Number.MIN_VALUE,
  huge: () => Math.floor(random() * 5 - 2) * 2 ** 1021,
};

for (const [family, draw] of Object.entries(families)) {
  test(`signs are exact: ${family}`, () => {
    const seen = new Set();
    for (const name of names) {
      for (let i = 0; i < 120; ++i) {
        const x = Array.from({length: arity[name]}, draw);
        const expected = exactSign(name, x);
        seen.add(expected);
        assert.equal(Math.sign(plumb[name](...x)), expected, `${name}(${x})`);
        assert.equal(Math.sign(plumb[`${name}exact`](...x)), expected, `${name}exact(${x})`);
      }
    }
    assert.equal(seen.size, family === 'uniform' || family === 'extreme' ? Math.max(2, seen.size) : 3);
  });
}

test('as robust-predicates, where nothing overflows or underflows', () => {
  for (const family of ['uniform', 'grid', 'near_half', 'tenths']) {
    for (const name of names) {
      for (let i = 0; i < 2000; ++i) {
        const x = Array.from({length: arity[name]}, families[family]);
        const [value, other] = [plumb[name](...x), robust[name](...x)];
        assert.equal(Math.sign(value), Math.sign(other) + 0, `${name}(${x})`);
        assert.ok(Math.abs(value - other) <= Math.abs(other) / 1000, `${name}(${x}): ${value}, ${other}`);
        const fast = `${name}fast`;
        assert.ok(Math.abs(plumb[fast](...x) - robust[fast](...x)) < 1e-11, `${fast}(${x})`);
      }
    }
  }
});

test('types are those of robust-predicates and name what there is', () => {
  const types = readFileSync(`${process.env.PLUMB_PACKAGE}/index.d.ts`, 'utf8');
  const declared = [...types.matchAll(/export function (\w+)/g)].map((m) => m[1]);
  assert.deepEqual(declared.sort(), Object.keys(plumb).sort());
  const file = `${process.env.PLUMB_NODE_MODULES}/stands_for.mts`;
  writeFileSync(file, `import * as ours from '${process.env.PLUMB_PACKAGE}/index.js';
    import * as theirs from 'robust-predicates';
    export const standsFor: typeof theirs = ours;
    // @ts-expect-error: a coordinate is missing
    ours.orient2d(0, 0, 1, 0, 0);`);
  try {
    execFileSync('node', [require.resolve('typescript/bin/tsc'), '--noEmit', '--strict', '--target', 'es2022', '--module',
      'nodenext', file], {encoding: 'utf8'});
  } catch (error) {
    assert.fail(error.stdout);
  } finally {
    rmSync(file);
  }
});

// What the tests of robust-predicates ask, whose fixtures its package does not carry.
test('its own cases', () => {
  const {orient2d, incircle, orient3d, insphere} = plumb;
  assert.ok(orient2d(0, 0, 1, 1, 0, 1) < 0);
  assert.ok(orient2d(0, 0, 0, 1, 1, 1) > 0);
  assert.equal(orient2d(0, 0, 0.5, 0.5, 1, 1), 0);
  for (let i = 0; i < 128 * 128; ++i) {
    const x = [0.95 + 2 ** -43 * (i % 128) / 128, 0.95 + 2 ** -43 * Math.floor(i / 128) / 128, 18, 18, 16.8, 16.8];
    assert.equal(Math.sign(orient2d(...x)), exactSign('orient2d', x));
  }
  const [above, below] = [-1 + 2 ** -53, -1 - 2 ** -52];
  assert.ok(incircle(1, 0, -1, 0, 0, 1, 0, above) < 0 && incircle(1, 0, -1, 0, 0, 1, 0, below) > 0);
  for (let x = 1e-64, i = 0; i < 128; ++i, x *= 10) {
    assert.ok(incircle(0, x, -x, -x, x, -x, 0, 0) > 0 && incircle(0, x, -x, -x, x, -x, 0, 2 * x) < 0);
    assert.equal(incircle(0, x, -x, -x, x, -x, 0, x), 0);
  }
  assert.ok(orient3d(0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, Number.MIN_VALUE) > 0);
  assert.ok(orient3d(0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, -Number.MIN_VALUE) < 0);
  const sphere = [1, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 1];
  assert.ok(insphere(...sphere, 0, 0, above) < 0 && insphere(...sphere, 0, 0, below) > 0);
  assert.equal(insphere(...sphere, 0, 0, -1), 0);
  for (let i = 0; i < 1000; ++i) {
    const a = Array.from({length: 3}, () => 0.5 + 5e-14 * random());
    assert.equal(orient3d(12, 12, 12, 24, 24, 24, 48, 48, 48, ...a), 0);
  }
});

test('beyond its range', () => {
  const tiny = 2 ** -400;
  const sphere = [1, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 1].map((c) => c * tiny);
  assert.ok(plumb.insphere(...sphere, 0, 0, 0) < 0);
  assert.equal(robust.insphere(...sphere, 0, 0, 0) + 0, 0);
  assert.equal(plumb.orient2d(-1e300, -1e300, 1e300, -1e300, 0, 1e300), -Infinity);
});

test('NaN in, NaN out; zero has no sign', () => {
  for (const name of names) {
    for (const wrong of [NaN, Infinity]) {
      for (let i = 0; i < arity[name]; ++i) {
        const x = Array.from({length: arity[name]}, random);
        x[i] = wrong;
        assert.ok(Number.isNaN(plumb[name](...x)), `${name}(${x})`);
      }
    }
    assert.ok(Object.is(plumb[name](...new Array(arity[name]).fill(1)), 0));
  }
});
