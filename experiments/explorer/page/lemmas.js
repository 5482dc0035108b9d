// SPDX-License-Identifier: GPL-3.0-or-later
// The lemmas' pages: sliders of whole numbers, and the scene and verdicts that the lemma's own code makes of them.
import * as THREE from 'three';
import {Stage, colors, dispose, isDark, label} from './stage.js';
import {element} from './dom.js';

// left: the label is to the left, as a point whose label is to the right is near.
const roles = {
  surface: {color: () => (isDark() ? 0x8b99a5 : 0x8a97a3), opacity: 0.1},
  ball: {color: () => colors.sky, opacity: 0.22},
  printed: {color: () => colors.orange, opacity: 0.2, grid: true},
  repaired: {color: () => colors.blue, opacity: 0.2},
  cap: {color: () => colors.yellow, opacity: 0.45},
  half_space: {color: () => colors.green, opacity: 0.22},
  normal: {color: () => colors.green}, foot: {color: () => colors.green, size: 0.03, left: true},
  hull: {color: () => (isDark() ? 0xdfe6ea : 0x33404a)}, other_hull: {color: () => colors.blue}, rim: {color: () => colors.blue},
  ray: {color: () => colors.pink}, blend: {color: () => colors.pink, size: 0.04},
  partner: {color: () => colors.blue, size: 0.05, left: true},
  quaternion: {color: () => (isDark() ? 0xffffff : 0x15181b), size: 0.04}, unit: {color: () => colors.blue, size: 0.035},
  apex: {color: () => colors.yellow, size: 0.045}, center: {color: () => colors.blue, size: 0.035},
  printed_center: {color: () => colors.orange, size: 0.035},
  inside: {color: () => colors.blue, size: 0.05}, outside: {color: () => colors.orange, size: 0.06},
};
const up = new THREE.Vector3(0, 1, 0), ahead = new THREE.Vector3(0, 0, 1);
const vector = list => new THREE.Vector3(...list);

export class LemmaView {
  constructor(root, geometry) {
    this.root = root;
    this.geometry = geometry;
    this.stage = new Stage(root.querySelector('canvas'), () => this.page && this.show());
    this.drawing = new THREE.Group();
    this.stage.scene.add(this.drawing);
    const tabs = root.querySelector('[role=tablist]');
    for (const page of geometry.catalog.pages)
      tabs.append(element('button', {type: 'button', role: 'tab', id: `tab-${page.id}`, textContent: page.title.split(':')[0], onclick: () => this.open(page.id)}));
    tabs.addEventListener('keydown', event => {
      const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
      if (!step) return;
      const all = [...tabs.children], next = all[(all.indexOf(document.activeElement) + step + all.length) % all.length];
      next.focus();
      next.click();
    });
    this.open('lemma5');
  }

  open(id) {
    const page = this.page = this.geometry.catalog.pages.find(p => p.id === id);
    for (const tab of this.root.querySelectorAll('[role=tab]')) {
      tab.ariaSelected = String(tab.id === `tab-${id}`);
      tab.tabIndex = tab.id === `tab-${id}` ? 0 : -1;
    }
    this.root.querySelector('h4').textContent = page.title;
    this.root.querySelector('.text').textContent = page.text;
    this.sliders = page.sliders.map((s, i) => element('input', {type: 'range', id: `s-${id}-${i}`, min: s.low, max: s.high, value: s.start, oninput: () => this.show()}));
    this.outputs = page.sliders.map(() => element('output'));
    this.root.querySelector('.sliders').replaceChildren(...page.sliders.map((s, i) =>
        element('label', {htmlFor: `s-${id}-${i}`}, element('span', {}, `${s.label} `, this.outputs[i]), this.sliders[i])));
    this.root.querySelector('.presets').replaceChildren(...page.presets.map(p => element('button', {
      type: 'button', textContent: p.label, onclick: () => (p.values.forEach((v, i) => (this.sliders[i].value = v)), this.show())})));
    const view = {whole_sphere: [[0.6, 1.2, 7.6], [0, 0, 0]], lemma2: [[2.2, 1.8, 5.8], [0.2, 0.1, 0]]};
    this.stage.look(...(view[id] ?? [[1.6, 1.3, 4.2], [0.2, 0.1, 0]]));
    this.show();
  }

