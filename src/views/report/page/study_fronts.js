// ---- a study of accuracy and cost: error over cost for each quantity, orders, answers

const tradeoff = data.tradeoff;
const fronts = {plots: [], hidden: new Set(), chosen: null};
const SHAPES = ['circle', 'square', 'up', 'diamond', 'down', 'plus', 'pentagon', 'star', 'hexagon', 'cross'];
const pipelinesOf = tradeoff ? [...new Set(tradeoff.settings.map(setting => setting.pipeline))] : [];
const COSTS = {us_per_ms: 'a simulated millisecond, mean step', p99_us_per_ms: 'a simulated millisecond, 99th percentile',
  us_per_step: 'a step, mean', p99_us_per_step: 'a step, 99th percentile', processor_s_per_s: 'processor time of a simulated second',
  memory_mib: 'memory'};
const costTitle = () => 'step time of a simulated ms' + (tradeoff.cost === 'us_per_ms' ? '' : ', 99th percentile');

// With an SI prefix: 23.02 mm, 1.5 µN.
function sized(value, unit) {
  if (value === null) return '–';
  const prefixes = [[1e-3, 'm'], [1e-6, 'µ'], [1e-9, 'n']], size = Math.abs(value);
  if (!unit || size === 0 || (size >= 1 && unit !== 'm')) return withUnit(value, unit);
  const [scale, prefix] = prefixes.find(([least]) => size >= 0.9999 * least) ?? prefixes[2];
  return short(Number((value / scale).toPrecision(6))) + ' ' + prefix + unit;
}
const costText = (name, value) => value === null ? '–' : name === 'memory_mib' ? short(value) + ' MiB'
  : name === 'processor_s_per_s' ? short(value) + ' s' : microseconds(value);

function spreadText(spread, show) {
  if (spread.median === null) return '–';
  return show(spread.median) + (spread.count > 1 ? ' (' + show(spread.low) + ' to ' + show(spread.high) + ')' : '');
}

const settingText = setting => setting.pipeline + ': ' +
  setting.values.map((value, i) => tradeoff.names[i] + ' ' + value).join(', ');

function pipelineMark(pipeline, x, y, radius, hollow, front) {
  const index = pipelinesOf.indexOf(pipeline), {stroke} = styleOf(index);
  return drawn('g', {class: 'setting-mark', 'data-pipeline': pipeline},
    outline(SHAPES[index % SHAPES.length], x, y, radius, hollow ? {fill: '#fff', 'fill-opacity': 0.6, stroke, 'stroke-width': 1.8}
      : {fill: stroke, stroke: front ? '#000' : '#fff', 'stroke-width': front ? 1.8 : 0.8}));
}

// ---- what a plot shows: `error` of each setting, lines across, a front

function quantityPlot(quantity, index) {
  const references = quantity.references.map(at => tradeoff.references[at]);
  const kept = references.filter(one => !one.refused), several = references.length > 1;
  const refused = references.filter(one => one.refused);
  const label = (one, what) => what + (several ? ' of ' + one.pipeline : '') + ' ';
  return {id: quantity.name, title: quantity.name + ' (' + quantity.measure + ')',
    show: value => sized(value, quantity.units),
    error: setting => {
      const error = setting.errors[index], reference = tradeoff.references[error.reference];
      if (error.counts !== null) return {value: error.counts, hollow: false};
      return reference && reference.refused && error[quantity.measure] !== null
        ? {value: error[quantity.measure], hollow: true} : null;
    },
    floors: kept.filter(one => one.own_error !== null)
      .map(one => ({value: one.own_error, text: label(one, 'the reference’s own error') + sized(one.own_error, quantity.units)})),
    limits: kept.filter(one => one.tolerance !== null)
      .map(one => ({value: one.tolerance, text: label(one, 'tolerance') + sized(one.tolerance, quantity.units)})),
    front: quantity.front.map(at => [tradeoff.settings[at], Math.max(tradeoff.settings[at].errors[index].counts,
      tradeoff.references[tradeoff.settings[at].errors[index].reference].own_error ?? 0)]),
    refused: refused.map(one => 'Reference' + (several ? ' of ' + one.pipeline : '') + ' refused: ' + one.refused +
      '. Open marks are differences to it, and no errors: it has not converged.')};
}

function weighedPlot() {
  const on = tradeoff.settings.filter(setting => setting.front)
    .sort((a, b) => a.cost[tradeoff.cost].median - b.cost[tradeoff.cost].median);
  return {id: 'weighed', title: 'all together: the largest error over its tolerance', show: short, floors: [],
    error: setting => setting.weighed === null ? null : {value: setting.weighed, hollow: false},
    limits: [{value: 1, text: 'every error at most its tolerance'}],
    front: on.map(setting => [setting, setting.weighed]), refused: []};
}

