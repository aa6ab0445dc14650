#!/usr/bin/env python3
"""Writes docs/schema.md from the ontology and its shapes.

    schema_doc.py            writes docs/schema.md
    schema_doc.py -          prints it

The same files give the same text: everything is sorted, or in the order of the
ontology's own text.
"""

import pathlib
import re
import sys

import rdflib
from rdflib import OWL, RDF, RDFS, SH

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
ONTOLOGY = REPOSITORY / "src" / "kg_core" / "ontology"
TARGET = REPOSITORY / "docs" / "schema.md"
NAMESPACES = (REPOSITORY / "src" / "kg_core" / "kg_core" / "rdf" /
              "namespaces.h")
EX = rdflib.Namespace("http://example.org/mission/")

HEAD = """\
# Schema

Classes and properties of the facts, as `src/kg_core/ontology/mission.ttl`
defines them and `src/kg_core/ontology/shapes.ttl` checks them. Written by
`scripts/schema_doc.py`; a test compares.

`n` is how many values a subject may have: `1` exactly one, `0..1` at most one,
`1..*` one or more, `*` any number. A number may be written as an integer, a
decimal or a double. What a value must be stands after "Checked:", in the words
of the refusal. A class has the properties of the classes above it, too.
"""


def read():
    graph = rdflib.Graph()
    for name in ("mission.ttl", "shapes.ttl"):
        graph.parse(ONTOLOGY / name, format="turtle")
    return graph


def constants():
    """Prefixes, and named graphs with their comments, of namespaces.h."""
    text = NAMESPACES.read_text()
    values = dict(re.findall(
        r'constexpr char (k\w+)\[\]\s*=\s*"([^"]+)"', text))
    prefixes = [(name, values[key])
                for name, key in re.findall(r'\{"(\w+)",\s*(k\w+)\}', text)]
    graphs = [(values[key], " ".join(comment.replace("//", " ").split()))
              for comment, key in re.findall(
                  r"((?:^//.*\n)+)inline constexpr char "
                  r"(k\w*Graph(?:Prefix)?)\[\]", text, re.M)
              if key in values and key != "kGraph"]
    return prefixes, graphs


