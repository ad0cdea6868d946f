// Is an answer right, and if not, which mistake does it look like? The one judge: of the page, of
// notebooks and of `grade`.
//
// exercise: { asked, asks, shape, accept, outcomes }, made by judging.py. listed: what somebody may
// answer in a variant, [[name, rows], …], without the right answers in other units.

const NEAR = 10; // tolerances: so close is probably rounding on the way
const SAYS = {
  near: "Not yet, but very close. Keep all digits on the way, and give three decimals.",
  wrong: "Not yet, and none of the mistakes known here gives this.",
  parts: "Already right: {labels}.",
  shape: "Asked is {asked}. This was read as {read}.",
  other: "There are other right answers too.",
};

// A sentence with its placeholders filled.
const said = (sentence, words) => sentence.replace(/\{(\w+)\}/g, (_, key) => words[key]);

const offBy = (ask, x, wanted, factor) => {
  if (!ask.circle) return Math.abs(x - wanted);
  const turn = 2 * Math.PI * Math.abs(factor), off = Math.abs(x - wanted) % turn;
  return Math.min(off, turn - off);
};

// Whether each row is one of the wanted ones, each of them once. allowed: in tolerances.
const meets = ({ asks }, rows, wanted, factors, allowed = 1) => {
  const left = wanted.slice();
  const fits = (x, i, other) => offBy(asks[i], x, other[i], factors[i])
    <= allowed * asks[i].tolerance * Math.abs(factors[i]);
  return rows.every((row) => {
    const place = left.findIndex((other) => row.every((x, i) => fits(x, i, other)));
    if (place >= 0) left.splice(place, 1);
    return place >= 0;
  }) && !left.length;
};

// All that may be answered: in other units, too.
const withUnits = ({ outcomes }, listed) => {
  const right = listed.filter(([name]) => name === "right");
  const units = Object.keys(outcomes).filter((name) => name.startsWith("unit:"));
  return [...listed, ...units.flatMap((unit) => right.map(([, rows]) =>
    [unit, rows.map((row) => row.map((x, i) => x * outcomes[unit].factors[i]))]))];
};

// The labels of those numbers of an answer that are right by themselves.
const rightParts = ({ accept, shape, asks }, right, row) =>
  accept !== "one" || shape.length ? [] : asks.filter((ask, i) =>
    offBy(ask, row[i], right[i], 1) <= ask.tolerance).map((ask) => ask.label);

// The verdict on an answer that has the right shape.
const judge = (exercise, listed, rows) => {
  for (const [name, wanted] of withUnits(exercise, listed)) {
    const { result, says, factors } = exercise.outcomes[name];
    if (meets(exercise, rows, wanted, factors)) {
      const more = exercise.accept === "any" && result === "right" ? ` ${SAYS.other}` : "";
      return { result, name, says: says + more };
    }
  }
  const right = listed.filter(([name]) => name === "right"), ones = exercise.asks.map(() => 1);
  if (right.some(([, wanted]) => meets(exercise, rows, wanted, ones, NEAR))) {
    return { result: "wrong", name: "near", says: SAYS.near };
  }
  const parts = rightParts(exercise, right[0][1][0], rows[0]);
  const more = parts.length ? ` ${said(SAYS.parts, { labels: parts.join(", ") })}` : "";
  return { result: "wrong", name: "", says: SAYS.wrong + more };
};

// Lengths, from outside to inside, of lists in lists that are all alike; null if they are not.
const shapeOf = (value) => {
  if (!Array.isArray(value)) return [];
  const [first, ...others] = value.map(shapeOf);
  const alike = first && others.every((other) => other && String(other) === String(first));
  if (value.length && !alike) return null;
  return [value.length, ...(first ?? [])];
};

// A typed number or list as rows of the numbers asked for; null if it has another shape.
const rowsOf = ({ asks: { length: size }, accept, shape }, value, count) => {
  const single = [[size], shape.length ? shape : [size], [1, size], ...(size === 1 ? [[]] : [])];
  const several = [[count, size], ...(size === 1 ? [[count]] : [])];
  const found = JSON.stringify(shapeOf(value));
  if (!(accept === "all" ? several : single).some((one) => JSON.stringify(one) === found)) return null;
  const flat = [value].flat(Infinity), rows = [];
  for (let i = 0; i < flat.length; i += size) rows.push(flat.slice(i, i + size));
  return rows;
};

const shownValue = (value) => Array.isArray(value)
  ? `[${value.map(shownValue).join(", ")}]`
  : trueMinus(String(Number(value.toPrecision(6))));

// The verdict on what was typed: { result, name, says }; result "unread" counts for nothing.
const checkAnswer = (exercise, listed, text) => {
  const unread = (says) => ({ result: "unread", name: "", says });
  const { value, problem, about } = readAnswer(text);
  if (problem) return unread(said(PROBLEMS[problem], { about }));
  const rows = rowsOf(exercise, value, listed[0][1].length);
  if (rows) return judge(exercise, listed, rows);
  return unread(said(SAYS.shape, { asked: exercise.asked, read: shownValue(value) }));
};

// The verdicts on many answers, [variant, text] each. variants: what is listed for each.
const checkAnswers = (exercise, variants, answers) =>
  answers.map(([variant, text]) => checkAnswer(exercise, variants[variant], text));

Object.assign(part, { SAYS, checkAnswer, checkAnswers });