// ---- drawing

function pointsIn(plot) {
  return tradeoff.settings.filter(setting => !fronts.hidden.has(setting.pipeline)).flatMap(setting => {
    const error = plot.error(setting), cost = setting.cost[tradeoff.cost];
    return error && cost.median > 0 ? [{setting, cost, ...error}] : [];
  });
}

function acrossLine(box, y, kind, text, above) {
  return drawn('g', {class: kind}, drawn('line', {x1: box.left, x2: box.left + box.width, y1: y, y2: y}),
    drawn('text', {x: box.left + box.width - 4, y: above ? y - 4 : y + 12, 'text-anchor': 'end'}, text));
}

// From each setting of the front to the next: what can be had for at most this cost.
function stepLine(plot, box, xOf, yOf) {
  const points = plot.front.filter(([setting]) => !fronts.hidden.has(setting.pipeline))
    .map(([setting, error]) => [xOf(setting.cost[tradeoff.cost].median), yOf(error)]);
  if (!points.length) return null;
  let path = 'M' + points[0][0].toFixed(1) + ' ' + points[0][1].toFixed(1);
  for (const [x, y] of points.slice(1)) path += 'H' + x.toFixed(1) + 'V' + y.toFixed(1);
  return drawn('path', {class: 'front', d: path + 'H' + (box.left + box.width)});
}

function valueAxis(plot, axis, box, zero) {
  const made = drawn('g', {class: 'axis'});
  if (axis) for (const [value, text] of axis.marks()) {
    const y = box.top + (1 - axis.at(value)) * box.height;
    if (zero && y > zero - 15) continue;
    made.append(drawn('line', {x1: box.left - 4, x2: box.left + box.width, y1: y, y2: y, class: 'grid'}),
      drawn('text', {x: box.left - 7, y: y + 4, 'text-anchor': 'end'}, text));
  }
  if (zero) made.append(drawn('text', {x: box.left - 7, y: zero + 4, 'text-anchor': 'end'}, '0'),
    drawn('line', {x1: box.left, x2: box.left + box.width, y1: zero, y2: zero, class: 'grid'}));
  return made;
}

function drawFront(plot) {
  const points = pointsIn(plot);
  plot.holder.classList.toggle('empty', points.length === 0);
  plot.spots = [];
  if (points.length === 0) return plot.holder.replaceChildren();
  const width = Math.max(230, plot.holder.clientWidth), positive = [...points.map(point => point.value),
    ...plot.floors.map(one => one.value), ...plot.limits.map(one => one.value)].filter(value => value > 0);
  const zeros = points.some(point => point.value === 0) ? 30 : 0;  // a strip below: no logarithmic axis has a 0
  const box = {left: 66, top: 10, width: width - 66 - 12, height: 250 - zeros}, foot = {...box, height: 250};
  const xAxis = axisOver(points.flatMap(({cost}) => [cost.low, cost.median, cost.high]).filter(value => value > 0), true, microseconds);
  const yAxis = positive.length ? axisOver(positive, true, plot.show) : null;
  const xOf = cost => box.left + xAxis.at(cost) * box.width;
  const yOf = error => error > 0 ? box.top + (1 - yAxis.at(error)) * box.height : foot.top + foot.height - 13;
  const svg = drawn('svg', {class: 'map', width, height: 300, viewBox: '0 0 ' + width + ' 300', role: 'group',
    'aria-label': plot.title + ' over cost: ' + points.length + ' settings; arrow keys go from one to the next'});
  for (const {value} of plot.floors) if (value > 0) svg.append(drawn('rect', {class: 'below', x: box.left, y: yOf(value),
    width: box.width, height: foot.top + foot.height - yOf(value)}));
  svg.append(acrossAxis(xAxis, foot, costTitle()), valueAxis(plot, yAxis, box, zeros ? yOf(0) : 0), plotFrame(foot));
  const at_ms = xAxis.at(1000);
  if (at_ms > 0 && at_ms < 1) svg.append(drawn('g', {class: 'real-time'},
    drawn('line', {x1: xOf(1000), x2: xOf(1000), y1: box.top, y2: foot.top + foot.height}),
    drawn('text', {x: xOf(1000) + 4, y: foot.top + 12}, 'real time')));
  for (const {value, text} of plot.limits) if (value > 0) svg.append(acrossLine(box, yOf(value), 'limit', text, true));
  for (const {value, text} of plot.floors) if (value > 0) svg.append(acrossLine(box, yOf(value), 'floor', text, yOf(value) > 240));
  svg.append(...[stepLine(plot, box, xOf, yOf)].filter(line => line !== null));
  plot.spots = points.map(({setting, cost, value, hollow}) => {
    const x = xOf(cost.median), y = yOf(value), front = plot.front.some(([one]) => one === setting);
    const node = pipelineMark(setting.pipeline, x, y, 6.5, hollow, front), spoken = settingText(setting) + '; ' +
      (hollow ? 'difference ' : 'error ') + plot.show(value) + ', ' + microseconds(cost.median) + (front ? ', on the front' : '');
    node.prepend(drawn('line', {class: 'bar', x1: xOf(cost.low), x2: xOf(cost.high), y1: y, y2: y,
      stroke: styleOf(pipelinesOf.indexOf(setting.pipeline)).stroke}));
    node.append(drawn('title', {}, spoken));
    node.setAttribute('role', 'button');
    node.setAttribute('aria-label', spoken);
    return {x, y, node, setting};
  });
  svg.append(...plot.spots.map(spot => spot.node));
  choosable(svg, plot.spots, spot => chooseSetting(plot, spot.setting));
  plot.holder.replaceChildren(svg);
  ringSetting(plot);
}

