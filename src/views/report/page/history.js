// The page of a folder of benchmark files: times over commits, machines apart, steps, counters.

const charts = [];
const commitName = at => data.commits[at].commit.slice(0, 7) + (data.commits[at].modified ? '+' : '');
const commitDay = at => data.commits[at].date.slice(0, 10);
const many = (count, word) => count + ' ' + word + (count === 1 ? '' : 's');
const change = ratio => (ratio > 1 ? '+' : '\u2212') + (Math.abs(ratio - 1) * 100).toFixed(1) + '\u2009%';
const timeOf = us => us >= 1e6 ? short(us / 1e6) + ' s' : us >= 1e3 ? short(us / 1e3) + ' ms' : short(us) + ' µs';
const machineLabel = at => element('span', {class: 'machine'}, swatch(at), data.machines[at].name);
const allSteps = data.benchmarks.flatMap(benchmark => benchmark.curves.flatMap(curve =>
  curve.steps.map(step => ({benchmark, curve, step}))));

function historyHeading() {
  document.documentElement.classList.add('drawn');
  const last = data.commits.length - 1;
  const span = last === 0 ? 'one commit, ' + commitName(0) + ' of ' + commitDay(0)
    : (last + 1) + ' commits, ' + commitName(0) + ' of ' + commitDay(0) + ' to ' + commitName(last) + ' of ' +
      commitDay(last);
  page.append(element('header', {},
    element('h1', {}, 'Benchmarks: ' + data.title),
    element('p', {class: 'soft'}, many(data.benchmarks.length, 'benchmark') + ' on ' +
      many(data.machines.length, 'machine') + ', ' + span)));
  const notes = data.problems.map(problem =>
    element('li', {class: 'serious'}, element('b', {}, problem.file), ' is not shown: ' + problem.text));
  if (last === 0) notes.push(element('li', {}, 'One commit has no history yet: nothing to compare it with.'));
  if (data.commits.some(commit => commit.modified))
    notes.push(element('li', {}, 'A + after a commit: its files were changed when it was measured.'));
  if (notes.length) page.append(element('ul', {class: 'warnings'}, ...notes));
}

function machineSection() {
  const commitsOn = machine => new Set(data.benchmarks.flatMap(benchmark => benchmark.curves
    .filter(curve => curve.machine === machine).flatMap(curve => curve.commits))).size;
  const rows = data.machines.map((machine, at) => element('tr', {}, element('td', {}, machineLabel(at)),
    element('td', {}, String(machine.cores)), element('td', {}, machine.compiler), element('td', {}, machine.flags),
    element('td', {}, String(commitsOn(at)))));
  section('Machines', element('p', {class: 'soft'},
    'Times of two machines, compilers or sets of flags do not compare: each has a colour of its own.'),
  headedTable('text', ['machine', 'cores', 'compiler', 'flags', 'commits'], rows));
}

// ---- steps

// What a benchmark counted otherwise at a commit than at one before.
function countedOtherwise(benchmark, from, to) {
  return benchmark.counters.filter(({values}) =>
    values[from] !== null && values[to] !== null && values[from] !== values[to])
    .map(({name, values}) => name + ' ' + short(values[from]) + ' → ' + short(values[to]));
}

function stepRow({benchmark, curve, step}) {
  const place = curve.commits.indexOf(step.commit);
  const counted = countedOtherwise(benchmark, step.from, step.commit);
  return element('tr', {}, element('td', {}, commitName(step.commit)), element('td', {}, commitDay(step.commit)),
    element('td', {}, element('a', {href: '#' + idOf(benchmark)}, benchmark.name)),
    element('td', {}, machineLabel(curve.machine)),
    element('td', {class: step.ratio > 1 ? 'bad' : 'good'}, change(step.ratio)),
    element('td', {}, timeOf(curve.median_us[place - 1]) + ' → ' + timeOf(curve.median_us[place])),
    element('td', {}, short(step.p)),
    element('td', {}, counted.join(', ') || (benchmark.counters.length ? 'the same' : '–')));
}

