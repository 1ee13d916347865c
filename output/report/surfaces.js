// Surfaces that the page makes of equations and profiles, in doubles, for the eye.

/** The polynomial of exact terms in x, y, z as a function, scaled so that its largest coefficient is 1. */
function polynomialFunction(terms) {
  const numbers = terms.map(([coefficient, exponents]) => [toDouble(coefficient), exponents]);
  const largest = Math.max(...numbers.map(([c]) => Math.abs(c))) || 1;
  const powers = [[], [], []];
  const degree = Math.max(0, ...numbers.flatMap(([, exponents]) => exponents));
  return (p) => {
    for (let k = 0; k < 3; ++k) {
      powers[k][0] = 1;
      for (let e = 1; e <= degree; ++e) powers[k][e] = powers[k][e - 1] * p[k];
    }
    let sum = 0;
    for (const [c, [i, j, k]] of numbers) sum += c / largest * powers[0][i] * powers[1][j] * powers[2][k];
    return sum;
  };
}

const tetrahedra = [[0, 5, 1, 6], [0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6]];
const cubeCorners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];

/** The zero set of f in a box as a translucent piece: on n cells along each side, by tetrahedra. */
function zeroSurface(f, {low, high}, n, property, opacity) {
  const at = (i, j, k) => [low[0] + (high[0] - low[0]) * i / n, low[1] + (high[1] - low[1]) * j / n, low[2] + (high[2] - low[2]) * k / n];
  const values = new Float64Array((n + 1) ** 3);
  const index = (i, j, k) => (i * (n + 1) + j) * (n + 1) + k;
  for (let i = 0; i <= n; ++i) for (let j = 0; j <= n; ++j) for (let k = 0; k <= n; ++k) values[index(i, j, k)] = f(at(i, j, k));
  const step = low.map((a, k) => 1e-4 * (high[k] - a));
  const gradient = (p) => unit([0, 1, 2].map((k) => {
    const [a, b] = [[...p], [...p]];
    a[k] -= step[k];
    b[k] += step[k];
    return (f(b) - f(a)) / step[k];
  }));
  const piece = {positions: [], normals: [], triangles: [], property, opacity};
  const vertices = new Map();
  const vertex = (a, b) => {
    const key = a.id < b.id ? `${a.id},${b.id}` : `${b.id},${a.id}`;
    if (!vertices.has(key)) {
      const p = plus(a.at, minus(b.at, a.at), a.value / (a.value - b.value));
      vertices.set(key, piece.positions.length / 3);
      piece.positions.push(...p);
      piece.normals.push(...gradient(p));
    }
    return vertices.get(key);
  };
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < n; ++j)
      for (let k = 0; k < n; ++k) {
        const ids = cubeCorners.map(([a, b, c]) => index(i + a, j + b, k + c));
        const negative = ids.filter((id) => values[id] < 0).length;
        if (negative === 0 || negative === 8) continue;
        const corners = cubeCorners.map(([a, b, c], m) => ({id: ids[m], at: at(i + a, j + b, k + c), value: values[ids[m]]}));
        for (const tetrahedron of tetrahedra) {
          const inside = tetrahedron.filter((m) => corners[m].value < 0).map((m) => corners[m]);
          const outside = tetrahedron.filter((m) => !(corners[m].value < 0)).map((m) => corners[m]);
          if (inside.length === 1) piece.triangles.push(...outside.map((b) => vertex(inside[0], b)));
          if (inside.length === 3) piece.triangles.push(...inside.map((a) => vertex(a, outside[0])));
          if (inside.length === 2) {
            const [a, b, c, d] = [vertex(inside[0], outside[0]), vertex(inside[0], outside[1]), vertex(inside[1], outside[1]), vertex(inside[1], outside[0])];
            piece.triangles.push(a, b, c, a, c, d);
          }
        }
      }
  return oriented(piece);
}

/** Of a surface given by its equation what the program has sampled: some of its points. */
function equationCorners({mesh}) {
  return mesh ? mesh.points.filter((_, i) => i % 7 === 0) : [];
}

/** A surface given by its equation as a translucent piece: as it was sampled, or its zero set in the box of the view. */
function equationPiece({mesh, terms}, ball, patch) {
  if (!mesh) return {...zeroSurface(polynomialFunction(terms), ball, 32, `--patch${patch}`, 0.5), patch};
  const piece = {positions: mesh.points.flat(), normals: mesh.points.flatMap(() => [0, 0, 0]), triangles: [], property: `--patch${patch}`, opacity: 0.5};
  for (const face of mesh.faces)
    for (let i = 2; i < face.length; ++i) piece.triangles.push(face[0], face[i - 1], face[i]);
  // At a corner the sum of its triangles' normals: all faces go round in one direction.
  for (let t = 0; t < piece.triangles.length; t += 3) {
    const [p, q, r] = [0, 1, 2].map((k) => mesh.points[piece.triangles[t + k]]);
    const normal = cross(minus(q, p), minus(r, p));
    for (let k = 0; k < 3; ++k) normal.forEach((c, m) => { piece.normals[3 * piece.triangles[t + k] + m] += c; });
  }
  for (let i = 0; i < piece.normals.length; i += 3) piece.normals.splice(i, 3, ...unit(piece.normals.slice(i, i + 3)));
  return {...oriented(piece), patch};
}

/** A polyline of the half plane, turned about the z axis, as a translucent piece. */
function turnedPiece(polyline, property, opacity) {
  const sectors = 72;
  return gridPiece(polyline.length - 1, sectors, (s, t) => {
    const i = Math.round(s * (polyline.length - 1));
    const [r, z] = polyline[i];
    const chord = minus(polyline[Math.min(i + 1, polyline.length - 1)], polyline[Math.max(i - 1, 0)]);
    const angle = 2 * Math.PI * t;
    return {at: [r * Math.cos(angle), r * Math.sin(angle), z], normal: unit([chord[1] * Math.cos(angle), chord[1] * Math.sin(angle), -chord[0]])};
  }, property, opacity);
}

function circle(r, z) {
  return Array.from({length: 97}, (_, i) => [r * Math.cos(2 * Math.PI * i / 96), r * Math.sin(2 * Math.PI * i / 96), z]);
}

/** The box around points, a little larger, and its corners. */
function boxAround(points, margin) {
  const ball = ballAround(points);
  const low = ball.low.map((t) => t - margin * ball.radius);
  const high = ball.high.map((t) => t + margin * ball.radius);
  const corners = Array.from({length: 8}, (_, i) => [0, 1, 2].map((k) => (i >> k & 1 ? high[k] : low[k])));
  return {low, high, corners};
}
