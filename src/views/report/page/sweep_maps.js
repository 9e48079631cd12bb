// ---- maps: any quantity over any two axes, a panel a pipeline

const maps = {x: null, y: null, metric: null, reduce: 1, fixed: new Map(), log: null, logNow: false, panels: [],
  readout: null, bar: null, barTitle: null};
const REDUCTIONS = ['smallest', 'median', 'largest'];

// Cells need few values along both axes; everything else is drawn as points.
const drawsCells = () => maps.y !== null && maps.x.levels !== null && maps.y.levels !== null && data.design === 'grid';
const others = () => drawsCells() ? varying.filter(axis => axis !== maps.x && axis !== maps.y && axis.levels) : [];
const fits = run => others().every(axis => (maps.fixed.get(axis) ?? null) === null ||
  axis.codes[run] === maps.fixed.get(axis));

function reduced(runs) {
  const sorted = runs.filter(run => !Number.isNaN(maps.metric.values[run]))
    .sort((a, b) => maps.metric.values[a] - maps.metric.values[b]);
  return sorted.length ? sorted[[0, (sorted.length - 1) >> 1, sorted.length - 1][maps.reduce]] : null;
}

// The cells of a panel: their runs, the run whose value is drawn (null where none has one), and the one that is
// read out.
function cellsOf(pipeline) {
  const cells = new Map(), wide = maps.y.levels.length;
  for (let run = 0; run < RUNS; ++run) {
    if (pipelineOf[run] !== pipeline || !fits(run)) continue;
    const key = maps.x.codes[run] * wide + maps.y.codes[run];
    if (!cells.has(key)) cells.set(key, {x: maps.x.codes[run], y: maps.y.codes[run], good: [], bad: [], missing: []});
    const cell = cells.get(key);
    [cell.good, cell.missing, cell.bad][endOf[run]].push(run);
  }
  for (const cell of cells.values()) {
    cell.run = reduced(cell.good);
    cell.spoken = cell.run ?? cell.good[0] ?? cell.bad[0] ?? cell.missing[0];
    cell.all = [...cell.good, ...cell.bad, ...cell.missing];
    cell.inside = cell.all.some(run => chosen.inside[run]);
    cell.pinned = cell.all.includes(chosen.pinned);
  }
  return cells;
}

function drawCell(context, cell, box, colour) {
  const {x, y, width, height} = box;
  context.globalAlpha = cell.inside ? 1 : 0.2;
  if (cell.run !== null) {
    context.fillStyle = colourAt(colour.at(maps.metric.values[cell.run]));
    context.fillRect(x, y, width, height);
  } else if (cell.good.length) {
    openCircle(context, x + width / 2, y + height / 2, Math.min(4, width / 3, height / 3));
  } else if (cell.bad.length) {
    context.fillStyle = '#fdeeea';
    context.fillRect(x, y, width, height);
    cross(context, x + width / 2, y + height / 2, Math.min(6, width / 3, height / 3));
  } else {
    hatch(context, x, y, width, height);
  }
  if (cell.good.length && cell.bad.length) {
    context.fillStyle = '#fff';
    context.fillRect(x + width - 9, y, 9, 9);
    cross(context, x + width - 4.5, y + 4.5, 3);
  }
  context.globalAlpha = 1;
  if (cell.pinned) {
    context.strokeStyle = '#fff';
    context.lineWidth = 4;
    context.strokeRect(x + 1, y + 1, width - 2, height - 2);
    context.strokeStyle = '#000';
    context.lineWidth = 2;
    context.strokeRect(x + 1, y + 1, width - 2, height - 2);
  }
}

// Colours from the smallest to the largest value that is drawn, the same in all panels.
function colourScale() {
  const drawn = drawsCells()
    ? maps.panels.flatMap(panel => [...panel.cells.values()].map(cell => cell.run).filter(run => run !== null))
    : allRuns.filter(run => endOf[run] === GOOD);
  const values = drawn.map(run => maps.metric.values[run]).filter(Number.isFinite).sort((a, b) => a - b);
  if (values.length === 0) return scaleOf(maps.metric, false);
  const [min, max] = [values[0], values[values.length - 1]];
  maps.logNow = maps.log ?? (min > 0 && max > 100 * min);
  return scaleOf({...maps.metric, min, max, values}, maps.logNow);
}

