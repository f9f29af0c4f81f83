// The morph by the Khronos validator: node gltf_test.mjs FOLDER, with the .glb files of make_report in it.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { test } from 'node:test';

const { validateBytes } = createRequire(new URL('../../viewer/package.json', import.meta.url))('gltf-validator');
const folder = resolve(process.argv[2]);
const files = readdirSync(folder).filter((name) => name.endsWith('.glb'));

test('there are morphs to judge', () => assert.deepEqual(files.sort(), ['coloured.glb', 'morph.glb']));

for (const name of files) {
  test(`${name} is valid glTF with one animated target`, async () => {
    const report = await validateBytes(new Uint8Array(readFileSync(join(folder, name))));
    const found = report.issues.messages.filter((message) => message.severity < 3);  // errors, warnings and what they inform of, not hints
    assert.deepEqual(found, []);
    assert.equal(report.info.hasMorphTargets, true);
    assert.equal(report.info.animationCount, 1);
  });
}

test('a damaged morph is seen', async () => {
  const bytes = new Uint8Array(readFileSync(join(folder, files[0])));
  const report = await validateBytes(bytes.subarray(0, bytes.length - 8));
  assert.ok(report.issues.numErrors > 0);
});
