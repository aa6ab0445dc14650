#!/usr/bin/env python3
"""Access to the facts: SPARQL over HTTP with real clients (curl, rdflib),
watched queries, and expensive queries that must not block other clients.
"""

import concurrent.futures
import json
import os
import socket
import subprocess
import sys
import threading
import urllib.error
import urllib.parse
import urllib.request

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import rdflib
import rosnode
import rospy
from kg_msgs.msg import WatchedAnswer
from kg_msgs.srv import Query, Watch
from mission_test import CHANGE_S, Heard, main, node_pid, wait_until
from rdflib.plugins.stores.sparqlstore import SPARQLStore, SPARQLUpdateStore
from readme_test import blocks
from small_mission_case import SmallMissionTestCase

TOKEN = 'only-for-this-test-0123456789'
README_PORT = '8484'
EX = rdflib.Namespace('http://example.org/mission/')
FACTS = rdflib.URIRef('http://example.org/mission/graph/facts')
AGENTS = 'SELECT ?id { ?a a ex:Agent ; ex:id ?id } ORDER BY ?id'
HOSTILE = (
    'SELECT (COUNT(*) AS ?n) { ?a ?b ?c . ?d ?e ?f . ?g ?h ?i . ?j ?k ?l }',
    'SELECT ?a ?z { ?a (!ex:nothing|^ex:nothing)+ ?z . '
    '?y (!ex:nothing|^ex:nothing)+ ?x . ?w (!ex:no|^ex:no)+ ?v }',
    'SELECT ?a ?d ?g { ?a ?b ?c . ?d ?e ?f . ?g ?h ?i } '
    'ORDER BY DESC(CONCAT(STR(?c), STR(?f), STR(?i)))',
)


def free_port():
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


def ids(result):
    return [row['id']['value'] for row in result['results']['bindings']]


