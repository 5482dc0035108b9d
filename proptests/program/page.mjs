// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the page of `refitlab bake --report` with a document that writes down what is drawn, and compares what the page shows with
// its data.   node page.mjs REPORT.html
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import vm from 'node:vm';

const html = readFileSync(process.argv[2], 'utf8');
const [, script] = /<script>\n([^]*)<\/script>/.exec(html);
const before = 'const data = ', start = script.indexOf(before) + before.length;
const data = JSON.parse(script.slice(start, script.indexOf(';\n', start)));

// A pen has the paths that were stroked and filled, and the texts, since the canvas was cleared.
class Pen {
  clearRect() { Object.assign(this, {strokes: [], fills: [], texts: []}); }
  beginPath() { this.path = []; }
  moveTo(x, y) { this.path.push([x, y]); }
  lineTo(x, y) { this.path.push([x, y]); }
  arc(x, y) { this.path.push([x, y]); }
  closePath() {}
  stroke() { this.strokes.push({color: this.strokeStyle, points: this.path}); }
  fill() { this.fills.push({color: this.fillStyle, points: this.path}); }
  fillText(text) { this.texts.push(text); }
}
class Part {
  constructor() { Object.assign(this, {style: {}, rows: [], cells: [], options: [], clientWidth: 800, clientHeight: 500, textContent: '', pen: new Pen(),
                                       classList: {toggle: (name, is) => (this.chosen = is)}}); }
  add(option) { this.options.push(option); }
  insertRow() { return this.rows[this.rows.push(new Part()) - 1]; }
  insertCell() { return this.cells[this.cells.push(new Part()) - 1]; }
  getContext() { return this.pen; }
}

// Returns the page as it is when it was opened by an address with this hash.
function open(hash, source = script) {
  const parts = Object.fromEntries([...html.matchAll(/ id="(\w+)"/g)].map(([, id]) => [id, new Part()])), hidden = new Part();
  let next = null;
  const page = vm.createContext({
    atob, location: {hash}, window: {}, requestAnimationFrame: step => (next = step), Option: class { constructor(text, value) { Object.assign(this, {text, value}); } },
    document: {getElementById: id => parts[id] ?? null, querySelectorAll: what => (what === '#misses tr' ? parts.misses.rows : [hidden])}});
  vm.runInContext(source, page);
  const frame = time => next(time), get = name => vm.runInContext(name, page);
  return {parts, hidden, frame, get, runs: () => next !== null};
}

const near = (a, b, by = 1e-6) => Math.abs(a - b) <= by;
// The corners that a path of edges has, and where the page puts those of a box.
const corners = points => [...new Set(points.map(p => p.map(x => x.toFixed(3)).join(' ')))].sort();
function seen({get}, box, whole) {
  const size = 0.92 * 500 / Math.hypot(whole[3] - whole[0], whole[4] - whole[1], whole[5] - whole[2]), project = get('project');
  return corners([0, 1, 2, 3, 4, 5, 6, 7].map(i => project([box[i & 1 ? 3 : 0], box[i & 2 ? 4 : 1], box[i & 4 ? 5 : 2]], size, 800, 500).slice(0, 2)));
}
// A share, as it is said: in percent, with two digits.
function is_said(text, share) {
  if (share === undefined) return text === '–';
  if (share === null) return text === '∞';
  if (share === 0) return text === '0';
  return text.endsWith(' %') && near(Number(text.slice(0, -2)) / 100, share, 0.051 * share);
}

function check_table({parts}) {
  assert.equal(parts.file.textContent, data.file);
  assert.deepEqual(parts.clip.options.map(o => o.text), data.clips.map(c => c.name));
  assert.equal(parts.misses.rows.length, data.clips.length);
  parts.misses.rows.forEach((row, i) => {
    const {name, duration, keys, rate} = data.clips[i], cells = row.cells.map(c => c.textContent);
    assert.equal(cells.length, 7);
    assert.deepEqual([cells[0], cells[1], cells[2], cells[5]], [name, duration.toFixed(2), keys?.clusters ?? '–', rate?.clusters ?? '–']);
    assert.ok(is_said(cells[3], keys?.by) && is_said(cells[6], rate?.by), `${name}: ${cells[3]} for ${keys?.by}, ${cells[6]} for ${rate?.by}`);
    assert.equal(cells[4], keys?.clusters ? keys.time.toFixed(3) + ' s' : '–');
  });
}

