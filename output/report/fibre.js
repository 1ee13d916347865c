// A parameter line of one patch against the other: plane, cylinder, branches, feasible intervals, points.

/** sum of rows[i][j] a^i b^j. */
function formAt(rows, a, b) {
  let value = 0;
  for (let i = rows.length - 1; i >= 0; --i) {
    let inner = 0;
    for (let j = rows[i].length - 1; j >= 0; --j) inner = inner * b + rows[i][j];
    value = value * a + inner;
  }
  return value;
}

/** Polylines of f = 0 in the unit square, seen on n by n cells: [across, upwards] on the cells' edges. */
function zeroSet(f, n) {
  const values = Array.from({length: n + 1}, (_, i) => Float64Array.from({length: n + 1}, (_, j) => f(i / n, j / n)));
  const ends = new Map();
  const pieces = [];
  const edgePoint = (i, j, k, l) => {
    const t = values[i][j] / (values[i][j] - values[k][l]);
    return {key: `${i},${j},${k},${l}`, at: [(i + t * (k - i)) / n, (j + t * (l - j)) / n]};
  };
  const add = (p, q) => {
    const piece = {ends: [p.key, q.key], points: [p.at, q.at]};
    pieces.push(piece);
    for (const key of piece.ends) ends.set(key, [...(ends.get(key) || []), piece]);
  };
  const below = (i, j) => values[i][j] < 0;
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < n; ++j) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const cuts = [];
      corners.forEach(([a, b], k) => {
        const [c, d] = corners[(k + 1) % 4];
        if (below(a, b) !== below(c, d)) cuts.push(a + b < c + d ? edgePoint(a, b, c, d) : edgePoint(c, d, a, b));
      });
      if (cuts.length === 2) add(cuts[0], cuts[1]);
      if (cuts.length === 4) {
        const shift = f((i + 0.5) / n, (j + 0.5) / n) < 0 === below(i, j) ? 0 : 1;
        add(cuts[shift], cuts[(shift + 1) % 4]);
        add(cuts[shift + 2], cuts[(shift + 3) % 4]);
      }
    }
  return chained(pieces, ends);
}

/** Pieces joined at common ends. */
function chained(pieces, ends) {
  const used = new Set();
  const follow = (start, key) => {
    const points = [];
    for (let piece = start; piece; ) {
      used.add(piece);
      const other = piece.ends[0] === key ? 1 : 0;
      points.push(piece.points[other]);
      key = piece.ends[other];
      piece = (ends.get(key) || []).find((next) => !used.has(next));
    }
    return points;
  };
  const curves = [];
  for (const piece of pieces) {
    if (used.has(piece)) continue;
    const forwards = follow(piece, piece.ends[0]);
    const next = (ends.get(piece.ends[0]) || []).find((other) => !used.has(other));
    const backwards = next ? follow(next, piece.ends[0]) : [];
    curves.push([...backwards.reverse(), piece.points[0], ...forwards]);
  }
  return curves;
}

/** The curves of a line in the other patch's square: branches of the pulled-back plane, and what bounds the line. */
function lineCurves(fibre) {
  const {plane, u, l, m, cubic} = fibre.forms;
  const straight = fibre.result.shape !== 'conic';
  const zeros = (f) => zeroSet((s, r) => f(r, s), 140);
  const slope = plane.slice(1).map((row, i) => row.map((c) => (i + 1) * c));
  const branches = [[], []];
  if (plane.length)
    for (const curve of zeros((r, s) => formAt(plane, r, s))) {
      let last = -1;
      for (let i = 0; i + 1 < curve.length; ++i) {
        const [s, r] = [(curve[i][0] + curve[i + 1][0]) / 2, (curve[i][1] + curve[i + 1][1]) / 2];
        const branch = plane.length === 3 && formAt(slope, r, s) > 0 ? 1 : 0;
        if (branch !== last) branches[branch].push([curve[i]]);
        branches[branch].at(-1).push(curve[i + 1]);
        last = branch;
      }
    }
  return {
    branch1: branches[0], branch2: branches[1],
    second: m.length ? zeros((r, s) => straight ? formAt(m, r, s) : formAt(u, r, s) * formAt(m, r, s) - formAt(l, r, s) ** 2)
      : cubic.flatMap((f) => zeros((r, s) => formAt(f, r, s))),
    start: l.length ? zeros((r, s) => formAt(l, r, s)) : [],
    end: l.length ? zeros((r, s) => formAt(l, r, s) - formAt(u, r, s)) : [],
  };
}

