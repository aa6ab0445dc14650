#!/usr/bin/env python3
"""README.md is correct: commands marked to be run succeed verbatim in a running
mission; the others name targets, arguments and files that exist; its tables
agree with the code.
"""

import os
import re
import subprocess
import sys
import xml.etree.ElementTree

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from gulf_test import AGENT_TOPICS, SERVICES, TOPICS
from mission_test import ROOT, main
from small_mission_case import SmallMissionTestCase

COMMAND_S = 60.0


def read(*path):
    with open(os.path.join(ROOT, *path)) as file:
        return file.read()


def blocks(info):
    """Fenced blocks of the README with the info string `info`."""
    return re.findall(r'^```%s\n(.*?)^```$' % re.escape(info),
                      read('README.md'), re.MULTILINE | re.DOTALL)


def table(header):
    """Rows of the README's table whose first column is headed `header`."""
    match = re.search(r'^\| %s \|.*\n\|[-| ]*\n((?:\|.*\n)+)' % header,
                      read('README.md'), re.MULTILINE)
    return [[cell.strip() for cell in line.strip('|').split('|')]
            for line in match.group(1).splitlines()]


def launch_arguments():
    """Arguments of bringup.launch that can be passed: name to default."""
    tree = xml.etree.ElementTree.parse(
        os.path.join(ROOT, 'launch', 'bringup.launch'))
    return {arg.get('name'): arg.get('default') for arg in tree.iter('arg')
            if arg.get('default') is not None}


class ReadmeTest(SmallMissionTestCase):
    def test_1_commands_marked_to_be_run_do_what_they_say(self):
        self.mission.wait_for_plan()
        commands = [line for block in blocks('sh run')
                    for line in block.splitlines()]
        self.assertGreater(len(commands), 3)
        for command in commands:
            done = subprocess.run(command, shell=True, timeout=COMMAND_S,
                                  stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True)
            self.assertEqual(0, done.returncode, command + '\n' + done.stdout)
            for refusal in ('accepted: False', 'ok: False'):
                self.assertNotIn(refusal, done.stdout, command)
        self.assertTrue(self.mission.ask(
            'ASK { ex:alpha ex:usesPolicy ex:safe }'))
        self.assertTrue(self.mission.ask('ASK { ex:closed ex:kind "no_go" }'))
        self.mission.wait_for_plan(self.mission.world.last.world_version)

    def test_2_make_is_asked_for_targets_that_exist(self):
        targets = set(re.findall(r'^([a-z_]+):', read('Makefile'),
                                 re.MULTILINE))
        named = set(re.findall(r'\bmake ([a-z_]+)', read('README.md')))
        self.assertLessEqual({'bringup', 'test'}, named)
        self.assertLessEqual(named, targets)

    def test_2_launch_arguments_are_those_of_the_launch_file(self):
        arguments = launch_arguments()
        rows = {row[0].strip('`'): row[1].strip('`')
                for row in table('argument')}
        self.assertEqual(set(arguments), set(rows))
        for name in ('mission', 'rviz', 'sim', 'rate', 'record', 'once',
                     'give_up_s', 'deadline_s', 'data'):
            self.assertEqual(arguments[name], rows[name], name)
        for name in re.findall(r'\b([a-z_]+):=', '\n'.join(
                blocks('sh') + blocks('sh run'))):
            self.assertIn(name, arguments)

    def test_2_the_interface_table_is_the_interface(self):
        stated = {}
        for names, kind, _ in table('name'):
            for name in names.split(','):
                stated[name.strip().strip('`')] = kind.strip('`')
        known = {name: kind for name, kind in TOPICS.items()
                 if name.startswith('kg/')}
        known.update({'kg/<agent>/' + re.sub('^layer/.*', 'layer/<NAME>', name):
                      kind for name, kind in AGENT_TOPICS.items()})
        known.update(SERVICES)
        self.assertEqual(set(known), set(stated))
        for name, kind in stated.items():
            self.assertIn(kind, ('', known[name]), name)

    def test_2_the_package_table_is_the_source_folder(self):
        packages = {row[0].strip('`') for row in table('package')}
        self.assertEqual({name for name in os.listdir(os.path.join(ROOT, 'src'))
                          if os.path.isdir(os.path.join(ROOT, 'src', name))},
                         packages)

    def test_2_every_link_leads_to_a_file(self):
        for document in ['README.md'] + [
                os.path.join('docs', name)
                for name in os.listdir(os.path.join(ROOT, 'docs'))
                if name.endswith('.md')]:
            folder = os.path.dirname(document)
            text = re.sub(r'^```.*?^```$', '', read(document),
                          flags=re.MULTILINE | re.DOTALL)  # Not in code.
            for link in re.findall(r'\]\(([^)#]+)[^)]*\)', text):
                self.assertTrue(os.path.isfile(os.path.join(
                    ROOT, folder, link)), '%s: %s' % (document, link))


if __name__ == '__main__':
    main('readme', ReadmeTest)
