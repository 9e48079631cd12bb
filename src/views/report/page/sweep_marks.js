// ---- marks and axes of maps

const MARGIN = {left: 62, right: 10, top: 6, bottom: 42};

function hatch(context, x, y, width, height) {
  context.save();
  context.beginPath();
  context.rect(x, y, width, height);
  context.clip();
  context.strokeStyle = '#9aa4ae';
  context.lineWidth = 1;
  context.beginPath();
  for (let at = -height; at < width; at += 6) {
    context.moveTo(x + at, y + height);
    context.lineTo(x + at + height, y);
  }
  context.stroke();
  context.restore();
}

function openCircle(context, x, y, size) {
  context.strokeStyle = '#6e7781';
  context.lineWidth = 1.2;
  context.beginPath();
  context.arc(x, y, size, 0, 2 * Math.PI);
  context.stroke();
}

// Every mark, every second one ... so that none lies on its neighbour.
function fitting(marks, long, room) {
  for (let skip = 1; skip < marks.length; ++skip) {
    const some = marks.filter((mark, i) => i % skip === 0);
    const clear = ([at, text], i) => i === 0 ||
      Math.abs(at - some[i - 1][0]) * long >= (room(text) + room(some[i - 1][1])) / 2;
    if (some.every(clear)) return some;
  }
  return marks.slice(0, 1);
}

// Texts are cut off where they would lie on their neighbours; the whole is their title.
function textLabel(axis, index, text, place) {
  const label = element('span', {class: 'label', title: axis.levels[index]}, text);
  for (const [name, size] of Object.entries(place)) label.style[name] = size + 'px';
  return label;
}

function labelsAcross(context, marks, inner, height) {
  const longest = Math.max(...marks.map(([at, text]) => context.measureText(text).width)) + 8;
  const skip = Math.ceil((longest <= 64 ? longest : 44) * marks.length / inner.width);
  const width = skip * inner.width / marks.length - 4, top = height - MARGIN.bottom + 3;
  const last = MARGIN.left + inner.width + MARGIN.right - width;
  return marks.flatMap(([at, text], i) => i % skip ? [] : [textLabel(maps.x, i, text,
    {left: Math.min(last, MARGIN.left + at * inner.width - width / 2), top, width})]);
}

function labelsUpwards(marks, inner) {
  const skip = Math.ceil(14 * marks.length / inner.height);
  return marks.flatMap(([at, text], i) => i % skip ? [] : [textLabel(maps.y, i, text,
    {left: 16, top: MARGIN.top + (1 - at) * inner.height - 8, width: MARGIN.left - 20})]);
}

// Labels along an axis of cells or of points.
function drawAxes(panel, context, width, height, xMarks, yMarks) {
  const inner = {width: width - MARGIN.left - MARGIN.right, height: height - MARGIN.top - MARGIN.bottom};
  panel.labels.replaceChildren(...(maps.x.text ? labelsAcross(context, xMarks, inner, height) : []),
    ...(maps.y && maps.y.text ? labelsUpwards(yMarks, inner) : []));
  context.fillStyle = INK;
  context.textAlign = 'center';
  context.textBaseline = 'top';
  const room = text => context.measureText(text).width + 7;
  for (const [at, text] of fitting(maps.x.text ? [] : xMarks, inner.width, room)) {
    const half = context.measureText(text).width / 2;
    context.fillText(text, Math.min(MARGIN.left + at * inner.width, width - half), height - MARGIN.bottom + 5);
  }
  context.fillText(axisTitle(maps.x), MARGIN.left + inner.width / 2, height - 17, inner.width);
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  for (const [at, text] of fitting(maps.y && maps.y.text ? [] : yMarks, inner.height, () => 14))
    context.fillText(text, MARGIN.left - 5, MARGIN.top + (1 - at) * inner.height, MARGIN.left - 20);
  context.save();
  context.translate(8, MARGIN.top + inner.height / 2);
  context.rotate(-Math.PI / 2);
  context.textAlign = 'center';
  context.fillText(axisTitle(maps.y ?? maps.metric), 0, 0, inner.height + 30);
  context.restore();
  context.strokeStyle = '#9aa4ae';
  context.lineWidth = 1;
  context.strokeRect(MARGIN.left - 0.5, MARGIN.top - 0.5, inner.width + 1, inner.height + 1);
}

const axisTitle = column => column.title + (column.log && (column.isAxis || maps.y === null) ? ' (logarithmic)' : '');