const partnerOf = {u: 'v', v: 'u', r: 's', s: 'r', u1: 'v1', v1: 'u1'};

function curveNames(fibre) {
  const along = partnerOf[Object.keys(fibre.result.fixed)[0]];
  const folded = fibre.result.shape === 'folded';
  return {branch1: fibre.forms.plane.length > 3 ? 'plane P = 0' : 'plane P = 0, branch 1', branch2: 'plane P = 0, branch 2', second: {conic: 'cylinder Z = 0', 'plane cubic': 'cubic', 'twisted cubic': 'quadrics through the line'}[fibre.result.shape] || 'second plane',
    start: folded ? 'one end of the line' : `${along} = 0`, end: folded ? 'other end of the line' : `${along} = 1`};
}

/** Points of a line are called a, b, c, ... */
const pointLetter = (i) => String.fromCharCode(97 + i % 26);

/** The picture of a fibre, with its legend. */
function fibrePicture(fibre) {
  const across = fibre.result.eliminant.variable;
  const upwards = partnerOf[across];
  const square = unitSquare(across, upwards, `Fibre in the square of ${across} and ${upwards}`);
  const curves = lineCurves(fibre);
  const present = ['second', 'start', 'end', 'branch1', 'branch2'].filter((name) => curves[name].length);
  for (const name of present)
    square.lines.append(drawing('path', {class: `curve ${name}`, d: curves[name].map((curve) => pathThrough(square, simplified(curve, 4e-4))).join('')}));
  for (const {branch, intervals} of fibre.result.feasible)
    for (const {from, to} of intervals) {
      const y = square.y(0) - (branch === 2 ? 11 : 4);
      square.content.append(drawing('path', {class: 'bar', 'data-feasible': branch, stroke: componentColour(branch - 1),
        d: `M${square.x(from.approx)},${y}H${Math.max(square.x(to.approx), square.x(from.approx) + 1.5)}`}));
    }
  for (const root of fibre.phantoms)
    square.content.append(drawing('path', {class: 'phantom', d: `M${square.x(root)},${square.y(0) - 3}v-17`}));
  fibre.result.points.forEach((point, i) => {
    const at = [square.x(point.approx[across]), square.y(point.approx[upwards])];
    square.content.append(drawing('path', {class: 'fibre-line', d: `M${at[0]},${at[1]}V${square.y(0)}`}),
      drawing('circle', {class: 'fibre-point', 'data-point': i, cx: at[0], cy: at[1], r: 4.6}),
      drawing('circle', {class: 'hit point', 'data-point': i, cx: at[0], cy: at[1], r: 12}),
      drawing('text', {class: 'label', x: at[0] + 9, y: at[1] - 7}, pointLetter(i)));
  });
  const names = curveNames(fibre);
  const entries = present.map((name) => [drawing('path', {class: `curve ${name}`, d: 'M2,8H32'}), names[name]]);
  for (const {branch, intervals} of fibre.result.feasible)
    if (intervals.length) entries.push([drawing('path', {class: 'bar', stroke: componentColour(branch - 1), d: 'M2,8H32'}), `feasible ${across}, branch ${branch}`]);
  if (fibre.result.points.length) entries.push([drawing('circle', {class: 'fibre-point', cx: 17, cy: 8, r: 4.6}), 'intersection point']);
  if (fibre.phantoms.length) entries.push([drawing('path', {class: 'phantom', d: 'M17,0V16'}), 'phantom: root of the eliminant that is no point']);
  return {svg: square.svg, legend: legendList(entries)};
}

function legendList(entries) {
  return element('ul', {class: 'legend'}, entries.map(([mark, text]) => element('li', {}, drawing('svg', {viewBox: '0 0 34 16', 'aria-hidden': 'true'}, mark), text)));
}

function endText(interval) {
  return `${interval.from.closed ? '[' : '('}${short(interval.from.approx)}, ${short(interval.to.approx)}${interval.to.closed ? ']' : ')'}`;
}

function eliminantWords({eliminant: {variable, degree}}, phantoms) {
  if (degree <= 0) return '';
  const roots = phantoms === 0 ? `Every real root in [0,1] belongs to a point.`
    : `${counted(phantoms, 'real root')} in [0,1] ${phantoms === 1 ? 'is a phantom' : 'are phantoms'}, proved to belong to no point.`;
  return ` The eliminant in ${variable} has degree ${degree}. ${roots}`;
}

