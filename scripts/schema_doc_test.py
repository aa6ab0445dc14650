#!/usr/bin/env python3
"""docs/schema.md is up to date with the ontology and the shapes, and complete."""

import re
import unittest

import schema_doc


class TheDocument(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.schema = schema_doc.Schema()
        cls.text = cls.schema.document()

    def test_is_up_to_date(self):
        self.assertEqual(self.text, schema_doc.TARGET.read_text(),
                         "run scripts/schema_doc.py and commit docs/schema.md")

    def test_is_the_same_every_time(self):
        self.assertEqual(self.text, schema_doc.Schema().document())

    def test_has_every_class_of_ours_in_tree_and_sections(self):
        classes = [name for name in map(self.schema.name,
                                        self.schema.classes())
                   if name.startswith("ex:")]
        self.assertGreater(len(classes), 30)
        for name in classes:
            with self.subTest(name=name):
                self.assertRegex(self.text, rf"(?m)^ *{name} ")
                self.assertIn(f"\n### {name}\n", self.text)

    def test_has_every_property(self):
        for path in self.schema.properties():
            name = self.schema.name(path)
            self.assertIn(f"| `{name}` |", self.text)

    def test_counts_values_as_the_shapes_do(self):
        row = re.compile(r"\| `(\S+)` \|.*?\|.*?\| (\S+) \|")
        agent = self.text.split("\n### ex:Agent\n")[1].split("\n### ")[0]
        self.assertEqual("1", dict(row.findall(agent))["ex:usesPolicy"])
        mission = self.text.split("\n### ex:Mission\n")[1].split("\n### ")[0]
        counts = dict(row.findall(mission))
        self.assertEqual("1..*", counts["ex:hasWindow"])
        self.assertEqual("0..1", counts["ex:horizon"])

    def test_has_the_named_graphs_and_prefixes_of_the_code(self):
        for name in ("facts", "vocab", "inferred", "prov", "log", "state",
                     "plan/<run>"):
            self.assertIn(f"| `ex:graph/{name}` |", self.text)
        for prefix in ("ex", "prov", "time", "geo", "ssn", "sosa"):
            self.assertIn(f"| `{prefix}:` |", self.text)


if __name__ == "__main__":
    unittest.main()
