// The view of space as a vector picture with hidden lines removed, for print.

/** The nearest surface at every cell of the picture, as the reciprocal of its distance along the view. */
class DepthMap {
  constructor(view, pieces, scale) {
    this.scale = scale;
    [this.width, this.height] = view.size.map((t) => Math.ceil(t * scale));
    this.nearest = new Float64Array(this.width * this.height);
    for (const piece of pieces) {
      const corners = [];
      for (let i = 0; i < piece.positions.length; i += 3) corners.push(view.placed(piece.positions.slice(i, i + 3)));
      for (let t = 0; t < piece.triangles.length; t += 3) this.add([0, 1, 2].map((k) => corners[piece.triangles[t + k]]));
    }
  }

  add(corners) {
    if (corners.some(([, , near]) => !(near > 0))) return;
    const [[ax, ay], [bx, by], [cx, cy]] = corners.map(([x, y]) => [x * this.scale, y * this.scale]);
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (!area) return;
    const range = (a, b, c, most) => [Math.max(0, Math.floor(Math.min(a, b, c))), Math.min(most - 1, Math.ceil(Math.max(a, b, c)))];
    const [left_, right] = range(ax, bx, cx, this.width);
    const [above, below] = range(ay, by, cy, this.height);
    for (let y = above; y <= below; ++y)
      for (let x = left_; x <= right; ++x) {
        const s = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area;
        const t = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area;
        if (s < 0 || t < 0 || s + t > 1) continue;
        const near = corners[0][2] + s * (corners[1][2] - corners[0][2]) + t * (corners[2][2] - corners[0][2]);
        const cell = y * this.width + x;
        if (near > this.nearest[cell]) this.nearest[cell] = near;
      }
  }

  /** Whether nothing lies in front of a place of the picture at this reciprocal distance, but for the width of a cell. */
  shows([x, y, near]) {
    const [i, j] = [Math.round(x * this.scale), Math.round(y * this.scale)];
    if (i < 0 || j < 0 || i >= this.width || j >= this.height) return false;
    let least = Infinity;
    for (let b = Math.max(0, j - 1); b <= Math.min(this.height - 1, j + 1); ++b)
      for (let a = Math.max(0, i - 1); a <= Math.min(this.width - 1, i + 1); ++a) least = Math.min(least, this.nearest[b * this.width + a]);
    return near >= least * (1 - 2e-4);
  }
}

/** Where the surface of a piece turns away from the eye: segments between points of its triangles' edges. */
function silhouette(piece, eye) {
  const corner = (list, i) => [list[3 * i], list[3 * i + 1], list[3 * i + 2]];
  const facing = Array.from({length: piece.positions.length / 3}, (_, i) => dot(corner(piece.normals, i), minus(eye, corner(piece.positions, i))));
  const ends = new Map();
  const pieces = [];
  const cut = (i, j) => {
    const [a, b] = i < j ? [i, j] : [j, i];
    return {key: `${a},${b}`, at: plus(corner(piece.positions, a), minus(corner(piece.positions, b), corner(piece.positions, a)), facing[a] / (facing[a] - facing[b]))};
  };
  for (let t = 0; t < piece.triangles.length; t += 3) {
    const [i, j, k] = piece.triangles.slice(t, t + 3);
    const cuts = [[i, j], [j, k], [k, i]].filter(([a, b]) => facing[a] < 0 !== facing[b] < 0).map(([a, b]) => cut(a, b));
    if (cuts.length !== 2) continue;
    const segment = {ends: cuts.map(({key}) => key), points: cuts.map(({at}) => at)};
    pieces.push(segment);
    for (const key of segment.ends) ends.set(key, [...(ends.get(key) || []), segment]);
  }
  return chained(pieces, ends);
}

/** What the style sheet says for print: the colours of the light theme. */
function printColour(property) {
  const light = [...document.styleSheets[0].cssRules].find((rule) => rule.selectorText === ':root');
  return light.style.getPropertyValue(property).trim();
}

