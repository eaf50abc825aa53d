// What does the page of clashes show?  The list beside the scene, and two parts of it in color that a slider moves apart.
//
// Laws: the script reads the page's own JSON and refers to nothing outside; without it the list is the page.
// Source: none.
// Cost: none, text.
#pragma once

#include <string_view>

namespace plumb::tool {

inline constexpr std::string_view clash_stage = R"(
<p><button type="button" id="previous">previous</button><button type="button" id="next">next</button>
<button type="button" id="all">all parts</button><button type="button" id="closer">closer</button><button type="button" id="farther">farther</button></p>
<canvas id="scene" tabindex="0" width="760" height="560" role="img" aria-label="the two parts of a clash" style="width: 100%; touch-action: none"></canvas>
<p><label>apart <input type="range" id="apart" min="0" max="200" value="0" style="width: 60%"></label> <output id="moved"></output></p>
<p><label>other parts <select id="others"><option value="faint">faint</option><option value="hidden">hidden</option></select></label>
<label><input type="checkbox" id="through"> see through both</label></p>
<p><span style="color: #d55e00">&#9632;</span> <span id="first">the first</span> &nbsp; <span style="color: #0072b2">&#9632;</span> <span id="second">the second</span> &nbsp;
<span style="color: #f0c020">&#9632;</span> triangles that meet &nbsp; &#9675; place</p>
<p id="told" role="status"></p>
<p><small>Drag, or use the arrow keys, to turn; the wheel, or + and -, to come closer; n and p, or a row of the list, lead to a clash.</small></p>)";

inline constexpr std::string_view clash_script = R"(<script>
'use strict';
addEventListener('DOMContentLoaded', () => {
  const { parts, shown, unit } = JSON.parse(document.getElementById('raw').textContent);
  const find = id => document.getElementById(id);
  const canvas = find('scene'), slider = find('apart'), camera = meshView.camera();
  const rows = [...document.querySelectorAll('tr[data-clash]')];
  const { length, difference } = meshView;
  let chosen = -1;

  for (const part of parts) {
    part.least = [0, 1, 2].map(k => part.points.reduce((m, x, i) => i % 3 === k ? Math.min(m, x) : m, Infinity));
    part.most = [0, 1, 2].map(k => part.points.reduce((m, x, i) => i % 3 === k ? Math.max(m, x) : m, -Infinity));
    part.middle = part.least.map((x, k) => (x + part.most[k]) / 2);
  }
  // How long both parts are together, and the way on which the first leaves: that of the least translation where it is
  // known, else away from the other's middle.
  function about({ a, b, way }) {
    const [p, q] = [parts[a], parts[b]];
    const reach = length(p.most.map((x, k) => Math.max(x, q.most[k]) - Math.min(p.least[k], q.least[k]))) || 1;
    const apart = difference(p.middle, q.middle), far = length(apart);
    return { reach, way: way || (far ? apart.map(x => x / far) : [0, 0, 1]) };
  }
  const away = () => chosen < 0 ? 0 : slider.value / 200 * about(shown[chosen]).reach;

  function draw() {
    const picture = meshView.picture(canvas, camera), pair = chosen < 0 ? null : shown[chosen];
    const sieve = find('through').checked ? 2 : 1, yellow = [240, 192, 32];
    if (pair) {
      const { way } = about(pair), half = way.map(x => x * away() / 2);
      const side = (part, met, color, moved) => {
        const meets = new Set(met);
        picture.triangles(picture.project(part.points, moved), part.triangles, n => meets.has(n) ? yellow : color, sieve);
      };
      side(parts[pair.a], pair.met_a, [213, 94, 0], half);
      side(parts[pair.b], pair.met_b, [0, 114, 178], half.map(x => -x));
    }
    if (!pair || find('others').value === 'faint')
      parts.forEach((part, i) => {
        if (pair && (i === pair.a || i === pair.b)) return;
        picture.triangles(picture.project(part.points), part.triangles, () => [150, 160, 170], pair ? 4 : 1);
      });
    const context = picture.show();
    canvas.mark = null;
    if (pair) {
      const [x, y] = picture.view(...pair.place);
      canvas.mark = [x, y];
      context.strokeStyle = getComputedStyle(canvas).color;
      context.lineWidth = 2.5;
      context.beginPath();
      context.arc(x, y, 10, 0, 7);
      context.stroke();
    }
    const moved = away() * unit;
    find('moved').textContent = !pair ? '' : `${moved.toPrecision(4)}${pair.free !== null && moved >= pair.free ? ', free' : ''}`;
    rows.forEach((row, k) => row.classList.toggle('fails', k === chosen));
  }
  const later = meshView.later(draw);
  function all() {
    chosen = -1, slider.value = 0, Object.assign(camera, meshView.camera());
    find('told').textContent = find('moved').textContent = '';
    find('first').textContent = 'the first', find('second').textContent = 'the second';
    draw();
  }
  function go(k) {
    const pair = shown[k];
    chosen = k, slider.value = 0, camera.target = pair.place, camera.zoom = Math.min(1e6, 0.8 / about(pair).reach), camera.pitch = 0.4;
    const { way } = about(pair);
    camera.yaw = Math.hypot(way[0], way[1]) > 0.1 ? Math.atan2(way[0], -way[1]) + 0.9 : 0.6;  // the first leaves in sight
    find('first').textContent = parts[pair.a].name, find('second').textContent = parts[pair.b].name;
    find('told').textContent = pair.told;
    draw();
    rows[k].scrollIntoView({ block: 'nearest' });
  }
  function step(by) {
    for (let i = 1, k = chosen < 0 && by < 0 ? 0 : chosen; i <= rows.length; ++i) {
      k = (k + by + rows.length) % rows.length;
      if (!rows[k].hidden) return go(k);
    }
  }
  const nearer = by => { meshView.nearer(camera, by); later(); };
  rows.forEach((row, k) => row.querySelector('button').addEventListener('click', () => go(k)));
  find('all').addEventListener('click', all);
  find('closer').addEventListener('click', () => nearer(1.5));
  find('farther').addEventListener('click', () => nearer(1 / 1.5));
  find('next').addEventListener('click', () => step(1));
  find('previous').addEventListener('click', () => step(-1));
  for (const id of ['others', 'through', 'apart']) find(id).addEventListener('input', draw);
  canvas.addEventListener('keydown', e => {
    if (e.ctrlKey || e.altKey || e.metaKey) return;
    if (e.key === 'n') step(1);
    if (e.key === 'p') step(-1);
  });
  meshView.turnable(canvas, camera, later);
  all();
  if (rows.length) go(0);
});
</script>
)";

}  // namespace plumb::tool
