
"use strict";
(() => {
  const table = document.querySelector("table.cases");
  const form = document.getElementById("filters");
  const count = document.getElementById("count");
  if (!table || !form) return;
  const cases = [...table.tBodies].map((body, place) => ({ body, place, text: body.textContent.toLowerCase() }));

  // Filters.
  const wanted = (field, has) => form.elements[field].value === "" || has(form.elements[field].value);
  const filter = () => {
    const words = form.elements.text.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const { body, text } of cases) {
      const { verdict, generator, concerns } = body.dataset;
      const is = words.every((word) => text.includes(word)) && wanted("verdict", (v) => v === verdict) &&
        wanted("generator", (g) => g === generator) && wanted("concerns", (o) => concerns.split(" ").includes(o));
      body.hidden = !is;
      shown += is;
    }
    count.textContent = shown === cases.length ? `${shown} cases` : `${shown} of ${cases.length} cases`;
  };
  form.addEventListener("input", filter);
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("reset", () => setTimeout(filter));
  form.elements.unfold.addEventListener("click", () => {
    const all = cases.filter(({ body }) => !body.hidden).flatMap(({ body }) => [...body.querySelectorAll("details")]);
    const open = all.some((one) => !one.open);
    all.forEach((one) => { one.open = open; });
    form.elements.unfold.textContent = open ? "fold all" : "unfold all";
  });

  // Sorting: up, down, and back to the order of the run.
  const heads = [...table.tHead.rows[0].cells];
  const value = (body, column, isNumber) => {
    const cell = body.rows[0].cells[column];
    const said = cell.dataset.value ?? cell.textContent.trim();
    return isNumber ? (said === "" ? NaN : Number(said)) : said;
  };
  const compare = (one, other, isNumber) => {
    if (!isNumber) return one.localeCompare(other, "en", { numeric: true });
    if (Number.isNaN(one) || Number.isNaN(other)) return Number.isNaN(one) - Number.isNaN(other);
    return one - other;
  };
  heads.forEach((head, column) => head.querySelector("button").addEventListener("click", () => {
    const next = { none: "ascending", ascending: "descending", descending: "none" }[head.getAttribute("aria-sort")];
    heads.forEach((other) => other.setAttribute("aria-sort", other === head ? next : "none"));
    const isNumber = head.dataset.sorts === "number";
    const sign = next === "descending" ? -1 : 1;
    const keyed = cases.map((one) => ({ ...one, key: value(one.body, column, isNumber) }));
    const missing = (key) => Number.isNaN(key) || key === "";
    if (next !== "none") {
      keyed.sort((one, other) => missing(one.key) - missing(other.key) ||
        (missing(one.key) ? 0 : sign * compare(one.key, other.key, isNumber)) || one.place - other.place);
    }
    table.append(...keyed.map(({ body }) => body));
  }));

  // A link to a case shows it, whatever is filtered, and unfolds it.
  const open = () => {
    const target = location.hash.startsWith("#case-") && document.getElementById(location.hash.slice(1));
    if (!target) return;
    if (target.hidden) { form.reset(); filter(); target.hidden = false; }
    target.querySelectorAll("details").forEach((one) => { one.open = true; });
    target.scrollIntoView({ block: "start" });
  };
  addEventListener("hashchange", open);
  form.hidden = false;
  filter();
  open();
})();
