// Parameter squares as SVG: the first parameter runs to the right, the second upwards.

const side = 340;
const left = 44;
const top_ = 12;

/** A framed unit square with ticks at every fifth; `x` and `y` take parameters to the drawing's units. */
function unitSquare(across, upwards, label) {
  const svg = drawing('svg', {class: 'square', viewBox: `0 0 ${left + side + 14} ${top_ + side + 40}`, role: 'group', 'aria-label': label});
  const x = (t) => left + side * t;
  const y = (t) => top_ + side * (1 - t);
  let lines = '';
  for (let i = 1; i < 5; ++i) lines += `M${x(i / 5)},${y(0)}V${y(1)}M${x(0)},${y(i / 5)}H${x(1)}`;
  svg.append(drawing('path', {class: 'grid', d: lines}));
  for (let i = 0; i <= 5; ++i) {
    const text = i === 0 ? '0' : i === 5 ? '1' : `0.${2 * i}`;
    svg.append(drawing('text', {x: x(i / 5), y: y(0) + 16, 'text-anchor': 'middle', class: 'soft'}, text));
    if (i > 0) svg.append(drawing('text', {x: x(0) - 6, y: y(i / 5) + 4, 'text-anchor': 'end', class: 'soft'}, text));
  }
  svg.append(drawing('text', {class: 'axis', x: x(0.5), y: y(0) + 34, 'text-anchor': 'middle'}, across));
  svg.append(drawing('text', {class: 'axis', x: x(0) - 30, y: y(0.5) + 4, 'text-anchor': 'middle'}, upwards));
  const content = drawing('g');
  svg.append(content, drawing('path', {class: 'frame', d: `M${x(0)},${y(0)}H${x(1)}V${y(1)}H${x(0)}Z`}));
  return {svg, content, x, y};
}

/** Vertices that a polyline needs so that no other is further than `tolerance` from it (Douglas and Peucker). */
function simplified(points, tolerance) {
  const keep = new Array(points.length).fill(false);
  const stack = [[0, points.length - 1]];
  while (stack.length) {
    const [from, to] = stack.pop();
    keep[from] = keep[to] = true;
    const chord = minus(points[to], points[from]);
    const length = Math.hypot(...chord);
    let furthest = from;
    let distance = tolerance;
    for (let i = from + 1; i < to; ++i) {
      const to_point = minus(points[i], points[from]);
      const along = length > 0 ? Math.min(1, Math.max(0, to_point.reduce((s, t, k) => s + t * chord[k], 0) / length ** 2)) : 0;
      const d = Math.hypot(...to_point.map((t, k) => t - along * chord[k]));
      if (d > distance) [furthest, distance] = [i, d];
    }
    if (furthest > from) stack.push([from, furthest], [furthest, to]);
  }
  return points.filter((_, i) => keep[i]);
}

function pathThrough(square, points) {
  return 'M' + points.map(([a, b]) => `${square.x(a).toFixed(2)},${square.y(b).toFixed(2)}`).join('L');
}

/** Arcs from node to node in a square, 0 or 1: their two parameters at every vertex. */
function arcIn(arc, square) {
  return arc.polyline.map((vertex) => [vertex[2 * square], vertex[2 * square + 1]]);
}

function drawArc(square, which, arc) {
  const points = arcIn(arc, which);
  const free = [0, 1].filter((k) => arc.free.includes(parameters[2 * which + k]));
  if (free.length) {
    const range = [0, 1].map((k) => free.includes(k) ? [0, 1] : [Math.min(...points.map((p) => p[k])), Math.max(...points.map((p) => p[k]))]);
    square.content.append(drawing('path', {class: 'strip', fill: componentColour(arc.component), d: rectanglePath(square, range)}));
  }
  const d = pathThrough(square, simplified(points, 1e-4));
  const dashes = componentDashes(arc.component);
  square.content.append(
    drawing('path', {class: arc.on === 'patch-boundary' ? 'arc side' : 'arc', 'data-arc': arc.id, d, stroke: componentColour(arc.component),
      'stroke-dasharray': arc.contact === 'tangential' ? '5 2.5' : dashes}),
    drawing('path', {class: 'hit', 'data-arc': arc.id, d}));
}

