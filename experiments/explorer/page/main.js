// SPDX-License-Identifier: GPL-3.0-or-later
// Starts when the explorer comes into view: the geometry is opened once, for both parts.
import {openGeometry} from './geometry.js';
import {CharacterView} from './character.js';
import {LemmaView} from './lemmas.js';
import {say} from './dom.js';

const root = document.getElementById('explorer');
async function start() {
  try {
    const geometry = await openGeometry();
    const lemmas = new LemmaView(root.querySelector('.lemmas'), geometry);
    const character = new CharacterView(root.querySelector('.character'), geometry);
    character.open();
    window.refitlabExplorer = {geometry, character, lemmas};
  } catch (error) {
    for (const part of root.querySelectorAll('.part')) say(part, `The explorer cannot run in this browser: ${error.message}`);
    console.error(error);
  }
}
const watcher = new IntersectionObserver(entries => {
  if (!entries.some(e => e.isIntersecting)) return;
  watcher.disconnect();
  start();
}, {rootMargin: '200px'});
watcher.observe(root);
