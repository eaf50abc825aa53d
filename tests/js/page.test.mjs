// Does the package answer in a browser as in Node?  A page that opens from a disk, without a server or a network, hashes
// signs in headless Chromium.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {test} from 'node:test';

// Written out into the page: it sees nothing but its argument.
function hashOfSigns(plumb) {
  let state = 1, hash = 0;
  const random = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const seen = new Set();
  for (const [name, arity] of [['orient2d', 6], ['incircle', 8], ['orient3d', 12], ['insphere', 15]]) {
    for (let i = 0; i < 3000; ++i) {
      const scale = 2 ** Math.floor(random() * 1800 - 900);
      const sign = Math.sign(plumb[name](...Array.from({length: arity}, () => Math.floor(random() * 4) * scale)));
      hash = (Math.imul(hash, 31) + sign + 2) >>> 0;
      seen.add(sign);
    }
  }
  return `${hash} of ${seen.size} signs`;
}

const shell = 'chromium-headless-shell';
let missing = false;
try {
  execFileSync(shell, ['--version'], {stdio: 'ignore'});
} catch {
  missing = `there is no ${shell}`;
}

test('a page answers as Node does', {skip: missing}, async () => {
  const read = (name) => readFileSync(join(process.env.PLUMB_PACKAGE, name), 'utf8');
  const url = (text) => `data:text/javascript;base64,${Buffer.from(text).toString('base64')}`;
  const index = read('index.js').replace("'./signs.js'", `'${url(read('signs.js'))}'`);
  const page = `<body><script type="module">
    import * as plumb from '${url(index)}';
    document.body.textContent = (${hashOfSigns})(plumb);
  </script></body>`;
  const folder = mkdtempSync(join(tmpdir(), 'plumb-page-'));
  try {
    writeFileSync(join(folder, 'page.html'), page);
    const dom = execFileSync(shell, ['--no-sandbox', '--disable-gpu', '--virtual-time-budget=60000', '--dump-dom',
      pathToFileURL(join(folder, 'page.html')).href], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']});
    const here = hashOfSigns(await import(pathToFileURL(join(process.env.PLUMB_PACKAGE, 'index.js'))));
    assert.match(here, /of 3 signs/);
    assert.ok(dom.includes(here), `${here} in Node; the page: ${dom.slice(-300)}`);
  } finally {
    rmSync(folder, {recursive: true});
  }
});
