// The page of studies: marks that are told apart without colour, axes, and what both sections show of a run.

// ---- marks: outlines about the origin, within a circle of radius 1

const corners = (count, turn, radii = [1]) => Array.from({length: count}, (none, i) => {
  const angle = (turn + 360 * i / count) * Math.PI / 180, radius = radii[i % radii.length];
  return [radius * Math.sin(angle), -radius * Math.cos(angle)];
});
const turned = (points, angle) => points.map(([x, y]) => [x * Math.cos(angle) - y * Math.sin(angle),
  x * Math.sin(angle) + y * Math.cos(angle)]);
const PLUS = [[-0.45, -1], [0.45, -1], [0.45, -0.45], [1, -0.45], [1, 0.45], [0.45, 0.45], [0.45, 1], [-0.45, 1],
  [-0.45, 0.45], [-1, 0.45], [-1, -0.45], [-0.45, -0.45]];
const OUTLINES = {
  circle: corners(24, 0),
  square: [[-0.85, -0.85], [0.85, -0.85], [0.85, 0.85], [-0.85, 0.85]],
  diamond: corners(4, 0, [1.15]),
  up: [[0, -1.15], [1.15, 0.85], [-1.15, 0.85]],
  down: [[0, 1.15], [1.15, -0.85], [-1.15, -0.85]],
  pentagon: corners(5, 0, [1.1]),
  hexagon: corners(6, 90, [1.05]),
  star: corners(16, 0, [1.2, 0.8]),
  plus: PLUS,
  cross: turned(PLUS, Math.PI / 4),
  flag: [[-0.8, -1], [1.1, -1], [0.6, 0], [1.1, 1], [-0.8, 1]],
};

// Colours as in scripts/study_map.py.
const CLASSES = {
  refused: ['#4a4a8a', 'square', 'R'],
  crashed: ['#000000', 'hexagon', 'X'],
  too_slow: ['#7f7f7f', 'flag', 'T'],
  non_finite: ['#8c1515', 'star', 'N'],
  unsound_alone: ['#9467bd', 'pentagon', 'U'],
  passed_through: ['#d62728', 'up', 'P'],
  penetrating: ['#ff7f0e', 'down', 'D'],
  energy_growing: ['#e377c2', 'plus', 'E'],
  chattering: ['#e8c400', 'diamond', 'C'],
  force_out_of_range: ['#17becf', 'cross', 'F'],
  untouched: ['#ffffff', 'circle', '0'],
  stable: ['#2ca02c', 'circle', 'S'],
};
const UNKNOWN_CLASS = ['#dddddd', 'square', '?'];

// Whether white is read better than black on a colour: by its relative luminance (WCAG).
function isDark(colour) {
  const [r, g, b] = [1, 3, 5].map(at => parseInt(colour.slice(at, at + 2), 16) / 255)
    .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b < 0.179;
}

function outline(shape, x, y, radius, attributes) {
  const points = OUTLINES[shape].map(([dx, dy]) => (x + dx * radius).toFixed(1) + ',' + (y + dy * radius).toFixed(1));
  return drawn('polygon', {points: points.join(' '), ...attributes});
}

function classMark(name, x, y, radius) {
  const [colour, shape, letter] = CLASSES[name] ?? UNKNOWN_CLASS;
  const lower = {up: 0.22, down: -0.22}[shape] ?? 0;
  return drawn('g', {class: 'class-mark', 'data-class': name},
    outline(shape, x, y, radius, {fill: colour, stroke: '#000', 'stroke-width': 0.8}),
    radius < 8 ? null : drawn('text', {x, y: y + lower * radius + 3.8, class: isDark(colour) ? 'light' : 'dark',
      'text-anchor': 'middle'}, letter));
}

const markBox = (...children) => drawn('svg', {class: 'mark-box', viewBox: '-14 -14 28 28', 'aria-hidden': 'true'}, ...children);

// ---- axes

const LETTER = 6.7;  // px, on average
const cut = (text, room) => text.length * LETTER <= room ? text
  : text.slice(0, Math.max(1, Math.floor(room / LETTER) - 1)) + '…';

function linearMarks(min, max, count) {
  const rough = (max - min) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(digit => digit * power).find(one => one >= rough);
  const marks = [];
  for (let i = Math.ceil(min / step); i * step <= max; ++i) marks.push(Number((i * step).toPrecision(12)));
  return marks;
}

// An axis over these values: where each is (0 to 1), and its marks.
function axisOver(values, logarithmic, show = short) {
  let [min, max] = [Math.min(...values), Math.max(...values)];
  if (logarithmic) {
    const margin = max > min ? (max / min) ** 0.07 : 2;
    [min, max] = [min / margin, max * margin];
    const whole = Math.log(max / min);
    return {at: v => Math.log(v / min) / whole, marks: () => {
      const marks = valueMarks(min, max);
      return (marks.length > 1 ? marks : linearMarks(min, max, 4)).map(v => [v, show(v)]);
    }};
  }
  const margin = max > min ? 0.07 * (max - min) : Math.abs(max) || 1;
  [min, max] = [min - margin, max + margin];
  return {at: v => (v - min) / (max - min), marks: count => linearMarks(min, max, count).map(v => [v, show(v)])};
}