function lineWords({shape}, fixed) {
  const owner = report.patches[Math.min(Math.floor(parameters.indexOf(fixed) / 2), report.patches.length - 1)];
  return {conic: `${owner.weights ? 'a conic' : 'a parabola'}, cut out by its plane and a quadratic cylinder`,
    straight: 'straight, cut out by two planes', folded: 'straight and runs back on itself, cut out by two planes', point: 'a single point',
    'plane cubic': 'a cubic, cut out by its plane and one more equation', 'twisted cubic': 'a cubic in no plane, cut out by three quadrics'}[shape];
}

/** What is known of a fibre, in words, and its points with exact boxes. */
function fibreFacts(fibre) {
  const line = fibre.result;
  const [fixed, value] = Object.entries(line.fixed)[0];
  const facts = element('div', {});
  const variable = line.eliminant.variable;
  const points = counted(line.points.length, 'point') + (line.on_patch.length ? ` and ${counted(line.on_patch.length, 'piece')} of the line` : '');
  facts.append(element('p', {}, element('b', {}, `${fixed} = ${value}: ${points} on the other patch. `),
    `The line is ${lineWords(line, fixed)}.`,
    eliminantWords(line, fibre.phantoms.length)));
  for (const {branch, intervals} of line.feasible)
    facts.append(element('p', {}, `Feasible ${variable} on branch ${branch}: ${intervals.map(endText).join(', ') || 'none'}.`));
  if (line.points.length) facts.append(pointTable(line, fixed));
  for (const interval of line.on_patch) facts.append(element('p', {}, `The line lies on the other patch for ${partnerOf[fixed]} in ${endText(interval)}.`));
  for (const gap of line.incomplete) facts.append(element('p', {class: 'incomplete'}, `Not decided: ${gap.why}`));
  if (!fibre.polynomials) facts.append(element('p', {class: 'note'}, `The exact polynomials of this line are long; exsect line --${fixed} ${value} --json writes them.`));
  return facts;
}

function pointTable(line, fixed) {
  const columns = Object.keys(line.points[0].box);
  const rows = line.points.map((point, i) => element('tr', {'data-point': i}, element('td', {}, pickButton(pointLetter(i), drawing('circle', {class: 'fibre-point', r: 4.6}), `point ${pointLetter(i)}`)),
    columns.map((p) => valueCell(point.approx[p], point.box[p])),
    element('td', {class: 'number'}, String(point.multiplicity)), element('td', {class: 'number'}, point.branch ? String(point.branch) : '–'),
    element('td', {}, point.on.join(' '))));
  return tableOf({class: 'points cards'}, 'Each box holds exactly one point', [['point'], ...columns.map((name) => [name]), ['multiplicity', 'number'], ['branch', 'number'], ['on']], rows);
}

/** A decimal and, below it, the exact interval that holds the true value. */
function valueCell(approx, box) {
  return element('td', {class: 'value-cell'}, element('span', {class: 'decimal'}, approx === null ? '' : String(approx)), exactInterval(box));
}

/** The line of space of a fixed parameter: points, and the coefficients of 1, t, t². */
function lineInSpace(fixed, value) {
  const index = parameters.indexOf(fixed);
  const patch = report.patches[Math.min(Math.floor(index / 2), report.patches.length - 1)];
  const at = (t) => index % 2 === 0 ? patchAt(patch.points, value, t).at : patchAt(patch.points, t, value).at;
  const [p, q, r] = [at(0), at(0.5), at(1)];
  const a2 = p.map((_, k) => 2 * p[k] - 4 * q[k] + 2 * r[k]);
  return {at, a0: p, a1: p.map((_, k) => r[k] - p[k] - a2[k]), a2};
}

