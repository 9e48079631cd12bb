// ---- curves: what most runs do, and single ones

const MOST_LINES = 30;
const curves = {track: 0, chart: null, holder: null, note: null, read: null, rows: null, kept: null};

// Values of a run's own curve; null where the page does not hold it.
function ownCurve(track, run) {
  const row = curves.rows.get(run);
  if (row === undefined) return null;
  const count = data.curves.times_s.length, low = track.lows[row], high = track.highs[row];
  return Array.from({length: count}, (none, i) => {
    const code = track.codes[row * count + i];
    return code === 65535 ? null : (low + (high > low ? code / 65534 * (high - low) : 0)) * track.factor;
  });
}

function openTracks() {
  const kept = codesOf(data.curves.rows);
  curves.kept = kept;
  curves.rows = new Map(Array.from(kept, (run, row) => [run, row]));
  for (const track of data.curves.tracks) {
    [track.shown, track.factor] = UNITS[track.unit] ?? [track.unit, 1];
    track.lows = numbersOf(track.low, kept.length);
    track.highs = numbersOf(track.high, kept.length);
    track.codes = codesOf(track.values);
    for (const band of track.bands)
      for (const name of ['low', 'median', 'high'])
        band[name] = band[name].map(v => v === null ? null : v * track.factor);
  }
}

const trackTitle = track => inWords(track.curve) + (track.law ? ' of ' + track.law : '') +
  (track.shown ? ', ' + track.shown : '');
const isForce = track => track.unit === 'N' && data.curves.measured.length > 0;

const hasBand = track => track.bands.some(band => band.median.some(v => v !== null));
const hasOwn = (track, run) => curves.rows.has(run) && Number.isFinite(track.lows[curves.rows.get(run)]);

// Which single runs are drawn: the pinned one, then chosen ones in their order, where not all are chosen or there
// is nothing else to see.
function singleRuns(track) {
  const inside = Array.from(curves.kept).filter(run => chosen.inside[run]);
  const some = !hasBand(track) ? inside.filter(run => hasOwn(track, run)) : chosen.count < RUNS ? inside : [];
  const shown = some.slice(0, MOST_LINES).filter(run => run !== chosen.pinned);
  if (chosen.pinned !== null && curves.rows.has(chosen.pinned)) shown.push(chosen.pinned);
  return {shown, of: some.length};
}

function bandSeries(track, table, series, bands) {
  for (const band of track.bands) {
    if (band.median.every(v => v === null)) continue;
    const {stroke, dash} = styleOf(band.pipeline), first = table.length;
    table.push(band.high, band.low, band.median);
    series.push({stroke: stroke + '66', width: 0.5, points: {show: false}},
      {stroke: stroke + '66', width: 0.5, points: {show: false}},
      {stroke, width: 2.5, dash, points: {show: false}});
    bands.push({series: [first, first + 1], fill: stroke + '2e'});
  }
}

// The bands and the measured curve are in view, single runs up to three times as far.
function curveRange(track, table, firstSingle) {
  const ends = some => some.flat().filter(v => v !== null && Number.isFinite(v));
  const main = ends(table.slice(1, firstSingle)), all = ends(table.slice(1));
  let min = Math.min(0, ...main), max = Math.max(0, ...main);
  if (main.length === 0) return all.length ? [Math.min(...all), Math.max(...all)] : [0, 1];
  const wide = max - min || 1;
  for (const v of all) {
    min = Math.min(min, Math.max(v, -3 * wide));
    max = Math.max(max, Math.min(v, 3 * wide));
  }
  return [min, max + 0.04 * (max - min || 1)];
}

function drawCurves() {
  if (!curves.holder) return;
  const track = data.curves.tracks[curves.track], table = [data.curves.times_s], series = [{}], bands = [];
  bandSeries(track, table, series, bands);
  if (isForce(track)) {
    table.push(data.curves.measured);
    series.push({stroke: '#000', width: 2.5, dash: [2, 4], points: {show: false}});
  }
  const firstSingle = table.length, {shown, of} = singleRuns(track);
  for (const run of shown) {
    table.push(ownCurve(track, run));
    const pinned = run === chosen.pinned;
    series.push({stroke: pinned ? '#000' : styleOf(pipelineOf[run]).stroke + 'b0', width: pinned ? 2.5 : 1,
      points: {show: false}});
  }
  if (curves.chart) curves.chart.destroy();
  const range = curveRange(track, table, firstSingle);
  const axis = {font: FONT, stroke: INK, ticks: {stroke: '#c3c9d0', width: 1, size: 5},
    grid: {stroke: '#e8ebee', width: 1}};
  curves.chart = new uPlot({
    width: Math.max(220, curves.holder.clientWidth), height: 300, padding: [10, 14, 0, 0], legend: {show: false}, bands,
    scales: {x: {time: false}, y: {range}},
    axes: [{...axis, label: 'time, s', labelFont: FONT, labelSize: 18, labelGap: -2, size: 30, gap: 3},
      {...axis, size: 58, gap: 4, values: (chart, marks) => marks.map(short)}],
    series,
    cursor: {y: false, drag: {x: false, y: false}, points: {show: false}},
    hooks: {setCursor: [chart => readCurves(track, chart.cursor.idx)]},
  }, table, curves.holder);
  curves.holder.setAttribute('aria-label', trackTitle(track) + ' over time, by pipeline');
  curves.note.textContent = noteOnSingles(track, of, shown);
  readCurves(track, null);
}

