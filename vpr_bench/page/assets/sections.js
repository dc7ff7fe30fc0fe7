// One protocol at a time; its table, charts and pictures are made when it is first shown.

class View {
  constructor(section) {
    this.section = section;
    this.hidden = new Set();  // methods that the charts leave out
    this.drawn = new Set();  // figures
    this.choices = {};
    this.table = null;
  }

  get data() {
    const value = readJson(this.section.querySelector("script.data"));
    Object.defineProperty(this, "data", { value });
    return value;
  }
}

const views = new Map([...document.querySelectorAll("section.protocol")].map((section) => [section.id, new View(section)]));
const links = [...document.querySelectorAll("nav.protocols a")];

function askedFor() {
  let id = "";
  try { id = decodeURIComponent(location.hash.slice(1)); } catch (damaged) { /* the first one, then */ }
  return views.get(id) ?? views.values().next().value;
}

let current = null;

function showProtocol(view) {
  current = view;
  for (const other of views.values()) other.section.hidden = other !== view;
  for (const link of links) {
    if (link.hash.slice(1) === view.section.id) link.setAttribute("aria-current", "true");
    else link.removeAttribute("aria-current");
  }
  if (globalThis.DataTable) makeTable(view);
  makeLegend(view);
  drawAgain(view);  // the theme may have changed meanwhile
  watchCharts(view);
  watchGallery(view);
}

function whenSeen(target, make) {
  const observer = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    observer.disconnect();
    make();
  }, { rootMargin: "400px" });
  observer.observe(target);
}
