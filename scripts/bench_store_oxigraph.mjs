// Oxigraph's side of store_bench:
//     node bench_store_oxigraph.mjs GRAPH.nt QUERIES
// Prints "name<TAB>milliseconds<TAB>rows" (see
// src/kg_core/kg_core/rdf/store_bench_main.cc). The npm package is WebAssembly
// and keeps its store in memory, so its update is not durable. It is found from
// the working directory.

import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";

const oxigraph = createRequire(path.join(process.cwd(), "x.js"))("oxigraph");

function show(name, value, rows) {
  fs.writeSync(1, `${name}\t${value}\t${rows}\n`);
}

function medianMs(work) {
  const times = [];
  let sum = 0;
  while (times.length < 5 || sum < 500) {
    const begin = performance.now();
    work();
    times.push(performance.now() - begin);
    sum += times.at(-1);
  }
  times.sort((a, b) => a - b);
  return times[times.length >> 1];
}

const [graphPath, queriesPath] = process.argv.slice(2);
const store = new oxigraph.Store();
const before = process.memoryUsage().rss;
const begin = performance.now();
// In pieces of whole lines: a JavaScript string has an end.
const bytes = fs.readFileSync(graphPath);
for (let at = 0; at < bytes.length; ) {
  let end = Math.min(at + (64 << 20), bytes.length);
  end = bytes.lastIndexOf(10, end) + 1;
  store.load(bytes.toString("utf8", at, end), {
    format: "application/n-triples",
  });
  at = end;
}
show("load", performance.now() - begin, store.size);
show("memory", process.memoryUsage().rss - before, 0);
const lines = fs.readFileSync(queriesPath, "utf8").trim().split("\n");
for (const [name, query] of lines.map((line) => line.split("\t"))) {
  const rows = store.query(query).length;
  show(name, medianMs(() => store.query(query)), rows);
}
const edge = "<http://example.org/mission/edge/0_7>";
const cost = "<http://example.org/mission/cost>";
const update = `DELETE { ${edge} ${cost} ?c } INSERT { ${edge} ${cost} 5.0 } WHERE { ${edge} ${cost} ?c }`;
show("update", medianMs(() => store.update(update)), 0);