function ringSetting(plot) {
  for (const old of plot.holder.querySelectorAll('.ring')) old.remove();
  const spot = plot.spots.find(one => one.setting === fronts.chosen);
  if (spot) plot.holder.firstChild.append(ring(spot, 11));
}

function chooseSetting(plot, setting) {
  if (fronts.chosen === setting && plot.details.hasChildNodes()) return;
  fronts.chosen = setting;
  for (const other of fronts.plots) {
    if (other !== plot) other.details.replaceChildren();
    ringSetting(other);
  }
  plot.details.replaceChildren(settingDetails(setting));
}

// ---- tables

function errorRow(setting, quantity, index) {
  const error = setting.errors[index], reference = tradeoff.references[error.reference];
  const show = value => element('td', {}, sized(value, quantity.units));
  return element('tr', {}, element('th', {scope: 'row'}, quantity.name), show(error.rms), show(error.worst), show(error.peak),
    element('td', {}, error.counts !== null ? sized(error.counts, quantity.units)
      : reference && reference.refused ? 'refused' : 'not measured'),
    show(reference ? reference.own_error : null));
}

function settingDetails(setting) {
  const status = setting.status + (setting.detail ? ': ' + setting.detail : '');
  const costs = Object.entries(COSTS).map(([name, words]) => {
    const spread = setting.cost[name];
    return element('tr', {}, element('th', {scope: 'row'}, name === tradeoff.cost ? element('b', {}, words) : words),
      element('td', {}, costText(name, spread.median)),
      element('td', {}, spread.count > 1 ? costText(name, spread.low) + ' to ' + costText(name, spread.high) : '–'));
  });
  return element('div', {class: 'readout'},
    element('div', {}, element('p', {class: 'verdict'}, markBox(pipelineMark(setting.pipeline, 0, 0, 10, false, false)),
      element('b', {}, setting.pipeline), setting.front ? ' is on the front of all errors together' : ''),
    factList([...tradeoff.paths.map((path, i) => [path, setting.values[i]]), ['status', status],
      ['largest error over its tolerance', short(setting.weighed)]]), commandBox(setting.command)),
    element('div', {}, headedTable('numbers', ['cost', 'median', 'quartiles'], costs),
      headedTable('numbers', ['error', 'rms', 'worst', 'peak', 'counts', 'reference'],
        tradeoff.quantities.map((quantity, index) => errorRow(setting, quantity, index)))));
}

function failedRows() {
  return tradeoff.settings.flatMap(setting => {
    const lost = tradeoff.quantities.filter((quantity, i) => {
      const error = setting.errors[i], reference = tradeoff.references[error.reference];
      return error.counts === null && reference && !reference.refused;
    }).map(quantity => quantity.name);
    const why = setting.status !== 'ok' ? setting.status.replaceAll('_', ' ') + (setting.detail ? ': ' + setting.detail : '')
      : lost.length ? 'not measured: ' + lost.join(', ') : '';
    return why === '' ? [] : [element('tr', {}, element('td', {}, settingText(setting)), element('td', {class: 'problem'}, why),
      element('td', {}, commandBox(setting.command)))];
  });
}

