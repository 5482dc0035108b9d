// SPDX-License-Identifier: GPL-3.0-or-later
// Small parts of pages.
export function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

export const say = (root, text) => (root.querySelector('[role=status]').textContent = text);

// Fills a table's body; keeps the rows that are there, so that a selection and the focus survive.
export function rows(body, lines) {
  while (body.rows.length > lines.length) body.deleteRow(-1);
  lines.forEach(({data, cells, bad}, i) => {
    const row = body.rows[i] ?? body.insertRow();
    for (const [key, value] of Object.entries(data)) row.dataset[key] = value;
    row.className = bad ? 'miss' : '';
    cells.forEach((text, k) => ((row.cells[k] ?? row.insertCell()).textContent = text));
  });
}
