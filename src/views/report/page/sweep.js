// The page of a sweep: its texts and tables, and the order of its parts.

const state_of_page = {bound_mm: 0.5};
const DESIGNS = {grid: data.whole_grid ? 'a grid: every value of each axis with every value of the others'
  : 'a grid without some combinations of its values: axes go together, or points are excluded',
  random: 'random points',
  latin_hypercube: 'a Latin hypercube: points spread evenly along each axis',
    sobol: 'Sobol points: spread evenly over all axes'};

function countOf(test) {
  return data.counts.filter(([pipeline, status]) => test(status)).reduce((sum, entry) => sum + entry[2], 0);
}

const isFailed = status => status !== 'ok' && status !== 'missing';
// Why there is nothing to compare; null where there is.
const noneGood = () => countOf(status => status === 'ok') ? null : data.total === 0 ? 'There are no runs'
  : countOf(isFailed) ? 'No run has ended well' : 'No run has been run yet';
const plural = (count, word) => count + ' ' + word + (count === 1 ? '' : 's');

function sweepHeading() {
  document.documentElement.classList.add('drawn');
  const made = new Map(data.provenance);
  const version = made.get('version') && 'fissure ' + made.get('version');
  const about = [data.file, made.get('ended_utc'), version].filter(part => part);
  const failed = countOf(isFailed), missing = countOf(status => status === 'missing'),
    good = countOf(status => status === 'ok');
  page.append(element('header', {},
    element('h1', {}, data.title),
    data.description ? element('p', {}, data.description) : null,
    element('p', {class: 'soft'}, about.join(' · ')),
    element('p', {class: 'tally'}, element('b', {}, plural(data.total, 'run')), ': ',
      element('span', {}, good + ' finished'), ', ',
      element('span', {class: failed ? 'bad' : ''}, failed + ' failed'), ', ',
      element('span', {class: missing ? 'bad' : ''}, missing + ' not run'),
      '. Design: ' + (DESIGNS[data.design] ?? data.design) + '.')));
  if (data.shown < data.total) page.append(element('ul', {class: 'warnings'}, element('li', {},
    'Maps, lines, curves and shares are those of ' + data.shown + ' of the ' + data.total +
    ' runs, a sample spread evenly over them; counts of failed runs are of all.')));
}

// ---- which pipeline holds

function holdRow(code, depth, passed) {
  const runs = allRuns.filter(run => pipelineOf[run] === code), done = runs.filter(run => endOf[run] !== MISSING);
  const held = done.filter(run => endOf[run] === GOOD && depth.values[run] <= state_of_page.bound_mm).length;
  const lost = done.filter(run => statusOf(run) === 'non_finite').length;
  const failed = done.filter(run => endOf[run] === BAD).length;
  const through = passed ? done.filter(run => passed.values[run] > 0).length : null;
  const depths = done.filter(run => endOf[run] === GOOD).map(run => depth.values[run])
    .filter(v => !Number.isNaN(v)).sort((a, b) => a - b);
  const cell = count => element('td', {class: count > 0 ? 'bad' : ''},
    count === null ? '–' : count + ' (' + percent(count, done.length) + ')');
  return element('tr', {'data-pipeline': pipelines[code]}, element('th', {scope: 'row'}, pipelineLabel(code)),
    element('td', {class: done.length && held === done.length ? 'good' : ''},
      element('b', {}, percent(held, done.length)), ' (' + held + ' of ' + done.length + ')'),
    cell(through), cell(lost), cell(failed - lost), element('td', {}, String(runs.length - done.length)),
    element('td', {}, depths.length ? depth.show(depths[depths.length >> 1]) : '–'),
    element('td', {}, depths.length ? depth.show(depths[depths.length - 1]) : '–'));
}

