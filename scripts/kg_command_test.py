#!/usr/bin/env python3
"""The program kg as a user runs it: on a mission folder, on a new store, on W3C
manifests, and with invalid command lines. Needs no ROS master."""

import json
import os
import pathlib
import re
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import unittest
import urllib.error
import urllib.parse
import urllib.request

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(REPOSITORY / "src/mission/test"))

import small_mission  # After its folder is known.

PROGRAM = REPOSITORY / "devel/lib/kg_engine/kg"
MISSIONS = REPOSITORY / "config/missions"
SUITES = pathlib.Path(os.environ.get(
    "KG_SHARED_DATA", REPOSITORY.parent / "shared/data")) / "w3c"
MORE_SUITES = REPOSITORY / "src/kg_engine/test_data/w3c"
SUBCOMMANDS = {"query", "update", "validate", "export", "import", "diff", "log",
               "conformance", "serve", "why", "check"}

FACTS = """\
ex:wind a ex:Policy ; ex:alpha_base 1.0 ; ex:name "wind \\"B\\"" .
ex:calm a ex:Policy ; ex:alpha_base 0.5 .
"""

MANIFEST = """\
@prefix mf: <http://www.w3.org/2001/sw/DataAccess/tests/test-manifest#> .
@prefix : <http://tests.example/#> .
<> a mf:Manifest ; mf:entries ( :good :%(name)s ) .
:good a mf:PositiveSyntaxTest11 ; mf:action <good.rq> .
:%(name)s a mf:%(kind)s ; mf:action <good.rq> .
"""


def kg(*words, **options):
    """Runs the program in a shell without the ROS environment."""
    environment = {"PATH": "/usr/bin:/bin", "USER": "tester"}
    return subprocess.run(
        [str(PROGRAM)] + [str(word) for word in words], capture_output=True,
        text=True, check=False, timeout=120, env=environment,
        stdin=subprocess.DEVNULL if "input" not in options else None, **options)


class KgTestCase(unittest.TestCase):

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.store = self.folder / "world.db"

    def kg(self, *words, **options):
        """The output of a command that must succeed."""
        done = kg(*words, **options)
        self.assertEqual(0, done.returncode, f"{words}: {done.stderr}")
        self.assertEqual("", done.stderr, words)
        return done.stdout

    def assert_refused(self, words, reason, status=1):
        done = kg(*words)
        self.assertEqual(status, done.returncode, f"{words}: {done.stdout}")
        self.assertEqual(1, len(done.stderr.splitlines()), done.stderr)
        self.assertIn(reason, done.stderr)
        self.assertEqual("", done.stdout)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def make_store(self):
        self.kg("import", self.store, self.file("facts.ttl", FACTS),
                "--author", "maker")
        return self.store

    def ask(self, store, query):
        return self.kg("query", store, "-e", query).strip()


class Help(KgTestCase):

    def test_lists_every_subcommand_and_each_has_its_own(self):
        listed = re.findall(r"^  (\w+) ", self.kg("--help"), re.MULTILINE)
        self.assertEqual(SUBCOMMANDS, set(listed))
        self.assertEqual(2, kg().returncode)
        for name in listed:
            text = self.kg(name, "--help")
            self.assertTrue(text.startswith(f"usage: kg {name} "), text)
            options = set(re.findall(r"(--[\w-]+)", text))
            for option in options:
                ended = kg(name, option)
                self.assertNotIn("unknown option", ended.stderr)

    def test_is_pointed_to_when_the_command_line_is_wrong(self):
        for words, reason in [
                (["queri"], "unknown subcommand queri; see kg --help"),
                (["query"], "got 0 arguments; see kg query --help"),
                (["query", "x", "--formt", "json"], "unknown option --formt"),
                (["query", "x", "--format"], "--format lacks its value"),
                (["query", "x", "-e", "a", "-e", "b"], "-e is given twice"),
                (["diff", "x", "1", "-1"], "unknown option -1"),
                (["diff", "x", "1", "two"], "not two"),
                (["update", "x"], "expected one of -e, a file"),
                (["update", "x", "set", "ex:a"], "expected set SUBJECT"),
                (["export", "x", "--format", "rdfxml"], "expected --format"),
                (["check"], "got 0 arguments; see kg check --help"),
                (["conformance"], "at least one FOLDER")]:
            self.assert_refused(words, reason, status=2)


