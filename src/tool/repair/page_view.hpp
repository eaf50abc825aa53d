// What does the page of a repair show?  The mesh before and after side by side, and each change at its place.
//
// The script paints triangles into a depth buffer of its own: what a browser has of WebGL is not asked for.
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
<p>Drag to turn, turn the wheel to come closer; a row of the table, or a ring, leads to its place.</p>
<div style="display: flex; flex-wrap: wrap">
<div style="flex: 1 1 400px"><canvas id="before" width="520" height="420" role="img" aria-label="the mesh before" style="width: 100%; touch-action: none"></canvas><p id="was"></p></div>
<div style="flex: 1 1 400px"><canvas id="after" width="520" height="420" role="img" aria-label="the mesh after" style="width: 100%; touch-action: none"></canvas><p id="is"></p></div>
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
  let shown = 0, chosen = -1, yaw, pitch, zoom, target;
  const scene = () => scenes[shown];
  const length = v => Math.hypot(...v);
  const difference = (p, q) => p.map((x, k) => x - q[k]);
  const cross = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const point = (part, i) => part.points.slice(3 * i, 3 * i + 3);

  // Right and up in the picture, and toward the reader.
  function viewer(width, height) {
    const c = Math.cos(yaw), s = Math.sin(yaw), C = Math.cos(pitch), S = Math.sin(pitch), scale = zoom * Math.min(width, height);
    return (x, y, z) => {
      x -= target[0]; y -= target[1]; z -= target[2];
      const v = c * y - s * x;
      return [width / 2 + scale * (c * x + s * y), height / 2 - scale * (C * z + S * v), scale * (S * z - C * v)];
    };
  }
  function paint(canvas, part, altered) {
    const W = canvas.width, H = canvas.height, context = canvas.getContext('2d', { willReadFrequently: true }), image = context.createImageData(W, H);
    const pixels = new Uint32Array(image.data.buffer), depth = new Float32Array(W * H).fill(-Infinity);
    const view = viewer(W, H), at = new Float64Array(part.points.length);
    for (let i = 0; i < at.length; i += 3) at.set(view(part.points[i], part.points[i + 1], part.points[i + 2]), i);
    const put = (i, z, [r, g, b], light) => {
      depth[i] = z;
      pixels[i] = (255 << 24) | ((b * light) << 16) | ((g * light) << 8) | (r * light);
    };
    const t = part.triangles, changed = new Set(part.changed);
    for (let n = 0; n < t.length; n += 3) {
      const [a, b, c] = [3 * t[n], 3 * t[n + 1], 3 * t[n + 2]];
      const ax = at[a], ay = at[a + 1], bx = at[b], by = at[b + 1], cx = at[c], cy = at[c + 1];
      const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
      if (!area) continue;
      const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx) - 0.5)), right = Math.min(W - 1, Math.floor(Math.max(ax, bx, cx) - 0.5));
      const top = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5)), bottom = Math.min(H - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
      if (left > right || top > bottom) continue;
      const az = at[a + 2], zu = at[b + 2] - az, zv = at[c + 2] - az;
      const normal = cross([bx - ax, by - ay, zu], [cx - ax, cy - ay, zv]);
      const color = changed.has(n / 3) ? altered : area < 0 ? [176, 196, 214] : [217, 163, 0];
      const light = 0.4 + 0.6 * Math.abs(normal[2]) / (length(normal) || 1);
      const rims = Math.abs(area) > 120 ? [Math.hypot(cx - bx, cy - by), Math.hypot(cx - ax, cy - ay), Math.hypot(bx - ax, by - ay)] : null;
      for (let y = top; y <= bottom; ++y) {
        for (let x = left; x <= right; ++x) {
          const dx = x + 0.5 - ax, dy = y + 0.5 - ay;
          const v = ((cy - ay) * dx - (cx - ax) * dy) / area, w = ((bx - ax) * dy - (by - ay) * dx) / area, u = 1 - v - w;
          if (u < 0 || v < 0 || w < 0) continue;
          const z = az + v * zu + w * zv, i = y * W + x;
          if (z <= depth[i]) continue;
          const rim = rims && Math.min(u * Math.abs(area) / rims[0], v * Math.abs(area) / rims[1], w * Math.abs(area) / rims[2]) < 0.7;
          put(i, z, color, rim ? light * 0.7 : light);
        }
      }
    }
    const line = (ends, color) => {
      for (let n = 0; n < ends.length; n += 2) {
        const p = at.slice(3 * ends[n], 3 * ends[n] + 3), q = at.slice(3 * ends[n + 1], 3 * ends[n + 1] + 3);
        const steps = Math.min(4000, Math.ceil(Math.max(Math.abs(q[0] - p[0]), Math.abs(q[1] - p[1]), 1)));
        for (let s = 0; s <= steps; ++s) {
          const x = Math.floor(p[0] + (q[0] - p[0]) * s / steps), y = Math.floor(p[1] + (q[1] - p[1]) * s / steps), z = p[2] + (q[2] - p[2]) * s / steps;
          for (const [i, k] of [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]])
            if (i >= 0 && k >= 0 && i < W && k < H && z + 3 >= depth[k * W + i]) put(k * W + i, Math.max(z, depth[k * W + i]), color, 1);
        }
      }
    };
    line(part.open, [224, 0, 0]);
    line(part.crowded, [155, 48, 208]);
    context.putImageData(image, 0, 0);
    const rows = rowsOf(shown), ink = getComputedStyle(canvas).color;
    canvas.marks = [];
    scene().places.forEach((place, k) => {
      if (rows[k].hidden) return;
      const [x, y, z] = view(...place), i = Math.floor(y) * W + Math.floor(x);
      if (!(x >= 0 && y >= 0 && x < W && y < H)) return;
      canvas.marks.push([x, y, k]);
      context.strokeStyle = k === chosen ? '#0072b2' : ink;
      context.lineWidth = k === chosen ? 4 : 1.5;
      context.globalAlpha = k === chosen || z + 6 >= depth[i] ? 1 : 0.3;  // faint behind the surface
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
  let asked = false;
  function later() {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => { asked = false; draw(); });
  }
  function whole() {
    chosen = -1, yaw = 0.6, pitch = 0.4, zoom = 0.45, target = [0, 0, 0];
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
    chosen = k, target = scene().places[k];
    const near = sides.map(side => about(scene()[side], target)), { normal } = near[1];
    const reach = Math.max(...near.map(n => n.reach)), size = length(normal);
    zoom = Math.min(1e6, Math.max(0.45, 0.22 / (reach || 1)));
    if (size) yaw = Math.atan2(normal[0], -normal[1]) + 0.4, pitch = Math.max(-1.4, Math.min(1.4, Math.asin(normal[2] / size) + 0.3));
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
  const nearer = by => { zoom = Math.min(1e6, Math.max(0.1, zoom * by)); later(); };
  find('closer').addEventListener('click', () => nearer(1.5));
  find('farther').addEventListener('click', () => nearer(1 / 1.5));
  find('next').addEventListener('click', () => step(1));
  find('previous').addEventListener('click', () => step(chosen < 0 ? 0 : -1));
  for (const side of sides) {
    const canvas = find(side);
    let moved = 0;
    canvas.addEventListener('pointerdown', e => { moved = 0; canvas.setPointerCapture(e.pointerId); });
    canvas.addEventListener('pointermove', e => {
      if (!e.buttons) return;
      moved += Math.abs(e.movementX) + Math.abs(e.movementY);
      yaw += e.movementX / 120;
      pitch += e.movementY / 120;
      later();
    });
    canvas.addEventListener('click', e => {
      const scale = canvas.width / canvas.clientWidth;
      const near = canvas.marks.filter(([x, y]) => Math.hypot(x - e.offsetX * scale, y - e.offsetY * scale) < 12);
      if (moved < 4 && near.length) go(near[near.length - 1][2], true);
    });
    canvas.addEventListener('wheel', e => { e.preventDefault(); nearer(Math.exp(-e.deltaY / 400)); }, { passive: false });
  }
  document.querySelectorAll('input[data-filter]').forEach(box => box.addEventListener('change', later));
  document.querySelectorAll('button[data-set]').forEach(button => button.addEventListener('click', later));
  if (scenes.length) show(0);
});
</script>
)";

}  // namespace plumb::tool
