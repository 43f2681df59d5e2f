// The charts' files: reads {config, specs} as JSON from standard input, writes {name: text of an SVG} to standard output.
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

draw_all(JSON.parse(fs.readFileSync(0, 'utf8'))).then((drawn) => process.stdout.write(JSON.stringify(drawn)));
