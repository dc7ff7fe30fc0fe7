// What the page carries in itself: data as JSON, libraries as gzip in base64.

function readJson(element) {
  return JSON.parse(element.textContent);
}

function fromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const marks = atob(text);
  const bytes = new Uint8Array(marks.length);
  for (let at = 0; at < marks.length; at += 1) bytes[at] = marks.charCodeAt(at);
  return bytes;
}

function unpack(id) {
  const stream = new Blob([fromBase64(document.getElementById(id).textContent)]).stream();
  return new Response(stream.pipeThrough(new DecompressionStream("gzip"))).text();
}

function runScript(source) {
  document.head.append(element("script", {}, source));
}

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [attribute, value] of Object.entries(attributes)) made.setAttribute(attribute, value);
  made.append(...children);
  return made;
}

// The same as vpr_bench.report.foreign.shortened: a long name without its middle.
function shortened(text, most = 80) {
  const marks = [...text];
  const tail = Math.floor((most - 1) / 2);
  return marks.length <= most ? text : `${marks.slice(0, most - 1 - tail).join("")}…${marks.slice(-tail).join("")}`;
}

function choice(label, options, chosen, changed) {
  const select = element("select");
  for (const [value, text] of options) select.append(new Option(shortened(text), value, false, value === chosen));
  select.addEventListener("change", () => changed(select.value));
  return element("label", {}, `${label} `, select);
}
