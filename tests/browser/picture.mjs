// The picture of the README: node picture.mjs FILE.png writes what the page of examples/bump.json shows of space.
// EXSECT_PROGRAM and EXSECT_EXAMPLES say where the program and the examples are.
import {writeFileSync} from 'node:fs';

import {example, launch, open, report, settled} from './browser.mjs';

/** The bytes of the PNG file. */
export async function picture(browser, name = 'bump.json') {
  const page = await open(browser, report('intersect', example(name)).path, {viewport: {width: 1100, height: 900}, colorScheme: 'light', deviceScaleFactor: 1.5});
  await settled(page);
  return page.locator('.space').first().screenshot();
}

if (process.argv[2]) {
  const browser = await launch();
  writeFileSync(process.argv[2], await picture(browser, process.argv[3]));
  await browser.close();
}
