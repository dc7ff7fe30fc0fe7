// Sorting and filtering of the ranked tables; rows of different kinds stay apart, and blanks come last.

const RANK = 1, METHOD = 2, FIRST_METRIC = 3, FIRST_TIME = 8, MACHINE = 10;

function blanksLast(direction) {
  return (one, other) => {
    if (one === null || other === null) return (one === null) - (other === null);
    return direction * (one < other ? -1 : one > other ? 1 : 0);
  };
}

function makeTable(view) {
  if (view.table) return;
  const table = view.section.querySelector("table.ranking");
  view.table = new DataTable(table, {
    paging: false,
    info: false,
    autoWidth: false,
    layout: { topStart: null, topEnd: null, bottomStart: null, bottomEnd: null },
    order: [[RANK, "asc"]],
    orderFixed: { pre: [[0, "asc"]] },
    language: { zeroRecords: "No row matches." },
    columnDefs: [
      { targets: 0, visible: false, searchable: false },
      { targets: METHOD, type: "filled-text", orderSequence: ["asc", "desc"] },
      { targets: MACHINE, type: "filled-text", orderSequence: ["asc", "desc"] },
      { targets: [RANK, FIRST_TIME, FIRST_TIME + 1], type: "filled-number", orderSequence: ["asc", "desc"] },
      {
        targets: [...Array(FIRST_TIME - FIRST_METRIC).keys()].map((number) => number + FIRST_METRIC),
        type: "filled-number",
        orderSequence: ["desc", "asc"],
      },
    ],
  });
  view.table.on("draw", () => sayOrder(view.table));
  sayOrder(view.table);
  makeFilters(view);
}

// DataTables says how the first column is sorted that it sorts by, which is the hidden one that keeps rows apart.
function sayOrder(table) {
  const [[column, direction]] = table.order();
  for (const [number, head] of table.columns().header().toArray().entries()) {
    if (number === column) head.setAttribute("aria-sort", `${direction}ending`);
    else head.removeAttribute("aria-sort");
  }
}

function makeFilters(view) {
  const filters = view.section.querySelector(".filters");
  const count = filters.querySelector(".count");
  const all = view.table.rows().count();
  view.table.on("draw", () => {
    const shown = view.table.rows({ search: "applied" }).count();
    count.textContent = shown === all ? "" : `${shown} of ${all} rows`;
  });
  filters.querySelector("input").addEventListener("input", (event) => {
    const wanted = event.target.value.trim().toLowerCase();
    view.table.search.fixed("method", (text, data, index) => !wanted || methodOf(view, index).includes(wanted)).draw();
  });
  for (const select of filters.querySelectorAll("select")) {
    const what = select.dataset.filter;
    select.addEventListener("change", () => {
      const matches = (text, data, index) => !select.value || rowOf(view, index).dataset[what] === select.value;
      view.table.search.fixed(what, matches).draw();
    });
  }
}

function rowOf(view, index) {
  return view.table.row(index).node();
}

function methodOf(view, index) {
  const cell = rowOf(view, index).querySelector("th");  // the whole name, and what is said of it
  return `${cell.dataset.order} ${cell.textContent}`.toLowerCase();
}

function prepareTables() {
  const orders = { asc: blanksLast(1), desc: blanksLast(-1) };
  const filled = (convert) => ({ pre: (value) => (value === "" || value === null ? null : convert(value)), ...orders });
  DataTable.type("filled-number", "order", filled(Number));
  DataTable.type("filled-text", "order", filled((value) => String(value).toLowerCase()));
}