function holdSection() {
  const depth = metricNamed('max_inversion_aware_depth_m') ?? metricNamed('max_penetration_depth_m'),
    passed = metricNamed('passed_through_samples') ?? null;
  if (!depth) {
    if (noneGood()) section('Which pipeline holds', element('p', {}, noneGood() + ', so no pipeline holds.'));
    return;
  }
  const bound = element('input', {type: 'number', min: 0, step: 'any', value: state_of_page.bound_mm, id: 'bound'});
  const head = () => ['', 'holds: at most ' + short(state_of_page.bound_mm) + ' mm deep', 'passed through',
    'state not finite', 'failed otherwise',
    'not run', 'median depth', 'worst depth'];
  const table = () => headedTable('numbers holds', head(), pipelines.map((name, code) => holdRow(code, depth, passed)));
  let shown = table();
  bound.addEventListener('input', () => {
    if (!(Number(bound.value) >= 0) || bound.value === '') return;
    state_of_page.bound_mm = Number(bound.value);
    const next = table();
    shown.replaceWith(next);
    shown = next;
  });
  section('Which pipeline holds', element('p', {}, element('label', {},
    'A run holds when it finished and the tool was never deeper' + (metricNamed('max_inversion_aware_depth_m')
      ? ', inverted tissue included, than ' : ' than '),
    bound, ' mm.'), ' Shares are of the runs that were run.'), shown);
}

function axisSection() {
  if (RUNS === 0) return;
  const spacing = axis => axis.text ? '' : axis.levels && axis.levels.length < 2 ? 'fixed'
    : axis.log ? 'by factors' : axis.levels ? 'by steps' : 'evenly';
  section('What was swept', headedTable('axes', ['axis', 'place in the scenario', 'from', 'to', 'values', 'spaced'],
    sweepAxes.map(axis =>
    element('tr', {}, element('th', {scope: 'row'}, axis.label), element('td', {}, axis.path),
      ...(axis.text ? [element('td', {colspan: 2}, axis.levels.slice(0, 12).join(', ') +
        (axis.levels.length > 12 ? ' …' : ''))]
        : [element('td', {}, axis.show(axis.min)), element('td', {}, axis.show(axis.max))]),
      element('td', {class: 'count'}, axis.levels ? String(axis.levels.length) : 'any'),
      element('td', {}, spacing(axis))))));
}

// ---- the bar that says what is chosen, and the run that is looked at

function choiceBar() {
  if (RUNS === 0) return;
  const text = element('span', {class: 'chosen', 'aria-live': 'polite'});
  const letGo = () => {
    clearBrushes();
    chosen.pinned = null;
    chooseOnly(null);
  };
  const clear = element('button', {type: 'button', onclick: letGo}, 'All runs');
  const show = () => {
    const only = chosen.only ? ', ' + chosen.only.label : '';
    text.textContent = chosen.count === RUNS ? plural(RUNS, 'run') + ' on this page, all chosen'
      : plural(chosen.count, 'run') + ' of ' + RUNS + ' chosen' + only;
    if (chosen.pinned !== null) text.textContent += ' · looking at run ' + numberOf(chosen.pinned);
    clear.hidden = chosen.count === RUNS && chosen.pinned === null;
  };
  chosen.views.push(show);
  show();
  page.append(element('div', {class: 'controls', role: 'group', 'aria-label': 'chosen runs'}, text, clear));
}

function runSection() {
  const box = element('div', {});
  const made = section('The run that is looked at', box);
  const show = () => {
    const run = chosen.pinned;
    made.hidden = run === null;
    if (run === null) return;
    const row = (name, text, kind = '') => element('tr', {}, element('th', {scope: 'row'}, name),
      element('td', {class: kind}, text));
    const head = [row('run', numberOf(run) + ', point ' + points[run] +
      (repeats[run] > 0 ? ', repeat ' + repeats[run] : '')),
      row('pipeline', pipelines[pipelineOf[run]]),
      row('ended', endTextOf(run) + (detailOf(run) ? ': ' + detailOf(run) : ''), ['', '', 'bad'][endOf[run]])];
    if (fileOf(run)) head.push(row('result', fileOf(run)));
    const values = columns => columns.map(column => row(column.label, column.show(column.values[run])));
    box.replaceChildren(element('div', {class: 'pair'},
      headedTable('text', ['', ''], [...head, ...sweepAxes.map(axis => row(axis.path, axis.show(axis.values[run])))]),
      headedTable('text', ['', ''], values(metrics))));
  };
  chosen.views.push(show);
  show();
}

