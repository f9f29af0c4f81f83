// The report in a browser: node report_test.mjs FOLDER, with the pages of make_report in it.
import assert from 'node:assert/strict';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { openBrowser } from '../../viewer/browser.mjs';
import { openPictureReader } from './pictures.mjs';

const folder = resolve(process.argv[2]);
const patience = 120000;  // Machines that test are busy, and software draws the pictures.
let browser;
let pictures;
before(async () => {
  browser = await openBrowser();
  pictures = await openPictureReader(browser);
});
after(() => browser?.close());

/// Opens a page; `done` fails on any error, dialog or request that left the file.
async function open(t, name, { viewport = { width: 900, height: 560 }, reducedMotion = 'reduce' } = {}) {
  const page = await browser.newPage({ viewport, reducedMotion });
  page.setDefaultTimeout(patience);
  t.after(() => page.close());
  const troubles = [];
  page.on('console', (message) => message.type() === 'error' && troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('dialog', (dialog) => { troubles.push(`dialog ${dialog.message()}`); dialog.dismiss(); });
  page.on('request', (request) => /^(file|data|blob):/.test(request.url()) || troubles.push(`request ${request.url()}`));
  await page.goto(pathToFileURL(join(folder, name)).href);
  return { page, look: () => pictures.drawn(page.locator('#view')), done: () => assert.deepEqual(troubles, []) };
}

const change = async (look, action) => {
  const first = await look();
  await action();
  return pictures.difference(first, await look());
};

test('a report opens without errors and draws both shapes', async (t) => {
  const { page, look, done } = await open(t, 'match.html');
  const picture = await look();
  for (const half of [[0, 0.5], [0.5, 1]]) assert.ok((await pictures.ink(picture, half)) > 0.03, `ink in ${half}`);
  assert.match(await page.title(), /^deer\.off . bent deer\.off/u);
  assert.equal(await page.locator('label.match').count(), 3);
  done();
});

test('choosing another match changes the picture and the pairs', async (t) => {
  const { page, look, done } = await open(t, 'match.html');
  assert.equal(await page.locator('#rows tbody tr').count(), 15);
  assert.ok((await change(look, () => page.locator('label.match').nth(1).click())) > 0.01);
  assert.match(await page.locator('#details').innerText(), /Match 2[^]*mirrored/);
  assert.ok((await change(look, () => page.keyboard.press('3'))) > 0.01);
  assert.equal(await page.locator('#rows tbody tr').count(), 4);
  done();
});

test('the slider warps the model in both panes, and back', async (t) => {
  const { page, look, done } = await open(t, 'match.html');
  const first = await look();
  await page.locator('#set-share').fill('1');
  const warped = await look();
  for (const half of [[0, 0.5], [0.5, 1]]) assert.ok((await pictures.difference(first, warped, half)) > 0.01, `change in ${half}`);
  await page.locator('#set-share').fill('0');
  assert.equal(await pictures.difference(first, await look()), 0);
  done();
});

test('the warp plays there and back, by the button and by space, until it is stopped', async (t) => {
  const { page, look, done } = await open(t, 'match.html', { reducedMotion: 'no-preference' });
  const play = page.locator('#play');
  assert.equal(await play.getAttribute('aria-label'), 'Play the warp, there and back');
  await play.click();
  assert.equal(await play.getAttribute('aria-label'), 'Pause');
  await page.evaluate(() => {
    const watch = () => {
      const share = Number(document.querySelector('#set-share').value);
      if (share > 0.8) window.turns.push('there');
      if (share < 0.2) window.turns.push('back');
      window.turns = window.turns.filter((turn, i) => turn !== window.turns[i - 1]);
      requestAnimationFrame(watch);
    };
    window.turns = [];
    watch();
  });
  await page.waitForFunction(() => window.turns.slice(-4).join() === 'there,back,there,back');
  await page.locator('#view').focus();
  await page.keyboard.press('Space');
  const paused = await look();
  const share = await page.locator('#set-share').inputValue();
  await page.waitForTimeout(300);
  assert.equal(await page.locator('#set-share').inputValue(), share);
  assert.equal(await pictures.difference(paused, await look()), 0);
  await play.press('Space');
  assert.equal(await play.getAttribute('aria-label'), 'Pause');
  await page.locator('#set-share').fill('0.5');
  assert.match(await play.getAttribute('aria-label'), /Play/, 'who takes the slider stops it');
  done();
});

test('with reduced motion playing leaps to the other end', async (t) => {
  const { page, look, done } = await open(t, 'match.html');
  const start = await look();
  for (const end of ['1', '0']) {
    await page.locator('#play').press('Enter');
    assert.equal(await page.locator('#set-share').inputValue(), end);
    assert.match(await page.locator('#play').getAttribute('aria-label'), /Play/);
  }
  assert.equal(await pictures.difference(start, await look()), 0);
  done();
});

test('a pair shows its numbers when its row, its ball or its line is clicked', async (t) => {
  const { page, look, done } = await open(t, 'match.html');
  const details = page.locator('#details');
  assert.ok((await change(look, () => page.locator('#rows tbody tr').nth(4).click())) > 0.001);
  const text = await details.innerText();
  for (const word of [/Pair 5/, /radius/, /descriptor distance\s+0\.18/, /confidence\s+0\.76/, /position/]) assert.match(text, word);
  await page.keyboard.press('Escape');
  assert.match(await details.innerText(), /Match 1/);

  const box = await page.locator('#view').boundingBox();
  const clickWhere = async (area) => {
    const spot = await pictures.find(await look(), area);
    assert.ok(spot, `nothing coloured in ${area}`);
    await page.mouse.click(box.x + spot.x, box.y + spot.y);
  };
  await clickWhere([0.05, 0.4]);
  assert.match(await details.innerText(), /Pair \d+/);
  await page.keyboard.press('Escape');
  await clickWhere([0.49, 0.497]);
  assert.match(await details.innerText(), /Pair \d+/);
  done();
});

test('linked cameras turn both shapes, unlinked only one', async (t) => {
  const { page, look, done } = await open(t, 'match.html');
  const box = await page.locator('#view').boundingBox();
  const drag = async () => {
    await page.mouse.move(box.x + 100, box.y + box.height - 60);
    await page.mouse.down();
    await page.mouse.move(box.x + 180, box.y + box.height - 90, { steps: 4 });
    await page.mouse.up();
  };
  await page.locator('text=Lines').click();
  const first = await look();
  await drag();
  const linked = await look();
  assert.ok((await pictures.difference(first, linked, [0.55, 1])) > 0.01);
  await page.locator('text=Linked').click();
  await drag();
  const unlinked = await look();
  assert.ok((await pictures.difference(linked, unlinked, [0, 0.45])) > 0.01);
  assert.equal(await pictures.difference(linked, unlinked, [0.55, 1]), 0);
  done();
});

test('every switch changes the picture', async (t) => {
  const { page, look, done } = await open(t, 'match.html');
  await page.keyboard.press('3');
  for (const name of ['Unmatched', 'Lines', 'Points']) {
    assert.ok((await change(look, () => page.locator('.chip', { hasText: name }).click())) > 0.0005, name);
  }
  for (const [name, value] of [['#set-least', '0.9'], ['#set-ballScale', '0.4'], ['#set-opacity', '0.9']]) {
    await page.keyboard.press('2');
    await page.locator('#show-points').setChecked(true, { force: true });
    assert.ok((await change(look, () => page.locator(name).fill(value))) > 0.001, name);
  }
  assert.ok((await change(look, () => page.locator('#show-colouring').selectOption('position'))) > 0.01, 'colour');
  done();
});

test('a mirror plane stands in both panes, with its error in the list', async (t) => {
  const { page, look, done } = await open(t, 'symmetry.html');
  const notes = page.locator('.match .symmetry');
  assert.deepEqual(await notes.allInnerTexts(), ['repeated, turned by 0.0\u00b0, error 30\u2009%',
    'mirror plane, error 0.12\u2009%', 'repeated, turned by 0.0\u00b0, error 0.001\u2009%']);
  assert.equal(await change(look, () => page.keyboard.press('m')), 0, 'no plane of a repeated part');
  await page.keyboard.press('2');
  assert.match(await page.locator('#details').innerText(), /mirror plane\s+normal 0, 1, 0; offset 0\s+error\s+0\.12/);
  const without = await look();
  await page.locator('.chip', { hasText: 'Mirror plane' }).click();
  const shown = await look();
  for (const half of [[0, 0.5], [0.5, 1]]) assert.ok((await pictures.difference(without, shown, half)) > 0.05, `plane in ${half}`);
  done();
});

test('two shapes have no mirror plane to show', async (t) => {
  const { page, done } = await open(t, 'match.html');
  assert.equal(await page.locator('.chip', { hasText: 'Mirror plane' }).count() + await page.locator('.symmetry').count(), 0);
  done();
});

test('that no match is likely is said above the list, and only then', async (t) => {
  const doubtful = await open(t, 'doubtful.html');
  assert.match(await doubtful.page.locator('#family').innerText(), /No match here is likely to be right: the highest confidence is 0\.39\./);
  doubtful.done();
  const match = await open(t, 'match.html');
  assert.equal(await match.page.locator('.doubt').count(), 0);
  match.done();
});

test('a hostile file name stays text', async (t) => {
  const { page, done } = await open(t, 'hostile.html');
  assert.match(await page.locator('#title').innerText(), /<\/script><script>alert\(1\)<\/script><img src=x onerror=alert\(2\)>\.off/);
  assert.equal(await page.locator('img').count(), 0);
  assert.equal(await page.locator('script').count(), 2);
  done();
});

test('an empty family says so and still shows both shapes', async (t) => {
  const { page, look, done } = await open(t, 'empty.html');
  assert.match(await page.locator('#panel').innerText(), /Nothing found[^]*seeds\s+0/);
  const picture = await look();
  for (const half of [[0, 0.5], [0.5, 1]]) assert.ok((await pictures.ink(picture, half)) > 0.03);
  done();
});

test('one shape alone shows its points and their numbers', async (t) => {
  const { page, look, done } = await open(t, 'points.html');
  assert.ok((await pictures.ink(await look())) > 0.03);
  await page.locator('#rows tbody tr').nth(2).click();
  assert.match(await page.locator('#details').innerText(), /Point 2[^]*radius\s+0\.16[^]*response\s+0\.9/);
  done();
});

test('a phone shows everything without scrolling sideways', async (t) => {
  const { page, look, done } = await open(t, 'match.html', { viewport: { width: 390, height: 844 } });
  assert.ok((await pictures.ink(await look())) > 0.03);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  done();
});

test('in a window of any width the controls stay inside their rows and round ones stay round', async (t) => {
  const { page, done } = await open(t, 'match.html');
  for (const width of [390, 800, 900, 1400]) {
    await page.setViewportSize({ width, height: 600 });
    const outside = await page.evaluate(() => ['header', '#toolbar', '#footer'].flatMap((name) => {
      const row = document.querySelector(name).getBoundingClientRect();
      return [...document.querySelectorAll(`${name} :is(button, select, input, output, span)`)].filter((control) => {
        const box = control.getBoundingClientRect();
        return box.left < row.left || box.right > row.right - 10;
      }).map((control) => control.outerHTML);
    }));
    assert.deepEqual(outside, [], `at ${width}`);
    const play = await page.locator('#play').boundingBox();
    assert.equal(play.width, play.height);
  }
  done();
});