/** Runs of a polyline that are seen, in the picture's units. */
function seenRuns(view, map, points) {
  const runs = [[]];
  const places = points.map((p) => view.placed(p));
  places.slice(1).forEach((to, i) => {
    const from = places[i];
    const steps = Math.min(4000, Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) * map.scale)));
    for (let k = i ? 1 : 0; k <= steps; ++k) {
      const t = k / steps;
      const at = from.map((a, n) => a + t * (to[n] - a));
      if (at[2] > 0 && map.shows(at)) runs.at(-1).push([at[0], at[1]]);
      else if (runs.at(-1).length) runs.push([]);
    }
  });
  return runs.filter((run) => run.length > 1).map((run) => simplified(run, 0.12));
}

/** The view as it stands, as an SVG document in the colours of print. */
function vectorPicture(view) {
  const [width, height] = view.size;
  const pieces = view.shownSurfaces();
  const map = new DepthMap(view, pieces, 2);
  const eye = plus(view.ball.centre, view.camera.position.toArray(), view.ball.radius);
  const svg = drawing('svg', {xmlns: 'http://www.w3.org/2000/svg', viewBox: `0 0 ${width.toFixed(0)} ${height.toFixed(0)}`, width: '174mm', height: `${(174 * height / width).toFixed(2)}mm`,
    'font-family': "Helvetica, Arial, 'Liberation Sans', sans-serif", 'font-size': 12, fill: 'none', 'stroke-linecap': 'round', 'stroke-linejoin': 'round'});
  svg.append(drawing('title', {}, `${report.title || report.command}: view of space`));
  const path = (runs, property, width, dashes) => {
    if (!runs.length) return;
    const d = runs.map((run) => 'M' + run.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join('L')).join('');
    svg.append(drawing('path', {d, stroke: printColour(property), 'stroke-width': width, 'stroke-dasharray': dashes || null, 'stroke-linecap': dashes ? 'butt' : null}));
  };
  if (view.hasAxes) appendAxes(svg, view);
  for (const piece of pieces) path(silhouette(piece, eye).flatMap((line) => seenRuns(view, map, line)), '--soft', 1);
  for (const {visible, userData} of [...view.lines()].sort((a, b) => a.userData.width - b.userData.width))
    if (visible) path(seenRuns(view, map, userData.points), userData.property, 0.55 * userData.width, userData.dashes ? userData.dashes.map((t) => Math.max(1.5, 300 * t)).join(' ') : null);
  for (const mark of [...view.marks, ...view.extraMarks]) {
    if (!map.shows(view.placed(mark.at))) continue;
    const copy = drawing('g', {transform: mark.node.getAttribute('transform')});
    const glyph = mark.node.querySelector('.glyph');
    const paint = (value) => value && value.startsWith('var(') ? printColour(value.slice(4, -1)) : value;
    if (glyph) copy.append(drawing('path', {d: glyph.getAttribute('d'), 'fill-rule': 'evenodd', fill: paint(glyph.getAttribute('fill')), stroke: paint(glyph.getAttribute('stroke')), 'stroke-width': glyph.getAttribute('stroke-width')}));
    else copy.append(drawing('circle', {r: 3.6, fill: '#ffffff', stroke: '#1b1b1b', 'stroke-width': 1.6}));
    const number = mark.node.querySelector('.number');
    if (number && page.classList.contains('numbered')) copy.append(drawing('text', {x: number.getAttribute('x'), y: number.getAttribute('y'), fill: '#1b1b1b', 'font-size': 11}, number.textContent));
    svg.append(copy);
  }
  for (const {node} of view.labels)
    if (node.style.display !== 'none') svg.append(drawing('text', {transform: node.getAttribute('transform'), y: 4, 'text-anchor': 'middle', fill: '#1b1b1b', 'font-weight': 600, 'font-style': node.querySelector('text').getAttribute('font-style')}, node.textContent));
  return new XMLSerializer().serializeToString(svg) + '\n';
}

function appendAxes(svg, view) {
  for (const shape of view.axesLayer.children) {
    if (shape.tagName === 'path') svg.append(drawing('path', {d: shape.getAttribute('d'), stroke: printColour('--soft'), 'stroke-width': 0.6}));
    else svg.append(drawing('text', {x: shape.getAttribute('x'), y: shape.getAttribute('y'), 'text-anchor': shape.getAttribute('text-anchor'), fill: printColour('--soft'),
      'font-style': shape.classList.contains('axis-name') ? 'italic' : null, 'font-size': shape.classList.contains('axis-name') ? 14 : 11}, shape.textContent));
  }
}