function noteOnSingles(track, of, shown) {
  const held = curves.kept.length < RUNS ? ' The page holds the curves of ' + curves.kept.length + ' runs.' : '';
  const pinned = chosen.pinned === null ? '' : curves.rows.has(chosen.pinned)
    ? ' Black: run ' + numberOf(chosen.pinned) + '.' : ' The curve of run ' + numberOf(chosen.pinned) +
      ' is not among them.';
  if (!hasBand(track)) {
    const own = of ? 'Thin: ' + Math.min(of, MOST_LINES) + ' of ' + of + ' runs, as far as they came.'
      : 'None of the chosen runs has this curve.';
    return (noneGood() ?? 'No good run has this curve') + '. ' + own + held + pinned;
  }
  if (chosen.count === RUNS) return 'Choose runs above to see their own curves.' + held + pinned;
  const singles = shown.filter(run => run !== chosen.pinned).length;
  return 'Thin: ' + singles + (of > singles ? ' of ' + of : '') + ' chosen runs.' + held + pinned;
}

function readCurves(track, index) {
  const parts = track.bands.filter(band => band.median.some(v => v !== null)).map(band => element('span', {},
    pipelineLabel(band.pipeline), index === null || index === undefined ? ''
      : ' ' + short(band.median[index]) + ' (' + short(band.low[index]) + ' to ' + short(band.high[index]) + ')'));
  const at = index === null || index === undefined ? '' : 'at ' + short(data.curves.times_s[index]) + ' s: ';
  curves.read.replaceChildren(at, ...parts.flatMap(part => [part, ' ']), isForce(track) ? 'dotted: measured' : '');
}

function curveSection() {
  if (!data.curves) return;
  openTracks();
  if (!data.curves.tracks.some(track => hasBand(track) || allRuns.some(run => hasOwn(track, run)))) {
    section('Curves', element('p', {},
      (noneGood() ?? 'No run has a curve') + ', so there is nothing to draw.'));
    return;
  }
  const tracks = data.curves.tracks, names = [...new Set(tracks.map(track => track.curve))];
  const force = tracks.findIndex(track => track.unit === 'N');
  curves.track = Math.max(0, force);
  curves.holder = element('div', {role: 'img'});
  curves.note = element('p', {class: 'soft'});
  curves.read = element('p', {class: 'curve-legend'});
  const laws = () => tracks.filter(track => track.curve === tracks[curves.track].curve);
  const controls = () => element('div', {class: 'choices'},
    names.length < 2 ? null : chooser('Curve', names.map(inWords), names.indexOf(tracks[curves.track].curve),
      index => { curves.track = tracks.findIndex(track => track.curve === names[index]); redraw(); }),
    laws().length < 2 ? null : chooser('Force law', laws().map(track => track.law),
      laws().indexOf(tracks[curves.track]),
      index => { curves.track = tracks.indexOf(laws()[index]); redraw(); }));
  const title = element('h3', {});
  let box = controls();
  const redraw = () => {
    title.textContent = trackTitle(tracks[curves.track]);
    const next = controls();
    box.replaceWith(next);
    box = next;
    drawCurves();
  };
  const every = data.curves.every > 1 ? ' One in ' + data.curves.every + ' of the ' + data.curves.stored +
    ' stored instants is drawn.' : '';
  section('Curves', element('p', {class: 'soft'},
    'Line: the median of each pipeline’s good runs at each instant; band: from 10 % to 90 % of them.' +
    every), box, element('figure', {class: 'plot', 'data-plot': 'sweep_curves'}, element('figcaption', {}, title),
      curves.holder),
  curves.read, curves.note);
  title.textContent = trackTitle(tracks[curves.track]);
  let waiting = null;
  chosen.views.push(() => { clearTimeout(waiting); waiting = setTimeout(drawCurves, 120); });
  drawCurves();
}
