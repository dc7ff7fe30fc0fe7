// One legend for all charts of a protocol: a button per method, which hides it and shows it again.

const DASHES = ["solid", "dash", "dot", "dashdot"];
const STROKES = ["none", "6 3", "1.5 3", "7 3 1.5 3"];
const MARKERS = ["circle", "square", "diamond", "triangle-up", "triangle-down", "cross", "x", "star"];
const GLYPHS = ["●", "■", "◆", "▲", "▼", "✚", "✖", "★"];

function makeLegend(view) {
  const legend = view.section.querySelector(".methods");
  if (!legend || legend.childElementCount) return;
  for (const [method, look] of Object.entries(view.data.looks)) {
    const named = view.data.methods.some((one) => one.method === method)
      || view.data.scatters.some((plot) => plot.points.some((point) => point.method === method));
    if (named) legend.append(legendButton(view, method, look));
  }
}

function legendButton(view, method, look) {
  const button = element("button", { type: "button", "aria-pressed": "true", title: method }, swatch(look),
    element("bdi", {}, shortened(method)));
  button.addEventListener("click", () => {
    const hide = !view.hidden.has(method);
    if (hide) view.hidden.add(method);
    else view.hidden.delete(method);
    button.setAttribute("aria-pressed", String(!hide));
    drawAgain(view);
  });
  return button;
}

function swatch(look) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  const line = document.createElementNS(svg.namespaceURI, "line");
  const glyph = document.createElementNS(svg.namespaceURI, "text");
  for (const [name, value] of Object.entries({ viewBox: "0 0 34 14", width: 34, height: 14, "aria-hidden": "true" })) {
    svg.setAttribute(name, value);
  }
  const colour = `var(--method-${look.colour})`;
  line.style.cssText = `stroke:${colour};stroke-width:2;stroke-dasharray:${STROKES[look.dash]}`;
  for (const [name, value] of Object.entries({ x1: 0, x2: 34, y1: 7, y2: 7 })) line.setAttribute(name, value);
  for (const [name, value] of Object.entries({ x: 17, y: 11, "text-anchor": "middle", "font-size": 11 })) {
    glyph.setAttribute(name, value);
  }
  glyph.style.fill = colour;
  glyph.textContent = GLYPHS[look.marker];
  svg.append(line, glyph);
  return svg;
}
