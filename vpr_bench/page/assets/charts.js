// The charts of a protocol, each drawn when it comes into view, and again when a choice or the theme changes.

const LONGEST = 44;  // characters of a name beside a pointer

// Plotly takes tags and entities in what it writes for its own: nothing of a method's name must be one.
function plain(text) {
  return shortened(text, LONGEST).replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
}

function colours() {
  const style = getComputedStyle(document.documentElement);
  return (name) => style.getPropertyValue(`--${name}`).trim();
}

function layout(colour, x, y, more = {}) {
  const axis = {
    gridcolor: colour("hairline"), linecolor: colour("quiet"), zeroline: false, tickcolor: colour("quiet"),
    automargin: true, fixedrange: !matchMedia("(pointer: fine)").matches, ticks: "outside", ticklen: 4,
  };
  const font = { family: "system-ui, sans-serif", size: 12, color: colour("ink") };
  return {
    autosize: true, showlegend: false, dragmode: matchMedia("(pointer: fine)").matches ? "zoom" : false,
    paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
    font,
    margin: { l: 46, r: 14, t: 10, b: 42 }, hovermode: "closest",
    hoverlabel: { bgcolor: colour("paper"), bordercolor: colour("quiet"), align: "left", font: { ...font } },
    xaxis: { ...axis, ...x, title: { text: x.title, standoff: 8 } },
    yaxis: { ...axis, ...y, title: { text: y.title, standoff: 6 } },
    ...more,
  };
}

function visible(view) {
  return view.data.methods.filter((one) => !view.hidden.has(one.method));
}

function lineOf(view, colour, one, x, y, hover, more = {}) {
  const look = view.data.looks[one.method];
  const drawn = colour(`method-${look.colour}`);
  return {
    x, y, hovertext: hover, hoverinfo: "text", mode: "lines+markers", name: plain(one.name), meta: one.name,
    line: { color: drawn, width: 2, dash: DASHES[look.dash] },
    marker: { color: drawn, symbol: MARKERS[look.marker], size: 7, maxdisplayed: 7 },
    ...more,
  };
}

const SHARE = { range: [0, 1.02], tickformat: ".1f", dtick: 0.2 };

// Axes stay where they are, whatever methods are shown.
function from0(highest) {
  return { range: [-0.03 * highest, 1.03 * highest] };
}

function logarithmic(values) {
  const powers = values.filter((value) => value > 0).map(Math.log10);
  return { type: "log", tickformat: "~g", dtick: "D2", range: [Math.min(...powers) - 0.2, Math.max(...powers) + 0.2] };
}

const told = (value) => (value === null ? "–" : value.toFixed(3));
const within = (view, radius) => (view.data.unit ? `radius ${radius} (${view.data.unit})` : "");

