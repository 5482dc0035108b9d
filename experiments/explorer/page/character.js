// SPDX-License-Identifier: GPL-3.0-or-later
// The character: its skin, the balls of a level of its tree, the vertices that they miss, and joints to drag.
import * as THREE from 'three';
import {Stage, colors, disc, isDark} from './stage.js';
import {rows, say} from './dom.js';

const degrees = Math.PI / 180;
// Where a pose is known to send vertices out of the printed balls.
const start = {model: 'man', variant: 'spherical_printed_signed', clip: '', time: 0, joint: 'waist', twist: 170, level: 13, ball: 0};

export class CharacterView {
  constructor(root, geometry) {
    this.root = root;
    this.geometry = geometry;
    this.get = name => root.querySelector(`[name=${name}]`);
    this.settings = {...start};
    this.stage = new Stage(root.querySelector('canvas'), () => this.meshes && this.show());
    this.buildControls();
    this.listenToJoints();
  }

  buildControls() {
    const {catalog} = this.geometry;
    const options = (select, items) => select.replaceChildren(...items.map(([value, text]) => new Option(text, value)));
    options(this.get('model'), catalog.models.map(m => [m, m]));
    options(this.get('variant'), catalog.variants.filter(v => !v.name.startsWith('dual')).map(v => [v.name, v.name]));
    this.options = options;
    for (const name of ['model', 'variant', 'clip', 'joint', 'time', 'twist', 'level', 'ball'])
      this.get(name).addEventListener('input', event => this.change(name, event.target.value));
    this.get('worst').addEventListener('click', () => this.lookAtWorst());
    this.get('draw').addEventListener('input', () => this.show());
    this.get('play').addEventListener('click', () => this.play());
    this.root.querySelector('tbody').addEventListener('click', event => {
      const row = event.target.closest('tr');
      if (row) this.change('variant', row.dataset.variant);
    });
  }

  open() {
    this.load(this.settings.model);
  }

  change(name, value) {
    if (name === 'model') return this.load(value);
    this.settings[name] = ['variant', 'clip', 'joint'].includes(name) ? value : Number(value);
    if (name === 'clip') this.setClip(value);
    this.show();
  }

  // The first time a model is made, the browser stands still for a moment: say so first.
  load(model) {
    say(this.root, `building the ${model} …`);
    setTimeout(() => {
      let c;
      try {
        c = this.geometry.character(model);
      } catch (error) {
        this.get('model').value = this.settings.model;
        return say(this.root, error.message);
      }
      this.character = c;
      this.settings.model = model;
      this.options(this.get('joint'), c.joints.map(j => [j, j]));
      if (!c.joints.includes(this.settings.joint)) this.settings.joint = c.joints[c.twist_joint];
      this.options(this.get('clip'), [['', 'reference pose'], ...c.clips.map(k => [k.name, k.name])]);
      if (!c.clips.some(k => k.name === this.settings.clip)) this.settings.clip = '';
      this.get('level').max = c.levels;
      this.settings.level = Math.min(this.settings.level, c.levels);
      this.setClip(this.settings.clip);
      this.buildMeshes();
      this.frameCamera = true;
      this.show();
    }, 30);
  }

  setClip(name) {
    const clip = this.character.clips.find(c => c.name === name);
    this.get('time').max = clip ? clip.duration : 0;
    this.get('time').disabled = this.get('play').disabled = !clip;
    this.settings.time = Math.min(this.settings.time, clip ? clip.duration : 0);
  }

  buildMeshes() {
    for (const mesh of Object.values(this.meshes ?? {})) this.stage.scene.remove(mesh);
    const skin = new THREE.BufferGeometry();
    skin.setIndex(new THREE.BufferAttribute(this.character.triangles, 1));
    const outline = new THREE.BufferGeometry();
    // Over everything: what is transparent is drawn last, in the order that is asked for.
    const marks = {map: disc(), alphaTest: 0.5, transparent: true, sizeAttenuation: false, depthTest: false};
    this.meshes = {
      skin: new THREE.Mesh(skin, new THREE.MeshStandardMaterial({color: 0xb9c2ca, roughness: 0.75})),
      outside: new THREE.Points(outline, new THREE.PointsMaterial({...marks, size: 9, color: colors.orange})),
      halo: new THREE.Points(outline, new THREE.PointsMaterial({...marks, size: 13})),
      joints: new THREE.InstancedMesh(new THREE.SphereGeometry(1, 12, 8),
                                      new THREE.MeshBasicMaterial({depthTest: false, transparent: true, opacity: 0.75}), this.character.joints.length),
      ring: new THREE.Mesh(new THREE.TorusGeometry(1, 0.06, 8, 48), new THREE.MeshBasicMaterial({color: colors.pink, depthTest: false, transparent: true})),
    };
    this.meshes.halo.renderOrder = 8, this.meshes.outside.renderOrder = 9, this.meshes.joints.renderOrder = 10, this.meshes.ring.renderOrder = 10;
    this.stage.scene.add(...Object.values(this.meshes));
  }

