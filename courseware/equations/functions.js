// The functions beyond Math that a formula may call: see functions.py.

const RANK_TOLERANCE = 1e-9; // relative to the largest singular value, as in Python

// One-sided Jacobi: turn pairs of columns until all are orthogonal. Their lengths are then the
// singular values, and the turns V the right singular vectors.
const svd = (rows, cols, entries) => {
  const a = Array.from({ length: cols }, (_, j) =>
    Array.from({ length: rows }, (_, i) => entries[cols * i + j]));
  const v = a.map((_, j) => a.map((_, i) => (i === j ? 1 : 0)));
  const dot = (p, q) => p.reduce((sum, x, i) => sum + x * q[i], 0);
  const turn = (p, q, c, s) => p.forEach((x, i) => {
    p[i] = c * x - s * q[i];
    q[i] = s * x + c * q[i];
  });
  for (let sweep = 0, busy = true; busy && sweep < 30; sweep++) {
    busy = false;
    for (let i = 0; i < cols; i++) for (let j = i + 1; j < cols; j++) {
      const g = dot(a[i], a[j]), n = dot(a[i], a[i]), m = dot(a[j], a[j]);
      if (Math.abs(g) <= 1e-16 * Math.sqrt(n * m)) continue;
      busy = true;
      const z = (m - n) / (2 * g);
      const t = (z < 0 ? -1 : 1) / (Math.abs(z) + Math.sqrt(1 + z * z));
      const c = 1 / Math.sqrt(1 + t * t);
      turn(a[i], a[j], c, c * t);
      turn(v[i], v[j], c, c * t);
    }
  }
  const lengths = a.map((p) => Math.sqrt(dot(p, p)));
  const small = RANK_TOLERANCE * Math.max(...lengths);
  return { vectors: v, free: lengths.map((length) => !(length > small)) };
};

// Gauss and Jordan, with the largest pivot of a column.
const solve = (n, entries) => {
  const m = Array.from({ length: n }, (_, i) =>
    [...entries.slice(n * i, n * i + n), entries[n * n + i]]);
  for (let k = 0; k < n; k++) {
    let p = k;
    for (let i = k; i < n; i++) if (Math.abs(m[i][k]) > Math.abs(m[p][k])) p = i;
    [m[k], m[p]] = [m[p], m[k]];
    if (m[k][k] === 0) return m.map(() => NaN);
    for (let i = 0; i < n; i++) {
      const q = i === k ? 0 : m[i][k] / m[k][k];
      for (let j = k; j <= n; j++) m[i][j] -= q * m[k][j];
    }
  }
  return m.map((row, k) => row[n] / row[k]);
};

// As compiled formulas call them.
export const functions = {
  sinc: (x) => (x === 0 ? 1 : Math.sin(x) / x),
  rank: (rows, cols, ...c) => svd(rows, cols, c).free.filter((free) => !free).length,
  null_projector: (index, rows, cols, ...c) => {
    const { vectors, free } = svd(rows, cols, c);
    const i = Math.floor(index / cols), j = index % cols;
    return vectors.reduce((sum, v, k) => (free[k] ? sum + v[i] * v[j] : sum), 0);
  },
  solve: (index, n, cols, ...ab) => solve(n, ab)[index],
};
