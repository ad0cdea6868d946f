// Quarter turns: a state is [presses, part of the last one that is made].

const LONG = 600; // ms

const pressesOf = (text) => (/^(-?[xyz])*$/i.test(text) && text.match(/-?./g)) || [];

const quarter = (press) => {
  const axis = "xyz".indexOf(press.slice(-1).toLowerCase()), sign = press[0] === "-" ? -1 : 1;
  const unit = [0, 1, 2].map((k) => (k === axis ? sign : 0));
  const [i, j] = [(axis + 1) % 3, (axis + 2) % 3], R = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  R[4 * axis] = 1;
  R[3 * i + j] = -sign;
  R[3 * j + i] = sign;
  return { unit, R, own: press.slice(-1) < "a" };
};

const times = (A, B) => A.map((_, k) => {
  const row = 3 * Math.floor(k / 3), column = k % 3;
  return A[row] * B[column] + A[row + 1] * B[column + 3] + A[row + 2] * B[column + 6] + 0;
});

// What the formulas get: the rotation before the last turn, its axis, whose it is, part and count.
const turnNumbers = ([text, made]) => {
  const all = pressesOf(text).map(quarter), last = all[all.length - 1];
  const before = all.slice(0, -1).reduce(
    (R, turn) => (turn.own ? times(R, turn.R) : times(turn.R, R)), [1, 0, 0, 0, 1, 0, 0, 0, 1]);
  return [...before, ...(last?.unit ?? [0, 0, 0]), Number(last?.own ?? true), made, all.length];
};

const pressButton = (press) => {
  const letter = press.slice(-1), words = press[0] === "-" ? "minus" : "plus";
  return `<button type="button" data-press="${press}" aria-label="${words} 90° about `
    + `${letter < "a" ? "its own" : "the room\u2019s"} ${letter.toLowerCase()} axis" `
    + `style="color:${color(`${letter.toLowerCase()}_axis`)}">`
    + `${press[0] === "-" ? "\u2212" : "+"}<i>${letter.toLowerCase()}</i></button>`;
};

const turnsHtml = (control, i) => `<div class="rk-turning" data-i="${i}">`
  + [["about its own axes", "XYZ"], ["about the room’s axes", "xyz"]].map(([words, letters]) =>
    `<div role="group" aria-label="quarter turns ${words}"><span class="rk-name">${words}</span>`
    + `${[...letters].flatMap((letter) => [letter, `-${letter}`]).map(pressButton).join("")}</div>`)
    .join("") + "</div>";

const toldTurns = (text) => pressesOf(text).map((press) =>
  `${press[0] === "-" ? "\u2212" : "+"}${press.slice(-1).toLowerCase()}`
  + ` ${press.slice(-1) < "a" ? "own" : "room"}`).join(", ") || "none";

const followTurns = (live) => live.all("[data-press]").forEach((button) => {
  button.addEventListener("click", () => {
    const i = Number(button.closest("[data-i]").dataset.i), began = performance.now();
    const text = live.state[i][0] + button.dataset.press;
    cancelAnimationFrame(live.turning);
    if (reducedMotion()) return live.setOne(i, [text, 1]);
    const tick = (now) => {
      if (live.state[i][0] !== text) return; // set anew meanwhile
      const part = Math.min(1, Math.max(0, now - began) / LONG);
      live.setOne(i, [text, part]);
      if (part < 1) live.turning = requestAnimationFrame(tick);
    };
    live.setOne(i, [text, 0]);
    live.turning = requestAnimationFrame(tick);
  });
});

Object.assign(part, { turnNumbers });

// A matrix in the picture: columns in their colours, between brackets.
SHAPES.bracket = ([x, y, ...entries], shape, to) => {
  const { columns, digits, kind } = shape;
  const [x0, y0] = to([x, y]), wide = 20 + 9 * digits, high = 17, half = 1.5 * wide + 6;
  const number = (value, k) => {
    const at = `x="${n(x0 + (k % 3 - 0.6) * wide)}" y="${n(y0 + (Math.floor(k / 3) - 0.7) * high)}"`;
    return `<text ${at} text-anchor="end" style="fill:${color(columns[k % 3])};font:600 13px sans-serif">`
      + `${fixed(value, digits)}</text>`;
  };
  to.taken.push([x0 - half, y0 - 1.7 * high, x0 + half, y0 + 1.7 * high]);
  const edge = (side) => `M${n(x0 + side * (half - 4))} ${n(y0 - 1.6 * high)}h${4 * side}`
    + `v${n(3.2 * high)}h${-4 * side}`;
  return `<path d="${edge(-1)}${edge(1)}" ${stroke(kind)}/>${entries.map(number).join("")}`
    + label(to, x0, y0 + 1.6 * high, shape, [0, 1]);
};
