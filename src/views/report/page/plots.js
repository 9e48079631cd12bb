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
    {label, labelFont: FONT, labelSize: 18, labelGap: -2, size: 30, gap: 3,
      font: FONT, stroke: INK, ticks: tick, grid, ...more},
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
  if (log) Object.assign(options.axes[1],
    {splits: (chart, axis, min, max) => valueMarks(min, max), filter: (chart, marks) => marks});
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
  const button = negative ? null : element('button', {
    type: 'button', 'aria-pressed': String(log), title: 'logarithmic axis',
    onclick: () => {
      log = !log;
      button.setAttribute('aria-pressed', String(log));
      redraw();
    },
  }, 'log');
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
  const names = some => some.map(plot => plot.title.toLowerCase()).join(', ');
  const zero = all.filter(plot => plot.constant_zero);
  const unknown = all.filter(plot => !plot.constant_zero && plot.variants.length === 0);
  const grid = element('div', {class: 'plots'}, ...drawn.map(timePlot));
  section(title, drawn.length ? grid : null,
    zero.length ? element('p', {class: 'soft'}, '0 throughout in every run: ' + names(zero) + '.') : null,
    unknown.length ? element('p', {class: 'soft'}, 'Not measured in any run: ' + names(unknown) + '.') : null);
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
    all.map(one => data.runs[one.run].name + ' half within ' + microseconds(one.p50_us) +
      ', 99 % within ' + microseconds(one.p99_us)).join('; '));
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
    element('td', {}, one.steps < one.steps_of_run ? one.steps + ' of ' + one.steps_of_run : String(one.steps))));
  section('Step time', element('div', {class: 'plots wide'},
    element('figure', {class: 'plot', 'data-plot': 'step_time'},
      element('figcaption', {}, element('h3', {}, 'Steps within a time, %'),
        element('span', {class: 'note'},
          'wall time of a step without measuring and writing; the line is the 1 ms that a haptic loop has')),
      holder),
    headedTable('numbers', ['run', 'median', '99 % below', 'longest', 'above 1 ms', 'steps timed'], rows)));
  drawStepTimes(holder);
}
