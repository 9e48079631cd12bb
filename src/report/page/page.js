(() => {
'use strict';

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

function swatch(run) {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  const line = document.createElementNS('http://www.w3.org/2000/svg', 'line');
  const {stroke, dash} = styleOf(run);
  const set = (node, values) => Object.entries(values).forEach(([name, value]) => node.setAttribute(name, value));
  set(svg, {class: 'swatch', viewBox: '0 0 32 12', 'aria-hidden': 'true'});
  set(line, {x1: 0, y1: 6, x2: 32, y2: 6, stroke, 'stroke-width': 3, 'stroke-dasharray': dash.join(' ')});
  svg.append(line);
  return svg;
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
  if (size !== 0 && (size >= 1e7 || size < 1e-3)) return String(Number(value.toPrecision(3)).toExponential()).replace('e+', 'e');
  const text = size >= 1000 ? value.toFixed(0) : String(Number(value.toPrecision(4)));
  return size >= 10000 ? text.replace(/\B(?=(\d{3})+$)/g, '\u2009') : text;
}

const withUnit = (value, unit) => value === null || value === undefined ? '–' : short(value) + (unit ? ' ' + unit : '');

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

// ---- plots

const stepPlots = [];

// A gap of one run goes on where only others have points (2: uPlot's NULL_EXPAND).
function joined(tables) {
  return tables.length === 1 ? tables[0] : uPlot.join(tables, tables.map(() => [2, 2]));
}

function pointsOf(series, log) {
  let row = 0;
  const clock = clocks[series.run];
  return [series.rows.map(more => clock(row += more)), log ? series.values.map(v => v > 0 ? v : null) : series.values];
}

// Runs are sampled at different rows: what a run shows under the cursor is its own nearest point.
function nearestPoint(chart, series, index, x) {
  const values = chart.data[series], xs = chart.data[0];
  let before = index, after = index;
  while (before >= 0 && values[before] === undefined) --before;
  while (after < values.length && values[after] === undefined) ++after;
  if (before < 0) return after < values.length ? after : index;
  if (after >= values.length) return before;
  return x - xs[before] <= xs[after] - x ? before : after;
}

const tick = {stroke: '#c3c9d0', width: 1, size: 5};
const grid = {stroke: '#e8ebee', width: 1};

function axes(label, values, more = {}) {
  return [
    {label, labelFont: FONT, labelSize: 18, labelGap: -2, size: 30, gap: 3, font: FONT, stroke: INK, ticks: tick, grid, ...more},
    {size: 58, gap: 4, font: FONT, stroke: INK, ticks: tick, grid, values, space: 28},
  ];
}

function seriesOptions(runs, value) {
  return runs.map(run => ({
    label: runLabel(run),
    stroke: styleOf(run).stroke,
    dash: styleOf(run).dash,
    width: 2,
    show: !state.hidden.has(run),
    points: {show: (chart, index) => chart.data[index].filter(v => v !== undefined && v !== null).length < 2},
    value: (chart, v) => value(v),
  }));
}

const chartHeight = () => innerWidth <= 600 ? 190 : 220;

function commonOptions(holder, runs) {
  return {
    width: Math.max(200, holder.clientWidth),
    height: chartHeight(),
    padding: [10, 14, 0, 0],
    legend: {markers: {show: false}},
    hooks: {
      setSeries: [(chart, index, change) => {
        if (!moving && index > 0 && change.show !== undefined) setHidden(runs[index - 1], !change.show);
      }],
    },
  };
}

function yScale(plot, log) {
  if (log) return {distr: 3};
  return {range: (chart, min, max) => {
    if (min === null || min === undefined) return [0, 1];
    if (plot.from_zero) { min = Math.min(0, min); max = Math.max(0, max); }
    if (min === 0 && max === 0) return [0, 1];
    const margin = (max - min || Math.abs(max)) * 0.06;
    return [plot.from_zero && min === 0 ? 0 : min - margin, plot.from_zero && max === 0 ? 0 : max + margin];
  }};
}

function drawTimePlot(plot, holder, log) {
  const variant = plot.variants[Math.min(state.chosen[plot.select] ?? 0, plot.variants.length - 1)];
  const series = variant.series;
  const runs = series.map(one => one.run);
  const options = commonOptions(holder, runs);
  const flat = last_s > first_s ? 0 : 0.5 * step_s;
  options.scales = {
    x: {time: false, range: (chart, min, max) => state.span ?? [first_s - flat, last_s + flat]},
    y: yScale(plot, log),
  };
  options.axes = axes('time, s', (chart, marks) => marks.map(mark => mark === null ? '' : short(mark)),
    {values: (chart, marks) => marks.map(mark => String(Number(mark.toPrecision(6)))), space: 60});
  if (log) Object.assign(options.axes[1], {splits: (chart, axis, min, max) => valueMarks(min, max), filter: (chart, marks) => marks});
  options.series = [{label: 'Time', value: (chart, v) => v === null ? '–' : timeText(v)},
    ...seriesOptions(runs, v => withUnit(v, plot.unit))];
  options.cursor = {
    y: false,
    drag: {x: true, y: false, setScale: false},
    dataIdx: nearestPoint,
    points: {show: false},  // where equal values were dropped, the nearest point is far from the cursor
    bind: {
      mouseleave: () => null,
      dblclick: () => () => setSpan(null),
    },
  };
  // uPlot moves, scales and sizes a chart later than it is told to.
  options.hooks.ready = options.hooks.setSize = options.hooks.setScale = [placeCursor];
  options.hooks.setCursor = [chart => {
    if (!moving && chart.cursor.left >= 0) setTimeSoon(chart.posToVal(chart.cursor.left, 'x'));
  }];
  options.hooks.setSelect = [chart => {
    const {left, width} = chart.select;
    if (width < 5) return;
    const span = [chart.posToVal(left, 'x'), chart.posToVal(left + width, 'x')];
    chart.setSelect({left: 0, top: 0, width: 0, height: 0}, false);
    setSpan(span);
  }];
  holder.setAttribute('aria-label', spokenPlot(plot, variant));
  const entry = {chart: null, runs, holder};
  entry.chart = new uPlot(options, joined(series.map(one => pointsOf(one, log))), holder);
  plots.push(entry);
  return entry;
}

function spokenPlot(plot, variant) {
  const ends = variant.series.map(one => {
    const known = one.values.filter(v => v !== null);
    return data.runs[one.run].name + ' from ' + withUnit(Math.min(...known), plot.unit) + ' to ' +
      withUnit(Math.max(...known), plot.unit);
  });
  return plot.title + (variant.label ? ', ' + variant.label : '') + ', over time: ' + ends.join('; ');
}

function timePlot(plot) {
  const holder = element('div', {role: 'img'});
  const choice = element('span', {class: 'soft'});
  const negative = plot.variants.some(variant => variant.series.some(one => one.values.some(v => v < 0)));
  let entry = null;
  let log = plot.far_apart;
  const redraw = () => {
    if (entry) {
      entry.chart.destroy();
      plots.splice(plots.indexOf(entry), 1);
    }
    const index = Math.min(state.chosen[plot.select] ?? 0, plot.variants.length - 1);
    choice.textContent = plot.select ? plot.variants[index].label : '';
    const any = plot.variants[index].series.length > 0;
    entry = any ? drawTimePlot(plot, holder, log) : null;
    holder.classList.toggle('empty', !any);
  };
  const button = negative ? null : element('button', {type: 'button', 'aria-pressed': String(log), title: 'logarithmic axis', onclick: () => {
    log = !log;
    button.setAttribute('aria-pressed', String(log));
    redraw();
  }}, 'log');
  const missing = plot.missing.length === 0 ? null
    : element('span', {class: 'note'}, 'No values of ' + plot.missing.map(run => data.runs[run].name).join(', ') + '.');
  const figure = element('figure', {class: 'plot', 'data-plot': plot.id},
    element('figcaption', {}, element('h3', {}, plot.title + (plot.unit ? ', ' + plot.unit : '')), choice, button,
      plot.note ? element('span', {class: 'note'}, plot.note) : null, missing),
    holder);
  figure.redraw = redraw;
  return figure;
}

function plotSection(title, all) {
  const drawn = all.filter(plot => plot.variants.length > 0);
  const zero = all.filter(plot => plot.constant_zero).map(plot => plot.title.toLowerCase());
  const unknown = all.filter(plot => !plot.constant_zero && plot.variants.length === 0).map(plot => plot.title.toLowerCase());
  const grid = element('div', {class: 'plots'}, ...drawn.map(timePlot));
  section(title, drawn.length ? grid : null,
    zero.length ? element('p', {class: 'soft'}, '0 throughout in every run: ' + zero.join(', ') + '.') : null,
    unknown.length ? element('p', {class: 'soft'}, 'Not measured in any run: ' + unknown.join(', ') + '.') : null);
  for (const figure of grid.children) figure.redraw();
}

// ---- step times

function microseconds(value) {
  if (value === null || value === undefined) return '–';
  return value >= 1e6 ? short(value / 1e6) + ' s' : value >= 1000 ? short(value / 1000) + ' ms' : short(value) + ' µs';
}

// 1, 2, ... 9 of each power of ten.
function logMarks(min, max) {
  const marks = [];
  for (let power = Math.floor(Math.log10(min)); power <= Math.log10(max); ++power)
    for (let digit = 1; digit < 10; ++digit) marks.push(Number(digit + 'e' + power));
  return marks.filter(mark => mark >= min && mark <= max);
}

// Of a logarithmic value axis: powers of ten alone, and not all of very many.
function valueMarks(min, max) {
  const marks = logMarks(min, max), powers = marks.filter(mark => Number.isInteger(Math.log10(mark)));
  if (powers.length < 3) return marks.filter(mark => /^[125]/.test(mark.toExponential()));
  const skip = Math.ceil(powers.length / 7);
  return powers.filter((mark, index) => index % skip === 0);
}

function drawBudget(chart) {
  const x = Math.round(chart.valToPos(data.step_times.budget_us, 'x', true));
  const {top, height} = chart.bbox, context = chart.ctx, ratio = devicePixelRatio;
  context.save();
  context.setLineDash([]);
  context.strokeStyle = context.fillStyle = '#a3250f';
  context.lineWidth = 2 * ratio;
  context.beginPath();
  context.moveTo(x, top);
  context.lineTo(x, top + height);
  context.stroke();
  context.font = 'bold ' + 12 * ratio + 'px sans-serif';
  context.textAlign = 'left';
  context.textBaseline = 'bottom';
  context.fillText('1 ms', x + 5 * ratio, top + height - 5 * ratio);
  context.restore();
}

function drawStepTimes(holder) {
  const all = data.step_times.runs;
  const runs = all.map(one => one.run);
  const options = commonOptions(holder, runs);
  options.padding = [10, 24, 0, 0];
  options.scales = {
    x: {time: false, distr: 3, range: (chart, min, max) =>
      [Math.min(min, 95) / 1.2, Math.max(max, data.step_times.budget_us) * 1.5]},
    y: {range: () => [0, 102]},
  };
  options.axes = axes('time of a step', (chart, marks) => marks.map(mark => mark + ' %'), {
    splits: (chart, axis, min, max) => logMarks(min, max),
    values: (chart, marks) => marks.map(mark => Number.isInteger(Math.log10(mark)) ? microseconds(mark) : ''),
    filter: (chart, marks) => marks,
  });
  options.series = [{label: 'Within', value: (chart, v) => microseconds(v)},
    ...seriesOptions(runs, v => v === null || v === undefined ? '–' : v.toFixed(1) + ' %')];
  options.cursor = {y: false, drag: {x: false, y: false}, dataIdx: nearestPoint, points: {show: false}};
  options.hooks.draw = [drawBudget];
  holder.setAttribute('aria-label', 'Share of steps by the time they took: ' +
    all.map(one => data.runs[one.run].name + ' half within ' + microseconds(one.p50_us) + ', 99 % within ' + microseconds(one.p99_us)).join('; '));
  const tables = all.map(one => [one.curve_us, one.curve_percent]).map(([xs, ys]) => {
    const kept = xs.map((x, i) => i + 1 === xs.length || x !== xs[i + 1]);  // equal times: the last share
    return [xs.filter((x, i) => kept[i]), ys.filter((y, i) => kept[i])];
  });
  stepPlots.push({chart: new uPlot(options, joined(tables), holder), runs, holder});
}

function stepTimeSection() {
  const all = data.step_times.runs;
  if (all.length === 0) return;
  const holder = element('div', {role: 'img'});
  const rows = all.map(one => element('tr', {},
    element('th', {scope: 'row'}, runLabel(one.run)),
    ...[one.p50_us, one.p99_us, one.max_us].map(value => element('td', {}, microseconds(value))),
    element('td', {class: one.over_budget > 0 ? 'bad' : ''},
      one.over_budget + ' (' + (100 * one.over_budget / one.steps).toPrecision(2) * 1 + ' %)'),
    element('td', {}, String(one.steps))));
  section('Step time', element('div', {class: 'plots wide'},
    element('figure', {class: 'plot', 'data-plot': 'step_time'},
      element('figcaption', {}, element('h3', {}, 'Steps within a time, %'),
        element('span', {class: 'note'}, 'wall time of a step without measuring and writing; the line is the 1 ms that a haptic loop has')),
      holder),
    headedTable('numbers', ['run', 'median', '99 % below', 'longest', 'above 1 ms', 'steps'], rows)));
  drawStepTimes(holder);
}

// ---- frames

function frameSection() {
  const frames = data.frames;
  if (!frames) return;
  const grid = element('div', {class: frames.runs.length === 1 ? 'frames single' : 'frames'});
  for (const one of frames.runs) {
    const picture = element('img', {alt: 'frame of ' + data.runs[one.run].name, src: one.images[0], 'data-frame': 0});
    const when = element('span', {class: 'soft'});
    grid.append(element('figure', {'data-run': one.run}, element('figcaption', {}, runLabel(one.run), when), picture));
    listeners.push(time => {
      let index = 0;
      while (index + 1 < one.times_s.length && one.times_s[index + 1] <= time + 0.01 * step_s) ++index;
      if (picture.dataset.frame !== String(index) || !when.textContent) {
        picture.src = one.images[index];
        picture.dataset.frame = index;
        when.textContent = 'at ' + timeText(one.times_s[index]);
      }
    });
  }
  const thinned = frames.shown < frames.stored
    ? ' ' + frames.shown + ' of the ' + frames.stored + ' stored frames are shown here, evenly spread.' : '';
  section('Frames', element('p', {class: 'soft'}, 'The last frame up to the time of the cursor. Pictures are compressed' + (frames.smaller ? ' and smaller than stored.' : '.') + thinned), grid);
}

// ---- controls

function frameTimes() {
  return [...new Set((data.frames ? data.frames.runs : []).flatMap(one => one.times_s))].sort((a, b) => a - b);
}

function stepTime(direction, fine) {
  const times = frameTimes(), small = 0.01 * step_s;
  if (fine) return setTime(state.time + direction * step_s);
  if (times.length < 2) return setTime(state.time + direction * Math.max(step_s, (last_s - first_s) / 100));
  const next = direction > 0 ? times.find(time => time > state.time + small) : times.filter(time => time < state.time - small).pop();
  setTime(next ?? (direction > 0 ? last_s : first_s));
}

function onKey(event) {
  const direction = {ArrowLeft: -1, ArrowRight: 1}[event.key];
  if (!direction || event.ctrlKey || event.altKey || event.metaKey) return;
  if (event.target.closest('select, summary, video, .scroll, input[type=checkbox]')) return;
  event.preventDefault();
  stepTime(direction, event.shiftKey);
}

function playButton() {
  let began = null;
  const button = element('button', {type: 'button', onclick: () => {
    if (began) { began = null; button.textContent = 'Play'; return; }
    const from = state.time >= last_s ? first_s : state.time;
    const seconds = Math.max(5, last_s - first_s);  // short runs in slow motion
    button.textContent = 'Stop';
    const mine = began = {at: performance.now()};
    const go = now => {
      if (began !== mine) return;
      setTime(from + Math.max(0, now - mine.at) / 1000 * (last_s - first_s) / seconds);
      if (state.time < last_s) requestAnimationFrame(go);
      else { began = null; button.textContent = 'Play'; }
    };
    requestAnimationFrame(go);
  }}, 'Play');
  return button;
}

function timeControls() {
  const slider = element('input', {type: 'range', id: 'time', min: first_s, max: last_s, step: step_s, 'aria-label': 'time, seconds'});
  const shown = element('output', {for: 'time'});
  slider.addEventListener('input', () => setTime(Number(slider.value)));
  listeners.push(time => {
    slider.value = time;
    slider.setAttribute('aria-valuetext', timeText(time));
    shown.textContent = timeText(time);
  });
  document.addEventListener('keydown', onKey);
  return element('div', {class: 'time'}, playButton(), slider, shown);
}

function selector(axis, label) {
  const plot = data.plots.filter(one => one.select === axis && one.variants.length > 0)
    .sort((a, b) => b.variants.length - a.variants.length)[0];
  if (!plot) return null;
  state.chosen[axis] = plot.preferred;
  if (plot.variants.length < 2) return null;
  const select = element('select', {'data-select': axis, onchange: () => {
    state.chosen[axis] = select.selectedIndex;
    for (const one of document.querySelectorAll('.plot')) {
      const about = data.plots.find(known => known.id === one.dataset.plot);
      if (about && about.select === axis) one.redraw();
    }
  }}, ...plot.variants.map((variant, index) => element('option', {selected: index === plot.preferred}, variant.label)));
  return element('label', {}, label, select);
}

function controls() {
  const bar = element('div', {class: 'controls', role: 'group', 'aria-label': 'time and choices'});
  if (withRows.length) bar.append(timeControls());
  for (const made of [selector('law', 'Force law '), selector('xyz', 'Direction ')]) if (made) bar.append(made);
  const runs = element('span', {class: 'runs'});
  for (const run of withRows) {
    const box = element('input', {type: 'checkbox', checked: true, 'data-run': run, onchange: () => setHidden(run, !box.checked)});
    runs.append(element('label', {}, box, runLabel(run)));
  }
  if (withRows.length > 1) bar.append(runs);
  const whole = element('button', {type: 'button', class: 'whole', onclick: () => setSpan(null)}, 'Whole time');
  whole.hidden = true;
  bar.append(whole);
  if (withRows.length) page.append(bar);
}

// ---- texts and tables

function heading() {
  document.documentElement.classList.add('drawn');
  page.append(element('header', {},
    element('h1', {}, data.title),
    data.description ? element('p', {}, data.description) : null,
    data.file ? element('p', {class: 'soft'}, data.file, createdText()) : null));
}

function createdText() {
  const made = new Map(data.provenance);
  const parts = [made.get('ended_utc'), made.get('version') && 'fissure ' + made.get('version'), made.get('cpu_model')];
  const known = parts.filter(part => part);
  return known.length ? ' · ' + known.join(' · ') : '';
}

function warnings() {
  if (data.warnings.length === 0) return;
  page.append(element('ul', {class: 'warnings', 'aria-label': 'warnings'}, ...data.warnings.map(warning => {
    const about = warning.runs.length === 0 ? null
      : element('b', {}, warning.runs.map(run => data.runs[run].name).join(', ') + ': ');
    return element('li', {class: warning.serious ? 'serious' : ''}, about, warning.text);
  })));
}

function numberTable(table, kind) {
  return headedTable(kind, ['', ...data.runs.map((run, index) => runLabel(index))], table.map(row => element('tr', {},
    element('th', {scope: 'row'}, row.label + (row.unit ? ', ' + row.unit : '')),
    ...row.cells.map(cell => element('td', {class: cell.bad ? 'bad' : ''}, cell.text)))));
}

function summary() {
  if (data.runs.length === 0) return;
  const table = numberTable(data.key_numbers, 'numbers');
  const rows = [
    ['Status', run => run.status, run => run.status === 'ok' ? 'good' : 'bad'],
    ['Pipeline', run => run.pipeline + (run.precision ? ', ' + run.precision : ''), () => ''],
  ].map(([label, text, kind]) => element('tr', {}, element('th', {scope: 'row'}, label),
    ...data.runs.map(run => element('td', {class: kind(run)}, text(run)))));
  table.querySelector('tbody').prepend(...rows);
  section('Side by side', table, expectations(),
    element('details', {}, element('summary', {}, 'All summary values'), numberTable(data.all_numbers, 'numbers')),
    element('details', {}, element('summary', {}, 'What the pipelines are'),
      element('ul', {}, ...data.runs.map((run, index) => element('li', {}, runLabel(index), ': ' + run.description)))));
}

function expectations() {
  const all = data.expectations;
  if (all.length === 0) return null;
  const held = all.filter(one => one.holds).length;
  return element('details', {open: held < all.length},
    element('summary', {}, 'Expectations of the scenario: ' + held + ' of ' + all.length + ' hold'),
    headedTable('text', ['', 'run', 'quantity', 'found', 'expected'], all.map(one => element('tr', {},
      element('td', {class: one.holds ? 'good' : 'bad'}, one.holds ? '✓ holds' : '✗ fails'),
      ...[one.run, one.quantity, one.found, one.expected].map(text => element('td', {}, text))))));
}

function video() {
  if (data.video) section('Video', element('video', {controls: true, src: data.video, preload: 'metadata'}));
}

function provenance() {
  const made = section('Scenario and provenance');
  if (data.scenario) made.append(element('details', {}, element('summary', {}, 'Scenario, every default written out'), element('pre', {}, data.scenario)));
  if (data.provenance.length) made.append(element('details', {open: true}, element('summary', {}, 'Provenance'),
    headedTable('text', ['', ''], data.provenance.map(([name, value]) => element('tr', {}, element('th', {scope: 'row'}, name), element('td', {}, value))))));
}

function footer() {
  page.append(element('footer', {}, 'Made by ' + data.program + '. Plots: uPlot 1.6.32, MIT licence. ',
    data.kind === 'result' ? 'Series are thinned out; the smallest and the largest values of each span are kept.' : ''));
}

// ---- a folder of results

function folderRows(result) {
  const name = result.page ? element('a', {href: result.page}, result.name) : result.name;
  if (result.problem) return [element('tr', {}, element('th', {scope: 'row'}, name),
    element('td', {class: 'problem', colspan: data.columns.length + 2}, result.problem))];
  const rows = result.runs.map((run, index) => element('tr', {},
    index > 0 ? null : element('th', {scope: 'row', rowspan: result.runs.length}, name, element('br'), element('span', {class: 'soft'}, result.title)),
    element('td', {class: 'left'}, run.name),
    element('td', {class: run.status === 'ok' ? 'left good' : 'left bad'}, run.status),
    ...result.numbers[index].map(cell => element('td', {class: cell.bad ? 'bad' : ''}, cell.text))));
  return rows.length ? rows : [element('tr', {}, element('th', {scope: 'row'}, name), element('td', {colspan: data.columns.length + 2}, 'no run'))];
}

function folder() {
  heading();
  page.append(element('p', {class: 'soft'}, data.results.length + (data.results.length === 1 ? ' result' : ' results')));
  page.append(headedTable('results', ['result', 'run', 'status', ...data.columns.map(column => column.label + (column.unit ? ', ' + column.unit : ''))],
    data.results.flatMap(folderRows)));
  footer();
}

// ---- the page of one result

function worstTime() {
  const depth = data.plots.find(plot => plot.id === 'penetration_depth');
  let worst = 0, time = last_s;
  for (const series of depth && depth.variants.length ? depth.variants[0].series : []) {
    const [times, values] = pointsOf(series, false);
    values.forEach((value, index) => { if (value > worst) { worst = value; time = times[index]; } });
  }
  return time;
}

function fitPlots(width) {
  for (const {chart, holder} of plots.concat(stepPlots)) {
    const size = {width: width || Math.max(200, holder.clientWidth), height: chartHeight()};
    if (size.width !== chart.width || size.height !== chart.height) chart.setSize(size);
  }
}

function result() {
  heading();
  warnings();
  summary();
  controls();
  frameSection();
  video();
  const sections = [...new Set(data.plots.map(plot => plot.section))];
  const timingBefore = sections.indexOf('Energy and volume');
  sections.forEach((title, index) => {
    if (index === timingBefore) stepTimeSection();
    plotSection(title, data.plots.filter(plot => plot.section === title));
  });
  if (timingBefore < 0) stepTimeSection();
  provenance();
  footer();
  setTime(worstTime());
  let width = innerWidth;
  addEventListener('resize', () => { if (innerWidth !== width) { width = innerWidth; fitPlots(); } });
  addEventListener('beforeprint', () => fitPlots(335));  // two on A4 and on Letter
  addEventListener('afterprint', () => fitPlots());
}

page.replaceChildren();
if (data.kind === 'folder') folder(); else result();
})();
