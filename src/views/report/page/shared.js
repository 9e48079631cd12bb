// The first part of the page's script: pieces of pages, times, and what plots, frames and controls share.

const data = JSON.parse(document.getElementById('data').textContent);
const page = document.getElementById('page');

// Okabe and Ito's colours, which colour-blind readers can tell apart, each with dashes of its own for print in grey.
const STYLES = [
  {stroke: '#0072B2', dash: []},
  {stroke: '#D55E00', dash: [9, 4]},
  {stroke: '#009E73', dash: [2, 3]},
  {stroke: '#CC79A7', dash: [10, 3, 2, 3]},
  {stroke: '#E69F00', dash: [5, 3]},
  {stroke: '#1b2127', dash: [1, 4]},
  {stroke: '#56B4E9', dash: [14, 4]},
];
const styleOf = run => STYLES[run % STYLES.length];
const FONT = '12px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';
const INK = '#1b2127';

// ---- pieces of the page: text becomes text nodes, never markup

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else if (value !== false && value !== null) made.setAttribute(name, value === true ? '' : value);
  }
  made.append(...children.filter(child => child !== null));
  return made;
}

// The same for SVG.
function drawn(tag, attributes = {}, ...children) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children.filter(child => child !== null));
  return made;
}

function swatch(run) {
  const {stroke, dash} = styleOf(run);
  return drawn('svg', {class: 'swatch', viewBox: '0 0 32 12', 'aria-hidden': 'true'},
    drawn('line', {x1: 0, y1: 6, x2: 32, y2: 6, stroke, 'stroke-width': 3, 'stroke-dasharray': dash.join(' ')}));
}

const runLabel = run => element('span', {}, swatch(run), data.runs[run].name);

function headedTable(kind, head, rows) {
  return element('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'table'},
    element('table', {class: kind},
      element('thead', {}, element('tr', {}, ...head.map(cell => element('th', {scope: 'col'}, ...[cell].flat())))),
      element('tbody', {}, ...rows)));
}

function section(title, ...children) {
  const made = element('section', {}, element('h2', {}, title), ...children);
  page.append(made);
  return made;
}

// Four digits, the same in every language; a thin space groups thousands.
function short(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e7 || size < 1e-3))
    return Number(value.toPrecision(3)).toExponential().replace('e+', 'e');
  const text = size >= 1000 ? value.toFixed(0) : String(Number(value.toPrecision(4)));
  return size >= 10000 ? text.replace(/\B(?=(\d{3})+$)/g, '\u2009') : text;
}

const withUnit = (value, unit) => short(value) + (unit && typeof value === 'number' ? ' ' + unit : '');

// ---- times of rows

const clocks = (data.runs || []).map(run => {
  const {list_s, start_s, step_s} = run.times;
  return list_s ? row => list_s[row] : row => start_s + row * step_s;
});
const withRows = (data.runs || []).map((run, index) => index).filter(index => data.runs[index].times.count > 0);
const first_s = withRows.length ? Math.min(...withRows.map(run => clocks[run](0))) : 0;
const last_s = withRows.length ? Math.max(...withRows.map(run => clocks[run](data.runs[run].times.count - 1))) : 0;
const step_s = withRows.length && last_s > first_s
  ? Math.min(...withRows.filter(run => data.runs[run].times.count > 1)
    .map(run => (clocks[run](data.runs[run].times.count - 1) - clocks[run](0)) / (data.runs[run].times.count - 1)))
  : 1;
const timeText = time => time.toFixed(step_s < 0.0005 ? 4 : 3) + ' s';

// ---- what all plots, frames and controls share

const state = {time: last_s, span: null, hidden: new Set(), chosen: {}};
const plots = [];       // of series over time, drawn now
const listeners = [];   // called with the time
let moving = false;     // while plots are told of a new time

function placeCursor(chart) {
  const left = chart.valToPos(state.time, 'x');
  const inside = left >= 0 && left <= chart.bbox.width / devicePixelRatio;
  moving = true;
  chart.setCursor(inside ? {left, top: 0} : {left: -10, top: -10}, false);
  moving = false;
}

function setTime(time) {
  state.time = Math.min(last_s, Math.max(first_s, time));
  for (const {chart} of plots) placeCursor(chart);
  for (const listener of listeners) listener(state.time);
}

let wanted = null;
function setTimeSoon(time) {
  if (wanted === null) requestAnimationFrame(() => { const next = wanted; wanted = null; setTime(next); });
  wanted = time;
}

function setSpan(span) {
  state.span = span;
  for (const {chart} of plots) chart.setScale('x', {min: span ? span[0] : first_s, max: span ? span[1] : last_s});
  for (const button of document.querySelectorAll('.whole')) button.hidden = !span;
}

function setHidden(run, hide) {
  if (hide === state.hidden.has(run)) return;
  if (hide) state.hidden.add(run); else state.hidden.delete(run);
  for (const plot of plots.concat(stepPlots)) {
    moving = true;
    plot.runs.forEach((shown, index) => { if (shown === run) plot.chart.setSeries(index + 1, {show: !hide}); });
    moving = false;
  }
  for (const box of document.querySelectorAll('input[data-run="' + run + '"]')) box.checked = !hide;
  for (const figure of document.querySelectorAll('figure[data-run="' + run + '"]')) figure.hidden = hide;
}
