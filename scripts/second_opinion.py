#!/usr/bin/env python3
"""Runs the queries of random_cases in another SPARQL engine and compares bags.

    random_cases 1000 | scripts/second_opinion.py rdflib
    random_cases 1000 | scripts/second_opinion.py oxigraph NODE_MODULES_FOLDER

Prints every difference; last line: "cases N, differences N". Exit status 1 if
there is a difference. Numbers are compared by value and type, since lexical
forms of results are an engine's own ("2.50" + 1).
"""

import collections
import json
import pathlib
import subprocess
import sys

import rdflib
from rdflib.namespace import XSD
from rdflib.util import from_n3

NUMERIC = {XSD.integer, XSD.decimal, XSD.double, XSD.float}
ORACLE = pathlib.Path(__file__).parent / "second_opinion_oxigraph.mjs"


def canonical(term):
    """A key of the term that equal values share."""
    if term is None or isinstance(term, (rdflib.URIRef, rdflib.BNode)):
        return term if term is None else str(term)
    if term.datatype in NUMERIC:
        return (str(term.datatype), f"{float(term):.10g}")
    datatype = term.datatype or (None if term.language else XSD.string)
    return (str(term), str(datatype), (term.language or "").lower())


def bag(rows):
    return collections.Counter(tuple(canonical(term) for term in row)
                               for row in rows)


def read_rows(rows):
    return [tuple(None if text is None else from_n3(text) for text in row)
            for row in rows]


def ask_rdflib(case):
    dataset = rdflib.Dataset(default_union=False)
    dataset.default_context.parse(data=case["default"], format="nt")
    for name, text in case["named"].items():
        dataset.graph(rdflib.URIRef(name)).parse(data=text, format="nt")
    result = dataset.query(case["query"])
    if result.type == "CONSTRUCT":
        return list(result.graph)
    return [tuple(row.asdict().get(name) for name in case["variables"])
            for row in result]


class Oxigraph:
    """A Node.js process: one answer line per input line."""

    def __init__(self, modules):
        self._process = subprocess.Popen(
            ["node", ORACLE, modules], stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, text=True)

    def __call__(self, case):
        self._process.stdin.write(json.dumps(case) + "\n")
        self._process.stdin.flush()
        answer = json.loads(self._process.stdout.readline())
        if "error" in answer:
            raise ValueError(answer["error"])
        return read_rows(answer["rows"])


def describe(case, ours, theirs):
    print(f"seed {case['seed']}: {case['query']}")
    for name, text in [("default", case["default"]), *case["named"].items()]:
        print(f"  {name}:\n    " + text.replace("\n", "\n    "))
    for title, rows in (("ours only", ours - theirs),
                        ("theirs only", theirs - ours)):
        for row, count in sorted(rows.items(), key=str)[:5]:
            print(f"  {title} ({count}): {row}")


def main():
    engine = {"rdflib": lambda: ask_rdflib,
              "oxigraph": lambda: Oxigraph(sys.argv[2])}[sys.argv[1]]()
    cases = differences = 0
    for line in sys.stdin:
        case = json.loads(line)
        cases += 1
        ours, theirs = bag(read_rows(case["rows"])), bag(engine(case))
        if ours != theirs:
            differences += 1
            describe(case, ours, theirs)
    print(f"cases {cases}, differences {differences}")
    sys.exit(differences > 0 or cases == 0)


if __name__ == "__main__":
    main()
