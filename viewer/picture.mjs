// Takes a picture of a report by the system's Chromium: node picture.mjs REPORT.html PICTURE.png [WIDTHxHEIGHT]
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { openBrowser } from './browser.mjs';

const [report, picture, size = '1400x800'] = process.argv.slice(2);
if (!picture) {
  console.error('usage: npm run picture REPORT.html PICTURE.png [WIDTHxHEIGHT]');
  process.exit(2);
}
const [width, height] = size.split('x').map(Number);
const browser = await openBrowser();
const page = await browser.newPage({ viewport: { width, height }, reducedMotion: 'reduce' });
page.setDefaultTimeout(120000);
await page.goto(pathToFileURL(resolve(process.env.INIT_CWD ?? '.', report)).href);
await page.waitForTimeout(1000);
await page.screenshot({ path: resolve(process.env.INIT_CWD ?? '.', picture) });
await browser.close();