function stepSection() {
  const {relative, absolute_us, p, before, after} = data.criterion;
  const rule = 'A step is a commit whose median, and those of up to ' + many(after - 1, 'commit') + ' measured after it ' +
    'on that machine, lie more than ' + short(100 * relative) + '\u2009% and ' + short(absolute_us) +
    ' µs to one side of the median of the up to ' + before + ' commits before it, with p < ' + short(p) +
    ' by the U test over all their repetitions. Times of one machine on different days may differ for reasons of ' +
    'its own: scripts/bench-compare runs two commits in turn and decides.';
  const sorted = [...allSteps].sort((a, b) => b.step.commit - a.step.commit || b.step.ratio - a.step.ratio);
  section('Steps', element('p', {class: 'soft'}, rule), sorted.length
    ? headedTable('steps', ['commit', 'date', 'benchmark', 'machine', 'time', 'median', 'p', 'counters'],
      sorted.map(stepRow))
    : element('p', {}, data.commits.length < 2 ? 'None: there is one commit.' : 'None.'));
}

// ---- a benchmark

const idOf = benchmark => 'b' + data.benchmarks.indexOf(benchmark);

function seriesOf(benchmark) {
  const table = [data.commits.map((commit, at) => at)], series = [{}], bands = [];
  for (const curve of benchmark.curves) {
    const {stroke, dash} = styleOf(curve.machine), first = table.length;
    for (const values of [curve.high_us, curve.low_us, curve.median_us]) {
      const row = data.commits.map(() => null);
      curve.commits.forEach((commit, place) => { row[commit] = values[place]; });
      table.push(row);
    }
    const edge = {stroke: stroke + '55', width: 0.5, points: {show: false}, spanGaps: true};
    series.push(edge, edge, {stroke, dash, width: 2, spanGaps: true, points: {show: true, size: 6, fill: stroke}});
    bands.push({series: [first, first + 1], fill: stroke + '26'});
  }
  return {table, series, bands};
}

// A quarter of the middle at least: what looks large is large.
function timeRange(table) {
  const all = table.slice(1).flat().filter(v => v !== null);
  const min = Math.min(...all), max = Math.max(...all), middle = 0.5 * (min + max);
  const half = Math.max(0.55 * (max - min), 0.125 * middle);
  return [Math.max(0, middle - half), middle + 1.25 * half];
}

function drawSteps(chart, benchmark) {
  const context = chart.ctx, ratio = devicePixelRatio, {top, height} = chart.bbox;
  context.save();
  for (const curve of benchmark.curves) {
    for (const step of curve.steps) {
      const x = chart.valToPos(step.commit, 'x', true);
      context.strokeStyle = context.fillStyle = step.ratio > 1 ? '#a3250f' : '#0a6b3d';
      context.setLineDash([4 * ratio, 3 * ratio]);
      context.lineWidth = 1.5 * ratio;
      context.beginPath();
      context.moveTo(x, top + 14 * ratio);
      context.lineTo(x, top + height);
      context.stroke();
      context.font = 'bold ' + 12 * ratio + 'px ' + FONT.slice(FONT.indexOf(' ') + 1);
      context.textAlign = step.commit === 0 ? 'left' : step.commit === data.commits.length - 1 ? 'right' : 'center';
      context.textBaseline = 'top';
      const y = top + (curve.machine % 2 ? 14 : 0) * ratio;
      context.setLineDash([]);
      context.lineWidth = 4 * ratio;
      context.strokeStyle = '#fff';
      context.strokeText(change(step.ratio), x, y);
      context.fillText(change(step.ratio), x, y);
    }
  }
  context.restore();
}

// Of the commit `at`; without one, of the newest, and of each machine its newest.
function readBenchmark(box, benchmark, at) {
  const newest = at === null || at === undefined, shown = newest ? data.commits.length - 1 : at;
  const times = benchmark.curves.map(curve => {
    const place = newest ? curve.commits.length - 1 : curve.commits.indexOf(shown);
    const commit = curve.commits[place];
    return element('span', {class: 'machine'}, swatch(curve.machine), place < 0 ? 'not measured'
      : timeOf(curve.median_us[place]) + ' (' + timeOf(curve.low_us[place]) + ' to ' + timeOf(curve.high_us[place]) +
        ')' + (commit === shown ? '' : ' at ' + commitName(commit)));
  });
  const counts = benchmark.counters.map(counter => {
    const now = counter.values[shown];
    const earlier = counter.values.slice(0, shown).filter(v => v !== null).pop();
    const changed = now !== null && earlier !== undefined && earlier !== now;
    const text = counter.name.replaceAll('_', ' ') + ' ' + short(now) + (changed ? ' (was ' + short(earlier) + ')' : '') +
      (counter.differs ? ' (differs between machines)' : '');
    return element('span', {class: changed ? 'count changed' : 'count'}, text);
  });
  box.replaceChildren(element('div', {}, element('b', {}, commitName(shown)), ' ' + commitDay(shown) + ' ', ...times),
    element('div', {class: 'soft'}, ...counts));
}

