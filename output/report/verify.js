// The page of verify: the exact intersection, the candidate, and where they differ.

const squareOf = {first: 0, second: 1};

/** A candidate curve in space, whichever way it is given. */
function strandInSpace(strand, points = strand.points) {
  return strand.in === 'space' ? points : points.map(([a, b]) => patchAt(report.patches[squareOf[strand.in]].points, a, b).at);
}

function pointInSpace(point) {
  if (point.space) return point.space;
  return point.first ? patchAt(report.patches[0].points, ...point.first).at : patchAt(report.patches[1].points, ...point.second).at;
}

function claimGlyph(paint) {
  return drawing('path', {class: 'glyph', d: glyphs.crossing.path, fill: paint, stroke: 'var(--paper)', 'stroke-width': 1.2});
}

/** What a difference is about: points of space, and of either square, as far as they are stated. */
function statedPlaces(difference) {
  const whole = (vertices) => ({space: vertices.map(inSpace), ...Object.fromEntries(['first', 'second'].map((name, k) => [name, k < parameters.length / 2 ? vertices.map((v) => v.slice(2 * k, 2 * k + 2)) : []]))});
  const strandPlaces = (strand, points) => ({space: strandInSpace(strand, points), first: strand.in === 'first' ? points : [], second: strand.in === 'second' ? points : []});
  const {gap, part, curve, point, node, arc, overlap, components} = difference;
  if (gap) {
    const rims = overlap === null || overlap === undefined ? arcs : graph.overlaps[overlap].chains.flat();
    return whole(rims.find(({id}) => id === arc).polyline.slice(gap.vertices[0], gap.vertices[1] + 1));
  }
  if (part) {
    const index = result.curves[part.curve].spurious.filter((other) => other.in === part.in).findIndex(({from, to}) => from === part.from && to === part.to);
    const strand = report.candidate.curves[part.curve].find((other) => other.in === part.in);
    return strandPlaces(strand, strand.spurious[index] && strand.spurious[index].length ? strand.spurious[index] : strand.points);
  }
  if (point !== undefined) {
    const claimed = report.candidate.points[point];
    return {space: [pointInSpace(claimed)], first: claimed.first ? [claimed.first] : [], second: claimed.second ? [claimed.second] : []};
  }
  if (node !== undefined) return whole([[...parameters.map((p) => nodes[node].approx[p]), ...nodes[node].approx.point]]);
  if (components.length) return whole(components.flatMap((id) => graph.components[id].arcs.flatMap((k) => arcs[k].polyline)));
  if (curve !== undefined) {
    const places = report.candidate.curves[curve].map((strand) => strandPlaces(strand, strand.points));
    return {space: places[0].space, first: places.flatMap(({first}) => first), second: places.flatMap(({second}) => second)};
  }
  return whole(arcs.flatMap((k) => k.polyline));
}

/** Parameters of a patch near a point of space, by samples that close in on it; for the eye. */
function parametersNear(points, place) {
  let best = {at: [0.5, 0.5], distance: Infinity};
  for (let reach = 0.5, middle = [0.5, 0.5]; reach > 1e-7; reach /= 3) {
    for (let i = -5; i <= 5; ++i)
      for (let j = -5; j <= 5; ++j) {
        const at = [i, j].map((k, n) => Math.min(1, Math.max(0, middle[n] + k * reach / 5)));
        const distance = Math.hypot(...minus(patchAt(points, ...at).at, place));
        if (distance < best.distance) best = {at, distance};
      }
    middle = best.at;
  }
  return best.at;
}

/** At most `most` of a list, evenly. */
function some(list, most) {
  return list.length <= most ? list : Array.from({length: most}, (_, i) => list[Math.round(i * (list.length - 1) / (most - 1))]);
}

/** The places of every difference, in space and in the squares that there are. */
const differencePlaces = (report.command === 'verify' ? result.differences : []).map((difference) => {
  const places = statedPlaces(difference);
  const filled = (name, which) => places[name].length ? places[name] : some(places.space, 6).map((p) => parametersNear(report.patches[which].points, p));
  return {space: places.space, squares: report.patches.map((_, which) => filled(['first', 'second'][which], which))};
});

const extentOf = (points) => Math.max(...[0, 1].map((k) => Math.max(...points.map((p) => p[k])) - Math.min(...points.map((p) => p[k]))));

/** Flies to a difference in space and in both squares, or back. */
function showDifference(id) {
  squares.forEach((square, which) => id === null ? square.whole() : square.fly(differencePlaces[id].squares[which]));
  if (!view) return;
  if (id === null) return view.home();
  const {space} = differencePlaces[id];
  const {centre, radius} = ballAround(space);
  view.fly(centre, Math.max(1.4 * radius, space.length > 1 && radius > 1e-9 * view.whole.radius ? 0 : 0.05 * view.whole.radius));
}

function differenceWords(id) {
  const difference = result.differences[id];
  return [element('b', {}, `Difference ${id + 1}`), `, ${difference.kind}: ${difference.text}. `, textButton('show everything', () => select('difference', id))];
}

