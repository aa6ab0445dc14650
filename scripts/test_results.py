#!/usr/bin/env python3
"""Counts the results of a test run, including those that are missing.

    test_results.py [REPOSITORY] [RESULTS]

catkin and rostest exit with 0 when tests fail, count some cases twice and ignore a
test without a result. Here every case counts once; a result file that is
unreadable, has no case, or is missing although its test exists, is a failure. The
last line is "N passed, N failed"; the exit status is 0 only if none failed.
"""

import dataclasses
import pathlib
import re
import sys
import xml.etree.ElementTree as xml

MESSAGE_LENGTH = 500


@dataclasses.dataclass
class Count:
    passed: set = dataclasses.field(default_factory=set)
    failed: dict = dataclasses.field(default_factory=dict)   # name -> message
    skipped: dict = dataclasses.field(default_factory=dict)  # name -> reason


def expected_results(root):
    """Result file (package/name.xml) -> the test it comes from."""
    expected = {}
    for path in sorted(root.glob("src/*/**/*_test.cc")):
        package = path.relative_to(root / "src").parts[0]
        expected[f"{package}/gtest-{package}_{path.stem}.xml"] = path
    for path in sorted(root.glob("src/*/test/*.test")):
        package = path.relative_to(root / "src").parts[0]
        for name in rostest_names(path):
            expected[f"{package}/rosunit-{name}.xml"] = path
    for path in sorted(root.glob("scripts/*_test.py")):
        expected[f"scripts/{path.stem}.xml"] = path
    return {name: path.relative_to(root) for name, path in expected.items()}


def rostest_names(path):
    return [test.get("test-name") for test in xml.parse(path).iter("test")]


def unrun_python_tests(root):
    """Python files with cases that no .test file runs and no other test
    imports."""
    paths = sorted(root.glob("src/*/*/*_test.py"))
    named = {test.get("type") for path in root.glob("src/*/test/*.test")
             for test in xml.parse(path).iter("test")}
    texts = {path: path.read_text() for path in paths}
    imported = {module for text in texts.values() for module in
                re.findall(r"^(?:from|import) (\w+)", text, re.MULTILINE)}
    return [path.relative_to(root) for path in paths
            if path.name not in named and path.stem not in imported and
            re.search(r"^\s+def test_", texts[path], re.MULTILINE)]


def add_file(count, name, path):
    try:
        suite = xml.parse(path).getroot()
    except (OSError, xml.ParseError) as error:
        count.failed[name] = f"unreadable result: {error}"
        return
    cases = list(suite.iter("testcase"))
    if not cases:
        add_empty(count, name, suite)
    for case in cases:
        # rostest's own file only reports that a test node ran: count failures.
        add_case(count, name, case,
                 only_failures=path.name.startswith("rostest-"))


def add_empty(count, name, suite):
    """A result without a case is a failure, unless the test printed SKIPPED."""
    printed = "\n".join("".join(output.itertext())
                        for output in suite.iter("system-out"))
    reason = re.search(r"^SKIPPED: (.+)$", printed, re.MULTILINE)
    if reason:
        count.skipped[name] = reason[1]
    else:
        count.failed[name] = "the result holds no test case"


def add_case(count, name, case, only_failures):
    key = f"{name}: {case.get('classname')}.{case.get('name')}"
    problem = case.find("failure")
    problem = case.find("error") if problem is None else problem
    if problem is not None:
        count.failed[key] = problem.get("message") or problem.text or "failed"
    elif case.find("skipped") is not None:
        skipped = case.find("skipped")
        count.skipped[key] = skipped.get("message") or skipped.text or ""
    elif case.get("status") == "notrun":
        count.skipped[key] = "disabled"
    elif not only_failures:
        count.passed.add(key)


def count_results(root, results):
    count = Count()
    found = {str(path.relative_to(results)): path
             for path in sorted(results.glob("*/*.xml"))
             if not path.name.startswith("MISSING-")}
    for name, path in found.items():
        add_file(count, name, path)
    for name, source in expected_results(root).items():
        if name not in found:
            count.failed[name] = f"{source} wrote no result: it crashed or timed out"
    for path in unrun_python_tests(root):
        count.failed[str(path)] = "no .test file runs it"
    count.passed -= set(count.failed)
    return count


def shortened(text):
    text = " | ".join(line.strip() for line in text.splitlines()
                      if line.strip())
    if len(text) <= MESSAGE_LENGTH:
        return text
    half = MESSAGE_LENGTH // 2
    return f"{text[:half]} ... {text[-half:]}"


def report(count):
    for name, reason in count.skipped.items():
        print(f"SKIPPED {name}: {shortened(reason)}")
    for name, message in count.failed.items():
        print(f"FAILED  {name}: {shortened(message)}")
    if not count.passed and not count.failed:
        count.failed["tests"] = "none ran"
    print(f"{len(count.passed)} passed, {len(count.failed)} failed")
    return bool(count.failed)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    results = (pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else
               root / "build" / "test_results")
    sys.exit(report(count_results(root, results)))


if __name__ == "__main__":
    main()
