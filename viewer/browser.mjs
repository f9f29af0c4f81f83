// Starts the system's Chromium without a display and without network access; WebGL is drawn by software.
import { accessSync, constants } from 'node:fs';
import { delimiter, join } from 'node:path';
import { chromium } from 'playwright-core';

const names = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];

function isProgram(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

function findChromium() {
  const folders = (process.env.PATH ?? '').split(delimiter);
  const found = names.flatMap((name) => folders.map((folder) => join(folder, name))).find(isProgram);
  if (!found) throw new Error(`Chromium is missing: none of ${names.join(', ')} is in PATH. scripts/install_dependencies.sh installs it.`);
  return found;
}

export function openBrowser() {
  return chromium.launch({
    executablePath: findChromium(),
    timeout: 120000,
    // Without a GPU process for the page itself, software draws only what is WebGL.
    args: ['--disable-gpu', '--no-sandbox', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--disable-quic', '--no-first-run',
      '--disable-background-networking', '--disable-component-update', '--disable-sync'],
  });
}