function buildVerdict() {
  for (const gap of report.gaps) view.addWire(gap.map(inSpace), '--gap', 9, {opacity: 0.9, front: true});
  for (const curve of report.candidate.curves) {
    view.addWire(strandInSpace(curve[0]), '--ink', 1.8, {dashes: [0.02, 0.02], front: true});
    for (const strand of curve)
      for (const part of strand.spurious) view.addWire(strandInSpace(strand, part), '--spurious', 5, {front: true});
  }
}

function verdictInSpace() {
  if (!view) return;
  view.build(buildVerdict);
  for (const point of report.candidate.points) {
    const mark = drawing('g', {class: 'claimed'}, claimGlyph(point.wrong ? 'var(--spurious)' : 'var(--ink)'));
    view.overlay.append(mark);
    view.marks.push({node: mark, at: pointInSpace(point)});
  }
}

/** Draws the candidate and where it differs into a square or a part of one. */
function paintVerdict(square, which) {
  const line = (points, name) => square.lines.append(drawing('path', {class: `arc ${name}`, d: pathThrough(square, points)}));
  for (const gap of report.gaps) line(gap.map((vertex) => vertex.slice(2 * which, 2 * which + 2)), 'gap');
  for (const curve of report.candidate.curves)
    for (const strand of curve.filter((other) => squareOf[other.in] === which)) {
      line(strand.points, 'claimed');
      for (const part of strand.spurious) line(part, 'spurious');
    }
  for (const point of report.candidate.points) {
    const at = which === 0 ? point.first : point.second;
    if (at && square.shows(at)) square.marks.append(drawing('g', {class: 'claimed', transform: `translate(${square.x(at[0])},${square.y(at[1])})`}, claimGlyph(point.wrong ? 'var(--spurious)' : 'var(--ink)')));
  }
  differencePlaces.forEach(({squares: places}, id) => {
    const centre = middleOf(places[which]);
    if (square.numbers && square.shows(centre)) square.marks.append(differenceMark(id, result.differences[id], square, centre));
  });
}

function middleOf(points) {
  return [0, 1].map((k) => (Math.min(...points.map((p) => p[k])) + Math.max(...points.map((p) => p[k]))) / 2);
}

/** The number of a difference in a square: a button that flies to it. */
function differenceMark(id, difference, square, [a, b]) {
  return drawing('g', {class: 'difference-mark', 'data-difference': id, transform: `translate(${(square.x(a) + 15).toFixed(1)},${(square.y(b) - 15).toFixed(1)})`},
    drawing('title', {}, `difference ${id + 1}, ${difference.kind}: ${difference.text}`),
    drawing('path', {class: 'leader', d: 'M-5,5L-12,12'}), drawing('circle', {r: 8}), drawing('text', {'text-anchor': 'middle', y: 4}, String(id + 1)));
}

const insetSize = 104;
const leastSeen = 4;  // units of the drawing

/** Differences too small to be seen are magnified in a corner, at most one in each. */
function paintInsets(square, which) {
  if (!isWhole(square)) return;
  const crowded = [[0, 0], [1, 0], [0, 1], [1, 1]].map(([i, j]) => {
    const corner = [left + 6 + i * (side - insetSize - 12), top_ + 6 + j * (side - insetSize - 12)];
    const inside = ([a, b]) => square.x(a) > corner[0] - 8 && square.x(a) < corner[0] + insetSize + 8 && square.y(b) > corner[1] - 8 && square.y(b) < corner[1] + insetSize + 8;
    return {corner, points: arcs.flatMap((arc) => arcIn(arc, which)).filter(inside).length};
  }).sort((a, b) => a.points - b.points);
  const small = differencePlaces.map((places, id) => ({id, points: places.squares[which]})).filter(({points}) => side * extentOf(points) < leastSeen);
  small.slice(0, crowded.length).forEach(({id, points}, i) => {
    const extent = Math.max(2.4 * extentOf(points), 1e-9);
    const size = extentOf(points) > 0 ? extent : 0.02;
    const centre = middleOf(points);
    const [x, y] = crowded[i].corner;
    const from = [square.x(centre[0]), square.y(centre[1])];
    const holder = drawing('g', {class: 'inset', 'data-difference': id}, drawing('title', {}, `difference ${id + 1}, magnified ${Math.round(1 / size)} times`),
      drawing('path', {class: 'leader', d: `M${from}L${x + insetSize / 2},${y + insetSize / 2}`}), drawing('rect', {x, y, width: insetSize, height: insetSize}));
    square.marks.append(holder);
    const target = framed(holder, [x, y], insetSize, centre.map((t) => [t - size / 2, t + size / 2]));
    paintResult(target, which, false);
    paintVerdict(target, which);
    holder.append(drawing('circle', {class: 'spot', cx: from[0], cy: from[1], r: 5}), drawing('text', {class: 'label', x: x + 5, y: y + insetSize - 6}, `× ${Number((insetSize / side / size).toPrecision(2))}`));
  });
}

