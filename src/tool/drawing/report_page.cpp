#include "tool/drawing/report_page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tool/drawing/chart.hpp"

namespace plumb::tool {
namespace {

// The script only hides, shows and explains; without it the page is a plain report.
constexpr std::string_view kStyle = R"(<style>
  :root { color-scheme: light dark; --paper: #ffffff; --ink: #1f2328; --muted: #59636e; --line: #d1d9e0; --soft: #f6f8fa; --fail: #c2410c; }
  @media (prefers-color-scheme: dark) {
    :root { --paper: #0d1117; --ink: #e6edf3; --muted: #9ba4ae; --line: #3d444d; --soft: #161b22; --fail: #ff8340; }
  }
  body { margin: 0 auto; max-width: 1100px; padding: 16px 24px 64px; background: var(--paper); color: var(--ink);
    font: 15px/1.5 system-ui, -apple-system, 'Segoe UI', 'Helvetica Neue', Arial, sans-serif; }
  h1 { font-size: 26px; margin: 16px 0 4px; } h2 { font-size: 20px; margin: 32px 0 0; } p { margin: 4px 0 12px; }
  .about { color: var(--muted); }
  fieldset { border: 1px solid var(--line); border-radius: 6px; margin: 8px 0; padding: 4px 12px 8px; }
  legend { font-weight: 600; } fieldset label { display: inline-block; margin: 2px 14px 2px 0; white-space: nowrap; }
  button { font: inherit; color: inherit; background: var(--soft); border: 1px solid var(--line); border-radius: 6px;
    padding: 0 10px; margin-right: 8px; cursor: pointer; }
  article { border: 1px solid var(--line); border-radius: 6px; margin: 16px 0; overflow: hidden; }
  article svg { display: block; max-width: 100%; height: auto; margin: 0 auto; } article p, article h3 { margin: 8px 16px; }
  figure { margin: 8px 0; border-top: 1px solid var(--line); } figcaption { margin: 8px 16px; color: var(--muted); }
  .counts { padding: 0 16px 8px; overflow-x: auto; } .counts th { max-width: 180px; vertical-align: bottom; }
  .fails { color: var(--fail); font-weight: 600; }
  [data-key] { cursor: default; } .marker:focus, .marker:hover { stroke: var(--ink); stroke-width: 2.5; outline: none; }
  input:focus-visible, button:focus-visible, summary:focus-visible { outline: 2px solid #0072b2; outline-offset: 2px; }
  [hidden], .gone { display: none; }
  details { padding: 4px 16px 8px; background: var(--soft); border-top: 1px solid var(--line); }
  details div { overflow-x: auto; }
  .fold { border: 1px solid var(--line); border-radius: 6px; margin: 16px 0; } .fold article { background: var(--paper); }
  .wide { width: min(96vw, 1500px); position: relative; left: 50%; transform: translateX(-50%); }
  .summary { font-size: 11px; line-height: 1.35; width: 100%; } .summary th, .summary td { vertical-align: top; padding-right: 4px; }
  .summary td, .summary small { white-space: nowrap; font-size: inherit; }
  .summary thead th { vertical-align: bottom; }
  .summary thead th:not(:first-child) { writing-mode: vertical-rl; transform: rotate(180deg); padding: 0 0 4px; text-align: left; }
  .summary tr > :first-child { position: sticky; left: 0; background: var(--paper); }
  .drawn { stroke: currentColor; stroke-width: 1.5; stroke-linejoin: round; }
  small { color: var(--muted); } a { color: inherit; }
  table { border-collapse: collapse; font-variant-numeric: tabular-nums; margin: 8px 0; }
  th, td { padding: 2px 12px 2px 0; text-align: right; border-bottom: 1px solid var(--line); }
  th:first-child, td:first-child { text-align: left; }
  #hint { position: absolute; max-width: 320px; padding: 6px 10px; background: var(--ink); color: var(--paper);
    border-radius: 6px; font-size: 13px; pointer-events: none; }
</style>
)";

constexpr std::string_view kScript = R"(<script>
'use strict';
const all = (selector, within = document) => [...within.querySelectorAll(selector)];
const chosen = kind => new Set(all(`input[data-filter="${kind}"]:checked`).map(box => box.value));

// The steps through the points that are shown and that no other such point beats in both numbers.
function drawFrontier(svg) {
  const path = svg.querySelector('.frontier');
  if (!path) return;
  const points = all('.marker:not(.gone):not(.partial)', svg).map(m => m.dataset.at.split(' ').map(Number));
  points.sort((p, q) => p[0] - q[0] || q[1] - p[1]);
  let lowest = -Infinity, steps = '';
  for (const [x, y] of points) {
    if (y <= lowest) continue;
    lowest = y;
    steps += steps ? `H${x}V${y}` : `M${x} ${y}`;
  }
  path.setAttribute('d', steps || 'M0 0');
}

function applyFilter() {
  const kinds = [...new Set(all('input[data-filter]').map(box => box.dataset.filter))].filter(kind => kind !== 'method');
  const wanted = new Map(kinds.map(kind => [kind, chosen(kind)])), methods = chosen('method');
  const without = part => kinds.some(kind => kind in part.dataset && !wanted.get(kind).has(part.dataset[kind]));
  for (const part of all('article, tr')) part.hidden = without(part);
  for (const fold of all('.fold')) fold.hidden = !all('article', fold).some(a => !a.hidden);
  for (const section of all('section')) section.hidden = !all('article', section).some(a => !a.hidden);
  for (const part of all('[data-key]')) part.classList.toggle('gone', !methods.has(part.dataset.key));
  all('article svg').forEach(drawFrontier);
}

for (const box of all('input[data-filter]')) box.addEventListener('change', applyFilter);
for (const button of all('button[data-set]')) {
  button.addEventListener('click', () => {
    for (const box of all('input', button.closest('fieldset'))) box.checked = button.dataset.set === 'all';
    applyFilter();
  });
}

const hint = document.getElementById('hint');
function explain(marker) {
  const at = marker.getBoundingClientRect();
  hint.textContent = marker.getAttribute('aria-label');
  hint.hidden = false;
  const left = Math.min(at.right + 8, document.documentElement.clientWidth - hint.offsetWidth - 8);
  hint.style.left = `${Math.max(left, 8) + window.scrollX}px`;
  hint.style.top = `${at.bottom + 8 + window.scrollY}px`;
}
for (const marker of all('.marker')) {
  const title = marker.querySelector('title');
  marker.setAttribute('aria-label', title.textContent);
  marker.setAttribute('role', 'img');
  marker.setAttribute('tabindex', '0');
  title.remove();  // the hint takes its place
  for (const begin of ['mouseenter', 'focus']) marker.addEventListener(begin, () => explain(marker));
  for (const end of ['mouseleave', 'blur']) marker.addEventListener(end, () => { hint.hidden = true; });
}
document.addEventListener('keydown', event => { if (event.key === 'Escape') hint.hidden = true; });
all('.script').forEach(part => { part.hidden = false; });
function unfold() {  // what a link or the address leads to
  const fold = document.getElementById(decodeURIComponent(location.hash.slice(1)))?.querySelector('.fold');
  if (fold && !all('article', fold.parentElement).some(a => !fold.contains(a))) fold.open = true;
}
window.addEventListener('hashchange', unfold);
unfold();
applyFilter();  // a browser may have kept the boxes of an earlier visit
</script>
)";

std::string fieldset(const PageFilter& filter) {
  std::string text = fmt::format("<fieldset class=\"script\" hidden><legend>{}</legend>\n", filter.title);
  for (const std::string& name : filter.names) {
    text += fmt::format("<label><input type=\"checkbox\" data-filter=\"{}\" value=\"{}\" checked> {}</label>\n",
                        filter.kind, escaped(name), escaped(name));
  }
  return text +
         "<div><button type=\"button\" data-set=\"all\">all</button>"
         "<button type=\"button\" data-set=\"none\">none</button></div></fieldset>\n";
}

}  // namespace

std::string report_page(const ReportPage& page, const nlohmann::json& raw) {
  const auto text_of = [&raw](const char* key) { return escaped(raw.at(key).get<std::string>()); };
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n",
      escaped(page.title));
  html.append(chart_style).append(kStyle);
  html +=
      fmt::format("</head>\n<body>\n<h1>{}</h1>\n<p class=\"about\">plumb {}, {} ({}), on {}, {}; {}</p>\n<p>{}</p>\n",
                  escaped(page.heading), text_of("version"), text_of("compiler"), text_of("flags"), text_of("machine"),
                  text_of("date"), escaped(page.settings), escaped(page.introduction));
  html += page.opening;
  for (const PageFilter& filter : page.filters) html += fieldset(filter);
  html += page.body;
  std::string data = raw.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  // Within a script nothing may look like its end, or like the beginning of a comment, which would hide that.
  for (std::size_t at = 0; (at = data.find('<', at)) != std::string::npos; at += 6) data.replace(at, 1, "\\u003c");
  html.append("<div id=\"hint\" role=\"status\" hidden></div>\n<script type=\"application/json\" id=\"raw\">");
  html.append(data).append("</script>\n").append(kScript);
  return html.append("</body>\n</html>\n");
}

std::string inline_picture(std::string svg) {
  const std::size_t style = svg.find(chart_style);
  return style == std::string::npos ? svg : svg.erase(style, chart_style.size());
}

}  // namespace plumb::tool