function drawBenchmark(benchmark, holder, read) {
  const {table, series, bands} = seriesOf(benchmark), range = timeRange(table);
  const last = data.commits.length - 1;
  const chart = new uPlot({
    width: Math.max(220, holder.clientWidth), height: chartHeight(), padding: [10, 14, 0, 0], legend: {show: false},
    bands, series,
    scales: {x: {time: false, range: () => [-0.5, last + 0.5]}, y: {range}},
    axes: axes('commit, oldest first', (shown, marks) => marks.map(timeOf), {
      space: 62, incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000],
      values: (shown, marks) => marks.map(at => Number.isInteger(at) && data.commits[at] ? commitName(at) : '')}),
    cursor: {y: false, drag: {x: false, y: false}, points: {show: false}},
    hooks: {draw: [drawn => drawSteps(drawn, benchmark)],
      setCursor: [moved => readBenchmark(read, benchmark, moved.cursor.idx)]},
  }, table, holder);
  holder.setAttribute('aria-label', benchmark.name + ', time over commits: ' + benchmark.curves.map(curve =>
    data.machines[curve.machine].name + ' from ' + timeOf(curve.median_us[0]) + ' to ' +
    timeOf(curve.median_us[curve.median_us.length - 1])).join('; '));
  readBenchmark(read, benchmark, null);
  return chart;
}

function benchmarkFigure(benchmark) {
  const holder = element('div', {role: 'img'}), read = element('div', {class: 'read'});
  const figure = element('figure', {class: 'plot', 'data-plot': benchmark.name, id: idOf(benchmark)},
    element('figcaption', {}, element('h3', {}, benchmark.name)), holder, read);
  charts.push({benchmark, figure, holder, read, chart: null});
  return figure;
}

function showFitting(words, onlySteps) {
  for (const entry of charts) {
    const fits = entry.benchmark.name.toLowerCase().includes(words.toLowerCase()) &&
      (!onlySteps || entry.benchmark.curves.some(curve => curve.steps.length));
    entry.figure.hidden = !fits;
    if (fits && !entry.chart) entry.chart = drawBenchmark(entry.benchmark, entry.holder, entry.read);
  }
  for (const family of document.querySelectorAll('section.family'))
    family.hidden = [...family.querySelectorAll('.plot')].every(figure => figure.hidden);
}

function controlBar() {
  const words = element('input', {type: 'search', id: 'words', 'aria-label': 'part of a name'});
  const steps = element('input', {type: 'checkbox', id: 'only-steps', disabled: allSteps.length === 0});
  const show = () => showFitting(words.value, steps.checked);
  words.addEventListener('input', show);
  steps.addEventListener('change', show);
  page.append(element('div', {class: 'controls', role: 'group', 'aria-label': 'which benchmarks'},
    element('label', {}, 'Benchmarks with ', words), element('label', {}, steps, ' only those with steps'),
    element('span', {class: 'runs'}, ...data.machines.map((machine, at) => machineLabel(at)))));
}

function familySections() {
  const families = [...new Set(data.benchmarks.map(benchmark => benchmark.name.split('/')[0]))];
  for (const family of families) {
    const own = data.benchmarks.filter(benchmark => benchmark.name.split('/')[0] === family);
    section(family, element('div', {class: 'plots'}, ...own.map(benchmarkFigure))).classList.add('family');
  }
}

page.replaceChildren();
historyHeading();
machineSection();
stepSection();
controlBar();
page.append(element('p', {class: 'soft'}, 'Line: the median of a commit’s repetitions; band: from the first to the ' +
  'third quartile. Below: times and counters of the commit under the pointer, else of the newest.'));
familySections();
page.append(element('footer', {}, 'Made by ' + data.program + '. Plots: uPlot 1.6.32, MIT licence. Colours: Okabe and Ito.'));
showFitting('', false);

addEventListener('resize', () => {
  for (const {chart, holder} of charts)
    if (chart) chart.setSize({width: Math.max(220, holder.clientWidth), height: chartHeight()});
});
