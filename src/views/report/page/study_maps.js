// ---- a study of stability: maps of classes over one or two axes

const stability = data.stability;
const maps = {panels: [], map: null, pipeline: null, hidden: new Set(), chosen: null, counts: [], boundaries: null,
  nothing: null};
const ROW = {two: 46, one: 60}, GRID_MARK = 11, ROUND_MARK = 5.5;
const classOf = cell => cell.class === null ? null : stability.classes[cell.class].name;
const className = name => name === null ? 'not run yet' : name.replaceAll('_', ' ');
const valueText = text => text !== '' && Number.isFinite(Number(text)) ? short(Number(text)) : text;
const axisTitle = axis => axis.name + (axis.multiplies.length ? ', times' : '') +
  (axis.scale === 'logarithmic' ? ' (logarithmic)' : '');
const fitsFilter = panel => (maps.map === null || panel.map === maps.map) &&
  (maps.pipeline === null || panel.pipeline === maps.pipeline);
const isShown = cell => !maps.hidden.has(cell.class);

function spokenCell(panel, cell) {
  const values = panel.axes.map((axis, i) => axis.name + ' ' + valueText(cell.values[i])).join(', ');
  return values + ': ' + className(classOf(cell)) + (cell.reason ? ', ' + cell.reason : '');
}

function cellDetails(panel, cell) {
  const name = classOf(cell);
  const facts = [
    ...panel.axes.map((axis, i) => [axis.multiplies.length ? axis.path + ', times' : axis.path, cell.values[i]]),
    ['map, pipeline', panel.map + ', ' + panel.pipeline],
    cell.frequency_Hz ? ['frequency', short(cell.frequency_Hz) + ' Hz'] : null,
    ['wall time', seconds(cell.wall_s)],
    ['run', cell.round === 0 ? 'on the grid' : 'round ' + cell.round + ' of halving'],
  ];
  const link = cell.result ? element('p', {}, 'Result: ', element('a', {
    href: data.folder + cell.result.split('/').map(encodeURIComponent).join('/')}, cell.result)) : null;
  return element('div', {class: 'readout'},
    element('div', {}, element('p', {class: 'verdict'}, markBox(classMark(name, 0, 0, GRID_MARK)),
      element('b', {}, className(name)), cell.reason ? ': ' + cell.reason : ''), factList(facts)),
    element('div', {}, commandBox(cell.command), link));
}

// The row of values of the first axis; what is right and above of it.
function mapBox(panel, width) {
  const pitch = panel.axes.length > 1 ? ROW.two : ROW.one;
  const longest = Math.max(0, ...panel.rows.map(text => valueText(text).length * LETTER));
  const left = panel.axes.length > 1 ? Math.min(width / 3.5, longest + 30) : 14;
  return {left, top: 14, width: width - left - 12, height: panel.rows.length * pitch, pitch};
}

function rowAxis(panel, box) {
  const made = drawn('g', {class: 'axis'});
  if (panel.axes.length < 2) return made;
  panel.rows.forEach((text, row) => {
    const y = box.top + box.height - (row + 0.5) * box.pitch;
    made.append(drawn('line', {x1: box.left - 4, x2: box.left + box.width, y1: y, y2: y, class: 'grid'}),
      drawn('text', {x: box.left - 7, y: y + 4, 'text-anchor': 'end'}, cut(valueText(text), box.left - 26),
        drawn('title', {}, text)));
  });
  made.append(upwardTitle(box, panel.axes[0].name + (panel.axes[0].multiplies.length ? ', times' : '')));
  return made;
}

function boundaryBars(panel, box, axis) {
  const made = drawn('g', {class: 'boundaries'}), ends = panel.rows.map(() => -Infinity);
  for (const boundary of [...panel.boundaries].sort((a, b) => a.x - b.x)) {
    const x = box.left + axis.at(boundary.x) * box.width, text = short(boundary.x);
    const middle = box.top + box.height - (boundary.row + 0.5) * box.pitch, half = text.length * 3;
    made.append(drawn('line', {x1: x, x2: x, y1: middle - 15, y2: middle + 15},
      drawn('title', {}, 'boundary between ' + short(boundary.below) + ' and ' + short(boundary.above))));
    if (x - half < ends[boundary.row] + 4) continue;  // labels that would cover each other are left out
    ends[boundary.row] = x + half;
    made.append(drawn('text', {x, y: middle - 18, 'text-anchor': 'middle'}, text));
  }
  return made;
}

