// Parameter squares as SVG: the first parameter runs to the right, the second upwards.

const side = 340;
const left = 44;
const top_ = 12;

let clips = 0;

/** A place to draw the parameters `domain` in: a rectangle of the drawing, lines cut off at it, marks on top. */
function framed(svg, [from, upper], size, domain) {
  const clip = `clip-${++clips}`;
  const back = drawing('g');
  const lines = drawing('g', {'clip-path': `url(#${clip})`});
  const marks = drawing('g');
  svg.append(drawing('clipPath', {id: clip}, drawing('rect', {x: from, y: upper, width: size, height: size})), back, lines, marks);
  const target = {svg, back, lines, marks, content: marks, size, domain};
  target.x = (t) => from + size * (t - target.domain[0][0]) / (target.domain[0][1] - target.domain[0][0]);
  target.y = (t) => upper + size * (1 - (t - target.domain[1][0]) / (target.domain[1][1] - target.domain[1][0]));
  target.width = () => target.domain[0][1] - target.domain[0][0];
  target.shows = ([a, b]) => [a, b].every((t, k) => t >= target.domain[k][0] - 1e-9 * target.width() && t <= target.domain[k][1] + 1e-9 * target.width());
  return target;
}

/**
 * A framed square with ticks, at first of all parameters, 0 to 1: `x` and `y` take parameters to the drawing's units.
 * What is drawn into it by painters is drawn anew for every other domain.
 */
function unitSquare(across, upwards, label) {
  const svg = drawing('svg', {class: 'square', viewBox: `0 0 ${left + side + 14} ${top_ + side + 40}`, role: 'group', 'aria-label': label});
  const square = framed(svg, [left, top_], side, [[0, 1], [0, 1]]);
  svg.append(drawing('path', {class: 'frame', d: `M${left},${top_ + side}h${side}v${-side}h${-side}Z`}),
    drawing('text', {class: 'axis', x: left + side / 2, y: top_ + side + 34, 'text-anchor': 'middle'}, across),
    drawing('text', {class: 'axis', x: left - 30, y: top_ + side / 2 + 4, 'text-anchor': 'middle'}, upwards));
  square.painters = [];
  square.paint = (painter) => {
    square.painters.push(painter);
    painter(square);
  };
  square.show = (domain) => {
    square.domain = domain;
    for (const layer of [square.back, square.lines, square.marks]) layer.replaceChildren();
    drawGrid(square);
    for (const painter of square.painters) painter(square);
  };
  drawGrid(square);
  return square;
}

const wholeSquare = [[0, 1], [0, 1]];
const isWhole = (square) => square.domain.every(([a, b]) => a === 0 && b === 1);

function drawGrid(square) {
  let lines = '';
  const ticks = square.domain.map(([a, b]) => isWhole(square) ? Array.from({length: 6}, (_, i) => [i / 5, String(2 * i / 10)]) : roundTicks(a, b, 4));
  for (const [t, text] of ticks[0]) {
    lines += `M${square.x(t)},${top_}v${side}`;
    square.back.append(drawing('text', {x: square.x(t), y: top_ + side + 16, 'text-anchor': 'middle', class: 'soft'}, text));
  }
  for (const [t, text] of ticks[1]) {
    lines += `M${left},${square.y(t)}h${side}`;
    const coversName = text.length > 3 && Math.abs(square.y(t) - top_ - side / 2) < 12;
    if ((t > 0 || !isWhole(square)) && !coversName) square.back.append(drawing('text', {x: left - 6, y: square.y(t) + 4, 'text-anchor': 'end', class: 'soft'}, text));
  }
  square.back.append(drawing('path', {class: 'grid', d: lines}));
  if (!isWhole(square)) square.lines.append(drawing('path', {class: 'sides', d: rectanglePath(square, wholeSquare)}));
}

