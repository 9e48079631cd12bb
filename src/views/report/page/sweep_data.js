// What the views of a sweep share: its columns, scales and colours, and which runs are chosen.

const RUNS = data.shown;
const FAILED = '#b3261e', FAINT = '#d5dae0';

// ---- columns: see packed.h

function bufferOf(text) {
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes.buffer;
}

const numbersOf = (packed, count = RUNS) =>
  'same' in packed ? new Float32Array(count).fill(packed.same ?? NaN) : new Float32Array(bufferOf(packed.f32));
const codesOf = packed => new Uint16Array(bufferOf(packed.u16));

function textsOf(packed) {
  const codes = codesOf(packed.codes);
  return run => packed.values[codes[run]];
}

const runNumbers = data.numbers ? numbersOf(data.numbers) : null;
const numberOf = run => runNumbers ? runNumbers[run] : run;
const points = numbersOf(data.point), repeats = numbersOf(data.repeat);
const pipelines = data.pipeline.values, pipelineOf = codesOf(data.pipeline.codes);
const statusOf = textsOf(data.status), detailOf = textsOf(data.detail), fileOf = textsOf(data.files);
const GOOD = 0, MISSING = 1, BAD = 2;
const endTextOf = run => statusOf(run) === 'ok' ? 'finished' : statusOf(run);
const endOf = Uint8Array.from({length: RUNS}, (none, run) => ({ok: GOOD, missing: MISSING})[statusOf(run)] ?? BAD);
const allRuns = Array.from({length: RUNS}, (none, run) => run);

// Shown unit and the factor to it.
const UNITS = {m: ['mm', 1000], 'm s-1': ['m/s', 1], 'm s-2': ['m/s²', 1], 'N m-1': ['N/m', 1],
  'N s m-1': ['N s/m', 1], 'kg m-3': ['kg/m³', 1], degree: ['°', 1], pixel: ['px', 1], us: ['µs', 1], 1: ['', 1]};
const inWords = name => (name.startsWith('timing/') ? name.slice(7) : name).replaceAll('_', ' ');

// Texts without the words that all of them begin with.
function toldApart(texts) {
  let same = texts.length > 1 ? texts[0].length : 0;
  for (const text of texts) while (!text.startsWith(texts[0].slice(0, same))) --same;
  const start = texts[0] ? texts[0].slice(0, same).lastIndexOf(' ') + 1 : 0;
  return start > 0 ? texts.map(text => '…' + text.slice(start)) : texts;
}

// One column of numbers: an axis or a metric, in the unit that is shown.
function quantity(source, isAxis) {
  const [unit, factor] = UNITS[source.unit] ?? [source.unit, 1];
  const made = {name: source.name, path: source.path, unit, isAxis, text: source.numeric === false, levels: null};
  made.label = isAxis ? source.label : inWords(source.label);
  if (source.levels) {
    made.codes = codesOf(source.levels.codes);
    if (made.text) made.told = toldApart(source.levels.values);
    made.levels = made.text ? source.levels.values : source.levels.values.map(v => v * factor);
    made.values = made.text ? Float32Array.from(made.codes) : Float64Array.from(made.codes, code => made.levels[code]);
  } else {
    made.values = numbersOf(source.data);
    if (factor !== 1) made.values = made.values.map(v => v * factor);
  }
  made.title = made.label + (unit ? ', ' + unit : '');
  made.show = v => made.text ? made.levels[v] ?? '–' : short(v) + (unit && !Number.isNaN(v) ? ' ' + unit : '');
  const known = Array.from(made.values).filter(Number.isFinite).sort((a, b) => a - b);
  [made.min, made.max] = known.length ? [known[0], known[known.length - 1]] : [0, 1];
  made.known = known.length;
  made.log = !made.text && (isAxis ? spacedByFactors(made, known) : farApart(known));
  return made;
}

// Whether values are closer to equal factors than to equal steps.
function spacedByFactors(made, sorted) {
  if (!(sorted[0] > 0) || sorted[sorted.length - 1] < 2 * sorted[0]) return false;
  const spread = values => {
    const steps = values.slice(1).map((v, i) => v - values[i]);
    return Math.max(...steps) / Math.min(...steps);
  };
  if (made.levels) return made.levels.length > 2 && spread(made.levels.map(Math.log)) < spread(made.levels);
  const middle = sorted[sorted.length >> 1], first = sorted[0], last = sorted[sorted.length - 1];
  const share = (middle - first) / (last - first), logShare = Math.log(middle / first) / Math.log(last / first);
  return Math.abs(logShare - 0.5) < Math.abs(share - 0.5);
}

const farApart = sorted => sorted.length > 2 && sorted[0] > 0 && sorted[sorted.length - 1] > 1000 * sorted[0];

const sweepAxes = data.axes.map(axis => quantity(axis, true));
const metrics = data.metrics.map(metric => quantity(metric, false)).filter(metric => metric.known > 0);
const varying = sweepAxes.filter(axis => axis.min < axis.max);
const metricNamed = name => metrics.find(metric => metric.name === name);

// ---- scales: from a value to 0..1

