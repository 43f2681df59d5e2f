// The page's charts: each specification of the page's JSON is drawn in the figure of its name, in the page's scheme.
import * as vega from 'vega';

const given = JSON.parse(document.getElementById('charts').textContent);
const dark = matchMedia('(prefers-color-scheme: dark)');
const root = document.documentElement;
const tip = document.getElementById('tip');
// By name, for whoever wants to ask a chart for its numbers.
globalThis.views = {};

function scheme() {
  return root.dataset.scheme ?? (dark.matches ? 'dark' : 'light');
}

// A tooltip of what a mark carries: pairs of a name and a text; set as text, so that no name can be markup.
function show_tip(handler, event, item, value) {
  tip.hidden = value == null;
  if (tip.hidden) return;
  tip.replaceChildren(...value.map(([name, text]) => {
    const row = document.createElement('div');
    const head = document.createElement('b');
    head.textContent = name ? name + ' ' : '';
    row.append(head, text);
    return row;
  }));
  const right = event.clientX + tip.offsetWidth + 24 > innerWidth;
  tip.style.left = event.clientX + (right ? -tip.offsetWidth - 12 : 12) + 'px';
  tip.style.top = Math.min(event.clientY + 12, innerHeight - tip.offsetHeight - 8) + 'px';
}

async function draw(name) {
  globalThis.views[name]?.finalize();
  const container = document.getElementById(name + '-chart');
  container.replaceChildren();
  const view = new vega.View(vega.parse(given.specs[name], given.configs[scheme()]), {
    renderer: 'svg', container, hover: true, tooltip: show_tip,
  });
  globalThis.views[name] = view;
  await view.runAsync();
}

async function draw_all() {
  for (const name of Object.keys(given.specs)) await draw(name);
  root.dataset.drawn = scheme();
}

dark.addEventListener('change', draw_all);
document.getElementById('scheme').addEventListener('click', () => {
  root.dataset.scheme = scheme() === 'dark' ? 'light' : 'dark';
  draw_all();
});
draw_all();