class Schema:
    """The document, a list of lines."""

    def __init__(self):
        self.graph = read()
        self.prefixes, self.graphs = constants()
        self.order = self._order()
        self.lines = []

    def _order(self):
        """Place of each term in the ontology's text."""
        text = (ONTOLOGY / "mission.ttl").read_text()
        names = re.findall(r"^([\w]+:[\w]+) a ", text, re.M)
        return {name: place for place, name in enumerate(names)}

    def name(self, term):
        # The longest namespace wins: graph: lies within ex:.
        for prefix, iri in sorted(self.prefixes, key=lambda p: -len(p[1])):
            if str(term).startswith(iri):
                return f"{prefix}:{str(term)[len(iri):]}"
        return f"<{term}>"

    def sorted(self, terms):
        return sorted(set(terms), key=lambda term: (
            self.order.get(self.name(term), len(self.order)), self.name(term)))

    def text(self, term, property_):
        value = self.graph.value(term, property_)
        return " ".join(str(value).split()) if value is not None else ""

    def classes(self):
        return self.sorted(self.graph.subjects(RDF.type, OWL.Class))

    def properties(self):
        kinds = (OWL.ObjectProperty, OWL.DatatypeProperty, RDF.Property,
                 OWL.AnnotationProperty)
        return self.sorted(term for kind in kinds
                           for term in self.graph.subjects(RDF.type, kind))

    def say(self, *lines):
        self.lines.extend(lines)

    # The tree.

    def tree(self):
        self.say("", "## Class tree", "", "```")
        all_classes = set(self.classes())
        tops = [term for term in all_classes
                if not all_classes & set(
                    self.graph.objects(term, RDFS.subClassOf))]
        for top in self.sorted(tops):
            self.branch(top, 0)
        self.say("```")

    def branch(self, term, depth):
        name = "  " * depth + self.name(term)
        self.say(f"{name:<34}{self.text(term, RDFS.label)}")
        for below in self.sorted(self.graph.subjects(RDFS.subClassOf, term)):
            self.branch(below, depth + 1)

    # Classes.

    def above(self, term):
        """The class and all above it."""
        return set(self.graph.transitive_objects(term, RDFS.subClassOf))

    def shapes(self, term):
        targets = [(shape, target) for shape, target
                   in self.graph.subject_objects(SH.targetClass)]
        return self.sorted(shape for shape, target in targets
                           if target in self.above(term))

    def own_shape(self, term):
        shapes = self.sorted(self.graph.subjects(SH.targetClass, term))
        return shapes[0] if shapes else None

    def property_shapes(self, term, path):
        return [node for shape in self.shapes(term)
                for node in self.graph.objects(shape, SH.property)
                if (node, SH.path, path) in self.graph]

    def count(self, nodes):
        """How many values, of all shapes together."""
        least = max([int(value) for node in nodes for value in
                     self.graph.objects(node, SH.minCount)], default=0)
        most = min([int(value) for node in nodes for value in
                    self.graph.objects(node, SH.maxCount)], default=None)
        if most is None:
            return "1..*" if least else "*"
        return str(most) if least == most else f"{least}..{most}"

    def meaning(self, path, nodes):
        text = self.text(path, RDFS.comment)
        for node in nodes:
            checked = self.text(node, SH.message)
            if checked:
                text += f" Checked: {checked.removeprefix('expected ')}."
        return text.replace("|", "\\|")

    def row(self, term, path):
        nodes = self.property_shapes(term, path)
        ranges = ", ".join(f"`{self.name(value)}`" for value in self.sorted(
            self.graph.objects(path, EX.rangeIncludes)))
        self.say(f"| `{self.name(path)}` | {ranges} | "
                 f"{self.text(path, EX.unit)} | {self.count(nodes)} | "
                 f"{self.meaning(path, nodes)} |")

    def section(self, term):
        self.say("", f"### {self.name(term)}", "",
                 self.text(term, RDFS.comment) or self.text(term, RDFS.label))
        self.say(*self.notes(term))
        own = [path for path in self.properties()
               if term in self.graph.objects(path, EX.domainIncludes)]
        if own:
            self.say("", "| property | values | unit | n | meaning |",
                     "|---|---|---|---|---|")
        for path in own:
            self.row(term, path)

    def notes(self, term):
        parents = self.sorted(
            parent for parent in self.graph.objects(term, RDFS.subClassOf)
            if parent != OWL.Thing)
        if parents:
            yield ""
            yield ("Is also: " + ", ".join(
                f"`{self.name(parent)}`" for parent in parents) + ".")
        shape = self.own_shape(term)
        rule = self.text(shape, SH.message) if shape is not None else ""
        if rule:
            yield ""
            yield f"Checked by `{self.name(shape)}`: {rule}."
        key = self.graph.value(term, OWL.hasKey)
        if key is not None:
            yield ""
            yield ("Key: " + ", ".join(
                f"`{self.name(part)}`" for part in
                rdflib.collection.Collection(self.graph, key)) +
                "; no two share it.")
        alias = self.graph.value(term, OWL.equivalentClass)
        if alias is not None:
            yield ""
            yield (f"Another name: stored as `{self.name(alias)}`.")

    # The rest.

    def other_properties(self):
        """Those of no class of ours."""
        known = set(self.classes())
        rest = [path for path in self.properties()
                if not known & set(self.graph.objects(path,
                                                      EX.domainIncludes))]
        self.say("", "## Properties of anything", "",
                 "| property | values | meaning |", "|---|---|---|")
        for path in rest:
            ranges = ", ".join(f"`{self.name(value)}`" for value in
                               self.sorted(self.graph.objects(
                                   path, EX.rangeIncludes)))
            self.say(f"| `{self.name(path)}` | {ranges} | "
                     f"{self.text(path, RDFS.comment)} |")

    def other_names(self):
        self.say("", "## Other names", "",
                 "Accepted in facts, and stored as what they stand for.", "",
                 "| name | stored as |", "|---|---|")
        for kind in (OWL.equivalentClass, OWL.equivalentProperty):
            for term in self.sorted(self.graph.subjects(kind, None)):
                stored = self.name(self.graph.value(term, kind))
                self.say(f"| `{self.name(term)}` | `{stored}` |")

    def places(self):
        self.say("", "## Named graphs", "", "| graph | what |", "|---|---|")
        for iri, comment in self.graphs:
            name = iri.removeprefix(str(EX))
            if name.endswith("/"):
                name += "<run>"
            self.say(f"| `ex:{name}` | {comment} |")
        self.say("", "## Prefixes", "",
                 "Known in facts and queries without being declared.", "",
                 "| prefix | namespace |", "|---|---|")
        for prefix, iri in self.prefixes:
            self.say(f"| `{prefix}:` | `{iri}` |")

    def document(self):
        self.tree()
        self.say("", "## Classes")
        for term in self.classes():
            if self.text(term, RDFS.comment) or self.own_shape(term):
                self.section(term)
        self.other_properties()
        self.other_names()
        self.places()
        return HEAD + "\n".join(self.lines) + "\n"


def main():
    document = Schema().document()
    if sys.argv[1:] == ["-"]:
        sys.stdout.write(document)
    else:
        TARGET.write_text(document)


if __name__ == "__main__":
    main()