function scaleOf(column, log = column.log) {
  if (column.text) {
    const count = column.levels.length;
    const texts = column.told ?? column.levels;
    return {at: v => (v + 0.5) / count, marks: () => texts.map((text, i) => [(i + 0.5) / count, text])};
  }
  let {min, max} = column;
  const useLog = log && max > 0;
  if (useLog && min <= 0) min = column.values.reduce((least, v) => v > 0 && v < least ? v : least, max);
  const half = Math.abs(min) / 2 || 1;
  if (min === max) [min, max] = useLog ? [min / 2, max * 2] : [min - half, max + half];
  const at = useLog ? v => v > 0 ? Math.log(v / min) / Math.log(max / min) : v === 0 ? 0 : NaN
    : v => (v - min) / (max - min);
  return {at, log: useLog, marks: most => marksBetween(min, max, useLog, most).map(v => [at(v), short(v)])};
}

function marksBetween(min, max, log, most) {
  if (log) {
    const all = [];
    for (let power = Math.floor(Math.log10(min)); power <= Math.log10(max); ++power)
      for (const digit of [1, 2, 5]) all.push(Number(digit + 'e' + power));
    const inside = all.filter(v => v >= min * 0.999 && v <= max * 1.001);
    const tens = inside.filter(v => Math.abs(Math.log10(v) - Math.round(Math.log10(v))) < 1e-9);
    const chosen = inside.length > most && tens.length > 1 ? tens : inside;
    if (chosen.length < 2) return marksBetween(min, max, false, most);
    return chosen.filter((v, i) => i % Math.ceil(chosen.length / most) === 0);
  }
  const rough = (max - min) / most, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(digit => digit * power).find(wide => wide >= rough * 0.999);
  const marks = [];
  for (let i = Math.ceil(min / step - 1e-6); i * step <= max + 1e-6 * step; ++i)
    marks.push(Number((i * step).toPrecision(12)));
  return marks;
}

// Viridis (van der Walt and Smith): even steps for the eye, and for colour-blind ones.
const VIRIDIS = ['440154', '482878', '3e4989', '31688e', '26828e', '1f9e89', '35b779', '6ece58', 'b5de2b', 'fde725']
  .map(hex => [0, 2, 4].map(at => parseInt(hex.slice(at, at + 2), 16)));

function colourAt(share) {
  const at = Math.min(1, Math.max(0, share)) * (VIRIDIS.length - 1),
    below = Math.min(VIRIDIS.length - 2, Math.floor(at));
  const mixed = VIRIDIS[below].map((v, i) => Math.round(v + (at - below) * (VIRIDIS[below + 1][i] - v)));
  return 'rgb(' + mixed.join(',') + ')';
}

// ---- which runs are chosen

const chosen = {
  inside: new Uint8Array(RUNS).fill(1),  // by brushes and by a list
  count: RUNS,
  pinned: null,      // the run that is looked at
  brushes: new Map(),  // by dimension: a test of a run
  only: null,        // {label, runs: Set}: a list that somebody has clicked
  views: [],         // called after a change
  told: false,
};

function tellViews() {
  if (chosen.told) return;
  chosen.told = true;
  requestAnimationFrame(() => { chosen.told = false; for (const view of chosen.views) view(); });
}

function choose() {
  const tests = [...chosen.brushes.values()];
  chosen.count = 0;
  for (let run = 0; run < RUNS; ++run) {
    let inside = chosen.only === null || chosen.only.runs.has(run);
    for (let i = 0; inside && i < tests.length; ++i) inside = tests[i](run);
    chosen.inside[run] = inside ? 1 : 0;
    chosen.count += chosen.inside[run];
  }
  tellViews();
}

function chooseOnly(label, runs) {
  chosen.only = label ? {label, runs: new Set(runs)} : null;
  choose();
}

function pin(run) {
  chosen.pinned = run;
  tellViews();
}

// ---- pieces

const pipelineLabel = code => element('span', {}, swatch(code), pipelines[code]);
const pinButton = run => element('button', {type: 'button', class: 'run', onclick: () => pin(run)},
  String(numberOf(run)));
const percent = (part, whole) => whole ? short(Number((100 * part / whole).toPrecision(3))) + ' %' : '–';

function chooser(label, options, selected, change) {
  const select = element('select', {'aria-label': label}, ...options.map((text, index) =>
    element('option', {selected: index === selected, value: index}, text)));
  select.addEventListener('change', () => change(select.selectedIndex));
  return element('label', {}, label + ' ', select);
}

// A canvas as sharp as the screen, drawn in CSS pixels.
function prepared(canvas, width, height) {
  const ratio = devicePixelRatio || 1;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  canvas.style.width = width + 'px';
  canvas.style.height = height + 'px';
  const context = canvas.getContext('2d');
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = FONT;
  context.fillStyle = context.strokeStyle = INK;
  return context;
}

function cross(context, x, y, size, colour = FAILED) {
  context.strokeStyle = colour;
  context.lineWidth = 1.8;
  context.beginPath();
  context.moveTo(x - size, y - size);
  context.lineTo(x + size, y + size);
  context.moveTo(x + size, y - size);
  context.lineTo(x - size, y + size);
  context.stroke();
}
