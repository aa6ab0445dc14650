#!/usr/bin/env python3
"""The commands of the Makefile: help, choice of master, environment, errors."""

import pathlib
import re
import socket
import subprocess
import unittest

from free_master import free_master

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
SCRIPTS = REPOSITORY / "scripts"


def run(*command, **options):
    return subprocess.run(command, cwd=REPOSITORY, capture_output=True,
                          text=True, stdin=subprocess.DEVNULL, check=False,
                          **options)


class MakeHelp(unittest.TestCase):

    def test_lists_every_target_that_there_is(self):
        targets = set(re.search(r"^\.PHONY: (.*)$",
                                (REPOSITORY / "Makefile").read_text(),
                                re.MULTILINE)[1].split()) - {"help"}
        self.assertLessEqual({"build", "bringup", "test", "bench", "figures",
                              "clean"}, targets)
        listed = re.findall(r"^make (\w+) ", run("make", "help").stdout,
                            re.MULTILINE)
        self.assertEqual(targets, set(listed))


class TheMaster(unittest.TestCase):

    def test_is_the_wanted_one_if_it_is_free(self):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        self.assertEqual(f"http://127.0.0.1:{port}",
                         free_master(f"http://127.0.0.1:{port}"))

    def test_moves_on_from_a_port_that_is_taken(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            found = free_master(f"http://127.0.0.1:{port}")
        self.assertGreater(int(found.rsplit(":", 1)[1]), port)

    def test_of_another_machine_is_left_alone(self):
        self.assertEqual("http://vessel:11311",
                         free_master("http://vessel:11311"))

    def test_without_a_port_is_refused(self):
        with self.assertRaisesRegex(SystemExit, "no port"):
            free_master("http://localhost")


class TheEnvironment(unittest.TestCase):

    def variable(self, name, **given):
        script = f'. scripts/environment.sh; printf %s "${{{name}-unset}}"'
        return run("bash", "-c", script,
                   env={"PATH": "/opt/other/bin:/usr/bin:/bin", **given}).stdout

    def test_finds_the_python_of_debian_first(self):
        self.assertTrue(self.variable("PATH").startswith("/usr/bin:"))

    def test_stays_on_the_loopback_interface(self):
        self.assertEqual("localhost", self.variable("ROS_HOSTNAME"))
        self.assertEqual("unset", self.variable("ROS_IP", ROS_IP="10.0.0.7"))
        self.assertRegex(self.variable("ROS_MASTER_URI"), "^http://127.0.0.1:")

    def test_keeps_a_master_that_was_chosen(self):
        self.assertEqual("http://vessel:11311", self.variable(
            "ROS_MASTER_URI", ROS_MASTER_URI="http://vessel:11311"))


class Refusals(unittest.TestCase):

    def assert_refused(self, command, reason):
        ended = run(*command)
        self.assertEqual(1, ended.returncode, ended.stdout)
        self.assertIn(reason, ended.stderr)
        self.assertEqual(1, len(ended.stderr.splitlines()))

    def test_of_a_section_that_the_package_list_has_not(self):
        self.assert_refused([SCRIPTS / "install_packages.sh", "gi"],
                            "apt-packages.txt has no [gi]")

    def test_of_a_launch_argument_that_is_none(self):
        self.assert_refused([SCRIPTS / "bringup.sh", "once=true"],
                            "expected name:=value, not 'once=true'")


if __name__ == "__main__":
    unittest.main()
