#!/usr/bin/env python3
"""Compares the test files of the tree with the list scripts/test_files.txt.

    test_files.py [--add] [REPOSITORY]     prints what is missing or not listed

The list protects tests from being lost in a merge. It holds names without
folders, so that a test can move; a name that two folders use is listed twice.
--add lists new tests. A line is deleted by hand only, in the commit that deletes
or renames the test.
"""

import argparse
import collections
import pathlib
import sys

LIST = pathlib.Path("scripts/test_files.txt")
PATTERNS = ("src/*/**/*_test.cc", "src/*/**/*_test.py", "src/*/**/*.test",
            "scripts/*_test.py")
HEAD = """\
# Every test of the tree, by name. A new test: scripts/test_files.py --add.
# A deleted or renamed test: delete its line here, in the same commit.
"""


def present_tests(root):
    """Name of every test file -> its paths."""
    paths = {path for pattern in PATTERNS for path in root.glob(pattern)}
    tests = collections.defaultdict(list)
    for path in sorted(paths):
        tests[path.name].append(str(path.relative_to(root)))
    return tests


def listed_tests(root):
    """Name of every listed test -> how often it is listed."""
    lines = (root / LIST).read_text().splitlines()
    return collections.Counter(line for line in lines
                               if line and not line.startswith("#"))


def complaints(root):
    present, listed = present_tests(root), listed_tests(root)
    for name in sorted(set(present) | set(listed)):
        paths = present.get(name, [])
        if len(paths) < listed[name]:
            yield (f"{name}: missing; {LIST} lists {listed[name]}, the tree "
                   f"has {len(paths)}")
        elif len(paths) > listed[name]:
            yield (f"{name}: not listed in {LIST} ({', '.join(paths)}); run "
                   "scripts/test_files.py --add")


def add(root):
    """Adds the tests that the list lacks; removes none."""
    names = listed_tests(root) if (root / LIST).exists() else {}
    names = collections.Counter(names)
    for name, paths in present_tests(root).items():
        names[name] = max(names[name], len(paths))
    lines = [name for name in sorted(names) for _ in range(names[name])]
    (root / LIST).write_text(HEAD + "\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--add", action="store_true",
                        help="list the tests that are not listed yet")
    parser.add_argument("repository", nargs="?", type=pathlib.Path,
                        default=pathlib.Path(__file__).resolve().parent.parent)
    options = parser.parse_args()
    if options.add:
        add(options.repository)
    found = list(complaints(options.repository))
    print("\n".join(found or ["test files: all listed, none missing"]))
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