class AMissionFolder(KgTestCase):

    def test_is_queried_in_every_format(self):
        query = "SELECT ?id { ?a a ex:Agent ; ex:id ?id } ORDER BY ?id"
        run = kg("query", MISSIONS / "tampico", "-e", query)
        self.assertEqual(0, run.returncode, run.stderr)
        self.assertIn("files say is left out", run.stderr)
        self.assertEqual(1, len(run.stderr.splitlines()))
        self.assertRegex(run.stdout, r'(?m)^[^"]*"alpha"')
        answer = kg("query", MISSIONS / "tampico", "-e", query, "--format",
                    "json").stdout
        ids = [row["id"]["value"]
               for row in json.loads(answer)["results"]["bindings"]]
        self.assertIn("alpha", ids)
        self.assertEqual(
            "\r\n".join(["id"] + ids) + "\r\n",
            kg("query", MISSIONS / "tampico", "-e", query, "--format",
               "csv").stdout.replace("\r\n", "\n").replace("\n", "\r\n"))

    def test_that_ships_is_valid(self):
        for mission in ("gulf", "tampico"):
            done = kg("validate", MISSIONS / mission)
            self.assertEqual(0, done.returncode, done.stdout)
            self.assertTrue(done.stdout.endswith("0 violations\n"))
            # Their files need not be there; then only that is told.
            for line in done.stderr.splitlines():
                self.assertRegex(line, "is left out: .* not found")
            self.assertIn("sh:conforms true", self.kg(
                "validate", MISSIONS / mission / "mission.ttl", "--report"))

    def test_is_not_changed_but_says_what_it_would_accept(self):
        change = ["update", MISSIONS / "gulf", "set", "ex:alpha",
                  "ex:usesPolicy"]
        self.assert_refused(change + ["ex:safe"], "is not changed")
        checked = kg(*change, "ex:safe", "--check")
        self.assertEqual(0, checked.returncode, checked.stderr)
        refused = kg(*change, "ex:nosuch", "--check")
        self.assertEqual(1, refused.returncode)
        self.assertIn("refused: ", refused.stderr)


