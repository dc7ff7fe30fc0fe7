// The page comes to life: first the table that is in view, then the charts.

const toggle = document.getElementById("theme");

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  toggle.setAttribute("aria-pressed", String(theme === "dark"));
  if (globalThis.Plotly) for (const view of views.values()) if (!view.section.hidden) drawAgain(view);
}

function chosenTheme() {
  try { return localStorage.getItem("vpr-bench-theme"); } catch (refused) { return null; }
}

toggle.addEventListener("click", () => {
  const theme = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
  try { localStorage.setItem("vpr-bench-theme", theme); } catch (refused) { /* then it is not remembered */ }
  setTheme(theme);
});
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", (event) => {
  if (!chosenTheme()) setTheme(event.matches ? "dark" : "light");
});

for (const link of links) {
  link.addEventListener("click", (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    history.pushState(null, "", link.hash);
    showProtocol(askedFor());
    document.getElementById("status").textContent = `Showing ${current.section.id}`;
  });
}
window.addEventListener("popstate", () => showProtocol(askedFor()));

async function start() {
  setTheme(document.documentElement.dataset.theme);
  showProtocol(askedFor());
  const sources = ["tables", "charts"].map(unpack);
  runScript(await sources[0]);
  prepareTables();
  makeTable(current);
  runScript(await sources[1]);
  watchCharts(current);
  const first = current.section.querySelector("figure[data-chart]");
  if (first && !current.drawn.has(first)) await draw(current, first);
  performance.mark("ready");
  document.documentElement.dataset.ready = "yes";
}

if (document.documentElement.classList.contains("js")) {
  start().catch((error) => {  // whatever does not work here, the plain tables do
    document.documentElement.classList.remove("js");
    for (const view of views.values()) view.section.hidden = false;
    throw error;
  });
}
