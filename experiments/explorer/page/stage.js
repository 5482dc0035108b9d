// SPDX-License-Identifier: GPL-3.0-or-later
// A stage: a canvas with a camera that is turned by dragging or by the arrow keys, in the page's light or dark scheme.
import * as THREE from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';

// Okabe and Ito's colours, which the colour-blind tell apart; each role also has a form or a label of its own.
export const colors = {blue: 0x0072b2, sky: 0x56b4e9, orange: 0xd55e00, yellow: 0xe69f00, green: 0x009e73, pink: 0xcc79a7};
const dark = matchMedia('(prefers-color-scheme: dark)');
export const isDark = () => dark.matches;

export class Stage {
  constructor(canvas, onScheme) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true});
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(35, 1, 0.01, 200);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x707880, 2.2));
    const sun = new THREE.DirectionalLight(0xffffff, 1.6);
    sun.position.set(2, 4, 3);
    this.camera.add(sun);
    this.scene.add(this.camera);
    this.controls = new OrbitControls(this.camera, canvas);
    canvas.style.touchAction = 'pan-y';  // the controls set none, and nobody could scroll past the picture
    this.controls.addEventListener('change', () => this.draw());
    canvas.addEventListener('keydown', event => this.key(event));
    const scheme = () => {
      this.scene.background = new THREE.Color(isDark() ? 0x1b2025 : 0xf4f6f8);
      if (onScheme) onScheme();
      this.draw();
    };
    dark.addEventListener('change', scheme);
    scheme();
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    // Narrow pictures step back, so that as much is seen across.
    this.camera.fov = this.camera.aspect < 1.2 ? 2 * Math.atan(Math.tan(35 * Math.PI / 360) * 1.2 / this.camera.aspect) * 180 / Math.PI : 35;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  look(from, at) {
    this.camera.position.set(...from);
    this.controls.target.set(...at);
    const distance = this.camera.position.distanceTo(this.controls.target);  // files have units of their own
    this.camera.near = distance / 500, this.camera.far = distance * 100;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  key(event) {
    const turns = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]};
    const zooms = {'+': 0.9, '=': 0.9, '-': 1.1};
    if (!turns[event.key] && !zooms[event.key]) return;
    event.preventDefault();
    const way = new THREE.Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
    if (zooms[event.key]) way.radius *= zooms[event.key];
    else way.theta += turns[event.key][0], way.phi = Math.min(3.1, Math.max(0.05, way.phi + turns[event.key][1]));
    this.camera.position.setFromSpherical(way).add(this.controls.target);
    this.controls.update();
  }

  // At most once a frame, whoever asks.
  draw() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.renderer.render(this.scene, this.camera);
    });
  }
}

// A text that always faces the camera.
export function label(text, size, color = isDark() ? '#f0f2f4' : '#15181b') {
  const canvas = document.createElement('canvas'), pen = canvas.getContext('2d'), font = '600 44px system-ui, sans-serif';
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(text).width) + 16, canvas.height = 60;
  pen.font = font;
  pen.lineWidth = 8, pen.lineJoin = 'round', pen.strokeStyle = isDark() ? '#1b2025' : '#f4f6f8', pen.fillStyle = color;
  pen.strokeText(text, 8, 46);
  pen.fillText(text, 8, 46);
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({map: texture, depthTest: false, transparent: true}));
  sprite.scale.set(size * canvas.width / canvas.height, size, 1);
  sprite.center.set(-0.08, -0.15);
  sprite.renderOrder = 20;
  return sprite;
}

// A round mark for points.
export function disc() {
  const canvas = Object.assign(document.createElement('canvas'), {width: 32, height: 32}), pen = canvas.getContext('2d');
  pen.fillStyle = '#fff';
  pen.arc(16, 16, 15, 0, 2 * Math.PI);
  pen.fill();
  return new THREE.CanvasTexture(canvas);
}

export function dispose(group) {
  group.traverse(object => {
    object.geometry?.dispose();
    object.material?.map?.dispose();
    object.material?.dispose();
  });
  group.clear();
}