const axisOfList = texts => ({at: index => (index + 0.5) / texts.length, texts, marks: () => texts.map((text, i) => [i, text])});

// Marks, lines and the title of an axis to the right; marks that would lie on their neighbours are left out.
function acrossAxis(axis, box, title) {
  const made = drawn('g', {class: 'axis'}), bottom = box.top + box.height;
  let last = -Infinity;
  for (const [value, text] of axis.marks(box.width / 90)) {
    const x = box.left + axis.at(value) * box.width;
    const shown = axis.texts ? cut(text, Math.max(40, box.width / axis.texts.length - 6)) : text;
    made.append(drawn('line', {x1: x, x2: x, y1: box.top, y2: bottom + 4, class: 'grid'}));
    const half = shown.length * LETTER / 2;
    if (x - half < last + 6) continue;
    last = x + half;
    made.append(drawn('text', {x, y: bottom + 16, 'text-anchor': 'middle'}, shown, drawn('title', {}, text)));
  }
  made.append(drawn('text', {x: box.left + box.width / 2, y: bottom + 33, 'text-anchor': 'middle', class: 'title'},
    cut(title, box.width + 60), drawn('title', {}, title)));
  return made;
}

function upwardTitle(box, title) {
  return drawn('text', {x: 0, y: 0, transform: 'translate(11 ' + (box.top + box.height / 2) + ') rotate(-90)',
    'text-anchor': 'middle', class: 'title'}, cut(title, box.height + 20), drawn('title', {}, title));
}

function plotFrame(box) {
  return drawn('rect', {x: box.left, y: box.top, width: box.width, height: box.height, class: 'frame'});
}

// ---- marks that are chosen: by a click near them, by the arrow keys, by the focus

// `spots`: [{x, y, node, ...}] in a drawing. One of them is in the order of the focus.
function choosable(svg, spots, choose) {
  const reach = 22;
  svg.addEventListener('click', event => {
    const box = svg.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
    const far = spot => (spot.x - x) ** 2 + (spot.y - y) ** 2;
    const nearest = spots.reduce((best, spot) => best === null || far(spot) <= far(best) ? spot : best, null);
    if (nearest && far(nearest) <= reach * reach) focusOn(nearest);
  });
  const focusOn = spot => { spot.node.focus({preventScroll: true}); choose(spot); };
  const allow = spot => spots.forEach(one => one.node.setAttribute('tabindex', one === spot ? '0' : '-1'));
  svg.addEventListener('focusin', event => {
    const spot = spots.find(one => one.node === event.target);
    if (spot) { allow(spot); choose(spot); }
  });
  svg.addEventListener('keydown', event => {
    const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
    const here = spots.find(one => one.node === event.target);
    if (!way || !here) return;
    event.preventDefault();
    let best = null, least = Infinity;
    for (const spot of spots) {
      const dx = spot.x - here.x, dy = spot.y - here.y;
      const ahead = way[0] * dx + way[1] * dy, aside = Math.abs(way[1] * dx) + Math.abs(way[0] * dy);
      if (ahead > 0 && ahead + 3 * aside < least) [best, least] = [spot, ahead + 3 * aside];
    }
    if (best) focusOn(best);
  });
  if (spots.length) allow(spots[0]);
}

// Around a mark, with a copy of it that no other mark covers.
function ring(spot, radius) {
  const copy = spot.node.cloneNode(true);
  for (const name of ['tabindex', 'role', 'aria-label']) copy.removeAttribute(name);
  return drawn('g', {class: 'ring', 'aria-hidden': 'true'},
    drawn('circle', {cx: spot.x, cy: spot.y, r: radius, stroke: '#fff', 'stroke-width': 5}),
    drawn('circle', {cx: spot.x, cy: spot.y, r: radius, stroke: '#0b5cad', 'stroke-width': 2.5}), copy);
}

// ---- what is shown of a run

function copyText(code) {
  const fallBack = () => {
    const range = document.createRange();
    range.selectNodeContents(code);
    getSelection().removeAllRanges();
    getSelection().addRange(range);
    return document.execCommand('copy');
  };
  if (!navigator.clipboard) return Promise.resolve(fallBack());
  return navigator.clipboard.writeText(code.textContent).then(() => true, fallBack);
}

function commandBox(command) {
  const code = element('code', {}, ...command.split(/(?= --)/).map(part => element('span', {}, part)));
  const button = element('button', {type: 'button', class: 'copy', onclick: () => copyText(code).then(done => {
    button.textContent = done ? 'Copied' : 'Marked: copy it by hand';
  })}, 'Copy');
  return element('div', {class: 'command'}, code, button);
}

function factList(facts) {
  return element('dl', {class: 'facts'}, ...facts.filter(fact => fact !== null)
    .map(([name, value]) => element('div', {}, element('dt', {}, name), element('dd', {}, value))));
}

const seconds = value => value === null ? '–' : value >= 1 ? short(value) + ' s' : short(1000 * value) + ' ms';
