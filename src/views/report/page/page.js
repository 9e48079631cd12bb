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
  const smaller = frames.smaller ? ' and smaller than stored' : '';
  section('Frames', element('p', {class: 'soft'},
    'The last frame up to the time of the cursor. Pictures are compressed' + smaller + '.' + thinned), grid);
}

// ---- controls

function frameTimes() {
  return [...new Set((data.frames ? data.frames.runs : []).flatMap(one => one.times_s))].sort((a, b) => a - b);
}

function stepTime(direction, fine) {
  const times = frameTimes(), small = 0.01 * step_s;
  if (fine) return setTime(state.time + direction * step_s);
  if (times.length < 2) return setTime(state.time + direction * Math.max(step_s, (last_s - first_s) / 100));
  const next = direction > 0 ? times.find(time => time > state.time + small)
    : times.filter(time => time < state.time - small).pop();
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
  const slider = element('input',
    {type: 'range', id: 'time', min: first_s, max: last_s, step: step_s, 'aria-label': 'time, seconds'});
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
    const box = element('input',
      {type: 'checkbox', checked: true, 'data-run': run, onchange: () => setHidden(run, !box.checked)});
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
    ['Ended', run => run.end.status, run => run.end.finished ? '' : 'bad'],
    ['Verdict', run => run.end.verdict, run => 'verdict ' + run.end.grade],
    ['Pipeline', run => run.pipeline + (run.precision ? ', ' + run.precision : ''), () => ''],
  ].map(([label, text, kind]) => element('tr', {}, element('th', {scope: 'row'}, label),
    ...data.runs.map(run => element('td', {class: kind(run)}, text(run)))));
  table.querySelector('tbody').prepend(...rows);
  section('Side by side', table, data.reaction_note ? element('p', {class: 'soft'}, data.reaction_note) : null, expectations(),
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
  if (data.scenario) made.append(element('details', {},
    element('summary', {}, 'Scenario, every default written out'), element('pre', {}, data.scenario)));
  if (data.provenance.length) made.append(element('details', {open: true}, element('summary', {}, 'Provenance'),
    headedTable('text', ['', ''], data.provenance.map(([name, value]) => element('tr', {},
      element('th', {scope: 'row'}, name), element('td', {}, value))))));
}

function footer() {
  page.append(element('footer', {}, 'Made by ' + data.program + '. Plots: uPlot 1.6.32, MIT licence. ',
    data.kind === 'result' ? 'Series are thinned out; the smallest and the largest value of each span are kept.'
      : ''));
}

// ---- a folder of results

function folderRows(result) {
  const name = result.page ? element('a', {href: result.page}, result.name) : result.name;
  if (result.problem) return [element('tr', {}, element('th', {scope: 'row'}, name),
    element('td', {class: 'problem', colspan: data.columns.length + 3}, result.problem))];
  if (result.note) return [element('tr', {},
    element('th', {scope: 'row'}, name, element('br'), element('span', {class: 'soft'}, result.title)),
    element('td', {class: 'left', colspan: data.columns.length + 3}, result.note))];
  const rows = result.runs.map((run, index) => element('tr', {},
    index > 0 ? null : element('th', {scope: 'row', rowspan: result.runs.length},
      name, element('br'), element('span', {class: 'soft'}, result.title)),
    element('td', {class: 'left'}, run.name),
    element('td', {class: run.end.finished ? 'left' : 'left bad'}, run.end.status),
    element('td', {class: 'left verdict ' + run.end.grade}, run.end.verdict),
    ...result.numbers[index].map(cell => element('td', {class: cell.bad ? 'bad' : ''}, cell.text))));
  return rows.length ? rows : [element('tr', {}, element('th', {scope: 'row'}, name),
    element('td', {class: 'problem', colspan: data.columns.length + 3}, 'no run'))];
}

function folder() {
  heading();
  const count = data.results.length + (data.results.length === 1 ? ' file' : ' files');
  const columns = data.columns.map(column => column.label + (column.unit ? ', ' + column.unit : ''));
  page.append(element('p', {class: 'soft'}, count),
    headedTable('results', ['result', 'run', 'ended', 'verdict', ...columns], data.results.flatMap(folderRows)));
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
