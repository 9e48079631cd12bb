// ---- parallel coordinates: a line a run, a vertical axis a quantity; dragging along an axis chooses runs

const TOP = 34, BOTTOM = 26, TALL = 320, NONE = -0.1;  // NONE: where what has no value is drawn
const lines = {dims: [], back: null, front: null, box: null, wide: 0, job: 0, metrics: new Set()};

function dimension(title, column, scale) {
  const at = new Float32Array(RUNS);
  for (let run = 0; run < RUNS; ++run) {
    const share = scale.at(column.values[run]);
    at[run] = Number.isFinite(share) && endOf[run] !== MISSING || column.isAxis ? share : NONE;
  }
  // Runs of equal value are spread a little, so that each of their lines is seen.
  const room = column.levels ? Math.min(0.03, 0.3 / column.levels.length) : 0;
  const drawn = at.map((share, run) => share + room * (2 * (run * 0.6180339887 % 1) - 1));
  return {title, column, scale, at, drawn, brush: null, handle: null, band: null};
}

function makeDimensions() {
  const entry = {text: true, isAxis: true, levels: pipelines, values: pipelineOf, title: 'pipeline', label: 'pipeline',
    show: code => pipelines[code]};
  const made = pipelines.length > 1 ? [dimension('pipeline', entry, scaleOf(entry))] : [];
  for (const axis of varying) made.push(dimension(axis.title, axis, scaleOf(axis)));
  for (const metric of metrics)
    if (lines.metrics.has(metric)) made.push(dimension(metric.title, metric, scaleOf(metric)));
  return made;
}

const xOf = index => 46 + index * (lines.wide - 92) / Math.max(1, lines.dims.length - 1);
const yOf = share => TOP + (1 - share) * (TALL - TOP - BOTTOM - 18);

function trace(context, run) {
  context.moveTo(xOf(0), yOf(lines.dims[0].drawn[run]));
  for (let i = 1; i < lines.dims.length; ++i) context.lineTo(xOf(i), yOf(lines.dims[i].drawn[run]));
}

// Lines of one look, a few hundred in a path: longer paths are slow to draw.
function strokeRuns(context, runs, look) {
  Object.assign(context, {strokeStyle: look.colour, lineWidth: look.width, globalAlpha: look.alpha});
  context.setLineDash(look.dash ?? []);
  for (let first = 0; first < runs.length; first += 200) {
    context.beginPath();
    for (const run of runs.slice(first, first + 200)) trace(context, run);
    context.stroke();
  }
  context.setLineDash([]);
  context.globalAlpha = 1;
}

// Thousands of lines are drawn over several frames, so that the page stays quick.
function strokeOverTime(context, groups, done) {
  const job = ++lines.job, pieces = [];
  for (const {runs, look} of groups)
    for (let first = 0; first < runs.length; first += 1500) pieces.push([runs.slice(first, first + 1500), look]);
  const go = () => {
    if (job !== lines.job) return;
    const piece = pieces.shift();
    if (piece) strokeRuns(context, ...piece);
    if (pieces.length) requestAnimationFrame(go); else done();
  };
  go();
}

function drawBack() {
  const context = prepared(lines.back, lines.wide, TALL);
  const look = {colour: FAINT, width: 0.7, alpha: RUNS > 2000 ? 0.35 : 0.8};
  strokeRuns(context, allRuns.filter(run => endOf[run] !== MISSING), look);
}

function drawFront() {
  if (lines.dims.length === 0) return;
  const context = prepared(lines.front, lines.wide, TALL);
  const inside = allRuns.filter(run => chosen.inside[run]), bad = inside.filter(run => endOf[run] === BAD);
  const alpha = Math.min(0.85, Math.max(0.12, 60 / Math.max(1, inside.length)));
  const groups = pipelines.map((name, code) => ({
    runs: inside.filter(run => pipelineOf[run] === code && endOf[run] === GOOD),
    look: {colour: styleOf(code).stroke, width: 1, alpha},
  }));
  const seen = Math.min(0.85, Math.max(0.25, 90 / Math.max(1, bad.length)));
  groups.push({runs: bad, look: {colour: FAILED, width: 1.5, alpha: seen, dash: [6, 3]}});
  strokeOverTime(context, groups, () => {
    if (chosen.pinned !== null) {
      strokeRuns(context, [chosen.pinned], {colour: '#fff', width: 5, alpha: 0.9});
      strokeRuns(context, [chosen.pinned], {colour: '#000', width: 2.5, alpha: 1});
    }
    drawLineAxes(context);
  });
}

function drawLineAxes(context) {
  context.lineWidth = 1;
  lines.dims.forEach((dim, index) => {
    const x = xOf(index), room = (lines.wide - 92) / Math.max(1, lines.dims.length - 1) - 8;
    context.strokeStyle = '#6e7781';
    context.beginPath();
    context.moveTo(x, yOf(1));
    context.lineTo(x, yOf(0));
    context.stroke();
    context.fillStyle = INK;
    context.textAlign = index === 0 ? 'left' : index + 1 === lines.dims.length ? 'right' : 'center';
    const titleX = index === 0 ? 2 : index + 1 === lines.dims.length ? lines.wide - 2 : x;
    drawTitle(context, dim.title, titleX, Math.max(70, room));
    context.textAlign = 'left';
    context.textBaseline = 'middle';
    const marks = dim.scale.marks(6), skip = Math.ceil(marks.length / 16);
    for (const [at, text] of marks.filter((mark, i) => i % skip === 0)) writeMark(context, text, x + 4, yOf(at));
    if (!dim.column.isAxis && dim.at.includes(Math.fround(NONE))) writeMark(context, 'none', x + 4, yOf(NONE));
  });
}