function answerRow(answer) {
  const setting = tradeoff.settings[answer.setting ?? answer.nearest] ?? null;
  const cost = one => one ? spreadText(one.cost[tradeoff.cost], microseconds) : '–';
  const errors = one => tradeoff.quantities.flatMap((quantity, i) => one.errors[i].counts === null ? []
    : [quantity.name + ' ' + sized(one.errors[i].counts, quantity.units)]).join(', ');
  const both = one => one ? cost(one) + '; ' + errors(one) : '–';
  const verdict = answer.setting === null ? 'no setting' : answer.holds === null ? 'not run again'
    : answer.holds ? 'holds' : 'does not hold';
  const chosen = setting === null ? 'none' : (answer.setting === null ? 'none; the nearest, ' + short(answer.times_beyond) +
    ' times beyond: ' : '') + settingText(setting);
  return element('tr', {}, element('td', {}, answer.wish),
    element('td', {}, chosen, answer.scenario ? element('div', {}, element('a', {
      href: data.folder + encodeURIComponent(answer.scenario)}, answer.scenario)) : null),
    element('td', {}, both(setting)), element('td', {}, both(answer.again)),
    element('td', {class: answer.holds ? 'good' : answer.holds === false || answer.setting === null ? 'bad' : ''}, verdict));
}

function orderRow(order) {
  const along = order.path.endsWith('.subdivisions') ? 'width of ' + order.path : order.path, {low, high, count} = order.order;
  const two = value => value === null ? '–' : value.toFixed(2).replace(/^-(0\.00)$/, '$1');
  return element('tr', {}, element('td', {}, order.quantity), element('td', {}, order.pipeline), element('td', {}, along),
    element('td', {}, two(order.order.median)), element('td', {}, count > 1 ? two(low) + ' to ' + two(high) : '–'),
    element('td', {}, String(count)));
}

function referenceRow(reference) {
  const show = value => element('td', {}, sized(value, reference.units));
  return element('tr', {}, element('td', {}, reference.quantity), element('td', {}, reference.pipeline), show(reference.own_error),
    element('td', {}, reference.order === null ? '–' : reference.order.toFixed(2)), show(reference.peak), show(reference.tolerance),
    element('td', {class: reference.refused ? 'problem' : ''}, reference.refused ? 'refused: ' + reference.refused : 'converges'));
}

// ---- the section

function frontFigure(plot) {
  plot.holder = element('div', {});
  plot.details = element('div', {class: 'details', 'data-quantity': plot.id, 'aria-live': 'polite'});
  fronts.plots.push(plot);
  const figure = element('figure', {class: 'panel', 'data-quantity': plot.id},
    element('figcaption', {}, element('h3', {}, plot.title),
      ...plot.refused.map(text => element('span', {class: 'note refused'}, text))), plot.holder);
  return [figure, plot.details];
}

function pipelineChoice(pipeline) {
  const box = element('input', {type: 'checkbox', checked: true, 'data-pipeline': pipeline, onchange: () => {
    if (box.checked) fronts.hidden.delete(pipeline); else fronts.hidden.add(pipeline);
    showFronts();
  }});
  return element('label', {}, box, markBox(pipelineMark(pipeline, 0, 0, 9, false, false)), pipeline);
}

function showFronts() {
  for (const plot of fronts.plots) drawFront(plot);
}

function tradeoffSection() {
  if (!tradeoff) return;
  const plots = tradeoff.quantities.map(quantityPlot);
  if (plots.length > 1 && tradeoff.settings.some(setting => setting.weighed !== null)) plots.unshift(weighedPlot());
  const failed = failedRows();
  section('What accuracy costs', tradeoff.description ? element('p', {}, tradeoff.description) : null,
    element('p', {class: 'soft'}, tradeoff.settings.length + ' settings. A mark is a setting: its median cost with quartiles, ' +
      'and its error against the reference. The black line is the front: what no cheaper setting beats. Grey is below the ' +
      'reference’s own error, where nothing is told apart. Click a mark, or step over them with the arrow keys, for all its ' +
      'numbers and the command that runs it again.'),
    element('div', {class: 'choices'}, ...pipelinesOf.map(pipelineChoice)),
    element('div', {class: 'panels'}, ...plots.flatMap(frontFigure)));
  if (tradeoff.answers.length) section('Answers', headedTable('text answers',
    ['wish', 'setting', 'cost and errors', 'run again', 'verdict'], tradeoff.answers.map(answerRow)));
  if (failed.length) section('Settings without a result',
    headedTable('text failed', ['setting', 'why', 'command'], failed));
  section('Orders', element('p', {class: 'soft'}, 'The power of a size with which an error falls, along an axis that changes ' +
    'alone; the median where it changes along several lines.'), tradeoff.orders.length
    ? headedTable('text orders', ['error of', 'pipeline', 'along', 'order', 'quartiles', 'lines'], tradeoff.orders.map(orderRow))
    : element('p', {}, 'None can be observed: that takes three sizes whose errors are above the reference’s own.'));
  section('References', headedTable('text references',
    ['quantity', 'pipeline', 'own error', 'order', 'peak', 'tolerance', ''], tradeoff.references.map(referenceRow)));
  showFronts();
}
