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

function verdictInSpace() {
  if (!view) return;
  for (const gap of report.gaps) view.wireGroup.add(view.wire(gap.map((vertex) => vertex.slice(4)), '--gap', 9, {opacity: 0.9, order: 4}));
  for (const curve of report.candidate.curves) {
    view.wireGroup.add(view.wire(strandInSpace(curve[0]), '--ink', 1.8, {dashes: [0.02, 0.02], order: 5}));
    for (const strand of curve)
      for (const part of strand.spurious) view.wireGroup.add(view.wire(strandInSpace(strand, part), '--spurious', 5, {order: 6}));
  }
  for (const point of report.candidate.points) {
    const mark = drawing('g', {class: 'claimed'}, claimGlyph(point.wrong ? 'var(--spurious)' : 'var(--ink)'));
    view.overlay.append(mark);
    view.marks.push({node: mark, at: pointInSpace(point)});
  }
  view.repaint();
}

function verdictInSquares() {
  const line = (square, points, name) => square.content.append(drawing('path', {class: `arc ${name}`, d: pathThrough(square, points)}));
  squares.forEach((square, which) => {
    for (const gap of report.gaps) line(square, gap.map((vertex) => vertex.slice(2 * which, 2 * which + 2)), 'gap');
    for (const curve of report.candidate.curves)
      for (const strand of curve.filter((strand) => squareOf[strand.in] === which)) {
        line(square, strand.points, 'claimed');
        for (const part of strand.spurious) line(square, part, 'spurious');
      }
    for (const point of report.candidate.points) {
      const at = which === 0 ? point.first : point.second;
      if (at) square.content.append(drawing('g', {class: 'claimed', transform: `translate(${square.x(at[0])},${square.y(at[1])})`}, claimGlyph(point.wrong ? 'var(--spurious)' : 'var(--ink)')));
    }
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
  if (entries.length) page.append(legendList(entries));
}

function differenceTable() {
  const where = (difference) => [
    difference.components.length ? `component ${difference.components.join(', ')}` : '',
    difference.arc === undefined ? '' : `arc ${difference.arc}`,
    difference.curve === undefined ? '' : `curve ${difference.curve}`,
    difference.point === undefined ? '' : `point ${difference.point}`].filter(Boolean).join(', ');
  const exactly = ({gap, part}) => gap ? element('span', {}, `${gap.parameter} `, exactInterval([gap.from, gap.to]))
    : part ? `${part.in === 'space' ? '' : `${part.in}: `}${short(part.from)} to ${short(part.to)}` : '';
  const rows = result.differences.map((difference) => element('tr', {'data-kind': difference.kind}, element('td', {}, difference.kind),
    element('td', {class: 'statement'}, difference.text), element('td', {}, where(difference)), element('td', {}, exactly(difference))));
  return tableOf({id: 'differences'}, 'Each of these is proved', [['kind'], ['difference'], ['where'], ['exactly']], rows);
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

function verdictWords() {
  const claimed = `${counted(report.candidate.curves.length, 'curve')}${report.candidate.points.length ? ` and ${counted(report.candidate.points.length, 'point')}` : ''}`;
  const source = result.source ? ` of ${result.source}` : '';
  if (result.verdict === 'agrees') return `The candidate${source}, ${claimed}, is within ${boundText(result.tolerance)} of the true curve and joined in the same way.`;
  if (result.verdict === 'disagrees') return `The candidate${source}, ${claimed}, differs from the true curve in ${counted(result.differences.length, 'way')}.`;
  return `The candidate${source}, ${claimed}: ${result.undecided.join('; ')}.`;
}

function verdictProofs() {
  const agrees = ['Agreement: candidate and true curve can be run through together, never farther apart than the tolerance; every arc is run through once.', 'Both are cut into straight pieces with proved bounds; between matched places the distance is largest at an end.'];
  const differs = ['Differences: every gap, spurious part and false point is farther than the tolerance from the other side.', 'Distances of straight pieces are bounded from below, their bounds and all rounding taken off.'];
  return [...(result.verdict === 'agrees' ? [agrees] : result.verdict === 'disagrees' ? [differs] : []), ...intersectionProofs(true)];
}

function verifyPage() {
  counts([['components', graph.summary.components], ['curves claimed', report.candidate.curves.length], ['points claimed', report.candidate.points.length], ['tolerance', boundText(result.tolerance)]]);
  pictures(true);
  verdictInSpace();
  verdictInSquares();
  verdictLegend();
  if (result.differences.length) section('Differences', 'differences-section', differenceTable());
  section('The candidate', 'candidate-section', ...(result.components.length ? [coverageTable()] : []), ...(result.curves.length ? [candidateTable()] : []));
  graphTables();
  section('What was proved, and how', 'proofs', proofSection(verdictProofs()));
  dataSection();
  listenForSelection();
  markSelected();
}