function drawPanel(panel) {
  const width = Math.max(230, panel.holder.clientWidth), box = mapBox(panel, width), last = panel.axes.at(-1);
  const axis = last.scale === 'values' ? axisOfList(last.grid.map(valueText))
    : axisOver(panel.cells.map(cell => cell.x), last.scale === 'logarithmic');
  const height = box.top + box.height + 40;
  const svg = drawn('svg', {class: 'map', width, height, viewBox: '0 0 ' + width + ' ' + height, role: 'group',
    'aria-label': panel.map + ', ' + panel.pipeline + ': ' + panel.cells.length + ' cells; arrow keys go from cell to cell'},
  acrossAxis(axis, box, axisTitle(last)), rowAxis(panel, box), plotFrame(box), boundaryBars(panel, box, axis));
  panel.spots = panel.cells.filter(isShown).sort((a, b) => a.round - b.round).map(cell => {
    const x = box.left + axis.at(cell.x) * box.width, y = box.top + box.height - (cell.row + 0.5) * box.pitch;
    const node = classMark(classOf(cell), x, y, cell.round === 0 ? GRID_MARK : ROUND_MARK);
    const spoken = spokenCell(panel, cell);
    for (const [name, value] of Object.entries({role: 'button', 'aria-label': spoken, 'data-round': cell.round}))
      node.setAttribute(name, value);
    node.append(drawn('title', {}, spoken));
    return {x, y, node, cell};
  });
  svg.append(...panel.spots.map(spot => spot.node));
  choosable(svg, panel.spots, spot => chooseCell(panel, spot.cell));
  panel.holder.replaceChildren(svg);
  markChosen(panel);
}

function markChosen(panel) {
  for (const old of panel.holder.querySelectorAll('.ring')) old.remove();
  const spot = panel.spots.find(one => one.cell === maps.chosen);
  if (spot) panel.holder.firstChild.append(ring(spot, spot.cell.round === 0 ? 15 : 9));
}

function chooseCell(panel, cell) {
  if (maps.chosen === cell) return;
  maps.chosen = cell;
  for (const other of maps.panels) {
    if (other !== panel) other.details.replaceChildren();
    if (other.spots) markChosen(other);
  }
  panel.details.replaceChildren(cellDetails(panel, cell));
}

function panelFigure(panel) {
  panel.holder = element('div', {});
  panel.details = element('div', {class: 'details', 'data-map': panel.map, 'aria-live': 'polite'});
  const paths = panel.axes.map(axis => axis.path + (axis.multiplies.length ? ' (times ' + axis.multiplies.join(', ') + ')' : ''));
  panel.figure = element('figure', {class: 'panel', 'data-map': panel.map, 'data-pipeline': panel.pipeline},
    element('figcaption', {}, element('h3', {}, panel.map + ', ' + panel.pipeline),
      element('span', {class: 'note'}, panel.description), element('span', {class: 'note path'}, paths.reverse().join(' × '))),
    panel.holder);
  maps.panels.push(panel);
  return [panel.figure, panel.details];
}

// ---- the legend, which filters; boundaries

function legendRow(name, index, means) {
  const box = element('input', {type: 'checkbox', checked: true, 'data-class': name, onchange: () => {
    if (box.checked) maps.hidden.delete(index); else maps.hidden.add(index);
    showMaps();
  }});
  const count = element('td', {});
  maps.counts.push([index, count]);
  return element('tr', {}, element('td', {}, element('label', {}, box, markBox(classMark(name, 0, 0, GRID_MARK)), className(name))),
    count, element('td', {}, means));
}