function drawCells(panel, context, width, height, colour) {
  const columns = maps.x.levels.length, rows = maps.y.levels.length;
  const cell = {width: (width - MARGIN.left - MARGIN.right) / columns,
    height: (height - MARGIN.top - MARGIN.bottom) / rows};
  panel.boxOf = one => ({x: MARGIN.left + one.x * cell.width, y: MARGIN.top + (rows - 1 - one.y) * cell.height,
    width: cell.width + 0.5, height: cell.height + 0.5});
  for (const one of panel.cells.values()) if (!one.pinned) drawCell(context, one, panel.boxOf(one), colour);
  for (const one of panel.cells.values()) if (one.pinned) drawCell(context, one, panel.boxOf(one), colour);
  const marks = axis => (axis.told ?? axis.levels.map(short)).map((text, i) =>
    [(i + 0.5) / axis.levels.length, text]);
  drawAxes(panel, context, width, height, marks(maps.x), marks(maps.y));
}

function drawPoints(panel, context, width, height, colour) {
  const xScale = scaleOf(maps.x), yScale = scaleOf(maps.y ?? maps.metric);
  const inner = {width: width - MARGIN.left - MARGIN.right - 12, height: height - MARGIN.top - MARGIN.bottom - 12};
  const yOf = run => (maps.y ?? maps.metric).values[run];
  panel.dots = [];
  for (const run of allRuns) {
    if (pipelineOf[run] !== panel.pipeline) continue;
    const up = yScale.at(yOf(run));
    panel.dots.push({run, x: MARGIN.left + 6 + xScale.at(maps.x.values[run]) * inner.width,
      y: MARGIN.top + 6 + (1 - (Number.isNaN(up) ? 0 : up)) * inner.height});
  }
  const order = dot => (dot.run === chosen.pinned ? 2 : chosen.inside[dot.run]);
  for (const dot of [...panel.dots].sort((a, b) => order(a) - order(b))) drawDot(context, dot, colour);
  const shift = (marks, span) => marks.map(([at, text]) => [(6 + at * span) / (span + 12), text]);
  drawAxes(panel, context, width, height, shift(xScale.marks(width < 340 ? 4 : 7), inner.width),
    shift(yScale.marks(7), inner.height));
}

function drawDot(context, {run, x, y}, colour) {
  context.globalAlpha = chosen.inside[run] ? 0.95 : 0.12;
  const value = maps.metric.values[run], size = RUNS > 3000 ? 2.5 : 3.8;
  if (endOf[run] === BAD) {
    cross(context, x, y, size);
  } else {
    context.beginPath();
    context.arc(x, y, size, 0, 2 * Math.PI);
    context.fillStyle = Number.isNaN(value) ? '#fff' : colourAt(colour.at(value));
    context.fill();
    context.lineWidth = 0.8;
    context.strokeStyle = Number.isNaN(value) ? '#6e7781' : 'rgba(27,33,39,.45)';
    context.stroke();
  }
  context.globalAlpha = 1;
  if (run !== chosen.pinned) return;
  context.lineWidth = 2.5;
  context.strokeStyle = '#000';
  context.beginPath();
  context.arc(x, y, 8, 0, 2 * Math.PI);
  context.stroke();
}

function drawMaps() {
  for (const panel of maps.panels) {
    panel.cells = drawsCells() ? cellsOf(panel.pipeline) : null;
    panel.dots = null;
  }
  const colour = colourScale();
  for (const box of document.querySelectorAll('#logColours')) box.checked = maps.logNow;
  maps.barTitle.textContent = maps.metric.title + (maps.logNow ? ' (logarithmic)' : '');
  for (const panel of maps.panels) {
    const width = Math.max(220, panel.holder.clientWidth);
    const height = Math.round(Math.min(330, Math.max(230, width * 0.75)));
    const context = prepared(panel.canvas, width, height);
    (drawsCells() ? drawCells : drawPoints)(panel, context, width, height, colour);
  }
  drawColourBar(colour);
}

function drawColourBar(colour) {
  const width = Math.min(420, Math.max(240, maps.bar.parentElement.clientWidth)),
    context = prepared(maps.bar, width, 36);
  for (let x = 20; x < width - 20; ++x) {
    context.fillStyle = colourAt((x - 20) / (width - 41));
    context.fillRect(x, 2, 1.5, 14);
  }
  context.fillStyle = INK;
  context.textAlign = 'center';
  context.textBaseline = 'top';
  let last = -Infinity;
  for (const [at, text] of colour.marks(6)) {
    const x = 20 + at * (width - 41), half = context.measureText(text).width / 2;
    if (x - half < last + 8) continue;
    context.fillRect(x, 14, 1, 5);
    context.fillText(text, x, 21);
    last = x + half;
  }
}