class AMissionWithItsFiles(KgTestCase):

    def setUp(self):
        super().setUp()
        self.mission = self.folder / "small"
        self.mission.mkdir()
        small_mission.write_mission(self.mission)

    def with_facts(self, turtle):
        with open(self.mission / "mission.ttl", "a") as file:
            file.write(turtle)

    def findings(self, target):
        """What `kg validate` says besides what was read of the files."""
        lines = self.kg("validate", target).splitlines()
        read = [line for line in lines if line.startswith("data: ")]
        self.assertEqual(["ex:currents", "ex:currents", "ex:sst"],
                         [line.split(": ")[1] for line in read])
        for line in read:
            self.assertRegex(line, "5 times, .*every 24 h, 0 missing; "
                                   "3000 cells, 10 % without data$")
        return [line for line in lines if line not in read]

    def test_is_validated_with_its_files(self):
        self.assertEqual(["0 violations"], self.findings(self.mission))
        ocean = self.mission / "ocean.nc"
        small_mission.write_ocean(ocean, days=2)  # Too short for the windows.
        for _ in range(2):
            done = kg("validate", self.mission)
            self.assertEqual(1, done.returncode)
            self.assertIn("ocean.nc", done.stdout)
            ocean.write_text("<html>404 Not Found</html>")
        ocean.unlink()
        done = kg("validate", self.mission)
        self.assertIn("ocean.nc", done.stderr)
        self.assertEqual("0 violations\n", done.stdout)

    def test_is_validated_with_a_word_on_facts_without_effect(self):
        self.with_facts("""
            ex:faraway a ex:Constraint ; ex:kind "no_go" ; ex:name "faraway" ;
                geo:asWKT "POLYGON((-80 26, -79 26, -79 26.5, -80 26.5, -80 26))"^^geo:wktLiteral .
            ex:ashore a ex:Event ; ex:forWindow ex:w0 ; ex:value 1 ;
                ex:radiusKm 2 ; geo:asWKT "SRID=4326;POINT Z (-91.95 26 10)"^^geo:wktLiteral .
            """)
        lines = self.findings(self.mission)
        self.assertEqual(3, len(lines), lines)
        self.assertRegex(lines[0], "^warning: ex:faraway has no effect.*off "
                                   "the grid")
        self.assertRegex(lines[1], "^warning: ex:ashore has no effect.*on land")

    def test_says_what_forbids_a_start(self):
        self.with_facts("""
            ex:harbour a ex:Constraint ; ex:kind "no_go" ; ex:name "harbour" ;
                geo:asWKT "POLYGON((-91 25.6, -90.8 25.6, -90.8 25.8, -91 25.8, -91 25.6))"^^geo:wktLiteral .
            """)
        self.assert_refused(["why", self.mission, "--agent", "bravo"],
                            "agent alpha (ex:alpha) starts at POINT(-90.9 "
                            "25.7), which is in ex:harbour")

    def test_says_what_its_files_say(self):
        self.assertEqual("yes", self.ask(self.mission, (
            "ASK { ?field a ex:CurrentField ; ex:forWindow ex:w0 ; "
            "prov:wasDerivedFrom ?file . ?file ex:sha256 ?hash }")))

    def test_says_why_in_numbers_that_sum_and_facts_that_hold(self):
        why = json.loads(self.kg("why", self.mission, "--agent", "alpha",
                                 "--window", "1", "--json"))
        parts = why["contributions"]
        self.assertAlmostEqual(why["value"],
                               sum(part["value"] for part in parts), delta=1e-9)
        self.assertIn("ex:alpha ex:usesPolicy ex:fast",
                      [fact for part in parts for fact in part["facts"]])
        facts = sorted({fact for part in parts for fact in part["facts"]
                        if "plan/" not in fact})
        self.assertEqual("yes", self.ask(
            self.mission, "ASK { " + " . ".join(facts) + " }"))
        text = self.kg("why", self.mission, "--agent", "alpha", "--cell",
                       "-90.75,25.75", "--window", "0")
        self.assertTrue(text.startswith("U of alpha in window 0 at POINT("))
        self.assert_refused(["why", self.mission, "--agent", "nobody"],
                            "agent 'nobody' is not known")
        self.assert_refused(["why", self.mission, "--cell", "1"],
                            "--cell: expected two numbers", 2)

    def test_is_not_imported_nor_changed_to_what_is_no_mission(self):
        state = self.folder / "state"
        state.mkdir()
        facts = self.mission / "mission.ttl"
        whole = facts.read_text()
        facts.write_text(whole.replace("ex:forAgent ex:bravo",
                                       "ex:forAgent ex:alpha"))
        words = ["import", state / "store.db", facts, "--data", self.mission]
        refused = kg(*words)
        self.assertEqual(1, refused.returncode, refused.stdout)
        self.assertEqual("no", self.ask(state, "ASK { ?m a ex:Mission }"))
        facts.write_text(whole)
        self.kg(*words)
        before = self.kg("export", state, "--format", "nquads")
        refused = kg("update", state, "remove", "ex:bravo_start",
                     "--data", self.mission)
        self.assertEqual(1, refused.returncode, refused.stdout)
        self.assertEqual(before, self.kg("export", state, "--format",
                                         "nquads"))

    def test_becomes_a_state_folder_with_the_same_facts(self):
        state = self.folder / "state"
        state.mkdir()
        self.kg("import", state / "store.db", self.mission / "mission.ttl",
                "--data", self.mission)
        self.assertEqual(["0 violations"], self.findings(state))
        facts = ["--graph", "graph:facts", "--format", "ntriples"]
        self.assertEqual(self.kg("export", self.mission, *facts),
                         self.kg("export", state, *facts))
        before = self.kg("export", state, "--format", "nquads")
        later = ["set", "ex:w0", "time:hasBeginning",
                 '"2026-06-02T01:00:00Z"^^xsd:dateTime']
        without = kg("update", state, *later)
        self.assertEqual(1, without.returncode)
        self.assertIn('refused: ex:currents: file "ocean.nc"', without.stderr)
        self.assertEqual(before, self.kg("export", state, "--format", "nquads"))
        self.kg("update", state, *later, "--data", self.mission)
        self.assertEqual("yes", self.ask(
            state, "ASK { ?field a ex:CurrentField ; ex:forWindow ex:w0 }"))
        checked = kg("check", state, "--data", self.mission)
        self.assertEqual(1, checked.returncode)  # Nothing was compiled yet.
        self.assertIn("differs: tensor of", checked.stdout)


