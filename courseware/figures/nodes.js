// A picture as nodes, [tag, attributes, children]: written as text, or put into the page so that
// only what has changed is touched. Children are nodes, or markup that is put in as it is.

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

const createElement = ([tag, attributes, inside = []]) => {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  Object.entries(attributes).forEach((attribute) => element.setAttribute(...attribute));
  updateNodes(element, inside, []);
  return element;
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
    if (typeof nodes === "string") element.innerHTML = nodes;
    else element.replaceChildren(...nodes.map(createElement));
    return;
  }
  nodes.forEach((node, i) => {
    const old = before[i];
    if (node === old) return;
    if (!old) element.append(createElement(node));
    else if (old[0] !== node[0]) element.children[i].replaceWith(createElement(node));
    else updateElement(element.children[i], node, old);
  });
  for (let i = before.length; i > nodes.length; i--) element.lastElementChild.remove();
};