function check_picture(page, index) {
  const clip = data.clips[index], {view} = page.parts, worst = clip.keys?.worst ?? -1;
  page.frame(1000);
  const of = color => view.pen.strokes.filter(s => s.color === color && s.points.length === 24);
  assert.equal(of('#0072b2').length, 1);
  assert.deepEqual(corners(of('#0072b2')[0].points), seen(page, clip.box, clip.box), `${clip.name}: the box of the whole clip`);
  assert.equal(of('#d55e00').length, worst < 0 ? 0 : 1);
  assert.ok(view.pen.fills.length > 0, `${clip.name}: no triangle is seen`);
  if (worst < 0) return 0;
  const drawn = of('#d55e00')[0].points;
  assert.deepEqual(corners(drawn), seen(page, clip.boxes[worst], clip.box), `${clip.name}: the box of the cluster`);
  // The triangles of that cluster are in its box, and no others are coloured.
  const coloured = view.pen.fills.filter(f => f.color.endsWith(',40)')), [xs, ys] = [0, 1].map(i => drawn.map(p => p[i]));
  for (const [x, y] of coloured.flatMap(f => f.points))
    assert.ok(x > Math.min(...xs) - 0.1 && x < Math.max(...xs) + 0.1 && y > Math.min(...ys) - 0.1 && y < Math.max(...ys) + 0.1, `${clip.name}: a triangle is outside of its box`);
  return coloured.length;
}

function check_chart({parts}, index) {
  const {name, chart, keys} = data.clips[index], title = parts.chart_title.textContent;
  if (!chart) return assert.ok(title.startsWith(keys ? 'No cluster of this clip' : 'No clusters were baked'));
  assert.ok(title.includes(name) && title.includes('xyz'[chart.axis]) && title.includes(chart.low ? 'least' : 'greatest'));
  // y is downward. The curve is on the bound's side of the keys' box somewhere, and within the bound everywhere.
  const height = color => parts.chart.pen.strokes.find(s => s.color === color).points.map(p => p[1]), sign = chart.low ? -1 : 1;
  const curve = height('#d55e00').map(y => -sign * y), keys_at = -sign * height('#999')[0], bound = -sign * height('#0072b2')[0];
  assert.equal(curve.length, chart.curve.length);
  assert.ok(Math.max(...curve) > keys_at && Math.max(...curve) <= bound + 1e-6, `${name}: the chart`);
  assert.equal(parts.chart.pen.fills.length, chart.keys.length);
  assert.equal(parts.chart.pen.texts.length, 6);
}

let coloured = 0;
const page = open('');
check_table(page);
for (let i = 0; i < data.clips.length; ++i) {
  page.parts.misses.rows[i].onclick();
  assert.deepEqual(page.parts.misses.rows.map(r => r.chosen), data.clips.map((_, k) => k === i));
  coloured += check_picture(page, i);
  check_chart(page, i);
}
assert.ok(coloured > 0 || data.clips.every(c => !(c.keys?.worst >= 0)), 'no triangle of any worst cluster is seen');

// Keys turn the picture, and an address opens a clip at a time, or the first if there is no such clip.
const [turn, tilt] = [page.get('turn'), page.get('tilt')];
for (const key of ['ArrowRight', 'ArrowUp', 'x']) page.parts.view.onkeydown({key, preventDefault() {}});
assert.ok(page.get('turn') > turn && page.get('tilt') < tilt);
const last = data.clips.length - 1;
for (const [hash, clip, share] of [[`#${last},0.25`, last, 0.25], ['#99,7', 0, 1], ['#0,-3', 0, 0], ['#x,y', 0, 0]]) {
  const other = open(hash);
  assert.deepEqual([other.parts.clip.value, other.get('share'), other.get('playing')], [clip, share, false], hash);
  check_picture(other, clip);
  assert.equal(other.parts.seconds.textContent, `${(share * data.clips[clip].duration).toFixed(2)} s of ${data.clips[clip].duration.toFixed(2)}`);
}

// A file without clips has a page that says so, and no pictures.
const {clips, ...rest} = data;
const still = open('', script.slice(0, start) + JSON.stringify(rest) + script.slice(script.indexOf(';\n', start)));
assert.ok(still.parts.what.textContent.includes(' 0 clips') && still.parts.what.textContent.endsWith('The file has no animation that could be shown.'));
assert.ok(still.hidden.style.display === 'none' && !still.runs());
console.log(`${process.argv[2]}: the page shows its ${clips.length} clips, ${coloured} triangles of worst clusters and their boxes`);
