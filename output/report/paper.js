// For a paper: tables of nodes with proved digits, the entry for the literature, and what repeats the result.

/** Exact rational numbers as [numerator, denominator > 0]; "p/q" or "p" as text. */
const exactNumber = (text) => {
  const [p, q = '1'] = text.split('/');
  return [BigInt(p), BigInt(q)];
};
const exactSum = ([a, b], [c, d]) => b === d ? [a + c, b] : [a * d + c * b, b * d];
const exactProduct = ([a, b], [c, d]) => [a * c, b * d];
const isLess = ([a, b], [c, d]) => a * d < c * b;

/** The interval of c x for x in [low, high]. */
function scaledInterval(c, [low, high]) {
  const ends = [exactProduct(c, low), exactProduct(c, high)];
  return c[0] < 0n ? ends.reverse() : ends;
}

/** Intervals of the Bernstein polynomials of degree n for t in [low, high], a part of [0,1]. */
function bernsteinIntervals(n, [low, high]) {
  const rest = [high, low].map(([a, b]) => [b - a, b]);
  const power = (t, k) => k > 0 ? exactProduct(t, power(t, k - 1)) : [1n, 1n];
  const binomials = [[1n], [1n, 1n], [1n, 2n, 1n], [1n, 3n, 3n, 1n]][n];
  return binomials.map((c, i) => [0, 1].map((end) => exactProduct([c, 1n], exactProduct(power([low, high][end], i), power(rest[end], n - i)))));
}

/** [low, high] divided by an interval of positive numbers. */
function dividedInterval([low, high], below) {
  const divided = ([a, b], [c, d]) => [a * d, b * c];
  return [divided(low, below[low[0] < 0n ? 0 : 1]), divided(high, below[high[0] < 0n ? 1 : 0])];
}

/** Proved intervals of x, y, z over a box of two parameters of a patch; null where the denominator's is not positive. */
function exactPoint({net, weights}, box) {
  const [first, second] = box.map((interval, which) => bernsteinIntervals((which ? net[0].length : net.length) - 1, interval.map(exactNumber)));
  const sumOf = (coefficient) => {
    let sum = [[0n, 1n], [0n, 1n]];
    net.forEach((row, i) => row.forEach((_, j) => {
      const basis = [0, 1].map((end) => exactProduct(first[i][end], second[j][end]));
      sum = scaledInterval(coefficient(i, j), basis).map((end, n) => exactSum(sum[n], end));
    }));
    return sum;
  };
  if (!weights) return [0, 1, 2].map((k) => sumOf((i, j) => exactNumber(net[i][j][k])));
  const below = sumOf((i, j) => exactNumber(weights[i][j]));
  if (below[0][0] <= 0n) return [null, null, null];
  return [0, 1, 2].map((k) => dividedInterval(sumOf((i, j) => exactProduct(exactNumber(weights[i][j]), exactNumber(net[i][j][k]))), below));
}

/** floor(a/b) for b > 0. */
const floored = (a, b) => a >= 0n ? a / b : -((-a + b - 1n) / b);

/**
 * The decimal with as many digits after the point, at most `most`, as the interval proves: every number of it is
 * within one unit of the last digit; a single number that the decimal gives exactly has no zeros at its end. Empty if not even the units are known.
 */
function provedDecimal([low, high], most = 12) {
  for (let digits = most; digits >= 0; --digits) {
    const scale = 10n ** BigInt(digits);
    const middle = exactSum(exactProduct(low, [1n, 2n]), exactProduct(high, [1n, 2n]));
    const nearest = floored(2n * middle[0] * scale + middle[1], 2n * middle[1]);
    if (isLess([nearest + 1n, scale], high) || isLess(low, [nearest - 1n, scale])) continue;
    const isExact = !isLess(low, high) && !isLess([nearest, scale], low) && !isLess(low, [nearest, scale]);
    const size = String(nearest < 0n ? -nearest : nearest).padStart(digits + 1, '0');
    const text = (nearest < 0n ? '-' : '') + (digits ? `${size.slice(0, -digits)}.${size.slice(-digits)}` : size);
    return isExact && digits ? text.replace(/\.?0+$/, '') : text;
  }
  return '';
}