/** The wheel, two fingers, dragging and keys change what a square shows; `after` is called when it has changed. */
function zoomable(square, after) {
  const {svg} = square;
  const show = (domain) => {
    const size = Math.min(1, domain[0][1] - domain[0][0]);
    if (!(size > 1e-11)) return;
    square.show(size === 1 ? wholeSquare : domain.map(([a, b]) => {
      const from = Math.min(Math.max((a + b - size) / 2, -0.04 * size), 1 - size + 0.04 * size);
      return [from, from + size];
    }));
    svg.classList.toggle('zoomed', !isWhole(square));
    after(square);
  };
  square.zoom = (factor, at = square.domain.map(([a, b]) => (a + b) / 2)) => show(square.domain.map(([a, b], k) => [at[k] + (a - at[k]) * factor, at[k] + (b - at[k]) * factor]));
  square.fly = (points) => {
    const range = [0, 1].map((k) => [Math.min(...points.map((p) => p[k])), Math.max(...points.map((p) => p[k]))]);
    const extent = Math.max(...range.map(([a, b]) => b - a));
    const size = Math.min(1, extent > 0 ? 2.2 * extent : 0.06);
    show(range.map(([a, b]) => [(a + b - size) / 2, (a + b + size) / 2]));
  };
  square.whole = () => show(wholeSquare);
  const place = (event) => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    return [square.domain[0][0] + (at.x - left) / side * square.width(), square.domain[1][0] + (top_ + side - at.y) / side * square.width()];
  };
  svg.setAttribute('tabindex', 0);
  svg.addEventListener('wheel', (event) => {
    if (!event.ctrlKey && !svg.contains(document.activeElement)) return;
    event.preventDefault();
    square.zoom(Math.exp(Math.max(-40, Math.min(40, event.deltaY)) * 0.006), place(event));
  }, {passive: false});
  svg.addEventListener('keydown', (event) => {
    if (event.target !== svg) return;
    const pan = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]}[event.key];
    if (event.key === '+' || event.key === '=') square.zoom(0.7);
    else if (event.key === '-') square.zoom(1 / 0.7);
    else if (event.key === '0') square.whole();
    else if (pan && !isWhole(square)) show(square.domain.map(([a, b], k) => [a + pan[k] * (b - a), b + pan[k] * (b - a)]));
    else return;
    event.preventDefault();
  });
  listenForFingers(square, place, show);
}

