#!/usr/bin/env python3
"""README, CHANGELOG and docs: columns, words, and the files that they name."""

import pathlib
import re
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
SOURCES = REPOSITORY / "src"
DOCUMENTS = [REPOSITORY / "README.md", REPOSITORY / "CHANGELOG.md",
             *sorted((REPOSITORY / "docs").glob("*.md"))]
COLUMNS = 120
# The packages of docs/architecture.md. Paths below one that is not in the tree
# yet are not checked.
PACKAGES = ("kg_base", "kg_core", "kg_mission", "kg_compiler", "kg_planner",
            "kg_selector", "kg_engine", "kg_msgs", "kg_ros", "mission")
MOST_FILES = 8       # Of one example in docs/extending.md.
EXAMPLES = 7
WORDS = re.compile(r"\b(houses?|rooms?|doors?|anew|thrift\w*|taken up again)\b",
                   re.IGNORECASE)
# Text that engineers read: the documents, and comments in these folders.
WORDED = ("launch", "rviz", "config", "src/mission/scripts",
          "src/mission/test", "src/kg_msgs")
FOLDERS = ("src", "docs", "config", "scripts", "launch", "rviz")
SUFFIXES = (".h", ".cc", ".py", ".sh", ".launch", ".rviz", ".msg", ".srv",
            ".txt", ".ttl", ".rq", ".ru", ".md")
BARE_SUFFIXES = (".h", ".cc", ".py", ".sh", ".rviz", ".launch")
NOT_OURS = ("planners.launch",)  # Of a mission's own folder.


def name_of(path):
    return path.relative_to(REPOSITORY).as_posix()


def outside_fences(text):
    """Numbered lines of a document without its fenced blocks."""
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not fenced:
            yield number, line


def too_long(text):
    """Lines beyond the limit; tables, fenced blocks and single words may be."""
    for number, line in outside_fences(text):
        if len(line) > COLUMNS and not line.startswith("|") and (
                " " in line.strip()):
            yield number


def named_paths(text):
    """Paths and file names in code spans, except patterns such as a/<b>."""
    lines = "\n".join(line for _, line in outside_fences(text))
    for span in re.findall(r"`([^`\n]+)`", lines):
        if re.fullmatch(r"[\w./-]*\w[\w./-]*", span) and not span.startswith("/"):
            yield span.removeprefix("./")


def has_all_packages():
    return all((SOURCES / package).is_dir() for package in PACKAGES)


def is_postponed(document, path):
    """Not checked yet: files of packages that are not in the tree, and, until
    all packages are, those of the examples."""
    if document == "docs/extending.md" and not has_all_packages():
        return True
    parts = pathlib.PurePosixPath(path).parts
    package = parts[1] if parts[0] == "src" and len(parts) > 1 else parts[0]
    return package in PACKAGES and not (SOURCES / package).is_dir()


def is_missing(path, file_names):
    first = path.split("/")[0]
    if "/" not in path:
        return (path.endswith(BARE_SUFFIXES) and path not in NOT_OURS and
                path not in file_names)
    if first in FOLDERS:
        return not (REPOSITORY / path).exists()
    if first in PACKAGES and path.endswith(SUFFIXES):
        return not (SOURCES / first / path).exists()
    return False


def examples(text):
    """Heading -> first cells of the table rows below it."""
    found = {}
    for section in re.split(r"^## ", text, flags=re.MULTILINE)[1:]:
        heading, _, body = section.partition("\n")
        rows = re.findall(r"^\| (`src/[^|]+?|`[a-z]+/[^|]+?) \|", body,
                          re.MULTILINE)
        if rows:
            found[heading] = rows
    return found


