#!/usr/bin/env python3
"""Asks a running mission what would change under hypothetical facts; the world
is not modified.

    rosrun mission what_if.py what_if_energy_budget
    rosrun mission what_if.py --update FACTS.ru --query QUESTION.rq

NAME selects NAME.ru and NAME.rq of config/queries. FACTS.ru is a SPARQL 1.1
Update on the facts, QUESTION.rq a SPARQL query on the hypothetical world (its
graphs: docs/interface.md). Exit status 1 if the update is rejected.
"""

import argparse
import os
import sys

import rospy
from kg_msgs.msg import FactUpdate
from kg_msgs.srv import WhatIf

QUERIES = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..',
                       'config', 'queries')
WAIT_S = 10.0


def read(path):
    with open(path) as file:
        return file.read()


def parse(arguments):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument('name', nargs='?', help='name of a shipped question')
    parser.add_argument('--update', help='file of a SPARQL 1.1 Update')
    parser.add_argument('--query', help='file of a SPARQL query')
    parser.add_argument('--time-limit', type=float, default=0.0,
                        help='wall-clock [s]; default 60')
    parsed = parser.parse_args(arguments)
    if parsed.name:
        parsed.update = os.path.join(QUERIES, parsed.name + '.ru')
        parsed.query = os.path.join(QUERIES, parsed.name + '.rq')
    if not parsed.update and not parsed.query:
        parser.error('expected NAME, --update or --query')
    return parsed


def main(arguments):
    asked = parse(arguments)
    try:
        update = read(asked.update) if asked.update else ''
        query = read(asked.query) if asked.query else ''
        rospy.wait_for_service('kg/what_if', WAIT_S)
        answer = rospy.ServiceProxy('kg/what_if', WhatIf)(
            update=FactUpdate(author='what_if.py', sparql=update), query=query,
            time_limit_s=asked.time_limit)
    except (OSError, rospy.ROSException, rospy.ServiceException) as error:
        print('what_if.py: %s' % error, file=sys.stderr)
        return 1
    print(answer.text.rstrip())
    return 0 if answer.ok else 1


if __name__ == '__main__':
    sys.exit(main(rospy.myargv(sys.argv)[1:]))