  show() {
    const s = this.settings, c = this.character;
    let view;
    try {
      view = this.geometry.view({...s, joint: c.joints.indexOf(s.joint), twist: s.twist * degrees});
    } catch (error) {
      return say(this.root, error.message);
    }
    this.view = view;
    s.ball = view.ball;
    this.showSkin(view);
    this.showBalls(view);
    this.showJoints(view);
    this.showNumbers(view);
    this.stage.draw();
  }

  showSkin(view) {
    const {skin, outside, halo} = this.meshes;
    skin.geometry.setAttribute('position', new THREE.BufferAttribute(view.vertices, 3));
    skin.geometry.computeVertexNormals();
    skin.geometry.computeBoundingSphere();
    const points = [];
    view.outside.forEach((out, v) => out && points.push(...view.vertices.subarray(3 * v, 3 * v + 3)));
    outside.geometry.setAttribute('position', new THREE.Float32BufferAttribute(points, 3));
    outside.visible = halo.visible = points.length > 0;
    outside.frustumCulled = halo.frustumCulled = false;
    halo.material.color.set(isDark() ? 0xffffff : 0x000000);
    this.size = skin.geometry.boundingSphere.radius;
    if (this.frameCamera) {
      const {center, radius} = skin.geometry.boundingSphere;
      this.stage.look([center.x + radius * 1.1, center.y + radius * 0.5, center.z + radius * 3.1], center.toArray());
      this.frameCamera = false;
    }
  }

  showBalls(view) {
    const count = view.balls.length / 4, draw = this.get('draw').value;
    const detail = count > 300 ? [10, 7] : count > 60 ? [20, 14] : [40, 28];
    if (!this.balls || this.balls.count !== count) {
      if (this.balls) this.stage.scene.remove(this.balls), this.balls.geometry.dispose(), this.balls.dispose();
      this.balls = new THREE.InstancedMesh(new THREE.SphereGeometry(1, ...detail),
                                           new THREE.MeshStandardMaterial({transparent: true, opacity: 0.17, depthWrite: false, roughness: 0.4}), count);
      this.balls.frustumCulled = false;
      this.balls.renderOrder = 5;
      this.stage.scene.add(this.balls);
    }
    const matrix = new THREE.Matrix4(), color = new THREE.Color();
    for (let b = 0; b < count; ++b) {
      const [x, y, z, r] = view.balls.subarray(4 * b, 4 * b + 4);
      const size = r >= 0 && (draw === 'all' || b === view.ball || (draw === 'missing' && view.misses[b])) ? r : 0;
      matrix.makeScale(size, size, size).setPosition(x || 0, y || 0, z || 0);
      this.balls.setMatrixAt(b, matrix);
      this.balls.setColorAt(b, color.set(view.misses[b] ? colors.orange : b === view.ball ? colors.green : colors.blue));
    }
    this.balls.material.opacity = draw === 'all' ? 0.17 : 0.35;
    this.balls.instanceMatrix.needsUpdate = this.balls.instanceColor.needsUpdate = true;
  }

