// The editor of a cell: CodeMirror, in the colours of the page. Tab indents; Escape, then Tab, leaves.

const KINDS = { // of a word: the class that Pygments gives it
  keyword: "k", bool: "kc", null: "kc", string: "s1", number: "mi", comment: "c1", operator: "o", className: "nc",
};

const LOOK = {
  "&": { borderRadius: "5px" },
  "&.cm-focused": { outline: "3px solid var(--rk-accent)", outlineOffset: "-3px" },
  ".cm-content": { padding: "1rem 0" }, // as the code that it stands for
  ".cm-scroller": { font: ".875rem/1.3 var(--pst-font-family-monospace, monospace)" },
  ".cm-gutters": { background: "none", color: "inherit", border: 0, opacity: .5 },
  ".cm-cursor": { borderColor: "currentcolor" },
};

// parts: the vendored CodeMirror. onRun: what Shift and Enter do.
export const createEditor = (parts, { parent, text, label, onChange, onRun }) => {
  const { EditorView, keymap, tags, python } = parts;
  const classes = Object.entries(KINDS).map(([tag, name]) => ({ tag: tags[tag], class: name }));
  const run = () => { onRun(); return true; };
  const view = new EditorView({
    parent,
    doc: text,
    extensions: [
      keymap.of([{ key: "Shift-Enter", run }, { key: "Ctrl-Enter", run }]),
      parts.history(), parts.drawSelection(), parts.lineNumbers(), parts.indentOnInput(),
      parts.bracketMatching(), parts.indentUnit.of("    "),
      parts.StreamLanguage.define(python),
      parts.syntaxHighlighting(parts.tagHighlighter(classes)),
      keymap.of([...parts.defaultKeymap, ...parts.historyKeymap, parts.indentWithTab]),
      EditorView.lineWrapping,
      EditorView.theme(LOOK),
      EditorView.contentAttributes.of({ "aria-label": label, spellcheck: "false", autocapitalize: "off" }),
      EditorView.updateListener.of(({ docChanged }) => { if (docChanged) onChange(); }),
    ],
  });
  return {
    get text() { return view.state.doc.toString(); },
    set text(value) { view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: value } }); },
    focus(point) {
      view.focus();
      const place = point && view.posAtCoords(point);
      if (place) view.dispatch({ selection: { anchor: place } });
    },
  };
};