// ---- pointer, keys and what they read out

function spokenRun(run) {
  const values = varying.map(axis => axis.label + ' ' + axis.show(axis.values[run])).join(', ');
  const value = maps.metric.values[run];
  const good = () => Number.isNaN(value) ? 'no ' + maps.metric.label : maps.metric.label + ' ' + maps.metric.show(value);
  const end = endOf[run] === GOOD ? good()
    : endOf[run] === MISSING ? 'not run' : statusOf(run) + (detailOf(run) ? ': ' + detailOf(run) : '');
  return pipelines[pipelineOf[run]] + ', ' + values + ': ' + end +
    ' · run ' + numberOf(run) + ', point ' + points[run] + (fileOf(run) ? ', ' + fileOf(run) : '');
}

function spokenCell(cell) {
  const standing = cell.run === null ? 'one' : 'the ' + REDUCTIONS[maps.reduce];
  const counted = [[cell.good, 'good'], [cell.bad, 'failed'], [cell.missing, 'not run']].filter(([runs]) => runs.length)
    .map(([runs, word]) => runs.length + ' ' + word).join(', ');
  return spokenRun(cell.spoken) + (cell.all.length > 1 ? ' · ' + standing + ' of ' + cell.all.length +
    ' runs (' + counted + ')' : '');
}

function found(panel, x, y) {
  if (panel.cells) return [...panel.cells.values()].find(cell => {
    const box = panel.boxOf(cell);
    return x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height;
  }) ?? null;
  let best = null, least = 16 * 16;
  for (const dot of panel.dots) {
    const far = (dot.x - x) ** 2 + (dot.y - y) ** 2;
    if (far < least) [best, least] = [dot, far];
  }
  return best;
}

const runAt = spot => spot.all ? spot.spoken : spot.run;
const spoken = spot => spot.all ? spokenCell(spot) : spokenRun(spot.run);

function readOut(spot) {
  if (spot) maps.readout.textContent = spoken(spot);
}

// From the pinned spot to the next one in a direction.
function stepOnMap(panel, key) {
  const [dx, dy] = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[key];
  const spots = panel.cells ? [...panel.cells.values()] : panel.dots;
  const here = spots.find(spot => spot.all ? spot.pinned : spot.run === chosen.pinned) ?? null;
  const sign = panel.cells ? 1 : -1;  // points count downwards
  if (!here) return spots[0] ?? null;
  let best = null, least = Infinity;
  for (const spot of spots) {
    const ahead = dx * (spot.x - here.x) + sign * dy * (spot.y - here.y);
    const aside = Math.abs(dy * (spot.x - here.x)) + Math.abs(dx * (spot.y - here.y));
    if (ahead > 0 && ahead + 3 * aside < least) [best, least] = [spot, ahead + 3 * aside];
  }
  return best ?? here;
}

function mapPanel(pipeline) {
  const canvas = element('canvas', {tabindex: '0', role: 'img', 'data-pipeline': pipelines[pipeline]});
  const labels = element('div', {}), holder = element('div', {class: 'labelled'}, canvas, labels);
  const panel = {pipeline, canvas, holder, labels, cells: null, dots: null};
  const spot = event => {
    const box = canvas.getBoundingClientRect();
    return found(panel, event.clientX - box.left, event.clientY - box.top);
  };
  canvas.addEventListener('pointermove', event => readOut(spot(event)));
  canvas.addEventListener('click', event => { const at = spot(event); if (at) { readOut(at); pin(runAt(at)); } });
  canvas.addEventListener('keydown', event => {
    if (!/^Arrow/.test(event.key)) return;
    event.preventDefault();
    const at = stepOnMap(panel, event.key);
    if (at) { readOut(at); pin(runAt(at)); }
  });
  maps.panels.push(panel);
  return element('figure', {class: 'map'}, element('figcaption', {}, element('h3', {}, pipelineLabel(pipeline))),
    holder);
}

