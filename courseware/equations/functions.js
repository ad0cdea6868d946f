// The functions beyond Math that a formula may call: see functions.py.

const RANK_TOLERANCE = 1e-9; // relative to the longest row
export const dot = (p, q) => p.reduce((sum, x, i) => sum + x * q[i], 0);

// Gram and Schmidt, the longest row first, twice against rounding: an orthonormal basis of the rows.
const rowBasis = (rows, cols, entries) => {
  let left = Array.from({ length: rows }, (_, i) => entries.slice(cols * i, cols * i + cols));
  const basis = [], small = RANK_TOLERANCE * Math.sqrt(Math.max(...left.map((row) => dot(row, row))));
  for (;;) {
    const longest = left.reduce((one, other) => dot(other, other) > dot(one, one) ? other : one);
    const long = Math.sqrt(dot(longest, longest));
    if (!(long > small)) return basis;
    const unit = longest.map((x) => x / long), without = (row) => {
      const along = dot(row, unit);
      return row.map((x, i) => x - along * unit[i]);
    };
    basis.push(unit);
    left = left.map((row) => without(without(row)));
  }
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
  rank: (rows, cols, ...c) => rowBasis(rows, cols, c).length,
  null_projector: (index, rows, cols, ...c) => {
    const i = Math.floor(index / cols), j = index % cols;
    return rowBasis(rows, cols, c).reduce((left, unit) => left - unit[i] * unit[j], Number(i === j));
  },
  solve: (index, n, cols, ...ab) => solve(n, ab)[index],
};
