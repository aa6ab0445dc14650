#!/usr/bin/env python3
"""Ontology and shapes, read by a second parser (rdflib)."""

import pathlib
import re
import unittest

import rdflib
from rdflib import OWL, RDF, RDFS, SH

PACKAGE = pathlib.Path(__file__).resolve().parent.parent / "src" / "kg_mission"
ONTOLOGY = PACKAGE / "ontology"
EX = rdflib.Namespace("http://example.org/mission/")
TIME = rdflib.Namespace("http://www.w3.org/2006/time#")
GEO = rdflib.Namespace("http://www.opengis.net/ont/geosparql#")
STANDARDS = {
    "prov": "http://www.w3.org/ns/prov#",
    "time": str(TIME),
    "geo": str(GEO),
    "ssn": "http://www.w3.org/ns/ssn/",
    "sosa": "http://www.w3.org/ns/sosa/",
    "ex": str(EX),
}
# Fig. 2 of the paper.
TREE = {
    EX.MissionEntity: (EX.Agent, EX.Policy, EX.Mission, EX.Event),
    EX.SpatiotemporalEntity: (EX.TimeWindow, EX.GridSpec, EX.WorkField,
                              EX.ValueLayer, EX.Constraint),
    TIME.TemporalEntity: (EX.TimeWindow,),
    EX.Artifact: (EX.TensorArtifact, EX.NavGraph, EX.Waypoint,
                  EX.TraverseEdge, EX.EdgeCost),
    rdflib.PROV.Activity: (EX.CompilePhi2, EX.PlanRun),
}
PREFIXES = "".join(f"@prefix {name}: <{iri}> .\n" for name, iri in {
    **STANDARDS, "xsd": str(rdflib.XSD), "rdfs": str(RDFS),
    "rdf": str(RDF)}.items())


class TheOntology(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.graph = rdflib.Graph().parse(ONTOLOGY / "mission.ttl")
        cls.shapes = rdflib.Graph().parse(ONTOLOGY / "shapes.ttl")

    def test_declares_the_prefixes_of_the_standards(self):
        text = (ONTOLOGY / "mission.ttl").read_text()
        declared = dict(re.findall(r"@prefix (\w+): <([^>]+)> \.", text))
        for name, iri in STANDARDS.items():
            self.assertEqual(iri, declared[name])

    def test_holds_the_tree_of_the_paper(self):
        for top, below in TREE.items():
            found = set(self.graph.transitive_subjects(RDFS.subClassOf, top))
            for term in below:
                self.assertIn(term, found)
                self.assertIn((term, RDF.type, OWL.Class), self.graph)

    def test_types_nothing_by_domain_or_range(self):
        self.assertFalse(list(self.graph.triples((None, RDFS.domain, None))))
        self.assertFalse(list(self.graph.triples((None, RDFS.range, None))))

    def test_says_domain_range_and_meaning_of_every_property(self):
        query = """SELECT ?p { ?p a ?kind
            VALUES ?kind { owl:ObjectProperty owl:DatatypeProperty rdf:Property }
            FILTER (NOT EXISTS { ?p rdfs:comment ?c ; rdfs:label ?l ;
                                 ex:domainIncludes ?d ; ex:rangeIncludes ?r })
            }"""
        self.assertFalse(list(self.graph.query(
            query, initNs={"ex": EX, "owl": OWL, "rdfs": RDFS, "rdf": RDF})))

    def test_is_what_the_shapes_speak_of(self):
        kinds = (OWL.ObjectProperty, OWL.DatatypeProperty, RDF.Property,
                 OWL.AnnotationProperty)
        for node in self.shapes.objects(None, SH.path):
            steps = ([node] if isinstance(node, rdflib.URIRef) else
                     rdflib.collection.Collection(self.shapes, node))
            for step in steps:
                self.assertTrue(any((step, RDF.type, kind) in self.graph
                                    for kind in kinds), step)
        for target in self.shapes.objects(None, SH.targetClass):
            self.assertIn((target, RDF.type, OWL.Class), self.graph)


class TheShapes(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.shapes = rdflib.Graph().parse(ONTOLOGY / "shapes.ttl")

    def test_have_names_and_say_what_they_expect(self):
        names = set(self.shapes.subjects(RDF.type, SH.NodeShape))
        self.assertGreater(len(names), 35)
        for shape in names:
            self.assertIsInstance(shape, rdflib.URIRef)
            self.assertTrue(self.shapes.value(shape, SH.message), shape)
            self.assertTrue(self.shapes.value(shape, RDFS.label), shape)
            for node in self.shapes.objects(shape, SH.property):
                message = self.shapes.value(node, SH.message)
                self.assertTrue(message, (shape, list(
                    self.shapes.objects(node, SH.path))))

    def test_have_bad_examples_that_are_turtle(self):
        files = sorted((PACKAGE / "test" / "shacl_bad").glob("*.ttl"))
        self.assertGreater(len(files), 150)
        for file in files:
            with self.subTest(file=file.name):
                text = file.read_text()
                rdflib.Graph().parse(data=PREFIXES + text, format="turtle")
                self.assertRegex(text, r"\A# Refused: .+\n# shape: ex:\w+\n"
                                       r"# path: .+\n")


if __name__ == "__main__":
    unittest.main()