  showJoints(view) {
    const {joints, ring} = this.meshes, matrix = new THREE.Matrix4(), color = new THREE.Color(), chosen = this.character.joints.indexOf(this.settings.joint);
    view.joints.forEach((at, j) => {
      const size = this.size * (j === chosen ? 0.022 : 0.013);
      joints.setMatrixAt(j, matrix.makeScale(size, size, size).setPosition(...at));
      joints.setColorAt(j, color.set(j === chosen ? colors.pink : isDark() ? 0xdfe6ea : 0x33404a));
    });
    joints.instanceMatrix.needsUpdate = joints.instanceColor.needsUpdate = true;
    joints.boundingSphere = null;
    ring.position.set(...view.joints[chosen]);
    ring.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), new THREE.Vector3(...view.axis));
    ring.scale.setScalar(this.size * 0.1);
  }

  showNumbers(view) {
    const s = this.settings;
    for (const name of ['model', 'variant', 'clip', 'joint', 'time', 'twist', 'level', 'ball']) this.get(name).value = s[name];
    this.get('ball').max = view.balls.length / 4 - 1;
    const text = {time: `${s.time.toFixed(2)} s`, twist: `${s.twist}°`, level: `${s.level} of ${view.level_count}`, ball: `${view.ball + 1} of ${view.balls.length / 4}`};
    for (const [name, value] of Object.entries(text)) this.root.querySelector(`output[for=x-${name}]`).textContent = value;
    const sound = Object.fromEntries(this.geometry.catalog.variants.map(v => [v.name, v.sound]));
    rows(this.root.querySelector('tbody'), view.summaries.map(v => ({
      data: {variant: v.variant, chosen: v.variant === s.variant},
      cells: [`${v.variant}${sound[v.variant] ? '' : ' (unsound)'}`,
              v.vertices_outside ? `✗ ${v.vertices_outside}` : '✓ 0', v.undefined ? `✗ ${v.undefined}` : '0', v.worst_miss ? v.worst_miss.toPrecision(3) : '0',
              v.mean_radius?.toPrecision(4) ?? '—', v.mean_over_optimal?.toFixed(3) ?? '—', v.ball_radius?.toPrecision(4) ?? '—'],
      bad: v.vertices_outside > 0 || v.undefined > 0,
    })));
    this.root.querySelector('.optimal').textContent =
        `Smallest ball of the ${view.ball_vertices} vertices of the ball that is looked at (green): radius ${view.ball_optimal.toPrecision(4)}.`;
    const own = view.summaries.find(v => v.variant === s.variant), bad = view.misses.filter(m => m).length;
    const faults = [];
    if (own.vertices_outside) faults.push(`${own.vertices_outside} vertices are outside ${bad - own.undefined} of ${own.balls} balls (orange)`);
    if (own.undefined) faults.push(`${own.undefined} of ${own.balls} balls are undefined, and not drawn`);
    say(this.root, `${s.variant}: ${faults.join('; ') || 'all vertices are in their balls'}.`);
  }

  // The first ball that misses a vertex after the one that is looked at, or the largest.
  lookAtWorst() {
    const {misses, balls, ball} = this.view, count = misses.length;
    let found = -1;
    for (let i = 1; i <= count && found < 0; ++i) if (misses[(ball + i) % count]) found = (ball + i) % count;
    for (let b = 0; b < count && !misses[found]; ++b) if (found < 0 || balls[4 * b + 3] > balls[4 * found + 3]) found = b;
    this.change('ball', found);
  }

  play() {
    this.playing = !this.playing;
    this.get('play').textContent = this.playing ? 'stop' : 'play';
    let last = performance.now();
    const step = now => {
      if (step !== this.step) return;
      const length = Number(this.get('time').max);
      if (!this.playing || !length) return void (this.playing = false, this.get('play').textContent = 'play');
      this.settings.time = (this.settings.time + Math.max(0, now - last) / 1000) % length;
      last = now;
      this.show();
      requestAnimationFrame(step);
    };
    this.step = step;
    if (this.playing) requestAnimationFrame(step);
  }

  // Dragging a joint sideways, or its ring, twists it; dragging anything else turns the camera.
  listenToJoints() {
    const {canvas, camera, controls} = this.stage, caster = new THREE.Raycaster();
    const hit = event => {
      const box = canvas.getBoundingClientRect();
      const at = new THREE.Vector2((event.clientX - box.left) / box.width * 2 - 1, 1 - (event.clientY - box.top) / box.height * 2);
      caster.setFromCamera(at, camera);
      if (caster.intersectObject(this.meshes.ring).length) return this.settings.joint;
      // The nearest joint on the screen, as their handles are small.
      let nearest = null, least = 14;
      this.view.joints.forEach((p, j) => {
        const seen = new THREE.Vector3(...p).project(camera);
        const distance = Math.hypot((seen.x - at.x) * box.width / 2, (seen.y - at.y) * box.height / 2);
        if (distance < least) least = distance, nearest = this.character.joints[j];
      });
      return nearest;
    };
    let drag = null;
    canvas.addEventListener('pointerdown', event => {
      const joint = this.view && hit(event);
      if (!joint) return;
      event.stopImmediatePropagation();
      canvas.setPointerCapture(event.pointerId);
      if (joint !== this.settings.joint) this.settings.joint = joint, this.settings.twist = 0;
      drag = {x: event.clientX, twist: this.settings.twist};
      controls.enabled = false;
      this.show();
    }, {capture: true});
    canvas.addEventListener('pointermove', event => {
      if (!drag) return void (canvas.style.cursor = this.view && hit(event) ? 'ew-resize' : 'grab');
      this.change('twist', Math.max(-180, Math.min(180, Math.round(drag.twist + event.clientX - drag.x))));
    });
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => (drag = null, controls.enabled = true));
  }
}