/** The plane of a line as a translucent piece, cut off at the box. */
function planePiece(line, ball, normal) {
  const {low, high} = ball;
  const corner = (i) => [0, 1, 2].map((k) => (i >> k & 1 ? high[k] : low[k]));
  const points = [];
  for (let i = 0; i < 8; ++i)
    for (let k = 0; k < 3; ++k) {
      if (i >> k & 1) continue;
      const [p, q] = [corner(i), corner(i | 1 << k)];
      const [f, g] = [dot(normal, minus(p, line.a0)), dot(normal, minus(q, line.a0))];
      if (f * g < 0) points.push(plus(p, minus(q, p), f / (f - g)));
    }
  if (points.length < 3) return null;
  const middle = points.reduce((sum, p) => plus(sum, p), [0, 0, 0]).map((t) => t / points.length);
  const right = unit(minus(points[0], middle));
  const up = cross(normal, right);
  points.sort((a, b) => Math.atan2(dot(up, minus(a, middle)), dot(right, minus(a, middle))) - Math.atan2(dot(up, minus(b, middle)), dot(right, minus(b, middle))));
  const piece = {positions: [], normals: [], triangles: [], property: '--plane', opacity: 0.3};
  const cells = 16;
  points.forEach((p, i) => {
    const q = points[(i + 1) % points.length];
    for (let a = 0; a < cells; ++a)
      for (let b = 0; a + b < cells; ++b)
        for (const triangle of a + b + 1 < cells ? [[[0, 0], [1, 0], [0, 1]], [[1, 0], [1, 1], [0, 1]]] : [[[0, 0], [1, 0], [0, 1]]])
          for (const [c, d] of triangle) {
            piece.triangles.push(piece.positions.length / 3);
            piece.positions.push(...plus(plus(middle, minus(p, middle), (a + c) / cells), minus(q, middle), (b + d) / cells));
            piece.normals.push(...normal);
          }
  });
  return oriented(piece);
}

/** The quadratic cylinder over the line along the normal of its plane. */
function cylinderPiece(line, ball, normal) {
  const height = 0.32 * ball.radius;
  const pointAt = (t) => {
    const s = -0.12 + 1.24 * t;
    return line.a0.map((_, k) => line.a0[k] + line.a1[k] * s + line.a2[k] * s * s);
  };
  return gridPiece(14, 70, (h, t) => {
    const s = -0.12 + 1.24 * t;
    const middle = pointAt(t);
    // Cut off at the box, so that all of it is in the picture.
    const reach = [1, -1].map((sign) => Math.max(0, Math.min(height, ...normal.map((n, k) => sign * n > 0 ? (ball.high[k] - middle[k]) / (sign * n) : sign * n < 0 ? (ball.low[k] - middle[k]) / (sign * n) : Infinity))));
    const at = plus(middle, normal, reach[0] * h - reach[1] * (1 - h));
    return {at, normal: unit(cross(normal, line.a1.map((c, k) => c + 2 * line.a2[k] * s)))};
  }, '--cylinder', 0.34);
}

/** The shown line in the view of space and in the squares: `shown` says which of line, plane, cylinder. */
function showLine(view, squares, fixed, value, points, shown) {
  const index = parameters.indexOf(fixed);
  squares.forEach((square, which) => {
    square.line = () => {
      square.fibre.replaceChildren();
      if (!shown.line) return;
      const sameSquare = Math.floor(index / 2) === which;
      const ends = square.domain[1 - index % 2];
      if (sameSquare) square.fibre.append(drawing('path', {class: 'fibre-line', d: pathThrough(square, index % 2 === 0 ? ends.map((t) => [value, t]) : ends.map((t) => [t, value]))}));
      points.forEach((point, i) => {
        if (!square.shows([point[2 * which], point[2 * which + 1]])) return;
        const at = [square.x(point[2 * which]), square.y(point[2 * which + 1])];
        square.fibre.append(drawing('circle', {class: 'fibre-point', 'data-point': i, cx: at[0], cy: at[1], r: 3.8}),
          drawing('circle', {class: 'hit point', 'data-point': i, cx: at[0], cy: at[1], r: 9}));
      });
    };
    square.line();
  });
  if (!view) return;
  const line = lineInSpace(fixed, value);
  const normal = unit(cross(line.a1, line.a2));
  view.showExtra(() => {
    const surfaces = [];
    if (report.patches.every(isBiquadratic) && dot(normal, normal) > 0) {
      if (shown.plane) surfaces.push(planePiece(line, view.whole, normal));
      if (shown.cylinder) surfaces.push(cylinderPiece(line, view.whole, normal));
    }
    const wires = shown.line ? [view.wire(Array.from({length: 65}, (_, i) => line.at(i / 64)), '--line', 2.2)] : [];
    const marks = !shown.line ? [] : points.map((point, i) => {
      const node = drawing('circle', {class: 'fibre-point', 'data-point': i, r: 4});
      view.overlay.append(node);
      return {node, at: inSpace(point), point: i};
    });
    return {surfaces: surfaces.filter(Boolean), wires, marks};
  });
}