/** Heads and rows of the table of nodes, or of the points of a line: kinds, parameters, and the point of space. */
function printedNodes() {
  const columns = (box) => parameters.map((p) => box[p] ? provedDecimal(box[p].map(exactNumber)) : '');
  if (nodes.length && !parameters.length)
    return {heads: ['node', 'kind', 'x', 'y', 'z'], rows: nodes.map((node) => [String(node.id), nodeWords(node), ...node.box.map((interval) => provedDecimal(interval.map(exactNumber)))])};
  if (nodes.length)
    return {heads: ['node', 'kind', ...parameters, 'x', 'y', 'z'], rows: nodes.map((node) => [String(node.id), nodeWords(node), ...columns(node.box),
      ...exactPoint(report.patches[0], parameters.slice(0, 2).map((p) => node.box[p])).map((interval) => interval ? provedDecimal(interval) : '')])};
  if (report.command !== 'line' || !result.points.length) return null;
  const known = parameters.filter((p) => result.points[0].box[p]);
  return {heads: ['point', ...known], rows: result.points.map((point, i) => [pointLetter(i), ...known.map((p) => provedDecimal(point.box[p].map(exactNumber)))])};
}

/** One name in mathematics: u1 is u with index 1. */
const texName = (name) => /^[a-z]\d?$/.test(name) ? `$${name[0]}${name[1] ? `_${name[1]}` : ''}$` : name;
const texText = (text) => text.replace(/[\\{}$&#%_^~]/g, (c) => ({'\\': '\\textbackslash{}', '^': '\\^{}', '~': '\\~{}'})[c] || `\\${c}`);
const texNumber = (text) => text ? `$${text}$` : '--';

function latexTable({heads, rows}) {
  const words = heads.map((head) => ['node', 'kind', 'point'].includes(head));
  const lines = rows.map((row) => row.map((cell, i) => words[i] ? texText(cell) : texNumber(cell)).join(' & ') + ' \\\\');
  return ['% Every digit is proved: the true value is within one unit of the last digit.', `\\begin{tabular}{${heads.map((_, i) => words[i] ? 'l' : 'r').join('')}}`, '\\hline',
    heads.map(texName).join(' & ') + ' \\\\', '\\hline', ...lines, '\\hline', '\\end{tabular}', ''].join('\n');
}

function markdownTable({heads, rows}) {
  const line = (cells) => `| ${cells.map((cell) => cell.replace(/\|/g, '\\|') || '–').join(' | ')} |`;
  return [line(heads), `|${heads.map((head) => ['node', 'kind', 'point'].includes(head) ? ' --- |' : ' ---: |').join('')}`, ...rows.map(line), ''].join('\n');
}

function bibtex() {
  const [, version = ''] = report.program.split(' ');
  return `@software{exsect,\n  title = {exsect: exact, certified intersection of biquadratic {B\\'ezier} surface patches},\n  author = {{The exsect authors}},\n  version = {${version}},\n  license = {Apache-2.0}\n}\n`
    + '@incollection{chau2008intersecting,\n  author = {Chau, St\\\'ephane and Oberneder, Margot and Galligo, Andr\\\'e and J{\\"u}ttler, Bert},\n  title = {Intersecting Biquadratic {B\\\'ezier} Surface Patches},\n'
    + '  booktitle = {Geometric Modeling and Algebraic Geometry},\n  editor = {Piene, Ragni and J{\\"u}ttler, Bert},\n  publisher = {Springer},\n  year = {2008}\n}\n';
}

/** A button that copies a text, and says whether it did. */
function copyButton(label, makeText, status) {
  return textButton(label, async () => {
    status.textContent = await copyText(makeText()) ? 'copied' : 'the browser does not let the page copy';
  });
}

function paperSection() {
  const status = element('span', {class: 'note', role: 'status'});
  const table = printedNodes();
  const what = nodes.length ? 'nodes' : 'points';
  const buttons = [
    ...(view ? [textButton('drawing of space as SVG', () => saveFile(filename('-space.svg'), 'image/svg+xml', [vectorPicture(view)]))] : []),
    ...(table ? [copyButton(`${what} as LaTeX`, () => latexTable(table), status), copyButton(`${what} as Markdown`, () => markdownTable(table), status)] : []),
    copyButton('BibTeX', bibtex, status), ...(report.line ? [copyButton('command line', () => report.line + '\n', status)] : [])];
  const rows = [...(report.line ? [['command', report.line]] : []), ...report.inputs.filter(({sha256}) => sha256).map(({file, sha256}) => [`SHA-256 of ${file}`, sha256]), ['program', report.program]];
  section('For a paper', 'paper', element('div', {class: 'controls'}, ...buttons, status),
    element('dl', {class: 'origin'}, rows.flatMap(([name, text]) => [element('dt', {}, name), element('dd', {}, element('code', {}, text))])),
    ...(table ? [element('p', {class: 'note'}, 'The tables hold as many decimals as the boxes prove: the true value is within one unit of the last digit. The drawing has no hidden lines and the colours of print.')] : []));
}