function legendTable() {
  const unrun = stability.panels.some(panel => panel.cells.some(cell => cell.class === null));
  return headedTable('classes', ['class', 'cells', 'what it means'], [
    ...stability.classes.map((entry, index) => legendRow(entry.name, index, entry.means)),
    ...(unrun ? [legendRow(null, null, 'the study goes on with the same command')] : [])]);
}

function mapChooser(label, names, choose) {
  return element('label', {}, label + ' ', element('select', {'aria-label': label, onchange: event => {
    choose(event.target.selectedIndex === 0 ? null : names[event.target.selectedIndex - 1]);
    showMaps();
  }}, element('option', {}, 'all'), ...names.map(name => element('option', {}, name))));
}

function boundaryRows() {
  const label = index => element('span', {class: 'of-class'}, markBox(classMark(stability.classes[index].name, 0, 0, GRID_MARK)),
    className(stability.classes[index].name));
  return stability.panels.filter(fitsFilter).flatMap(panel => panel.boundaries
    .filter(boundary => !maps.hidden.has(boundary.class_below) || !maps.hidden.has(boundary.class_above))
    .map(boundary => element('tr', {}, element('td', {}, panel.map), element('td', {}, panel.pipeline),
      element('td', {}, panel.axes.length > 1 ? panel.axes[0].name + ' = ' + valueText(panel.rows[boundary.row]) : ''),
      element('td', {}, panel.axes.at(-1).name),
      element('td', {}, short(boundary.below)), element('td', {}, short(boundary.above)),
      element('td', {}, label(boundary.class_below)), element('td', {}, label(boundary.class_above)))));
}

function showMaps() {
  for (const panel of maps.panels) {
    panel.figure.hidden = panel.details.hidden = !fitsFilter(panel);
    if (!panel.figure.hidden) drawPanel(panel);
  }
  const shown = stability.panels.filter(fitsFilter);
  for (const [index, cell] of maps.counts)
    cell.textContent = String(shown.reduce((sum, panel) => sum + panel.cells.filter(one => one.class === index).length, 0));
  maps.nothing.hidden = shown.length > 0;
  const rows = boundaryRows();
  maps.boundaries.replaceChildren(rows.length
    ? headedTable('text boundary-table', ['map', 'pipeline', 'at', 'along', 'from', 'to', 'below', 'above'], rows)
    : element('p', {}, 'None between these.'));
}

function criteriaList() {
  const facts = Object.entries(stability.criteria).map(([name, value]) =>
    [name, Array.isArray(value) ? value.join(', ') || 'all' : String(value)]);
  return element('details', {}, element('summary', {}, 'Thresholds of the classes'), factList(facts));
}

function stabilitySection() {
  if (!stability) return;
  const all = key => [...new Set(stability.panels.map(panel => panel[key]))];
  const cells = stability.panels.reduce((sum, panel) => sum + panel.cells.length, 0);
  maps.boundaries = element('div', {class: 'boundary-list'});
  maps.nothing = element('p', {hidden: true}, 'No map goes through this pipeline.');
  section('Where runs break', stability.description ? element('p', {}, stability.description) : null,
    element('p', {class: 'soft'}, cells + ' cells. A cell is a run; it has the first class of the list whose criterion holds. ' +
      'Large marks are the grid, small ones the runs that halved a boundary to ' + short(100 * stability.refine_to) +
      '\u2009%, black bars the boundaries. Click a mark, or step over them with the arrow keys, for its values and the ' +
      'command that runs it again.'),
    element('div', {class: 'choices'},
      mapChooser('Map', all('map'), name => { maps.map = name; }),
      mapChooser('Pipeline', all('pipeline'), name => { maps.pipeline = name; })),
    legendTable(), criteriaList(), maps.nothing, element('div', {class: 'panels'}, ...stability.panels.flatMap(panelFigure)));
  section('Boundaries', element('p', {class: 'soft'},
    'Between two neighbouring runs of different classes along the last axis; the classes chosen above.'), maps.boundaries);
  showMaps();
}