// ---- failures and fits

function rangeOf(axis, where) {
  const factor = (UNITS[data.axes[sweepAxes.indexOf(axis)].unit] ?? ['', 1])[1];
  const [from, to] = [axis.show(where.from * factor), axis.show(where.to * factor)];
  return from === to ? ' = ' + from : ' from ' + from + ' to ' + to;
}

function placeOf(where) {
  const axis = sweepAxes.find(one => one.name === where.axis);
  const more = where.more ? ' or one of ' + where.more + ' more' : '';
  const range = axis.text ? ' = ' + where.values.join(' or ') + more : rangeOf(axis, where);
  return axis.label + range + ' (' + percent(where.share, 1) + ' of all runs are there)';
}

function failureSection() {
  if (data.failures.length === 0) return;
  const codes = codesOf(data.reasons);
  const placeIn = number => runNumbers ? runNumbers.indexOf(number) : number;
  const rows = data.failures.map((failure, index) => element('tr', {},
    element('td', {}, element('button', {type: 'button', onclick: () =>
      chooseOnly(failure.status + (failure.reason ? ': ' + failure.reason : ''),
        allRuns.filter(run => codes[run] === index))},
    'choose'), ' ', element('b', {class: 'bad'}, failure.status)),
    element('td', {}, failure.reason || 'no reason given'),
    element('td', {}, String(failure.count)),
    element('td', {}, failure.pipelines.map(([name, count]) => name + ' ' + count).join(', ')),
    element('td', {}, failure.where.length ? 'all at ' + failure.where.map(placeOf).join(', ') :
      'nowhere in particular'),
    element('td', {}, ...failure.examples.flatMap(number =>
      [placeIn(number) < 0 ? String(number) : pinButton(placeIn(number)), ' ']))));
  section('Failures by reason', element('p', {class: 'soft'},
    'Numbers within reasons are written as #, so that one cause is one row.'),
    headedTable('failures', ['ended', 'reason', 'runs', 'pipelines', 'where', 'for example run'], rows));
}

function fitSection() {
  const misfit = metricNamed('misfit_N');
  if (!misfit) return;
  const known = allRuns.filter(run => !Number.isNaN(misfit.values[run]));
  const best = known.sort((a, b) => misfit.values[a] - misfit.values[b]).slice(0, 20);
  const rows = best.map((run, place) => element('tr', {}, element('td', {}, String(place + 1)),
    element('td', {}, misfit.show(misfit.values[run])),
    element('td', {}, pipelineLabel(pipelineOf[run])), ...varying.map(axis =>
      element('td', {}, axis.show(axis.values[run]))),
    element('td', {}, pinButton(run))));
  section('Best fits', element('p', {class: 'soft'},
    'The runs whose force comes closest to the measured one: the smallest misfit first. ',
    element('button', {type: 'button', onclick: () => { clearBrushes(); chooseOnly('best fits', best); }},
      'Choose these')),
  headedTable('numbers fits', ['', 'misfit', 'pipeline', ...varying.map(axis => axis.label), 'run'], rows));
}

function sourceSection() {
  const made = section('Sweep file and provenance');
  if (data.source) made.append(element('details', {}, element('summary', {}, 'Sweep file'),
    element('pre', {}, data.source)));
  if (data.provenance.length) made.append(element('details', {}, element('summary', {}, 'Provenance'),
    headedTable('text', ['', ''], data.provenance.map(([name, value]) => element('tr', {},
      element('th', {scope: 'row'}, name), element('td', {}, value))))));
  page.append(element('footer', {}, 'Made by ' + data.program +
    '. Plots of curves: uPlot 1.6.32, MIT licence. Colours: viridis; Okabe and Ito.'));
}

page.replaceChildren();
sweepHeading();
holdSection();
axisSection();
choiceBar();
mapSection();
parallelSection();
runSection();
curveSection();
fitSection();
failureSection();
sourceSection();

let seenWidth = innerWidth;
addEventListener('resize', () => {
  if (innerWidth === seenWidth) return;
  seenWidth = innerWidth;
  if (maps.panels.length) drawMaps();
  if (lines.box) layParallel();
  drawCurves();
});
