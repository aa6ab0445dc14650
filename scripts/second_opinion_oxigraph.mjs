// Answers the cases of random_cases with Oxigraph: a line of JSON in, a line of
// JSON out, {"rows": [["<iri>", null]]} or {"error": "..."}.
//     node second_opinion_oxigraph.mjs NODE_MODULES_FOLDER

import { createRequire } from 'node:module';
import readline from 'node:readline';

const require = createRequire(`${process.argv[2]}/`);
const oxigraph = require('oxigraph');

function load(store, text, graph) {
  const options = { format: 'application/n-triples' };
  if (graph) options.to_graph_name = oxigraph.namedNode(graph);
  store.load(text, options);
}

const text = (term) => (term === undefined ? null : term.toString());

function answer(problem) {
  const store = new oxigraph.Store();
  load(store, problem.default);
  for (const [name, graph] of Object.entries(problem.named)) load(store, graph, name);
  return store.query(problem.query).map((row) => (row instanceof Map
    ? problem.variables.map((name) => text(row.get(name)))
    : [row.subject, row.predicate, row.object].map(text)));
}

for await (const line of readline.createInterface({ input: process.stdin })) {
  let reply;
  try {
    reply = { rows: answer(JSON.parse(line)) };
  } catch (error) {
    reply = { error: String(error) };
  }
  process.stdout.write(`${JSON.stringify(reply)}\n`);
}