class Checking(KgTestCase):

    def test_needs_a_store(self):
        self.assert_refused(["check", MISSIONS / "tampico"],
                            "expected a store")


class Facts(KgTestCase):

    def test_that_are_wrong_are_named_line_by_line(self):
        wrong = self.file("wrong.ttl", 'ex:w a ex:TimeWindow ; ex:index 0 ; '
                                       'ex:confidence 1.2 .')
        done = kg("validate", wrong)
        self.assertEqual(1, done.returncode)
        self.assertIn("ex:confidence", done.stdout)
        report = kg("validate", wrong, "--report")
        self.assertEqual(1, report.returncode)
        self.assertIn("sh:conforms false", report.stdout)
        broken = kg("validate", self.file("x.ttl", "ex:a ex:b"))
        self.assertEqual(1, broken.returncode)
        self.assertIn("x.ttl:1:", broken.stdout)


class AStore(KgTestCase):

    def test_is_made_changed_and_remembers(self):
        store = self.make_store()
        self.assertEqual("yes", self.ask(store, "ASK { ex:wind a ex:Policy }"))
        self.kg("update", store, "set", "ex:wind", "ex:alpha_base", "2.0",
                "--author", "operator")
        self.kg("update", store, "-e",
                "DELETE { ?p ex:alpha_base ?v } INSERT { ?p ex:alpha_base 3.0 }"
                " WHERE { ?p a ex:Policy ; ex:alpha_base ?v }")
        self.kg("update", store, self.file(
            "more.ttl", "ex:storm a ex:Policy ; ex:alpha_base 9.0 ."))
        self.kg("update", store, "remove", "ex:calm")
        self.assertEqual("yes", self.ask(
            store, "ASK { ex:wind ex:alpha_base 3.0 . ex:storm a ex:Policy "
                   "FILTER NOT EXISTS { ex:calm ?p ?o } }"))
        log = self.kg("log", store, "--subject", "ex:wind")
        self.assertRegex(log, (
            r"^version (\d+), \S+Z, tester\n"
            r"  - ex:wind ex:alpha_base 2.0\n  \+ ex:wind ex:alpha_base 3.0\n"
            r"version (\d+), \S+Z, operator\n"
            r"  - ex:wind ex:alpha_base 1.0\n  \+ ex:wind ex:alpha_base 2.0\n"
            r"version (\d+), \S+Z, maker \(\S+facts.ttl\)\n"))
        versions = [int(number) for number in
                    re.findall(r"^version (\d+)", self.kg("log", store),
                               re.MULTILINE)]
        self.assertEqual(sorted(versions, reverse=True), versions)
        diff = self.kg("diff", store, versions[-1], versions[0])
        lines = sorted(line.split("  # ")[0] for line in diff.splitlines())
        self.assertEqual(
            ["+ ex:storm ex:alpha_base 9.0 .", "+ ex:storm rdf:type ex:Policy .",
             "+ ex:wind ex:alpha_base 3.0 .", "- ex:calm ex:alpha_base 0.5 .",
             "- ex:calm rdf:type ex:Policy .", "- ex:wind ex:alpha_base 1.0 ."],
            lines)
        self.assertRegex(diff, r"9\.0 \.  # version \d+, \S+Z, tester\n")
        self.assertEqual("", self.kg("diff", store, versions[1], versions[1]))
        self.assert_refused(["diff", store, "0", "99"], "does not exist yet")

    def test_refuses_a_whole_update_with_its_reasons(self):
        store = self.make_store()
        before = self.kg("export", store, "--format", "nquads")
        for change in (["add", "ex:wind", "ex:alpha_bas", "1.0"],
                       ["set", "ex:wind", "ex:alpha_base", '"much"'],
                       ["-e", "INSERT DATA { ex:x a ex:Policy } ; CLEAR ALL"],
                       [self.file("bad.ttl", "ex:wind ex:alpha_base")]):
            done = kg("update", store, *change)
            self.assertEqual(1, done.returncode, change)
            self.assertTrue(done.stderr.startswith("refused: "), done.stderr)
        self.assertIn("nearest is ex:alpha_base", kg(
            "update", store, "add", "ex:wind", "ex:alpha_bas", "1").stderr)
        self.assertEqual(before, self.kg("export", store, "--format", "nquads"))
        self.assertEqual("", self.kg("update", store, "--check", "set",
                                     "ex:wind", "ex:alpha_base", "7.0"))
        self.assertEqual(before, self.kg("export", store, "--format", "nquads"))
        self.assertEqual("nothing to change\n", self.kg(
            "update", store, "set", "ex:wind", "ex:alpha_base", "1.0"))

    def test_goes_out_and_comes_back_in_every_syntax(self):
        store = self.make_store()
        self.kg("update", store, "-e",
                'INSERT DATA { ex:wind rdfs:label "l\\u00e4ng\\n"@de }')
        facts = self.kg("export", store, "--graph", "graph:facts", "--format",
                        "ntriples")
        self.assertIn('"läng\\n"@de', facts)
        for name in ("x.ttl", "x.trig", "x.nt", "x.nq"):
            file = self.folder / name
            self.kg("export", store, "--graph", "graph:facts", "-o", file)
            other = self.folder / f"{name}.db"
            self.kg("import", other, file)
            self.assertEqual(facts, self.kg(
                "export", other, "--graph",
                "http://example.org/mission/graph/facts", "--format",
                "ntriples"), name)
        self.assert_refused(["export", store, "--graph", "graph:nosuch"],
                            "there is no graph graph:nosuch")
        self.assert_refused(["export", store, "-o", "/nosuch/folder/x.ttl"],
                            "cannot be written")

    def test_takes_a_whole_export_but_keeps_its_own_log(self):
        store = self.make_store()
        whole = self.folder / "whole.trig"
        self.kg("export", store, "-o", whole)
        done = kg("import", self.folder / "other.db", whole)
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertIn("are left out", done.stderr)
        self.assertEqual(1, self.kg("log", self.folder / "other.db").count(
            "version "))

    def test_keeps_graphs_that_blank_nodes_name(self):
        self.file("in.trig", """
            _:g prov:value "measured" .
            graph:facts { _:g a ex:Policy ; ex:alpha_base 1 ; ex:name "g" }
            _:g { ex:x ex:p _:g } [] { ex:y ex:p 2 }""")
        first = self.folder / "first.db"
        self.kg("import", first, self.folder / "in.trig", "--graph",
                "http://x/about")
        for form in ("trig", "nq"):
            whole = self.folder / f"whole.{form}"
            self.kg("export", first, "-o", whole)
            again = self.folder / f"{form}.db"
            done = kg("import", again, whole)
            self.assertEqual(0, done.returncode, done.stderr)
            # One node in all graphs, and the name of one of them.
            self.assertEqual("yes", self.ask(again, """
                ASK { GRAPH <http://x/about> { ?g prov:value "measured" }
                      GRAPH graph:facts { ?g ex:name "g" }
                      GRAPH ?g { ex:x ex:p ?g } GRAPH ?h { ex:y ex:p 2 }
                      FILTER(isBlank(?g) && isBlank(?h) && ?g != ?h) }"""))

    def test_in_use_is_refused_and_points_to_the_services(self):
        store = self.make_store()
        holder = sqlite3.connect(store)
        self.addCleanup(holder.close)
        holder.execute("BEGIN EXCLUSIVE")
        self.assert_refused(["query", store, "-e", "ASK {}"], "kg/query")

    def test_that_is_not_there_is_not_made_by_asking(self):
        for words in (["query", self.store, "-e", "ASK {}"],
                      ["log", self.store], ["diff", self.store, "0", "0"],
                      ["export", self.store], ["validate", self.store],
                      ["update", self.store, "-e", "CLEAR DEFAULT"],
                      ["query", self.folder, "-e", "ASK {}"]):
            self.assert_refused(words, "expected a store")
        self.assertFalse(self.store.exists())
        self.file("world.db", "no store")
        self.assert_refused(["log", self.store], "world.db")