  show() {
    const scene = this.scene = this.geometry.scene(this.page.id, this.sliders.map(s => Number(s.value)));
    scene.texts.forEach((text, i) => (this.outputs[i].textContent = text));
    dispose(this.drawing);
    for (const b of scene.balls) this.ball(b);
    for (const c of scene.caps) this.cap(c);
    for (const p of scene.planes) this.plane(p);
    for (const l of scene.lines) this.line(l);
    for (const p of scene.points) this.point(p);
    this.root.querySelector('.verdicts').replaceChildren(...scene.verdicts.map(v =>
        element('li', {className: `${v.verdict} ${v.form || 'hypothesis'}`},
                element('b', {textContent: v.form ? `${v.form}: ` : 'asked: '}), `${v.says} `,
                element('span', {className: 'mark', textContent: v.verdict === 'holds' ? (v.form ? '✓ holds' : '✓ yes') : v.form ? '✗ fails' : '✗ no'}))));
    this.root.querySelector('.numbers').textContent = scene.numbers.map(n => `${n.label} = ${Number(n.value.toPrecision(6))}`).join(' · ');
    this.stage.draw();
  }

  mesh(shape, role, more = {}) {
    const {color, opacity = 1} = roles[role];
    const mesh = new THREE.Mesh(shape, new THREE.MeshStandardMaterial(
        {color: color(), opacity, transparent: opacity < 1, depthWrite: opacity === 1, side: THREE.DoubleSide, roughness: 0.6, ...more}));
    this.drawing.add(mesh);
    return mesh;
  }

  ball({role, center, radius}) {
    const shape = new THREE.SphereGeometry(Math.max(radius, 1e-3), 48, 32);
    shape.translate(...center);
    this.mesh(shape, role);
    if (!roles[role].grid) return;
    const coarse = new THREE.SphereGeometry(Math.max(radius, 1e-3), 20, 14), grid = new THREE.WireframeGeometry(coarse);
    coarse.dispose();
    grid.translate(...center);
    this.drawing.add(new THREE.LineSegments(grid, new THREE.LineBasicMaterial({color: roles[role].color(), transparent: true, opacity: 0.45})));
  }

  cap({role, center, apex, cos}) {
    const axis = vector(apex).sub(vector(center)), radius = axis.length();
    const shape = new THREE.SphereGeometry(radius * 1.004, 64, 32, 0, 2 * Math.PI, 0, Math.max(Math.acos(cos), 0.02));
    shape.applyQuaternion(new THREE.Quaternion().setFromUnitVectors(up, axis.normalize()));
    shape.translate(...center);
    this.mesh(shape, role);
  }

  plane({role, foot, normal}) {
    const shape = new THREE.CircleGeometry(1.35, 64);
    shape.applyQuaternion(new THREE.Quaternion().setFromUnitVectors(ahead, vector(normal).normalize()));
    shape.translate(...foot);
    this.mesh(shape, role);
    // A tick into the half-space.
    this.line({role, from: foot, to: vector(foot).addScaledVector(vector(normal).normalize(), 0.25).toArray()});
  }

  line({role, from, to}) {
    this.drawing.add(new THREE.Line(new THREE.BufferGeometry().setFromPoints([vector(from), vector(to)]), new THREE.LineBasicMaterial({color: roles[role].color()})));
  }

  point({role, label: text, at}) {
    // Inside and outside differ by form too: a ball, a diamond.
    const {size, left} = roles[role];
    const shape = role === 'outside' ? new THREE.OctahedronGeometry(size * 1.3) : new THREE.SphereGeometry(size, 20, 14);
    shape.translate(...at);
    this.mesh(shape, role);
    const name = label(text, 0.13);
    name.position.set(...at);
    if (left) name.center.x = 1.08;
    this.drawing.add(name);
  }
}
