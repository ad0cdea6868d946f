// A picture as nodes, [tag, attributes, children]: written as text; on a page only what has changed is
// touched. Children are nodes, or markup that is put in as it is.

export const renderAttributes = (attributes) => Object.entries(attributes)
  .map(([name, value]) => ` ${name}="${value}"`).join("");

export const renderNodes = (nodes) => typeof nodes === "string" ? nodes : nodes
  .map(([tag, attributes, inside = []]) => {
    const start = `<${tag}${renderAttributes(attributes)}`;
    return inside.length ? `${start}>${renderNodes(inside)}</${tag}>` : `${start}/>`;
  }).join("");

export const setAttribute = (element, name, value) => {
  if (element.getAttribute(name) !== String(value)) element.setAttribute(name, value);
};

const updateElement = (element, [, now, inside = []], [, before, were = []]) => {
  for (const name in now) if (now[name] !== before[name]) element.setAttribute(name, now[name]);
  for (const name in before) if (!(name in now)) element.removeAttribute(name);
  updateNodes(element, inside, were);
};

// Bring an element's children from the nodes that they were to the nodes that they are now.
export const updateNodes = (element, nodes, before) => {
  if (nodes === before) return;
  if (typeof nodes === "string" || typeof before === "string") {
    element.innerHTML = renderNodes(nodes);
    return;
  }
  let child = element.firstElementChild;
  before.forEach((old, i) => {
    const node = nodes[i], next = child.nextElementSibling;
    if (!node) child.remove();
    else if (node[0] !== old[0]) child.outerHTML = renderNodes([node]);
    else if (node !== old) updateElement(child, node, old);
    child = next;
  });
  if (nodes.length > before.length) element.insertAdjacentHTML("beforeend", renderNodes(nodes.slice(before.length)));
};
