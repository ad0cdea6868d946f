// Shows the content of a widget by its part's `inNotebook`. The part's script and style come once
// for all widgets of the part, in a model of their own; a kernel has its own, so several notebooks
// in one window do not meet.

const value = async (code) => {
  const address = URL.createObjectURL(
    new Blob([`export default ${code};`], { type: "text/javascript" }));
  try {
    return (await import(address)).default;
  } finally {
    URL.revokeObjectURL(address);
  }
};

const dress = (id, rules) => {
  const style = document.getElementById(id) ?? document.createElement("style");
  if (style.textContent === rules) return;
  Object.assign(style, { id, textContent: rules });
  document.head.append(style);
};

export default {
  async render({ model, el }) {
    const runtime = await model.widget_manager.get_model(model.get("runtime"));
    runtime.part ??= value(runtime.get("script"));
    dress(`workshop-${runtime.get("name")}`, runtime.get("rules"));
    const [part, content] = await Promise.all([runtime.part, value(model.get("content"))]);
    return part.inNotebook(content, { model, el });
  },
};