// In two rows, where one is too short.
function drawTitle(context, title, x, room) {
  const words = title.split(' '), rows = ['', ''];
  for (const word of words) {
    const row = rows[1] === '' && context.measureText(rows[0] + ' ' + word).width <= room ? 0 : 1;
    rows[row] += (rows[row] ? ' ' : '') + word;
  }
  context.textBaseline = 'bottom';
  if (!rows[0]) rows.reverse();
  if (rows[1]) { context.fillText(rows[0], x, 14, room); context.fillText(rows[1], x, 28, room); }
  else context.fillText(rows[0], x, 28, room);
}

function writeMark(context, text, x, y) {
  const long = text.length > 16 ? text.slice(0, 15) + '…' : text;
  context.lineWidth = 3;
  context.strokeStyle = 'rgba(255,255,255,.85)';
  context.strokeText(long, x, y);
  context.fillStyle = INK;
  context.fillText(long, x, y);
  context.lineWidth = 1;
}

// ---- brushes

function setBrush(dim, brush) {
  dim.brush = brush && [Math.max(-0.15, Math.min(...brush)), Math.min(1.02, Math.max(...brush))];
  if (dim.brush) {
    const [low, high] = dim.brush;
    chosen.brushes.set(dim.column, run => dim.at[run] >= low && dim.at[run] <= high);
  } else {
    chosen.brushes.delete(dim.column);
  }
  showBrush(dim);
  choose();
}

function showBrush(dim) {
  dim.band.hidden = !dim.brush;
  dim.handle.setAttribute('aria-valuetext', dim.brush ? 'chosen from ' +
    Math.round(100 * Math.max(0, dim.brush[0])) + ' to ' +
    Math.round(100 * Math.min(1, dim.brush[1])) + ' % of the axis' : 'all runs');
  if (!dim.brush) return;
  dim.band.style.top = yOf(dim.brush[1]) + 'px';
  dim.band.style.height = Math.max(3, yOf(dim.brush[0]) - yOf(dim.brush[1])) + 'px';
}

function clearBrushes() {
  chosen.brushes.clear();
  for (const dim of lines.dims) { dim.brush = null; showBrush(dim); }
}

function brushKey(dim, event) {
  const step = {ArrowUp: 0.05, ArrowDown: -0.05}[event.key];
  if (event.key === 'Escape' || event.key === 'Delete') setBrush(dim, null);
  else if (step) setBrush(dim, dim.brush ? [dim.brush[0] + (event.shiftKey ? 0 : step), dim.brush[1] + step] :
    [0.4, 0.6]);
  else return;
  event.preventDefault();
}

function brushHandle(dim, index) {
  dim.band = element('div', {class: 'band'});
  dim.handle = element('div', {class: 'handle', tabindex: '0', role: 'slider', 'aria-label': dim.title,
    'aria-valuemin': 0,
    'aria-valuemax': 100, 'aria-valuenow': 0, 'data-dimension': dim.column.name ?? dim.title}, dim.band);
  dim.handle.style.left = xOf(index) - 20 + 'px';
  const shareAt = event => 1 - (event.clientY - lines.box.getBoundingClientRect().top - TOP) /
    (TALL - TOP - BOTTOM - 18);
  let from = null;
  dim.handle.addEventListener('pointerdown', event => {
    from = shareAt(event);
    dim.handle.setPointerCapture(event.pointerId);
  });
  dim.handle.addEventListener('pointermove', event => {
    if (from !== null && Math.abs(shareAt(event) - from) > 0.015) setBrush(dim, [from, shareAt(event)]);
  });
  dim.handle.addEventListener('pointerup', event => {
    if (from !== null && Math.abs(shareAt(event) - from) <= 0.015) setBrush(dim, null);
    from = null;
  });
  dim.handle.addEventListener('pointercancel', () => { from = null; });
  dim.handle.addEventListener('keydown', event => brushKey(dim, event));
  showBrush(dim);
  return dim.handle;
}

function layParallel() {
  lines.dims = makeDimensions();
  chosen.brushes.clear();
  lines.wide = Math.max(lines.box.parentElement.clientWidth, 92 + 96 * (lines.dims.length - 1));
  lines.box.style.width = lines.wide + 'px';
  lines.box.replaceChildren(lines.back, lines.front, ...lines.dims.map(brushHandle));
  drawBack();
  choose();
}

function metricBoxes() {
  return element('details', {}, element('summary', {}, 'Quantities beside the axes'),
    element('div', {class: 'choices'}, ...metrics.map(metric => {
      const box = element('input', {type: 'checkbox', checked: lines.metrics.has(metric), onchange: () => {
        if (box.checked) lines.metrics.add(metric); else lines.metrics.delete(metric);
        layParallel();
      }});
      return element('label', {}, box, metric.title);
    })));
}

function parallelSection() {
  if (RUNS === 0 || varying.length + metrics.length === 0) return;
  const wanted = ['max_penetration_depth_m', 'max_force_N', 'misfit_N'].map(metricNamed).filter(metric => metric);
  for (const metric of wanted.length ? wanted : metrics.slice(0, 2)) lines.metrics.add(metric);
  lines.back = element('canvas', {'aria-hidden': 'true'});
  lines.front = element('canvas', {'aria-hidden': 'true', class: 'lines'});
  lines.box = element('div', {class: 'parallel', role: 'group', 'aria-label': 'runs over all axes'});
  section('All axes at once', element('p', {class: 'soft'},
    'A line is a run; dashed red ones failed. Drag along an axis to choose runs, everywhere on this page; click the axis to ' +
    'let go. With keys: up and down move what is chosen on an axis, with Shift they widen it, Escape lets go.'),
  element('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'runs over all axes'}, lines.box),
    metrics.length ? metricBoxes() : null);
  layParallel();
  chosen.views.push(drawFront);
}
