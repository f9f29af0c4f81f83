// What is written as glTF, by the Khronos validator: node gltf_test.mjs FOLDER, with the files of make_report in it.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { test } from 'node:test';

const { validateBytes } = createRequire(new URL('../../viewer/package.json', import.meta.url))('gltf-validator');
const folder = resolve(process.argv[2]);
const files = readdirSync(folder).filter((name) => /\.(glb|gltf)$/.test(name));
const report = (name) => validateBytes(new Uint8Array(readFileSync(join(folder, name))), {
  externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(folder, decodeURIComponent(uri)))),
});

test('there are files to judge', () => assert.deepEqual(files.sort(), ['carried too.gltf', 'carried.glb', 'coloured.glb', 'morph.glb']));

for (const name of files) {
  test(`${name} is valid glTF`, async () => {
    const { issues } = await report(name);
    // Errors, warnings and what they inform of, not hints, nor that a material without a picture has UVs, or bumps no tangents.
    const found = issues.messages.filter(({ severity, pointer, code }) =>
      severity < 3 && !pointer?.endsWith('/TEXCOORD_0') && code !== 'MESH_PRIMITIVE_GENERATED_TANGENT_SPACE');
    assert.deepEqual(found, []);
  });
}

for (const name of ['morph.glb', 'coloured.glb', 'carried.glb']) {
  test(`${name} has one animation, and a target`, async () => {
    const { info } = await report(name);
    assert.equal(info.hasMorphTargets, true);
    assert.equal(info.animationCount, 1);
  });
}

for (const [name, influences] of [['carried.glb', 4], ['carried too.gltf', 8]]) {
  test(`${name} has a skin, a shape key and a picture`, async () => {
    const { info } = await report(name);
    assert.deepEqual([info.hasSkins, info.hasMorphTargets, info.materialCount, info.maxInfluences], [true, true, 2, influences]);
    assert.deepEqual(info.resources.map((resource) => resource.mimeType).filter((type) => type.startsWith('image')), ['image/png']);
  });
}

test('carried too.gltf keeps what its materials are', () => {
  const { materials, textures, samplers } = JSON.parse(readFileSync(join(folder, 'carried too.gltf')));
  const [metal, bumps] = materials;
  assert.equal(metal.pbrMetallicRoughness.metallicRoughnessTexture.extensions.KHR_texture_transform.rotation, 0.5);
  assert.deepEqual([bumps.normalTexture.index, bumps.occlusionTexture.index, bumps.alphaMode, bumps.doubleSided], [0, 1, 'MASK', undefined]);
  assert.deepEqual([textures.length, samplers], [2, [{ wrapS: 33071 }]]);
});

test('a damaged morph is seen', async () => {
  const bytes = new Uint8Array(readFileSync(join(folder, 'morph.glb')));
  const report = await validateBytes(bytes.subarray(0, bytes.length - 8));
  assert.ok(report.issues.numErrors > 0);
});