/** One finger or the mouse moves what is shown, once it is not all; two fingers zoom. */
function listenForFingers(square, place, show) {
  const fingers = new Map();
  const {svg} = square;
  svg.addEventListener('pointerdown', (event) => fingers.set(event.pointerId, {at: place(event), moved: false}));
  for (const end of ['pointerup', 'pointercancel', 'pointerleave']) svg.addEventListener(end, (event) => fingers.delete(event.pointerId));
  svg.addEventListener('pointermove', (event) => {
    const finger = fingers.get(event.pointerId);
    if (!finger) return;
    const to = place(event);
    const others = [...fingers].filter(([id]) => id !== event.pointerId).map(([, other]) => other);
    if (others.length === 1) {
      const still = others[0].at;
      const [before, now] = [finger.at, to].map((p) => Math.hypot(p[0] - still[0], p[1] - still[1]));
      if (before > 0 && now > 0) square.zoom(Math.min(2, Math.max(0.5, before / now)), still);
      finger.at = place(event);
    } else if (!others.length && !isWhole(square)) {
      const shift = minus(finger.at, to);
      if (Math.hypot(...shift) > 0.01 * square.width()) show(square.domain.map(([a, b], k) => [a + shift[k], b + shift[k]]));
    }
  });
  svg.style.touchAction = 'pan-x pan-y';
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
    square.lines.append(drawing('path', {class: 'strip', fill: componentColour(arc.component), d: rectanglePath(square, range)}));
  }
  const d = pathThrough(square, simplified(points, 1e-4 * square.width()));
  const dashes = componentDashes(arc.component);
  square.lines.append(
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

const nodeIn = (node, which) => [node.approx[parameters[2 * which]], node.approx[parameters[2 * which + 1]]];

function drawNode(square, which, node, place) {
  const at = nodeIn(node, which);
  const ranges = [0, 1].map((k) => node.free.includes(parameters[2 * which + k]) ? node.box[parameters[2 * which + k]].map(toDouble) : [at[k], at[k]]);
  if (ranges.some(([a, b]) => a !== b))
    square.lines.append(drawing('path', {class: 'strip', d: rectanglePath(square, ranges), fill: nodeColour(node)}),
      drawing('path', {class: 'arc side', stroke: nodeColour(node), d: pathThrough(square, [[ranges[0][0], ranges[1][0]], [ranges[0][1], ranges[1][1]]])}));
  if (!square.shows(at)) return;
  const label = `node ${node.id}, ${nodeWords(node)}`;
  const [x, y] = [square.x(at[0]), square.y(at[1])];
  square.marks.append(drawing('g', {class: 'node', 'data-node': node.id, role: 'button', tabindex: -1, 'aria-label': label,
    transform: `translate(${x.toFixed(2)},${y.toFixed(2)})`},
  drawing('title', {}, label), drawing('circle', {class: 'ringed', r: 9.5}), glyphPath(glyphName(node, which), nodeColour(node)),
  place ? drawing('text', {class: 'number', x: (place[0] - x).toFixed(1), y: (place[1] - y + 4).toFixed(1), 'text-anchor': 'middle'}, String(node.id)) : null,
  drawing('circle', {class: 'hit point', r: 11})));
}

/** Where the number of every node goes: beside it, on no other node and on no other number. */
function numberPlaces(square, which) {
  const seen = nodes.filter((node) => square.shows(nodeIn(node, which)));
  const at = new Map(seen.map((node) => [node.id, nodeIn(node, which).map((t, k) => k ? square.y(t) : square.x(t))]));
  const taken = [];
  return new Map(seen.map((node) => {
    const [x, y] = at.get(node.id);
    const size = [7 * String(node.id).length + 2, 12];
    const place = freePlace([x, y], size, [...at.values()].filter((other) => other[0] !== x || other[1] !== y).map((other) => [...other, 6]), [left + side + 14, top_ + side + 40], taken);
    taken.push([...place, ...size]);
    return [node.id, place];
  }));
}

/** "boundary on u=0", "turning in v". */
function nodeWords(node) {
  const words = [node.kinds.join(', ') || 'point'];
  if (node.on.length) words.push('on ' + node.on.join(', '));
  if (node.wrt.length) words.push('turning in ' + node.wrt.join(', '));
  if (node.free.length) words.push('free ' + node.free.join(', '));
  return words.join(', ').replace('turning, turning', 'turning');
}

/** The number of each component beside the middle of its longest arc, on no node. */
function labelComponents(square, which) {
  if (graph.components.length < 2) return;
  const obstacles = nodes.map((node) => nodeIn(node, which)).filter(square.shows).map(([a, b]) => [square.x(a), square.y(b), 7]);
  for (const component of graph.components) {
    const longest = component.arcs.map((id) => arcs[id]).sort((a, b) => b.polyline.length - a.polyline.length)[0];
    if (!longest) continue;
    const points = arcIn(longest, which).filter(square.shows);
    if (!points.length) continue;
    const middle = points[Math.floor(points.length / 2)];
    const curve = arcIn(longest, which).map(([a, b]) => [square.x(a), square.y(b), 2]);
    const place = freePlace([square.x(middle[0]), square.y(middle[1])], [8 * String(component.id).length, 13], [...obstacles, ...curve], [left + side, top_ + side], [], 6);
    const text = drawing('text', {class: 'label', x: place[0].toFixed(1), y: (place[1] + 4.5).toFixed(1), 'text-anchor': 'middle', 'data-component': component.id}, String(component.id));
    text.style.fill = componentColour(component.id);
    square.marks.append(text);
  }
}

/** Draws the whole result into a square or a part of one. */
function paintResult(square, which, numbered = true) {
  for (const region of graph.incomplete)
    square.lines.append(drawing('path', {class: 'undecided', d: rectanglePath(square, [0, 1].map((k) => region.where[parameters[2 * which + k]].map(toDouble)))}));
  for (const overlap of graph.overlaps)
    square.lines.append(drawing('path', {class: 'overlap', 'fill-rule': 'evenodd', fill: 'url(#hatch)', d: overlapPath(square, which, overlap)}));
  for (const arc of arcs) drawArc(square, which, arc);
  const order = [...nodes].sort((a, b) => glyphOrder.indexOf(glyphName(a, which)) - glyphOrder.indexOf(glyphName(b, which)));
  const places = numbered ? numberPlaces(square, which) : new Map();
  for (const node of order) drawNode(square, which, node, places.get(node.id));
}

/** A parameter square of the result with everything in it; `square.line` paints the line that is shown. */
function resultSquare(which, caption) {
  const square = unitSquare(parameters[2 * which], parameters[2 * which + 1], `Parameter square of ${caption}. The wheel zooms once it has the focus, 0 shows all of it.`);
  if (graph.overlaps.length) square.svg.prepend(hatch());
  square.paint(() => paintResult(square, which));
  square.paint(() => {
    square.fibre = drawing('g', {class: 'fibre-layer'});
    square.marks.append(square.fibre);
    if (square.line) square.line();
  });
  square.paint(() => labelComponents(square, which));
  square.paint(() => oneTabStop(square.svg));
  listenForArrows(square.svg);
  return square;
}

/** The pattern of overlaps. */
function hatch() {
  return drawing('defs', {}, drawing('pattern', {id: 'hatch', width: 7, height: 7, patternUnits: 'userSpaceOnUse', patternTransform: 'rotate(45)'},
    drawing('rect', {width: 7, height: 7, fill: 'var(--c5)', 'fill-opacity': 0.4}), drawing('path', {d: 'M0,0V7', stroke: 'var(--c0)', 'stroke-width': 2})));
}

/** One node can be reached with the tabulator, the others from there with the arrows. */
function oneTabStop(svg) {
  const first = nodeMarksOf(svg)[0];
  if (first) first.setAttribute('tabindex', 0);
}

const nodeMarksOf = (svg) => [...svg.querySelectorAll('.node')].sort((a, b) => a.dataset.node - b.dataset.node);

function listenForArrows(svg) {
  svg.addEventListener('keydown', (event) => {
    const marks = nodeMarksOf(svg);
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
