#!/usr/bin/env python3
"""SPARQL through the service kg/query, as plain Python values

    rows = KgQuery().select('SELECT ?id WHERE { ?a a ex:Agent ; ex:id ?id }')
    rows.world_version, rows[0]['id']

or as a table, from a file or from a query of config/queries by name, with
values for its parameters (terms in Turtle syntax):

    rosrun mission kg_query.py who_said subject=ex:alpha
"""

import json
import os
import sys

import rospkg
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
    """The service rejected the query; the reason in one line."""


class Rows(list):
    """Solutions, one dict each; unbound variables are absent."""

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
        """The service response; raises QueryError if it is not ok."""
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


def query_text(name):
    """The text of a file, or of the shipped query with that name."""
    shipped = os.path.join(rospkg.RosPack().get_path('mission'), 'config',
                           'queries', name + '.rq')
    path = shipped if os.path.isfile(shipped) else name
    with open(path) as file:
        return file.read()


def values_clause(parameters):
    """A VALUES clause from 'name=term' pairs: variable and required value."""
    if not parameters:
        return ''
    pairs = [parameter.split('=', 1) for parameter in parameters]
    return '\nVALUES (%s) { (%s) }' % (
        ' '.join('?' + name for name, _ in pairs),
        ' '.join(term for _, term in pairs))


def main(arguments):
    if not arguments or any('=' not in one for one in arguments[1:]):
        sys.exit('usage: kg_query.py FILE_OR_NAME [PARAMETER=TERM ...]')
    rospy.init_node('kg_query', anonymous=True, disable_signals=True)
    try:
        answer = KgQuery().answer(query_text(arguments[0]) +
                                  values_clause(arguments[1:]))
    except (OSError, QueryError, rospy.ServiceException) as error:
        sys.exit(str(error))
    print(answer.text, end='')


if __name__ == '__main__':
    main(sys.argv[1:])
