// The charts' files: reads {config, specs} as JSON from the file that is named first, writes {name: text of an SVG} into the second.
// Not standard input: what is not there yet of a pipe Node.js takes for an error.
import * as fs from 'node:fs';
import * as vega from 'vega';
import {textMetrics} from 'vega-scenegraph';

// Without a canvas Vega takes letters for wider than they are, and leaves holes. This is DejaVu Sans on average.
const LETTER = 0.61;
textMetrics.width = (item, text) => LETTER * (item.fontSize ?? 11) * String(text ?? '').length;

async function draw_all({config, specs}) {
  const drawn = {};
  for (const [name, spec] of Object.entries(specs))
    drawn[name] = await new vega.View(vega.parse(spec, config), {renderer: 'none', logLevel: vega.Warn}).toSVG();
  return drawn;
}

const [given, made] = process.argv.slice(2);
draw_all(JSON.parse(fs.readFileSync(given, 'utf8'))).then((drawn) => fs.writeFileSync(made, JSON.stringify(drawn)));