class Serving(KgTestCase):

    def serve(self, *words):
        process = subprocess.Popen(
            [str(PROGRAM), "serve", *[str(word) for word in words]],
            stdout=subprocess.PIPE, text=True, env={"PATH": "/usr/bin:/bin"})
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        return process.stdout.readline().strip()

    def post(self, endpoint, token, **form):
        request = urllib.request.Request(
            endpoint, urllib.parse.urlencode(form).encode(),
            {"Authorization": f"Bearer {token}", "Accept": "text/csv"})
        with urllib.request.urlopen(request, timeout=60) as answer:
            return answer.read().decode()

    def test_answers_and_changes_a_store_over_http(self):
        token = "0123456789abcdef"
        file = self.file("token", token)
        file.chmod(0o600)
        endpoint = self.serve(self.make_store(), "--port", "0",
                              "--token-file", file, "--writable")
        self.post(endpoint, token,
                  update="INSERT DATA { ex:calm ex:gamma_front 0.25 }")
        self.assertEqual("v\r\n0.25\r\n", self.post(
            endpoint, token, query="SELECT ?v { ex:calm ex:gamma_front ?v }"))
        with self.assertRaises(urllib.error.HTTPError) as refused:
            self.post(endpoint, token, update="CLEAR ALL")
        self.assertEqual(422, refused.exception.code)
        refused.exception.close()
        with self.assertRaises(urllib.error.HTTPError) as refused:
            self.post(endpoint, "fedcba9876543210", query="ASK {}")
        self.assertEqual(401, refused.exception.code)
        refused.exception.close()

    def test_of_a_mission_folder_is_read_only(self):
        self.assert_refused(
            ["serve", MISSIONS / "gulf", "--port", "0", "--writable"],
            "a mission folder is not changed")


