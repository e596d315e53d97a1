// Tables whose columns sort.
import { element } from "./dom.js";

const collator = new Intl.Collator("en", { numeric: true });

function compare(a, b) {
  if (a === null || a === undefined) return b === null || b === undefined ? 0 : 1; // what is missing comes last
  if (b === null || b === undefined) return -1;
  return typeof a === "number" && typeof b === "number" ? a - b : collator.compare(String(a), String(b));
}

// columns: [{ title, hint, value(row), show(row), path, header }]; `show` gives text or a node. The first column is the
// row's header. rows that `fails` says something about have that in place of all cells but the first.
export function sortableTable({ caption, columns, rows, most = Infinity, fails = () => null, more = null }) {
  const body = element("tbody");
  const heads = columns.map((column, i) => {
    const button = element("button", { type: "button", title: column.hint, onclick: () => sort(i) }, column.title);
    return element("th", { scope: "col", "aria-sort": "none", class: column.wide && "wide" }, button);
  });
  const note = element("p", { class: "soft" });
  let sorted = null;
  let ascending = true;

  function cell(column, row, i) {
    const value = column.value(row);
    const shown = column.show ? column.show(row) : String(value);
    const attributes = { "data-path": column.path, "data-value": typeof value === "number" || typeof value === "boolean" ? String(value) : null };
    return i === 0 ? element("th", { scope: "row" }, shown) : element("td", { ...attributes, class: column.wide && "wide" }, shown);
  }

  function line(row) {
    const failure = fails(row);
    if (failure) return element("tr", { class: "failed" }, cell(columns[0], row, 0), element("td", { colspan: columns.length - 1 }, failure));
    return element("tr", { "data-name": row.name ?? row.id }, ...columns.map((column, i) => cell(column, row, i)));
  }

  function fill() {
    const order = [...rows];
    if (sorted !== null) {
      const { value } = columns[sorted];
      const key = (row) => (fails(row) ? null : value(row));
      order.sort((a, b) => (key(a) === null || key(b) === null ? compare(key(a), key(b)) : (ascending ? 1 : -1) * compare(key(a), key(b))));
    }
    body.replaceChildren(...order.slice(0, most).map(line));
    note.textContent = order.length > most && more ? more(most, order.length) : "";
    note.hidden = !note.textContent;
  }

  function sort(i) {
    ascending = sorted === i ? !ascending : true;
    sorted = i;
    heads.forEach((head, k) => head.setAttribute("aria-sort", k === i ? (ascending ? "ascending" : "descending") : "none"));
    fill();
  }

  fill();
  const table = element("table", {}, element("caption", {}, caption), element("thead", {}, element("tr", {}, ...heads)), body);
  const scroll = element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption }, table);
  return { node: element("div", {}, scroll, note), setRows: (next) => ((rows = next), fill()) };
}
