// What does the page of a repair show?  The mesh before and after side by side, and each change at its place.
//
// The script draws by that of tool/drawing/mesh_view.hpp, which stands before it.
// Laws: it reads the page's own JSON and refers to nothing outside; without it the tables of changes are the page.
// Source: none.
// Cost: none, text.
#pragma once

#include <string_view>

namespace plumb::tool {

inline constexpr std::string_view repair_stage = R"(
<p><label>Mesh <select id="mesh"></select></label> <button type="button" id="all">whole mesh</button>
<button type="button" id="closer">closer</button><button type="button" id="farther">farther</button>
<button type="button" id="previous">previous change</button><button type="button" id="next">next change</button>
<output id="told"></output></p>
<p>Drag, or use the arrow keys, to turn; the wheel, or + and -, to come closer; a row of the table, or a ring, leads to its place.</p>
<div style="display: flex; flex-wrap: wrap">
<div style="flex: 1 1 400px"><canvas id="before" width="520" height="420" tabindex="0" role="img" aria-label="the mesh before" style="width: 100%; touch-action: none"></canvas><p id="was"></p></div>
<div style="flex: 1 1 400px"><canvas id="after" width="520" height="420" tabindex="0" role="img" aria-label="the mesh after" style="width: 100%; touch-action: none"></canvas><p id="is"></p></div>
</div>
<p><span style="color: #d55e00">&#9632;</span> no longer there or turned &nbsp; <span style="color: #009e73">&#9632;</span> new or turned &nbsp;
<span style="color: #d9a300">&#9632;</span> seen from the inside &nbsp; <span style="color: #e00000">&#9644;</span> open edge &nbsp;
<span style="color: #9b30d0">&#9644;</span> edge of more than two triangles &nbsp; &#9675; change &nbsp; &#9633; left as it was</p>)";

inline constexpr std::string_view repair_script = R"(<script>
'use strict';
addEventListener('DOMContentLoaded', () => {
  const scenes = JSON.parse(document.getElementById('raw').textContent).scenes;
  const find = id => document.getElementById(id);
  const chooser = find('mesh'), told = find('told'), sides = ['before', 'after'];
  scenes.forEach((scene, i) => chooser.add(new Option(scene.name, i)));
  chooser.parentElement.hidden = scenes.length < 2;
  const rowsOf = mesh => [...document.querySelectorAll(`tr[data-mesh="${mesh}"]`)];
  const { length, difference, cross } = meshView, camera = meshView.camera();
  let shown = 0, chosen = -1;
  const scene = () => scenes[shown];
  const point = (part, i) => part.points.slice(3 * i, 3 * i + 3);

  function paint(canvas, part, altered) {
    const picture = meshView.picture(canvas, camera), at = picture.project(part.points), changed = new Set(part.changed);
    picture.triangles(at, part.triangles, (n, turned) => changed.has(n) ? altered : turned ? [217, 163, 0] : [176, 196, 214]);
    picture.lines(at, part.open, [224, 0, 0]);
    picture.lines(at, part.crowded, [155, 48, 208]);
    const context = picture.show(), rows = rowsOf(shown), ink = getComputedStyle(canvas).color;
    canvas.marks = [];
    scene().places.forEach((place, k) => {
      if (rows[k].hidden) return;
      const [x, y, z] = picture.view(...place);
      if (!picture.holds(x, y)) return;
      canvas.marks.push([x, y, k]);
      context.strokeStyle = k === chosen ? '#0072b2' : ink;
      context.lineWidth = k === chosen ? 4 : 1.5;
      context.globalAlpha = k === chosen || picture.sees(x, y, z) ? 1 : 0.3;  // faint behind the surface
      context.beginPath();
      if (scene().left[k]) context.rect(x - 7, y - 7, 14, 14); else context.arc(x, y, k === chosen ? 10 : 7, 0, 7);
      context.stroke();
    });
    context.globalAlpha = 1;
  }
  function draw() {
    paint(find('before'), scene().before, [213, 94, 0]);
    paint(find('after'), scene().after, [0, 158, 115]);
    const rows = rowsOf(shown);
    document.querySelectorAll('tr[data-mesh]').forEach(row => row.classList.toggle('fails', row === rows[chosen]));
    told.textContent = chosen < 0 ? '' : rows[chosen].innerText;
  }
  const later = meshView.later(draw);
  function whole() {
    chosen = -1, Object.assign(camera, meshView.camera());
    find('was').textContent = `before: ${scene().was}`, find('is').textContent = `after: ${scene().is}`;
    draw();
  }
  // The longest edge at the vertex that is nearest to a place, and which way its triangles face.
  function about(part, place) {
    let nearest = -1, least = Infinity;
    for (const i of new Set(part.triangles)) {
      const d = length(difference(point(part, i), place));
      if (d < least) least = d, nearest = i;
    }
    let longest = 0, normal = [0, 0, 0];
    for (let n = 0; n < part.triangles.length; n += 3) {
      const corners = part.triangles.slice(n, n + 3);
      if (!corners.includes(nearest)) continue;
      const [p, q, r] = corners.map(i => point(part, i)), u = difference(q, p), v = difference(r, p);
      longest = Math.max(longest, length(u), length(v));
      normal = normal.map((x, k) => x + cross(u, v)[k]);
    }
    return { reach: Math.max(longest, least), normal };
  }
  function go(k, scrolls) {
    chosen = k, camera.target = scene().places[k];
    const near = sides.map(side => about(scene()[side], camera.target)), { normal } = near[1];
    const reach = Math.max(...near.map(n => n.reach)), size = length(normal);
    camera.zoom = Math.min(1e6, Math.max(0.45, 0.22 / (reach || 1)));
    if (size) camera.yaw = Math.atan2(normal[0], -normal[1]) + 0.4, camera.pitch = Math.max(-1.4, Math.min(1.4, Math.asin(normal[2] / size) + 0.3));
    draw();
    (scrolls ? rowsOf(shown)[k] : find('stage')).scrollIntoView({ block: 'nearest' });
  }
  function step(by) {
    const rows = rowsOf(shown);
    for (let i = 1, k = chosen; i <= rows.length; ++i) {
      k = (k + by + rows.length) % rows.length;
      if (!rows[k].hidden) return go(k);
    }
  }
  function show(mesh) {
    chooser.value = shown = mesh;
    whole();
  }
  document.querySelectorAll('tr[data-mesh] button').forEach(button => button.addEventListener('click', () => {
    const row = button.closest('tr'), mesh = +row.dataset.mesh;
    if (mesh !== shown) show(mesh);
    go(rowsOf(mesh).indexOf(row));
  }));
  chooser.addEventListener('change', () => show(+chooser.value));
  find('all').addEventListener('click', whole);
  const nearer = by => { meshView.nearer(camera, by); later(); };
  find('closer').addEventListener('click', () => nearer(1.5));
  find('farther').addEventListener('click', () => nearer(1 / 1.5));
  find('next').addEventListener('click', () => step(1));
  find('previous').addEventListener('click', () => step(chosen < 0 ? 0 : -1));
  for (const side of sides) {
    const canvas = find(side);
    const isClick = meshView.turnable(canvas, camera, later);
    canvas.addEventListener('click', e => {
      const scale = canvas.width / canvas.clientWidth;
      const near = canvas.marks.filter(([x, y]) => Math.hypot(x - e.offsetX * scale, y - e.offsetY * scale) < 12);
      if (isClick() && near.length) go(near[near.length - 1][2], true);
    });
  }
  document.querySelectorAll('input[data-filter]').forEach(box => box.addEventListener('change', later));
  document.querySelectorAll('button[data-set]').forEach(button => button.addEventListener('click', later));
  if (scenes.length) show(0);
});
</script>
)";

}  // namespace plumb::tool
