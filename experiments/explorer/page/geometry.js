// SPDX-License-Identifier: GPL-3.0-or-later
// The project's C++ in WebAssembly: settings in, numbers out. Nothing here computes geometry.
import load_explorer from 'refitlab-explorer-wasm';

export async function openGeometry() {
  const module = await load_explorer();
  const call = (name, ...texts) => {
    const answer = JSON.parse(module.ccall(name, 'string', texts.map(() => 'string'), texts));
    if (answer.error) throw new Error(answer.error);
    return answer;
  };
  // The run's own models, packed, a line of base64 each.
  for (const line of document.getElementById('explorer-models')?.textContent.trim().split('\n') ?? []) {
    const bytes = Uint8Array.from(atob(line), c => c.charCodeAt(0));
    const place = module.ccall('room_for_model', 'number', ['number'], [bytes.length]);
    module.HEAPU8.set(bytes, place);
    call('add_model');
  }
  // Copies: the memory may move at the next call.
  const list = (heap, bytes, place) => module[heap].slice(place.at / bytes, place.at / bytes + place.count);
  return {
    catalog: call('catalog'),
    character(model) {
      const answer = call('character', model);
      return {...answer, triangles: new Uint32Array(list('HEAP32', 4, answer.triangles))};
    },
    view(settings) {
      const answer = call('view', JSON.stringify(settings));
      return {...answer, vertices: list('HEAPF32', 4, answer.vertices), balls: list('HEAPF32', 4, answer.balls),
              outside: list('HEAPU8', 1, answer.outside), misses: list('HEAPU8', 1, answer.misses)};
    },
    scene: (page, values) => call('scene', page, JSON.stringify(values)),
  };
}