class Conformance(KgTestCase):

    def test_prints_a_line_a_test_and_the_count_last(self):
        self.file("good.rq", "ASK {}")
        self.file("manifest.ttl", MANIFEST % {
            "name": "bad", "kind": "NegativeSyntaxTest11"})
        done = kg("conformance", self.folder)
        lines = done.stdout.splitlines()
        self.assertRegex(lines[0], "^passed .* good ")
        self.assertRegex(lines[1], "^FAILED .* bad .*: was read")
        self.assertEqual("1 passed, 1 failed", lines[-1])
        self.assertEqual(1, done.returncode)
        self.file("manifest.ttl", MANIFEST % {
            "name": "other", "kind": "ProtocolTest"})
        done = kg("conformance", self.folder)
        self.assertEqual(["1 not run", "1 passed, 0 failed"],
                         done.stdout.splitlines()[-2:])
        self.assertEqual(0, done.returncode)
        (self.folder / "manifest.ttl").unlink()
        self.assert_refused(["conformance", self.folder], "expected a manifest")

    def test_document_is_up_to_date(self):
        if not SUITES.is_dir():
            self.skipTest(f"the W3C suites are not there: {SUITES}")
        table = self.folder / "conformance.md"
        done = kg("conformance", SUITES, MORE_SUITES, "--table", table,
                  "--deviations", MORE_SUITES / "deviations.txt")
        self.assertEqual(0, done.returncode, done.stdout[-2000:])
        self.assertEqual((REPOSITORY / "docs/conformance.md").read_text(),
                         table.read_text())


class TheReadme(unittest.TestCase):

    def test_commands_of_kg_do_what_they_say(self):
        text = (REPOSITORY / "README.md").read_text()
        blocks = re.findall(r"^```sh kg\n(.*?)^```$", text,
                            re.MULTILINE | re.DOTALL)
        commands = [line for block in blocks for line in block.splitlines()]
        used = {command.split()[3] for command in commands}
        self.assertLessEqual({"query", "update", "validate", "export", "import",
                              "diff", "log"}, used)
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        for link in ("config", "devel", "src"):
            (pathlib.Path(folder) / link).symlink_to(REPOSITORY / link)
        for command in commands:
            plain = command.replace("rosrun kg_engine kg", str(PROGRAM))
            done = subprocess.run(plain, shell=True, cwd=folder, check=False,
                                  capture_output=True, text=True, timeout=120)
            self.assertEqual(0, done.returncode, f"{command}: {done.stderr}")


if __name__ == "__main__":
    unittest.main()
