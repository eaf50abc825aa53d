// How are figures seen on a page, and the steps of a search between two of them?  As pictures that turn, and a slider.
//
// The script draws `scene` of the page's own JSON: bodies of points and edges, marks of one point or two, and steps, of
// which there may be none: then there is one picture and no slider.
// Laws: it refers to nothing outside; without it the table of steps is the page.
// Source: RTCD figure 9.5 (how it is commonly drawn).
// Cost: none, text; of steps what is written of them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "plumb/query/gjk/gjk.hpp"

namespace plumb::tool {

/// What a step's weights make of its corners.
Point3 weighted(std::span<const Point3> corners, const GjkStep& step);

/// Of each step the corners of the difference and their numbers, its point nearest to the origin, and the two points of
/// the bodies whose difference that is; by what the corners of either body are.
nlohmann::json drawn_steps(std::span<const GjkStep> steps, std::span<const Point3> corners_of_a,
                           std::span<const Point3> corners_of_b);

inline constexpr std::string_view search_stage = R"(
<p class="steps"><label for="step">Step</label> <button type="button" id="before" aria-label="the step before">&larr;</button>
<input type="range" id="step" min="1" value="1" style="width: 50%"> <button type="button" id="after" aria-label="the next step">&rarr;</button>
<output id="told" for="step"></output></p>
<p>Drag to turn. <span class="steps">The first picture has the bodies and the shortest way between them that the step knows,
the second the simplex of their differences, its point nearest to the origin, and the origin.</span></p>
<div style="display: flex; flex-wrap: wrap">
<svg id="bodies" viewBox="-260 -200 520 400" width="520" role="img" aria-label="the bodies" style="flex: 1 1 400px; max-width: 640px; touch-action: none"></svg>
<svg id="differences" viewBox="-260 -200 520 400" width="520" role="img" aria-label="the simplex" class="steps" style="flex: 1 1 400px; max-width: 640px; touch-action: none"></svg>
</div>)";

inline constexpr std::string_view search_script = R"(<script>
'use strict';
addEventListener('DOMContentLoaded', () => {
  const { bodies, marks = [], steps = [] } = JSON.parse(document.getElementById('raw').textContent).scene;
  if (!steps.length) document.querySelectorAll('#stage .steps').forEach(part => { part.style.display = 'none'; });
  const slider = document.getElementById('step'), told = document.getElementById('told');
  slider.max = steps.length;
  let yaw = 0.6, pitch = 0.4;
  const turn = ([x, y, z]) => {
    const c = Math.cos(yaw), s = Math.sin(yaw), u = c * x + s * y, v = c * y - s * x;
    return [u, -(Math.cos(pitch) * z + Math.sin(pitch) * v)];
  };
  // The view holds all steps, so that nothing jumps.
  const fit = points => {
    const least = [0, 1, 2].map(k => Math.min(...points.map(p => p[k]))), most = [0, 1, 2].map(k => Math.max(...points.map(p => p[k])));
    const half = Math.hypot(...most.map((m, k) => (m - least[k]) / 2)) || 1;
    return p => turn(p.map((x, k) => (x - (least[k] + most[k]) / 2) * (185 / half)));
  };
  const seen = fit([...bodies, ...marks].flatMap(b => b.points)), spread = fit([[0, 0, 0], ...steps.flatMap(s => s.simplex)]);
  const colors = ['#0072b2', '#d55e00', '#56b4e9', '#e69f00'];
  const safe = text => String(text).replace(/[&<]/g, c => c == '&' ? '&amp;' : '&lt;');
  const line = (p, q, color, width) => `<line x1="${p[0]}" y1="${p[1]}" x2="${q[0]}" y2="${q[1]}" stroke="${color}" stroke-width="${width}"/>`;
  const dot = (p, color, radius, title) => `<circle cx="${p[0]}" cy="${p[1]}" r="${radius}" fill="${color}"><title>${safe(title)}</title></circle>`;
  function draw() {
    const n = slider.value - 1, { simplex = [], pairs = [], nearest, between } = steps[n] || {};
    let left = '', right = '';
    bodies.forEach((body, k) => {
      const at = body.points.map(seen), used = new Set(pairs.map(pair => pair[k])), of = body.corners ? body.corners.map(seen) : at;
      for (const [i, j] of body.edges) left += line(at[i], at[j], colors[k], !body.corners && used.has(i) && used.has(j) ? 3 : 0.8);
      if (at.length == 1) left += dot(at[0], colors[k], 4, body.name);
      for (const i of used) left += dot(of[i], colors[k], 5, `corner ${i} of ${'ab'[k]}`);
    });
    for (const { points, title } of marks) {
      const at = points.map(seen);
      if (at.length > 1) left += line(at[0], at[1], '#009e73', 2);
      at.forEach(p => { left += dot(p, '#009e73', 4, title); });
    }
    if (between) {
      const ends = between.map(seen);
      left += line(ends[0], ends[1], 'currentColor', 2) + dot(ends[0], 'currentColor', 3, 'nearest of a') + dot(ends[1], 'currentColor', 3, 'nearest of b');
      const at = simplex.map(spread), origin = spread([0, 0, 0]), near = spread(nearest);
      if (at.length > 2) right += `<polygon points="${at.slice(0, 3).map(p => p.join()).join(' ')}" fill="#009e73" fill-opacity="0.2"/>`;
      for (let i = 0; i < at.length; ++i) {
        for (let j = 0; j < i; ++j) right += line(at[i], at[j], '#009e73', 2);
      }
      at.forEach((p, i) => { right += dot(p, '#009e73', 5, `corner ${pairs[i][0]} of a less corner ${pairs[i][1]} of b`); });
      right += line(origin, near, 'currentColor', 1.5) + dot(near, 'currentColor', 4, 'nearest to the origin') + dot(origin, '#cc0000', 5, 'the origin');
    }
    document.getElementById('bodies').innerHTML = left;
    document.getElementById('differences').innerHTML = right;
    told.textContent = `${n + 1} of ${steps.length}`;
    document.querySelectorAll('[data-step]').forEach(row => row.classList.toggle('fails', row.dataset.step == n));
  }
  slider.addEventListener('input', draw);
  const go = by => { slider.value = +slider.value + by; draw(); };
  document.getElementById('before').addEventListener('click', () => go(-1));
  document.getElementById('after').addEventListener('click', () => go(1));
  for (const svg of document.querySelectorAll('#stage svg')) {
    svg.addEventListener('pointerdown', e => svg.setPointerCapture(e.pointerId));
    svg.addEventListener('pointermove', e => {
      if (!e.buttons) return;
      yaw += e.movementX / 120;
      pitch += e.movementY / 120;
      draw();
    });
  }
  draw();
});
</script>
)";

}  // namespace plumb::tool