class TheDocuments(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.texts = {name_of(path): path.read_text() for path in DOCUMENTS}
        cls.files = {path.name for folder in FOLDERS
                     for path in (REPOSITORY / folder).rglob("*")}

    def test_are_at_most_120_columns_wide(self):
        self.assertEqual([], [f"{name}:{number}" for name, text in
                              self.texts.items() for number in too_long(text)])

    def test_name_files_that_exist(self):
        named = {(name, path) for name, text in self.texts.items()
                 for path in named_paths(text)}
        self.assertGreater(len(named), 100)
        missing = [f"{name}: {path}" for name, path in sorted(named)
                   if not is_postponed(name, path) and
                   is_missing(path, self.files) and
                   f"`{path}` (new)" not in self.texts[name]]
        self.assertEqual([], missing)

    def test_use_plain_words(self):
        files = [path for folder in WORDED
                 for path in sorted((REPOSITORY / folder).rglob("*"))
                 if path.suffix in SUFFIXES]
        self.assertGreater(len(files), 50)
        texts = dict(self.texts, **{
            name_of(path): path.read_text() for path in files})
        found = [f"{name}: {word}" for name, text in texts.items()
                 for word in WORDS.findall(text)]
        self.assertEqual([], found)


class Extending(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.examples = examples(
            (REPOSITORY / "docs" / "extending.md").read_text())

    def test_has_an_example_for_each_kind_of_extension(self):
        self.assertEqual(EXAMPLES, len(self.examples), self.examples.keys())

    def test_touches_few_files_in_each(self):
        for heading, files in self.examples.items():
            with self.subTest(example=heading):
                self.assertLessEqual(len(files), MOST_FILES)
                self.assertEqual(len(files), len(set(files)))


class Architecture(unittest.TestCase):
    """docs/architecture.md has a table of the folders of every package."""

    @classmethod
    def setUpClass(cls):
        cls.text = (REPOSITORY / "docs" / "architecture.md").read_text()

    def folders_of(self, package):
        """Folders in the package's table."""
        section = re.search(rf"^### {package}\n(.*?)(?=^##)", self.text + "\n##",
                            re.MULTILINE | re.DOTALL)
        self.assertIsNotNone(section, package)
        return set(re.findall(r"^\| `([\w/]+)/` \|", section[1], re.MULTILINE))

    def test_has_a_table_for_every_package(self):
        for package in PACKAGES:
            self.assertTrue(self.folders_of(package), package)

    def test_lists_every_folder_once_all_packages_exist(self):
        if not has_all_packages():
            self.skipTest("not all packages are in the tree yet")
        for package in PACKAGES:
            code = SOURCES / package / package
            there = {path.name for path in code.iterdir() if path.is_dir()
                     } if code.is_dir() else set()
            with self.subTest(package=package):
                self.assertEqual(set(), there - self.folders_of(package))


class TheChecks(unittest.TestCase):

    def test_find_a_line_that_is_too_long(self):
        wide = "word " * 30
        self.assertEqual([2], list(too_long(f"short\n{wide}\n| {wide} |\n")))
        self.assertEqual([], list(too_long(f"```\n{wide}\n```\n" + 130 * "x")))

    def test_find_a_path_that_does_not_exist(self):
        self.assertTrue(is_missing("docs/nothing.md", set()))
        self.assertTrue(is_missing("kg_core/nothing/at_all.h", set()))
        self.assertTrue(is_missing("nothing_at_all.h", set()))
        self.assertFalse(is_missing("docs/rules.md", set()))
        self.assertFalse(is_missing("verdict.json", set()))

    def test_read_paths_from_code_spans_only(self):
        self.assertEqual(["docs/rules.md", "a/b.h"], list(named_paths(
            "`docs/rules.md` and c/d.h, `state/<mission>`\n`a/b.h` `x y/z.h`\n"
            "```\n`e/f.h`\n```\n")))

    def test_count_the_files_of_an_example(self):
        table = "| file | change |\n|---|---|\n| `src/a.h` | x |\n| `src/b.cc` (new) | y |\n"
        self.assertEqual({"One": ["`src/a.h`", "`src/b.cc` (new)"]},
                         examples("# T\n## One\n" + table + "## Two\ntext\n"))


if __name__ == "__main__":
    unittest.main()