function mapControls() {
  const names = varying.map(axis => axis.title);
  const made = element('div', {class: 'choices'});
  const redraw = () => {
    const label = document.activeElement.getAttribute('aria-label'), next = mapControls();
    made.replaceWith(next);
    const same = [...next.querySelectorAll('select')].find(select => select.getAttribute('aria-label') === label);
    if (same) same.focus();
    drawMaps();
  };
  made.append(chooser('Colour', metrics.map(metric => metric.title), metrics.indexOf(maps.metric),
    index => { maps.metric = metrics[index]; maps.log = null; redraw(); }));
  made.append(chooser('Across', names, varying.indexOf(maps.x), index => { maps.x = varying[index]; redraw(); }));
  made.append(chooser('Upwards', [...names, 'the colour’s quantity'], maps.y ? varying.indexOf(maps.y) : names.length,
    index => { maps.y = varying[index] ?? null; redraw(); }));
  const log = element('input', {type: 'checkbox', id: 'logColours', checked: maps.logNow,
    onchange: () => { maps.log = log.checked; drawMaps(); }});
  made.append(element('label', {}, log, 'logarithmic colours'));
  if (!drawsCells()) return made;
  made.append(chooser('Where a cell has several runs', REDUCTIONS.map(word => word + ' value'), maps.reduce,
    index => { maps.reduce = index; redraw(); }));
  for (const axis of others()) {
    const levels = axis.levels.map(v => axis.text ? v : axis.show(v));
    made.append(chooser(axis.label, ['all values', ...levels], (maps.fixed.get(axis) ?? -1) + 1,
      index => { maps.fixed.set(axis, index === 0 ? null : index - 1); redraw(); }));
  }
  return made;
}

function legendMark(word, draw) {
  const canvas = element('canvas', {'aria-hidden': 'true'});
  draw(prepared(canvas, 18, 18));
  return element('span', {class: 'mark'}, canvas, ' ' + word);
}

function mapLegend() {
  if (!drawsCells()) return element('span', {class: 'soft'},
    'A red cross is a failed run, an open circle one without a value.');
  const edge = (context, colour) => { context.strokeStyle = colour; context.strokeRect(1.5, 1.5, 15, 15); };
  return element('span', {},
    legendMark('failed', context => {
      context.fillStyle = '#fdeeea';
      context.fillRect(1, 1, 16, 16);
      cross(context, 9, 9, 5);
    }),
    legendMark('no value', context => { edge(context, FAINT); openCircle(context, 9, 9, 4); }),
    legendMark('not run', context => { hatch(context, 1, 1, 16, 16); edge(context, '#9aa4ae'); }),
    legendMark('no run planned', context => edge(context, FAINT)));
}

function mapSection() {
  if (varying.length === 0) return;
  if (metrics.length === 0) {
    section('Maps over the axes', element('p', {},
      (noneGood() ?? 'No run has a number in its summary') + ', so there is nothing to draw.'));
    return;
  }
  [maps.x, maps.y] = [varying[0], varying[1] ?? null];
  const differing = metrics.filter(metric => metric.min < metric.max);  // one colour throughout says nothing
  maps.metric = ['misfit_N', 'max_penetration_depth_m', 'max_force_N'].map(metricNamed)
    .find(metric => differing.includes(metric)) ?? differing[0] ?? metrics[0];
  maps.readout = element('p', {class: 'readout', 'aria-live': 'polite'},
    'Point at a map, tap it, or step over it with the arrow keys: the run is read out here, and shown below.');
  maps.barTitle = element('span', {class: 'soft'});
  maps.bar = element('canvas', {class: 'bar', 'aria-hidden': 'true'});
  section('Maps over the axes', element('p', {class: 'soft'}, drawsCells()
    ? 'A cell is one pair of values. Only good runs give a value; a small red cross in the corner says that others ' +
      'of the cell failed.'
    : 'A point is a run, at its values of two axes.'), mapControls(),
  element('div', {class: 'legend'}, element('div', {}, maps.barTitle, maps.bar), mapLegend()),
  element('div', {class: 'maps'}, ...pipelines.map((name, index) => mapPanel(index))), maps.readout);
  let waiting = null;  // thousands of points would hold up a brush that is being drawn
  chosen.views.push(RUNS < 2000 ? drawMaps : () => { clearTimeout(waiting); waiting = setTimeout(drawMaps, 150); });
  drawMaps();
}
