"""SPARQL SELECT and ASK through the service kg/query, as plain Python values.

    rows = KgQuery().select('SELECT ?id WHERE { ?a a ex:Agent ; ex:id ?id }')
    rows.world_version, rows[0]['id']
"""

import json

import rospy
from kg_msgs.srv import Query

PREFIXES = """
PREFIX ex: <http://example.org/mission/>
PREFIX geo: <http://www.opengis.net/ont/geosparql#>
PREFIX graph: <http://example.org/mission/graph/>
PREFIX prov: <http://www.w3.org/ns/prov#>
PREFIX time: <http://www.w3.org/2006/time#>
"""


class QueryError(RuntimeError):
    """The service refused the query; says why in one line."""


class Rows(list):
    """Solutions, one dict each (an unbound variable is missing in it)."""

    def __init__(self, world_version, solutions):
        super().__init__(solutions)
        self.world_version = world_version


class KgQuery:
    """A client of kg/query."""

    def __init__(self):
        self._service = rospy.ServiceProxy('kg/query', Query)

    def wait(self, timeout_s):
        self._service.wait_for_service(timeout_s)

    def answer(self, query):
        """The service's own answer; raises QueryError if it is not ok."""
        answer = self._service(query=PREFIXES + query, format='json')
        if not answer.ok:
            raise QueryError(answer.error)
        return answer

    def select(self, query):
        answer = self.answer(query)
        bindings = json.loads(answer.result)['results']['bindings']
        return Rows(answer.world_version,
                    [{name: term['value'] for name, term in row.items()}
                     for row in bindings])

    def ask(self, query):
        return json.loads(self.answer(query).result)['boolean']
