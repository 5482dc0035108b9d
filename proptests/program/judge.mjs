// SPDX-License-Identifier: GPL-3.0-or-later
// The glTF validator finds no error in a baked file that the file before did not have, and glTF-Transform reads it, with the bounds.
//   node judge.mjs IN.glb OUT.glb
import {readFile} from 'node:fs/promises';
import validator from 'gltf-validator';
import {NodeIO} from '@gltf-transform/core';

const [before, after] = process.argv.slice(2);
const issues = async path => (await validator.validateBytes(new Uint8Array(await readFile(path)), {maxIssues: 10000})).issues;
const were = await issues(before), are = await issues(after);
if (are.numErrors > were.numErrors) {
  console.error(`${after}: the validator finds ${are.numErrors} errors, and had found ${were.numErrors}`);
  for (const message of are.messages.filter(m => m.severity === 0).slice(0, 5)) console.error(`  ${message.code} ${message.pointer}: ${message.message}`);
  process.exit(1);
}
const root = (await new NodeIO().read(after)).getRoot();
const bounded = root.listAnimations().filter(a => a.getExtras().refitlab?.box?.length === 6).length;
if (bounded !== root.listAnimations().length || root.listMeshes().some(m => m.getExtras().refitlab?.box?.length !== 6)) {
  console.error(`${after}: glTF-Transform does not see the bounds of all animations and meshes`);
  process.exit(1);
}
console.log(`${after}: ${are.numErrors} errors (${were.numErrors} before), ${are.numWarnings} warnings (${were.numWarnings}); ` +
            `glTF-Transform reads ${bounded} animations with bounds`);
