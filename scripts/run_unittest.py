#!/usr/bin/env python3
"""Runs one Python test file and writes its result as JUnit XML.

    run_unittest.py FILE_test.py RESULT.xml     exit status 1 if anything failed
"""

import importlib.util
import pathlib
import sys
import time
import unittest
import xml.etree.ElementTree as xml


class Result(unittest.TextTestResult):
    """Records every case with its outcome and duration."""

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.cases = {}  # id -> [(tag, text)]
        self.began_s = {}
        self.took_s = {}

    def startTest(self, test):
        super().startTest(test)
        self.cases[test.id()] = []
        self.began_s[test.id()] = time.monotonic()

    def stopTest(self, test):
        super().stopTest(test)
        self.took_s[test.id()] = time.monotonic() - self.began_s[test.id()]

    def _note(self, test, tag, text):
        self.cases.setdefault(test.id(), []).append((tag, text))

    def addFailure(self, test, err):
        super().addFailure(test, err)
        self._note(test, "failure", self.failures[-1][1])

    def addError(self, test, err):
        super().addError(test, err)
        self._note(test, "error", self.errors[-1][1])

    def addSubTest(self, test, subtest, err):
        super().addSubTest(test, subtest, err)
        if err:
            text = self._exc_info_to_string(err, subtest)
            self._note(test, "failure", f"{subtest}: {text}")

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        self._note(test, "skipped", reason)

    def addUnexpectedSuccess(self, test):
        super().addUnexpectedSuccess(test)
        self._note(test, "failure", "unexpected success")


def load(path):
    sys.path.insert(0, str(path.parent))
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[path.stem] = module
    spec.loader.exec_module(module)
    return unittest.defaultTestLoader.loadTestsFromModule(module)


def write(result, path):
    suite = xml.Element("testsuite", tests=str(len(result.cases)))
    for name, notes in result.cases.items():
        classname, _, case_name = name.rpartition(".")
        case = xml.SubElement(suite, "testcase", classname=classname,
                              name=case_name,
                              time=f"{result.took_s.get(name, 0):.3f}")
        for tag, text in notes:
            xml.SubElement(case, tag, message=text).text = text
    path.parent.mkdir(parents=True, exist_ok=True)
    xml.ElementTree(suite).write(path, encoding="utf-8", xml_declaration=True)


def main():
    source, target = (pathlib.Path(name).resolve() for name in sys.argv[1:3])
    runner = unittest.TextTestRunner(resultclass=Result)
    result = runner.run(load(source))
    write(result, target)
    sys.exit(not result.wasSuccessful())


if __name__ == "__main__":
    main()