function rectanglePath(square, [[a, b], [c, d]]) {
  return `M${square.x(a)},${square.y(c)}H${square.x(b)}V${square.y(d)}H${square.x(a)}Z`;
}

/** The rim of an overlap as closed paths: every arc of a chain turned so that it begins where the one before ends. */
function overlapPath(square, which, overlap) {
  return overlap.chains.map((chain) => {
    let points = [];
    chain.forEach((arc, i) => {
      const next = chain[(i + 1) % chain.length];
      const forward = chain.length === 1 || arc.to === next.from || arc.to === next.to;
      const piece = arcIn(arc, which);
      points = points.concat(forward ? piece : piece.reverse());
    });
    return pathThrough(square, points) + 'Z';
  }).join('');
}

function drawNode(square, which, node) {
  const at = [node.approx[parameters[2 * which]], node.approx[parameters[2 * which + 1]]];
  const ranges = [0, 1].map((k) => node.free.includes(parameters[2 * which + k]) ? node.box[parameters[2 * which + k]].map(toDouble) : [at[k], at[k]]);
  if (ranges.some(([a, b]) => a !== b))
    square.content.append(drawing('path', {class: 'strip', d: rectanglePath(square, ranges), fill: nodeColour(node)}),
      drawing('path', {class: 'arc side', stroke: nodeColour(node), d: pathThrough(square, [[ranges[0][0], ranges[1][0]], [ranges[0][1], ranges[1][1]]])}));
  const label = `node ${node.id}, ${nodeWords(node)}`;
  square.content.append(drawing('g', {class: 'node', 'data-node': node.id, role: 'button', tabindex: -1, 'aria-label': label,
    transform: `translate(${square.x(at[0]).toFixed(2)},${square.y(at[1]).toFixed(2)})`},
  drawing('title', {}, label), drawing('circle', {class: 'ringed', r: 9.5}), glyphPath(glyphName(node, which), nodeColour(node)),
  drawing('text', {class: 'number', x: at[0] > 0.93 ? -9 : 9, y: at[1] > 0.95 ? 16 : -7, 'text-anchor': at[0] > 0.93 ? 'end' : 'start'}, String(node.id)),
  drawing('circle', {class: 'hit point', r: 11})));
}

/** "boundary on u=0", "turning in v". */
function nodeWords(node) {
  const words = [node.kinds.join(', ') || 'point'];
  if (node.on.length) words.push('on ' + node.on.join(', '));
  if (node.wrt.length) words.push('turning in ' + node.wrt.join(', '));
  if (node.free.length) words.push('free ' + node.free.join(', '));
  return words.join(', ').replace('turning, turning', 'turning');
}

/** The number of each component beside the middle of its longest arc. */
function labelComponents(square, which) {
  if (graph.components.length < 2) return;
  for (const component of graph.components) {
    const longest = component.arcs.map((id) => arcs[id]).sort((a, b) => b.polyline.length - a.polyline.length)[0];
    if (!longest) continue;
    const points = arcIn(longest, which);
    const middle = Math.floor(points.length / 2);
    const [a, b] = points[middle];
    const tangent = unit(minus(points[Math.min(middle + 1, points.length - 1)], points[Math.max(middle - 1, 0)]));
    const away = a * -tangent[1] + b * tangent[0] > 0.5 * (tangent[0] - tangent[1]) ? 1 : -1;
    const place = [square.x(a) - away * 13 * tangent[1], square.y(b) - away * 13 * tangent[0] + 4];
    const text = drawing('text', {class: 'label', x: Math.min(Math.max(place[0], square.x(0.035)), square.x(0.965)),
      y: Math.min(Math.max(place[1], square.y(0.96)), square.y(0.02)), 'text-anchor': 'middle', 'data-component': component.id}, String(component.id));
    text.style.fill = componentColour(component.id);
    square.content.append(text);
  }
}

