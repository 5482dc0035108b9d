// SPDX-License-Identifier: GPL-3.0-or-later
// Drives the report's explorer in a headless browser and compares what it shows with what the library says.
//   node drive.mjs PAGE.html NUMBERS_PROGRAM FOLDER_FOR_PICTURES
import {spawnSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {chromium} from 'playwright-core';

const [page_file, numbers_program, folder] = process.argv.slice(2);
let failures = 0;
const check = (ok, text) => {
  console.log(`${ok ? 'ok  ' : 'FAIL'} ${text}`);
  if (!ok) ++failures;
};
// The models that stand in the page, as files for the library.
const packed = (/<script type="text\/plain" id="explorer-models">([^<]*)/.exec(readFileSync(page_file, 'utf8'))?.[1].trim().split('\n') ?? []).map((line, i) => {
  const file = `${folder}/model_${i}.cbor`;
  writeFileSync(file, Buffer.from(line, 'base64'));
  return file;
});
const library = questions => {
  const run = spawnSync(numbers_program, packed, {input: JSON.stringify(questions), encoding: 'utf8', maxBuffer: 1 << 26});
  if (run.status !== 0) throw new Error(`${numbers_program}: ${run.stderr}`);
  return JSON.parse(run.stdout);
};
// Equal but for rounding; sines of another machine's library differ in the last digit.
const close = (a, b) => a === b || Math.abs(a - b) <= 1e-9 * Math.max(1, Math.abs(a), Math.abs(b));
const same = (a, b) => a && b && typeof a === 'object' ? Object.keys(b).every(k => same(a[k], b[k])) && Object.keys(a).length === Object.keys(b).length
                                                       : typeof a === 'number' ? close(a, b) : a === b;

const browser = await chromium.launch({executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
                                       args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist']});
const errors = [];
async function open(width, height, colorScheme) {
  const page = await browser.newPage({viewport: {width, height}, colorScheme});
  page.setDefaultTimeout(180000);
  page.on('console', m => m.type() === 'error' && errors.push(m.text()));
  page.on('pageerror', e => errors.push(e.message));
  page.on('request', r => /^(file|data|blob):/.test(r.url()) || errors.push(`asked the network for ${r.url()}`));
  await page.goto(`file://${page_file}`);
  await page.locator('#explorer').scrollIntoViewIfNeeded();
  await page.waitForFunction(() => window.refitlabExplorer?.character.view);
  return page;
}

const page = await open(1200, 900, 'light');
const control = name => page.locator(`#explorer [name=${name}]`);
const slide = (locator, value) => locator.evaluate((input, v) => {
  input.value = v;
  input.dispatchEvent(new Event('input', {bubbles: true}));
}, value);
// What the page sends, where it draws the joints, and what stands in the chosen row of its table and below, as text.
const shown = () => page.evaluate(() => {
  const {settings, character, view} = window.refitlabExplorer.character;
  const row = document.querySelector('#explorer tr[data-chosen=true]');
  return {settings: {...settings, joint: character.joints.indexOf(settings.joint), twist: settings.twist * (Math.PI / 180)},
          cells: [...row.cells].map(c => c.textContent), joints: view.joints, optimal: document.querySelector('#explorer .optimal').textContent};
});

const steps = [];
const step = async name => steps.push({name, ...await shown()});
await step('as it opens');
for (const variant of ['spherical_printed', 'spherical_repaired', 'spherical_miniball', 'control_mixed', 'control_many_pieces', 'linear']) {
  await control('variant').selectOption(variant);
  await step(variant);
}
await control('variant').selectOption('spherical_printed_signed');
await slide(control('level'), 12);
await slide(control('ball'), 3);
await step('another level and ball');
await control('clip').selectOption('walk');
await slide(control('time'), 0.3);
// The printed algorithm's numbers hang on the last bits of a pose: 1e-13 seconds later, 13 more balls are undefined. The page has other
// last bits than the library, so what both say of a pose that is computed is compared for the repaired algorithm.
await control('variant').selectOption('spherical_repaired');
await step('a walk');
await control('variant').selectOption('spherical_printed_signed');
// Whoever starts it again before the next frame sees it at its own speed.
const shows = await page.evaluate(() => new Promise(done => {
  const {character} = window.refitlabExplorer, button = document.querySelector('#explorer [name=play]'), frames = 10;
  let shown = 0, seen = 0;
  for (let i = 0; i < 3; ++i) button.click();
  character.show = () => (++shown, Object.getPrototypeOf(character).show.call(character));
  const frame = () => ++seen < frames ? requestAnimationFrame(frame) : (delete character.show, button.click(), done(shown / frames));
  requestAnimationFrame(frame);
}));
check(0 < shows && shows < 1.5, `a clip that was stopped and started again is shown ${shows} times a frame`);
await control('clip').selectOption('');

// A drag of the twisted joint, by the mouse. The picture may be scrolled, so the joint is asked for where it is.
await slide(control('twist'), 0);
await page.locator('#explorer .character canvas').scrollIntoViewIfNeeded();
const grip = await page.evaluate(() => {
  const {stage, view, character, settings} = window.refitlabExplorer.character;
  const p = stage.camera.position.clone().set(...view.joints[character.joints.indexOf(settings.joint)]).project(stage.camera);
  const box = stage.canvas.getBoundingClientRect();
  return {x: box.left + (p.x + 1) / 2 * box.width, y: box.top + (1 - p.y) / 2 * box.height};
});
await page.mouse.move(grip.x, grip.y);
await page.mouse.down();
await page.mouse.move(grip.x + 60, grip.y, {steps: 2});
await page.mouse.move(grip.x + 165, grip.y, {steps: 2});
await page.mouse.up();
await step('a drag of the joint');
check(Math.abs(steps.at(-1).settings.twist * 180 / Math.PI - 165) < 2, `the drag of 165 points twists by ${(steps.at(-1).settings.twist * 180 / Math.PI).toFixed(0)} degrees`);
await control('variant').selectOption('spherical_repaired');
await step('the same, repaired');
await control('model').selectOption('snake');
await page.waitForFunction(() => window.refitlabExplorer.character.settings.model === 'snake');
await step('another model');
check(await page.evaluate(() => window.refitlabExplorer.character.settings.level <= window.refitlabExplorer.character.character.levels),
      'the level is one that the model has');
check(await page.evaluate(() => [...document.querySelectorAll('#explorer canvas')].every(c => getComputedStyle(c).touchAction === 'pan-y')),
      'a finger scrolls past the pictures');
const models = await page.evaluate(() => window.refitlabExplorer.geometry.catalog.models);
check(models.length === 3 + packed.length, `models to choose from: ${models.join(', ')}`);
for (const model of models.slice(3)) {
  await control('model').selectOption(model);
  await page.waitForFunction(name => window.refitlabExplorer.character.settings.model === name, model);
  const [near, distance, far] = await page.evaluate(() => (({camera, controls}) =>
      [camera.near, camera.position.distanceTo(controls.target), camera.far])(window.refitlabExplorer.character.stage));
  check(100 * near < distance && 10 * distance < far, `${model}: the camera, ${distance.toPrecision(3)} away, sees from ${near.toPrecision(3)} to ${far.toPrecision(3)}`);
  const clips = await page.evaluate(() => window.refitlabExplorer.character.character.clips);
  if (clips.length) await control('clip').selectOption(clips[0].name), await slide(control('time'), 0.4 * clips[0].duration);
  await step(model);
}

const answers = library(steps.map(s => s.settings));
steps.forEach(({name, settings, cells, joints, optimal}, i) => {
  const a = answers[i], number = text => Number(text.replace(/[✓✗ ]/g, ''));
  check(number(cells[1]) === a.vertices_outside && number(cells[2]) === a.undefined && cells[4] === a.mean_radius.toPrecision(4) &&
            cells[3] === (a.worst_miss ? a.worst_miss.toPrecision(3) : '0') && cells[5] === a.mean_over_optimal.toFixed(3) && cells[6] === (a.ball_radius?.toPrecision(4) ?? '—'),
        `${name}: ${settings.variant} shows ${cells.slice(1).join(', ')}; the library says ${a.vertices_outside} outside, ${a.undefined} undefined, ` +
            `${a.worst_miss.toPrecision(3)}, ${a.mean_radius.toPrecision(4)}, ${a.mean_over_optimal.toFixed(3)}, ${a.ball_radius?.toPrecision(4)}`);
  check(optimal.includes(` of the ${a.ball_vertices} vertices `) && optimal.endsWith(` radius ${a.ball_optimal.toPrecision(4)}.`),
        `${name}: ${optimal} The library says ${a.ball_optimal.toPrecision(4)}, of ${a.ball_vertices}`);
  check(same(joints, a.joints), `${name}: ${joints.length} joints are where the library has them`);
});
const outside = name => answers[steps.findIndex(s => s.name === name)].vertices_outside;
check(outside('as it opens') > 0 && outside('a drag of the joint') > 0, 'the printed algorithm loses vertices');
check(['spherical_repaired', 'spherical_miniball', 'control_mixed', 'control_many_pieces', 'the same, repaired'].every(n => outside(n) === 0), 'the sound variants lose none');

// The lemmas' pages: every preset, and a wide sweep of each slider.
const pages = await page.evaluate(() => window.refitlabExplorer.geometry.catalog.pages);
const questions = [], seen = [];
for (const {id, sliders, presets} of pages) {
  await page.locator(`#tab-${id}`).dispatchEvent('click');
  for (const [i, {label}] of presets.entries()) {
    await page.locator('#explorer .presets button').nth(i).dispatchEvent('click');
    seen.push({name: `${id}, ${label}`, question: questions.length, marks: await page.locator('#explorer .verdicts .mark').allTextContents()});
    questions.push({page: id, values: presets[i].values});
  }
  for (let s = 0; s < sliders.length; ++s)
    for (const share of [0, 0.3, 0.7, 1]) {
      const values = sliders.map(x => x.start);
      values[s] = Math.round(sliders[s].low + share * (sliders[s].high - sliders[s].low));
      questions.push({page: id, values});
    }
}
const scenes = library(questions);
const live = await page.evaluate(list => list.map(q => window.refitlabExplorer.geometry.scene(q.page, q.values)), questions);
check(live.every((scene, i) => same(scene, scenes[i])), `${questions.length} scenes of lemmas are the library's`);
seen.forEach(({name, question, marks}) => check(marks.length > 0 && marks.length === scenes[question].verdicts.length &&
    marks.every((m, k) => m.startsWith(scenes[question].verdicts[k].verdict === 'holds' ? '✓' : '✗')), `${name}: ${marks.join(' ')}`));
check(scenes.every(s => s.verdicts.every(v => v.form !== 'repaired' || v.verdict === 'holds')), 'no repaired statement fails anywhere');
check(pages.every(p => scenes.some((s, i) => questions[i].page === p.id && s.verdicts.some(v => v.form === 'printed' && v.verdict === 'fails'))),
      'each printed statement can be seen to fail');
await page.close();

for (const [width, height, name] of [[1200, 900, 'desktop'], [390, 844, 'phone']])
  for (const scheme of ['light', 'dark']) {
    const view = await open(width, height, scheme);
    await view.locator('#tab-lemma5').dispatchEvent('click');
    await view.locator('#explorer .presets button').nth(2).dispatchEvent('click');
    check(await view.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${name}, ${scheme}: nothing is wider than the page`);
    await view.waitForTimeout(500);
    const clip = await view.evaluate(() => (({x, y, width, height}) => ({x: x + scrollX, y: y + scrollY, width, height}))(document.getElementById('explorer').getBoundingClientRect()));
    await view.screenshot({path: `${folder}/explorer_${name}_${scheme}.png`, fullPage: true, clip});
    await view.close();
  }
check(errors.length === 0, `no errors in the console${errors.length ? `: ${errors.slice(0, 3).join('; ')}` : ''}`);
await browser.close();
process.exit(failures ? 1 : 0);
