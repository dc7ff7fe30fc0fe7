// Pictures of what a method got wrong and right; a card opens them large, with the arrow keys going on.

const viewer = document.getElementById("viewer");
const GROUPS = [
  ["failures", "Most confident failures", "Wrong, and sure of it: the highest scores come first."],
  ["successes", "Least confident successes", "Right, with the lowest scores."],
];

let pictures = null;

function picture(panel) {
  pictures ??= readJson(document.getElementById("pictures"));
  const found = pictures[panel.picture];
  if (!found) return element("span", { class: "no-picture" }, panel.name ? "picture not here" : "none");
  const [width, height, content] = found;
  const image = element("img", { alt: `${panel.title}: ${panel.name}`, width, height, decoding: "async" });
  image.src = `data:image/webp;base64,${content}`;
  if (width < 100) image.className = "small";
  return image;
}

function panelOf(panel, right) {
  const mark = panel.title !== "Answer" ? "" : right ? " right" : " wrong";
  const title = mark ? `${panel.title}:${mark}` : panel.title;
  return element("span", { class: `panel${mark}` },
    element("span", { class: "title" }, title),
    picture(panel),
    element("bdi", { class: "file" }, ...panel.name.split(/(?<=\/)/).flatMap((part) => [part, element("wbr")])),
    element("span", { class: "said" }, panel.note));
}

function watchGallery(view) {
  const gallery = view.section.querySelector(".gallery");
  if (!gallery || gallery.dataset.watched) return;
  gallery.dataset.watched = "yes";
  const methods = view.data.methods;
  const options = methods.map((one, number) => [String(number), one.name]);
  gallery.querySelector(".choices").append(choice("method", options, "0", (number) => fill(view, methods[number])));
  whenSeen(gallery, () => fill(view, methods[0]));
}

function fill(view, method) {
  const place = view.section.querySelector(".examples");
  const items = [];
  place.replaceChildren();
  if (!view.data.pictures) {
    place.append(element("p", { class: "note" }, "The images are not on the computer that wrote this page: only names are shown."));
  }
  for (const [name, title, about] of GROUPS) {
    const found = method.gallery[name];
    const cards = element("div", { class: "cards" });
    for (const [number, panels] of found.entries()) {
      const right = name === "successes";
      const item = { panels, right, title: `${shortened(method.name)}: ${right ? "success" : "failure"} ${number + 1} of ${found.length}` };
      item.card = element("button", { type: "button", class: "card", "aria-haspopup": "dialog" },
        ...panels.map((panel) => panelOf(panel, right)));
      const at = items.push(item) - 1;
      item.card.addEventListener("click", () => open(items, at));
      cards.append(item.card);
    }
    place.append(element("h4", {}, title), element("p", { class: "quiet" }, found.length ? about : "None."), cards);
  }
}

let shown = [], position = 0;

function open(items, at) {
  shown = items;
  turn(at);
  viewer.showModal();
}

function turn(at) {
  position = (at + shown.length) % shown.length;
  const item = shown[position];
  viewer.querySelector("h2").textContent = item.title;
  viewer.querySelector(".panels").replaceChildren(...item.panels.map((panel) => panelOf(panel, item.right)));
  viewer.querySelector(".position").textContent = `${position + 1} of ${shown.length}`;
}

viewer.querySelector(".before").addEventListener("click", () => turn(position - 1));
viewer.querySelector(".after").addEventListener("click", () => turn(position + 1));
viewer.querySelector(".close").addEventListener("click", () => viewer.close());
viewer.addEventListener("click", (event) => { if (event.target === viewer) viewer.close(); });
viewer.addEventListener("close", () => shown[position].card.focus());
viewer.addEventListener("keydown", (event) => {
  if (event.key === "ArrowLeft") turn(position - 1);
  if (event.key === "ArrowRight") turn(position + 1);
});