/** A parameter square of the result with everything in it; `fibre` is the layer of the line that is shown. */
function resultSquare(which, caption) {
  const square = unitSquare(parameters[2 * which], parameters[2 * which + 1], `Parameter square of ${caption}`);
  for (const region of graph.incomplete)
    square.content.append(drawing('path', {class: 'undecided', d: rectanglePath(square, [0, 1].map((k) => region.where[parameters[2 * which + k]].map(toDouble)))}));
  for (const overlap of graph.overlaps)
    square.content.append(drawing('path', {class: 'overlap', 'fill-rule': 'evenodd', fill: 'url(#hatch)', d: overlapPath(square, which, overlap)}));
  for (const arc of arcs) drawArc(square, which, arc);
  square.fibre = drawing('g', {class: 'fibre-layer'});
  square.content.append(square.fibre);
  const order = [...nodes].sort((a, b) => glyphOrder.indexOf(glyphName(a, which)) - glyphOrder.indexOf(glyphName(b, which)));
  for (const node of order) drawNode(square, which, node);
  labelComponents(square, which);
  if (graph.overlaps.length) square.svg.prepend(hatch());
  oneTabStop(square.svg);
  return square;
}

/** The pattern of overlaps. */
function hatch() {
  return drawing('defs', {}, drawing('pattern', {id: 'hatch', width: 7, height: 7, patternUnits: 'userSpaceOnUse', patternTransform: 'rotate(45)'},
    drawing('rect', {width: 7, height: 7, fill: 'var(--c5)', 'fill-opacity': 0.4}), drawing('path', {d: 'M0,0V7', stroke: 'var(--c0)', 'stroke-width': 2})));
}

/** One node can be reached with the tabulator, the others from there with the arrows. */
function oneTabStop(svg) {
  const marks = [...svg.querySelectorAll('.node')].sort((a, b) => a.dataset.node - b.dataset.node);
  if (!marks.length) return;
  marks[0].setAttribute('tabindex', 0);
  svg.addEventListener('keydown', (event) => {
    const step = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1}[event.key];
    const from = marks.indexOf(document.activeElement);
    if (!step || from < 0) return;
    event.preventDefault();
    const to = marks[(from + step + marks.length) % marks.length];
    marks[from].setAttribute('tabindex', -1);
    to.setAttribute('tabindex', 0);
    to.focus();
  });
}

const drawnStyle = {shape: ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'fill-opacity'],
  text: ['fill', 'stroke', 'stroke-width', 'paint-order', 'font-size', 'font-style', 'font-weight', 'font-family', 'text-anchor']};
const usualStyle = {'stroke-dasharray': 'none', 'fill-opacity': '1', 'paint-order': 'normal', 'font-style': 'normal', 'font-weight': '400', 'text-anchor': 'start'};

/** A drawing as a file of its own: what the style sheet says is written into the elements, what is not seen left out. */
function standaloneSvg(svg) {
  const copy = svg.cloneNode(true);
  const originals = [...svg.querySelectorAll('*')];
  const unseen = [];
  [...copy.querySelectorAll('*')].forEach((node, i) => {
    const style = getComputedStyle(originals[i]);
    if (node.classList.contains('hit') || node.tagName === 'title' || style.display === 'none' && !originals[i].closest('defs')) unseen.push(node);
    const kind = node.tagName === 'text' ? 'text' : ['path', 'circle', 'rect'].includes(node.tagName) ? 'shape' : null;
    for (const key of kind ? drawnStyle[kind] : []) {
      const value = style.getPropertyValue(key);
      if (value && value !== usualStyle[key]) node.setAttribute(key, value);
    }
    for (const name of node.getAttributeNames())
      if (['class', 'style', 'role', 'tabindex'].includes(name) || name.startsWith('data-') || name.startsWith('aria-')) node.removeAttribute(name);
  });
  for (const node of unseen) node.remove();
  for (const name of ['class', 'role']) copy.removeAttribute(name);
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return new XMLSerializer().serializeToString(copy);
}