const CHARTS = {
  curves(view, colour) {
    const radius = Number(view.choices.radius ?? view.data.radius);
    const traces = visible(view).map((one) => {
      const [recall, precision] = one.curves[one.radii.indexOf(radius)];
      const hover = recall.map((value, number) =>
        `<b>${plain(one.name)}</b><br>recall ${told(value)}<br>precision ${told(precision[number])}`);
      return lineOf(view, colour, one, recall, precision, hover);
    });
    return [traces, layout(colour, { title: "recall", ...SHARE }, { title: "precision", ...SHARE })];
  },

  radius(view, colour) {
    const metric = view.choices.metric ?? "recall@1";
    const traces = visible(view).map((one) => {
      const hover = one[metric].map((value, number) =>
        `<b>${plain(one.name)}</b><br>${within(view, one.radii[number])}<br>${metric} ${told(value)}`);
      return lineOf(view, colour, one, one.radii, one[metric], hover);
    });
    const x = { title: `radius (${view.data.unit})`, ...from0(Math.max(...view.data.methods[0].radii)) };
    const own = {
      type: "line", xref: "x", yref: "paper", x0: view.data.radius, x1: view.data.radius, y0: 0, y1: 1,
      line: { color: colour("quiet"), width: 1, dash: "dot" }, layer: "below",
    };
    return [traces, layout(colour, x, { title: metric, ...SHARE }, { shapes: [own] })];
  },

  recalls(view, colour) {
    const traces = visible(view).map((one) => {
      const depth = one.recalls.map((value, number) => number + 1);
      const hover = one.recalls.map((value, number) =>
        `<b>${plain(one.name)}</b><br>recall@${number + 1} ${told(value)}`);
      return lineOf(view, colour, one, depth, one.recalls, hover);
    });
    const deepest = Math.max(...view.data.methods.map((one) => one.recalls.length));
    return [traces, layout(colour, { title: "k", ...from0(deepest) }, { title: "recall@k", ...SHARE })];
  },

  latency(view, colour) {
    const plot = view.data.scatters.find((one) => one.machine === view.choices.machine) ?? view.data.scatters[0];
    const points = plot.points.filter((one) => !view.hidden.has(one.method));
    const front = points.filter((one) => one.front);
    const traces = points.map((one) => {
      const look = view.data.looks[one.method];
      const drawn = colour(`method-${look.colour}`);
      const bars = { type: "data", symmetric: false, array: [one.high - one.recall], arrayminus: [one.recall - one.low] };
      return {
        x: [one.ms], y: [one.recall], mode: "markers", name: plain(one.method), hoverinfo: "text",
        error_y: { ...bars, color: drawn, thickness: 1.2, width: 4 },
        marker: { color: drawn, symbol: MARKERS[look.marker], size: 11, line: { color: colour("paper"), width: 1 } },
        hovertext: [`<b>${plain(one.method)}</b><br>recall@1 ${told(one.recall)} (${told(one.low)}–${told(one.high)})`
          + `<br>${one.ms.toPrecision(3)} ms on ${plot.machine}${one.front ? "<br>on the front" : ""}`],
      };
    });
    traces.unshift({
      x: front.map((one) => one.ms), y: front.map((one) => one.recall), mode: "lines", hoverinfo: "skip",
      line: { color: colour("quiet"), width: 1.5, dash: "dot", shape: "hv" },
    });
    const x = { title: `median ms per query, machine ${plot.machine}`, ...logarithmic(plot.points.map((one) => one.ms)) };
    return [traces, layout(colour, x, { title: "recall@1", ...SHARE })];
  },

  losses(view, colour) {
    const noted = visible(view).filter((one) => one.steps.length).reverse();
    const names = [...new Set(noted.flatMap((one) => one.steps.map(([name]) => name)))].reverse();
    const parts = [["found (recall@1)", (one) => one.steps.at(-1)[2]],
      ...names.map((name) => [`lost by ${name}`, (one) => one.steps.find(([step]) => step === name)?.[1] ?? 0])];
    const shapes = ["", "/", "x", ".", "-", "+"];
    const traces = parts.map(([name, value], number) => ({
      type: "bar", orientation: "h", y: noted.map((one, place) => place), x: noted.map((one) => 100 * value(one)),
      name: plain(name), hoverinfo: "text", width: 0.5,
      text: noted.map((one) => (value(one) >= 0.06 ? (100 * value(one)).toFixed(1) : "")),
      textposition: "inside", insidetextanchor: "middle", textangle: 0, textfont: { color: number ? colour("bar-ink") : "#ffffff" },
      hovertext: noted.map((one) => `<b>${plain(one.name)}</b><br>${plain(name)}: ${(100 * value(one)).toFixed(1)} %`),
      marker: {
        color: colour(`bar-${Math.min(number, 5)}`), line: { color: colour("paper"), width: 1 },
        pattern: { fillmode: "overlay", shape: shapes[number % shapes.length], size: 7, solidity: 0.12, fgcolor: colour("bar-ink") },
      },
    }));
    const annotations = noted.map((one, place) => ({
      x: 0, y: place + 0.28, xref: "x", yref: "y", xanchor: "left", yanchor: "bottom", showarrow: false,
      text: plain(one.name), font: { size: 12 },
    }));
    const more = {
      annotations, barmode: "stack", showlegend: true, margin: { l: 10, r: 14, t: 10, b: 42 },
      legend: { orientation: "h", y: -0.25, yanchor: "top", x: 0, traceorder: "normal" },
    };
    return [traces, layout(colour, { title: "% of the queries", range: [0, 100] },
      { title: "", visible: false, range: [-0.5, noted.length - 0.3] }, more)];
  },
};

const CHOICES = {
  curves: (view) => ["radius", view.data.unit ? `radius in ${view.data.unit}` : "",
    (view.data.methods[0]?.radii ?? []).map((one) => [String(one), String(one)]), String(view.data.radius)],
  radius: () => ["metric", "metric", [["recall@1", "recall@1"], ["pr_auc", "pr_auc"]], "recall@1"],
  latency: (view) => ["machine", "machine",
    view.data.scatters.map((one) => [one.machine, one.machine]), view.data.scatters[0]?.machine],
};

function draw(view, figure) {
  const [traces, shape] = CHARTS[figure.dataset.chart](view, colours());
  view.drawn.add(figure);
  figure.querySelector(".alike").textContent = alike(traces);
  return Plotly.react(figure.querySelector(".canvas"), traces, shape, { displayModeBar: false, responsive: true });
}

// Of lines that are the same all through, only the last one can be seen.
function alike(traces) {
  const names = new Map();
  for (const one of traces.filter((trace) => trace.meta)) {
    const line = JSON.stringify([one.x, one.y]);
    names.set(line, [...(names.get(line) ?? []), shortened(one.meta)]);
  }
  const several = [...names.values()].filter((group) => group.length > 1);
  const list = new Intl.ListFormat("en-GB");
  return several.map((group) => `One line for ${list.format(group)}.`).join(" ");
}

function drawAgain(view) {
  for (const figure of view.drawn) draw(view, figure);
}

function watchCharts(view) {
  for (const figure of view.section.querySelectorAll("figure[data-chart]")) {
    if (!globalThis.Plotly || figure.dataset.watched) continue;
    figure.dataset.watched = "yes";
    makeChoices(view, figure);
    whenSeen(figure, () => draw(view, figure));
  }
}

function makeChoices(view, figure) {
  const place = figure.querySelector(".choices");
  const [what, label, options, chosen] = CHOICES[figure.dataset.chart]?.(view) ?? ["", "", []];
  if (options.length < 2) return place.remove();
  return place.append(choice(label, options, chosen, (value) => {
    view.choices[what] = value;
    draw(view, figure);
  }));
}