function verdictInSquares() {
  squares.forEach((square, which) => {
    square.numbers = true;
    square.paint(() => paintVerdict(square, which));
    square.paint(() => paintInsets(square, which));
    page.addEventListener('click', (event) => {
      const target = event.target.closest('.difference-mark, .inset');
      if (target && square.svg.contains(target)) select('difference', Number(target.dataset.difference));
    });
  });
}

function verdictLegend() {
  const stroke = (name) => drawing('path', {class: `arc ${name}`, d: 'M1,8H33'});
  const entries = [];
  if (report.candidate.curves.length) entries.push([stroke('claimed'), 'candidate']);
  if (report.gaps.length) entries.push([stroke('gap'), 'not covered by the candidate']);
  if (result.curves.some((curve) => curve.spurious.length)) entries.push([stroke('spurious'), 'no intersection']);
  if (report.candidate.points.length) {
    const mark = claimGlyph('var(--spurious)');
    mark.setAttribute('transform', 'translate(17,8)');
    entries.push([mark, 'claimed point']);
  }
  if (entries.length) document.getElementById('selection').before(legendList(entries));
}

function differenceTable() {
  const where = (difference) => [
    difference.components.length ? `component ${difference.components.join(', ')}` : '',
    difference.arc === undefined ? '' : `arc ${difference.arc}`,
    difference.curve === undefined ? '' : `curve ${difference.curve}`,
    difference.point === undefined ? '' : `point ${difference.point}`].filter(Boolean).join(', ');
  const exactly = ({gap, part}) => gap && !gap.parameter ? `vertices ${gap.vertices.join(' to ')}` : gap ? element('span', {}, `${gap.parameter} `, exactInterval([gap.from, gap.to]))
    : part ? `${part.in === 'space' ? '' : `${part.in}: `}${short(part.from)} to ${short(part.to)}` : '';
  const place = (id) => `(${ballAround(differencePlaces[id].space).centre.map((c) => Number(c.toPrecision(5))).join(', ')})`;
  const rows = result.differences.map((difference, id) => element('tr', {'data-kind': difference.kind, 'data-difference': id},
    element('td', {}, pickButton(`show ${id + 1}`, drawing('circle', {r: 6, fill: 'none', stroke: 'var(--bad)', 'stroke-width': 2.4}), `difference ${id + 1}`)),
    element('td', {}, difference.kind), element('td', {class: 'statement'}, difference.text), element('td', {}, where(difference)),
    element('td', {class: 'near'}, place(id)), element('td', {}, exactly(difference))));
  return tableOf({id: 'differences', class: 'cards'}, 'Each of these is proved. A button flies to it, in space and in the squares.', [[''], ['kind'], ['difference'], ['where'], ['near (x, y, z)'], ['exactly']], rows);
}

function distanceText(bounds) {
  return bounds ? `${Number(bounds[0].toPrecision(3))} to ${boundText(bounds[1])}` : '–';
}

function candidateTable() {
  const rows = result.curves.map((curve) => element('tr', {}, element('td', {class: 'number'}, String(curve.curve)), element('td', {}, curve.components.join(', ') || '–'),
    element('td', {class: 'number'}, distanceText(curve.distance)), element('td', {class: 'number'}, distanceText(curve.true_distance))));
  return tableOf({id: 'claimed-curves'}, 'Largest distances lie between the two numbers; proved',
    [['curve', 'number'], ['follows component'], ['largest distance from the true curve', 'number'], ['of the true curve from it', 'number']], rows);
}

function coverageTable() {
  const rows = result.components.map((component) => element('tr', {}, element('td', {class: 'number'}, String(component.component)), element('td', {}, component.shape),
    element('td', {}, component.coverage), element('td', {}, component.curves.join(', ') || '–')));
  return tableOf({id: 'coverage'}, 'Components of the true curve', [['component', 'number'], ['shape'], ['by the candidate'], ['curves']], rows);
}

function verdictProofs() {
  const agrees = ['Agreement: candidate and true curve can be run through together, never farther apart than the tolerance; every arc is run through once.', 'Both are cut into straight pieces with proved bounds; between matched places the distance is largest at an end.'];
  const differs = ['Differences: every gap, spurious part and false point is farther than the tolerance from the other side.', 'Distances of straight pieces are bounded from below, their bounds and all rounding taken off.'];
  return [...(result.verdict === 'agrees' ? [agrees] : result.verdict === 'disagrees' ? [differs] : []), ...intersectionProofs(true)];
}

function verifyPage() {
  pictures(true);
  verdictInSpace();
  verdictInSquares();
  verdictLegend();
  if (result.differences.length) section('Differences', 'differences-section', differenceTable());
  section('The candidate', 'candidate-section', ...(result.components.length ? [coverageTable()] : []), ...(result.curves.length ? [candidateTable()] : []));
  graphTables();
  section('What was proved, and how', 'proofs', proofSection(verdictProofs()));
  paperSection();
  dataSection();
  listenForSelection();
  markSelected();
}
