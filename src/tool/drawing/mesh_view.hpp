// How is a mesh seen on a page?  By a script that paints triangles into a canvas, and turns them by mouse and keys.
//
// It has a depth buffer of its own: what a browser has of WebGL is not asked for.  `meshView` is its one name; pages put
// it before their own scripts.
// Laws: it refers to nothing outside of the page, and draws nothing by itself.
// Source: Pineda 1988 (edge functions).
// Cost: none, text.
#pragma once

#include <string_view>

namespace plumb::tool {

inline constexpr std::string_view mesh_view_script = R"(<script>
'use strict';
const meshView = (() => {
  const length = v => Math.hypot(...v);
  const difference = (p, q) => p.map((x, k) => x - q[k]);
  const cross = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const camera = () => ({ yaw: 0.6, pitch: 0.4, zoom: 0.45, target: [0, 0, 0] });
  const nearer = (camera, by) => { camera.zoom = Math.min(1e6, Math.max(0.1, camera.zoom * by)); };

  // Right and up in the picture, and toward the reader.
  function viewer({ yaw, pitch, zoom, target }, width, height) {
    const c = Math.cos(yaw), s = Math.sin(yaw), C = Math.cos(pitch), S = Math.sin(pitch), scale = zoom * Math.min(width, height);
    return (x, y, z) => {
      x -= target[0]; y -= target[1]; z -= target[2];
      const v = c * y - s * x;
      return [width / 2 + scale * (c * x + s * y), height / 2 - scale * (C * z + S * v), scale * (S * z - C * v)];
    };
  }
  function picture(canvas, camera) {
    const W = canvas.width, H = canvas.height, context = canvas.getContext('2d', { willReadFrequently: true }), image = context.createImageData(W, H);
    const pixels = new Uint32Array(image.data.buffer), depth = new Float32Array(W * H).fill(-Infinity), view = viewer(camera, W, H);
    const put = (i, z, [r, g, b], light) => {
      depth[i] = z;
      pixels[i] = (255 << 24) | ((b * light) << 16) | ((g * light) << 8) | (r * light);
    };
    function project(points, by = [0, 0, 0]) {
      const at = new Float64Array(points.length);
      for (let i = 0; i < at.length; i += 3) at.set(view(points[i] + by[0], points[i + 1] + by[1], points[i + 2] + by[2]), i);
      return at;
    }
    // colorOf is told the triangle's number and whether it is seen from the inside; `sieve` n leaves one pixel of n in each row.
    function triangles(at, t, colorOf, sieve = 1) {
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
        const color = colorOf(n / 3, area < 0);
        const light = 0.4 + 0.6 * Math.abs(normal[2]) / (length(normal) || 1);
        const rims = Math.abs(area) > 120 ? [Math.hypot(cx - bx, cy - by), Math.hypot(cx - ax, cy - ay), Math.hypot(bx - ax, by - ay)] : null;
        for (let y = top; y <= bottom; ++y) {
          for (let x = left; x <= right; ++x) {
            if (sieve > 1 && (x + (y >> 1) * 2 + (y & 1) * (sieve >> 1)) % sieve) continue;
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
    }
    function lines(at, ends, color) {
      for (let n = 0; n < ends.length; n += 2) {
        const p = at.slice(3 * ends[n], 3 * ends[n] + 3), q = at.slice(3 * ends[n + 1], 3 * ends[n + 1] + 3);
        const steps = Math.min(4000, Math.ceil(Math.max(Math.abs(q[0] - p[0]), Math.abs(q[1] - p[1]), 1)));
        for (let s = 0; s <= steps; ++s) {
          const x = Math.floor(p[0] + (q[0] - p[0]) * s / steps), y = Math.floor(p[1] + (q[1] - p[1]) * s / steps), z = p[2] + (q[2] - p[2]) * s / steps;
          for (const [i, k] of [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]])
            if (i >= 0 && k >= 0 && i < W && k < H && z + 3 >= depth[k * W + i]) put(k * W + i, Math.max(z, depth[k * W + i]), color, 1);
        }
      }
    }
    const holds = (x, y) => x >= 0 && y >= 0 && x < W && y < H;
    const sees = (x, y, z) => z + 6 >= depth[Math.floor(y) * W + Math.floor(x)];
    return { view, project, triangles, lines, holds, sees, show: () => (context.putImageData(image, 0, 0), context) };
  }
  // Draws once a frame, however often it is asked to.
  function later(draw) {
    let asked = false;
    return () => {
      if (asked) return;
      asked = true;
      requestAnimationFrame(() => { asked = false; draw(); });
    };
  }
  // Turns the camera; gives a function that says whether the pointer has rested since it was pressed.
  function turnable(canvas, camera, changed) {
    let moved = 0;
    canvas.addEventListener('pointerdown', e => { moved = 0; canvas.setPointerCapture(e.pointerId); });
    canvas.addEventListener('pointermove', e => {
      if (!e.buttons) return;
      moved += Math.abs(e.movementX) + Math.abs(e.movementY);
      camera.yaw += e.movementX / 120;
      camera.pitch += e.movementY / 120;
      changed();
    });
    canvas.addEventListener('wheel', e => { e.preventDefault(); nearer(camera, Math.exp(-e.deltaY / 400)); changed(); }, { passive: false });
    const keys = {
      ArrowLeft: () => { camera.yaw -= 0.1; }, ArrowRight: () => { camera.yaw += 0.1; },
      ArrowUp: () => { camera.pitch -= 0.1; }, ArrowDown: () => { camera.pitch += 0.1; },
      '+': () => nearer(camera, 1.2), '=': () => nearer(camera, 1.2), '-': () => nearer(camera, 1 / 1.2)
    };
    canvas.addEventListener('keydown', e => {
      if (!keys[e.key] || e.ctrlKey || e.altKey || e.metaKey) return;
      e.preventDefault();
      keys[e.key]();
      changed();
    });
    return () => moved < 4;
  }
  return { length, difference, cross, camera, nearer, picture, later, turnable };
})();
</script>
)";

}  // namespace plumb::tool