class EndpointTest(SmallMissionTestCase):
    @classmethod
    def prepare(cls):
        super().prepare()
        cls.port = free_port()
        cls.url = 'http://127.0.0.1:%d' % cls.port
        cls.token_file = cls.file('token')
        with open(cls.token_file, 'w',
                  opener=lambda path, flags: os.open(path, flags, 0o600)) as f:
            f.write(TOKEN + '\n')
        cls.arguments = dict(cls.arguments, http_port=str(cls.port),
                             http_token_file=cls.token_file,
                             http_writable='true')

    def setUp(self):
        self.headers = {'Authorization': 'Bearer ' + TOKEN}
        wait_until(lambda: self.port_answers(), CHANGE_S, 'the HTTP port')

    def port_answers(self):
        with socket.socket() as probe:
            return probe.connect_ex(('127.0.0.1', self.port)) == 0

    def fetch(self, path, data=None, method=None, **headers):
        """Status and body; headers with '_' for '-'."""
        request = urllib.request.Request(
            self.url + path, data=data, method=method,
            headers=dict(self.headers, **{name.replace('_', '-'): value
                                          for name, value in headers.items()}))
        try:
            with urllib.request.urlopen(request, timeout=60) as response:
                return response.status, response.read().decode()
        except urllib.error.HTTPError as error:
            return error.code, error.read().decode()

    def query(self, query):
        status, body = self.fetch(
            '/sparql?' + urllib.parse.urlencode({'query': query}))
        self.assertEqual(200, status, body)
        return json.loads(body)

    def update(self, text, **headers):
        return self.fetch('/sparql', text.encode(), 'POST',
                          Content_Type='application/sparql-update', **headers)

    # HTTP.

    def test_1_curl_does_what_the_readme_says(self):
        commands = [line for block in blocks('sh http')
                    for line in block.splitlines()]
        self.assertGreater(len(commands), 2)
        for command in commands:
            command = command.replace(README_PORT, str(self.port)).replace(
                '~/.kg_token', self.token_file)
            done = subprocess.run(command, shell=True, timeout=CHANGE_S,
                                  stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True)
            self.assertEqual(0, done.returncode, command + '\n' + done.stdout)
            self.assertIn('world version' if 'update=' in command else 'alpha',
                          done.stdout, command)
        self.assertTrue(self.mission.ask(
            'ASK { ex:alpha ex:usesPolicy ex:safe }'))

    def test_1_is_closed_without_its_token(self):
        for headers in ({}, {'Authorization': 'Bearer wrong'}):
            self.headers = headers
            for path in ('/sparql?query=ASK%7B%7D', '/graphs/facts', '/'):
                self.assertEqual(401, self.fetch(path)[0], path)
            self.assertEqual(401, self.update('CLEAR DEFAULT')[0])

    def test_2_rdflib_queries(self):
        known = ids(self.query(AGENTS))
        self.assertEqual([row['id'] for row in self.mission.select(AGENTS)],
                         known)
        for method in ('GET', 'POST', 'POST_FORM'):
            for form in ('xml', 'json'):
                graph = rdflib.Graph(SPARQLStore(
                    self.url + '/sparql', method=method, returnFormat=form,
                    headers=dict(self.headers)))
                rows = graph.query(AGENTS, initNs={'ex': EX})
                self.assertEqual(known, [str(row.id) for row in rows])
                self.assertTrue(graph.query(
                    'ASK { ?a a <%sAgent> }' % EX).askAnswer)
        graph = rdflib.Graph(SPARQLStore(self.url + '/sparql',
                                         headers=dict(self.headers)))
        made = graph.query('CONSTRUCT { ?a a ?c ; ex:id ?i } '
                           'WHERE { ?a a ?c ; ex:id ?i }', initNs={'ex': EX})
        self.assertIn((EX.alpha, EX.id, rdflib.Literal('alpha')), made.graph)
        facts = rdflib.Graph(SPARQLStore(self.url + '/sparql',
                                         headers=dict(self.headers)), FACTS)
        self.assertIn((EX.alpha, rdflib.RDF.type, EX.Agent), facts)
        whole = rdflib.Graph().parse(data=self.fetch(
            '/graphs/facts', Accept='application/n-triples')[1], format='nt')
        self.assertEqual(len(whole), len(facts))
        self.assertEqual(whole.value(EX.alpha, EX.usesPolicy),
                         facts.value(EX.alpha, EX.usesPolicy))

    def test_3_rdflib_updates_and_the_mission_follows(self):
        store = SPARQLUpdateStore(self.url + '/sparql', self.url + '/sparql',
                                  headers=dict(self.headers,
                                               From='rdflib@ship'))
        graph = rdflib.Graph(store, FACTS)
        self.mission.wait_for_plan()
        graph.add((EX.alpha, rdflib.RDFS.label, rdflib.Literal('Älpha "1"')))
        self.assertEqual(rdflib.Literal('Älpha "1"'),
                         graph.value(EX.alpha, rdflib.RDFS.label))
        report = self.mission.updates.wait(
            lambda report: report.author == 'rdflib@ship')
        self.assertTrue(report.accepted)
        self.assertTrue(self.mission.ask(
            'ASK { GRAPH graph:prov { ?s ex:author "rdflib@ship" } }'))
        store.update('DELETE { ?a ex:usesPolicy ?p } '
                     'INSERT { ?a ex:usesPolicy ex:fast } '
                     'WHERE { ?a ex:id "alpha" ; ex:usesPolicy ?p }',
                     initNs={'ex': EX})
        version = self.mission.updates.last.world_version
        self.mission.wait_for_plan(version)
        graph.remove((EX.alpha, rdflib.RDFS.label, None))
        self.assertFalse(self.mission.ask('ASK { ex:alpha rdfs:label ?l }'))

    def test_3_a_refused_update_says_why_and_changes_nothing(self):
        before = self.fetch('/graphs/facts')
        status, why = self.update(
            'INSERT DATA { ex:w1 ex:confidence 1.2 }', From='careless')
        self.assertEqual(422, status)
        self.assertIn('ex:confidence', why)
        report = self.mission.updates.wait(
            lambda report: report.author == 'careless')
        self.assertFalse(report.accepted)
        self.assertEqual(why.splitlines(), report.reasons)
        status, why = self.fetch('/graphs/vocab', b'', 'PUT',
                                 Content_Type='text/turtle')
        self.assertEqual(403, status)
        status, why = self.fetch('/graphs/facts', b'', 'DELETE')
        self.assertEqual(422, status, why)
        self.assertEqual(before, self.fetch('/graphs/facts'))

    def test_3_what_was_read_can_be_put_back(self):
        status, facts = self.fetch('/graphs/facts')
        self.assertEqual(200, status)
        version = self.mission.world.last.world_version
        status, said = self.fetch('/graphs/facts', facts.encode(), 'PUT',
                                  Content_Type='text/turtle')
        self.assertEqual(200, status, said)
        self.assertEqual('world version %d\n' % version, said)

    def test_4_fifty_ask_while_facts_change(self):
        def choose(policy):
            return self.update(
                'DELETE { ?a ex:usesPolicy ?p } '
                'INSERT { ?a ex:usesPolicy ex:%s } '
                'WHERE { ?a a ex:Agent ; ex:usesPolicy ?p }' % policy)[0]
        self.assertEqual(200, choose('safe'))
        count = 'SELECT (COUNT(DISTINCT ?p) AS ?id) { ?a ex:usesPolicy ?p }'
        with concurrent.futures.ThreadPoolExecutor(50) as pool:
            answers = [pool.submit(self.query, count) for _ in range(200)]
            for policy in 4 * ('fast', 'safe'):
                self.assertEqual(200, choose(policy))
            self.assertEqual([['1']] * 200,
                             [ids(answer.result()) for answer in answers])

    # Expensive queries.

    def test_5_hostile_queries_end_and_block_no_other(self):
        hostile = [rospy.ServiceProxy('kg/query', Query) for _ in HOSTILE]
        ended = threading.Event()
        answers = []

        def run(service, query):
            answers.append(service(query=query))
            ended.set()
        threads = [threading.Thread(target=run, args=pair)
                   for pair in zip(hostile, HOSTILE)]
        for thread in threads:
            thread.start()
        probes = updates = 0
        while not ended.is_set():
            self.mission.select(AGENTS)
            probes += not ended.is_set()
            if probes == 5:
                report = self.mission.update(
                    set=[('ex:alpha', 'rdfs:label', '"while they ran"')])
                self.assertTrue(report.accepted, report.reasons)
                updates += not ended.is_set()
        for thread in threads:
            thread.join()
        self.assertGreater(probes, 5)
        self.assertEqual(1, updates)
        for answer in answers:
            self.assertFalse(answer.ok, answer.text[:200])
            self.assertIn('limit', answer.error)
        status, why = self.fetch('/sparql?' + urllib.parse.urlencode(
            {'query': HOSTILE[0]}))
        self.assertEqual(503, status)
        self.assertIn('limit', why)

    # Watches.

    def watch(self, **request):
        rospy.wait_for_service('kg/watch', CHANGE_S)
        return rospy.ServiceProxy('kg/watch', Watch)(**request)

    def test_6_a_watch_tells_of_every_change_at_last(self):
        told = Heard('kg/watched', WatchedAnswer)
        self.addCleanup(told.close)
        begun = self.watch(id='labels',
                           query='SELECT ?id { ?a rdfs:label ?id }')
        self.assertTrue(begun.ok, begun.error)
        held = ids(json.loads(begun.result))
        for number in range(30):
            self.mission.update(set=[('ex:bravo', 'rdfs:label',
                                    '"bravo %d"' % number)])
        last = told.wait(lambda message: message.id == 'labels' and
                         'bravo 29' in ids(json.loads(message.result)))
        for message in [m for m in told.messages if m.id == 'labels']:
            self.assertFalse(message.first)
            self.assertEqual('', message.error)
            for label in ids(json.loads(message.removed)):
                held.remove(label)
            held += ids(json.loads(message.added))
            self.assertEqual(sorted(ids(json.loads(message.result))),
                             sorted(held))
        self.assertEqual(last.world_version,
                         self.mission.world.last.world_version)

    def test_6_what_cannot_be_watched_is_refused(self):
        for query, why in (('ASK { ?a ?b ?c }', 'SELECT'),
                           ('SELECT ?a', '1:'),
                           (HOSTILE[0], 'limit')):
            answer = self.watch(query=query)
            self.assertFalse(answer.ok)
            self.assertIn(why, answer.error)
        self.assertIn("no watch 'none'",
                      self.watch(id='none', cancel=True).error)

    def test_7_plans_and_states_are_watched_too(self):
        told = Heard('kg/watched', WatchedAnswer)
        self.addCleanup(told.close)
        self.assertTrue(self.watch(
            id='run', query='SELECT ?id { ex:state ex:cycle ?id }').ok)
        self.mission.update(set=[('ex:alpha', 'ex:usesPolicy', 'ex:fast')])
        told.wait(lambda message: message.id == 'run' and not message.error)
        self.assertTrue(self.watch(id='run', cancel=True).ok)

    def test_8_a_restart_keeps_watches_and_reopens_the_endpoint(self):
        self.watch(id='agents', query=AGENTS)
        told = Heard('kg/watched', WatchedAnswer)
        self.addCleanup(told.close)
        before = node_pid('/kg')
        rosnode.kill_nodes(['/kg'])
        wait_until(lambda: node_pid('/kg') not in (None, before), CHANGE_S,
                   'another kg')
        message = told.wait(lambda message: message.id == 'agents')
        self.assertTrue(message.first)
        self.assertEqual(message.result, message.added)
        wait_until(self.port_answers, CHANGE_S, 'the HTTP port')
        self.assertEqual(ids(json.loads(message.result)),
                         ids(self.query(AGENTS)))


if __name__ == '__main__':
    main('endpoint', EndpointTest)
