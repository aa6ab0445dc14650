#!/usr/bin/env python3
"""Measures the style of the C++ code: functions, comments, circles, names.

    measure_style.py [--markdown | --list] [REPOSITORY]

One line per yardstick; with --markdown the tables that docs/architecture.md
quotes; with --list the places to improve: long functions without a comment and
class names of one word. The same tree gives the same output. C++ is read by a brace scanner, not
by a compiler: it knows comments, strings, preprocessor lines, scopes, function
heads and constructor initialisers, which is enough for formatted code.

  function lines     from the line of the opening brace to that of the closing
                     brace, both counted, without tests; lambdas belong to
                     the function around them
  comment lines      lines that only hold a comment, of all lines that are not
                     blank, in .cc files without tests
  uncommented        functions of LONG_LINES lines and more without a comment
                     between their braces, without tests
  include circles    units (x.h with x.cc) that include each other, directly or
                     not (check_include_order.py)
  class names        classes and structs defined in a named namespace, not in a
                     class, without tests; words are split at capitals
  package shares     non-blank lines of .h and .cc of each kg_ package
"""

import argparse
import collections
import dataclasses
import pathlib
import re

import check_include_order

LONG_LINES = 20

TOKEN = re.compile(
    r'//[^\n]*'                                  # comment
    r'|/\*.*?\*/'
    r'|R"(?P<raw>[^\s()\\]{0,16})\(.*?\)(?P=raw)"'  # raw string
    r'|"(?:[^"\\\n]|\\.)*"'                      # string
    r"|(?<![0-9A-Fa-f])'(?:[^'\\\n]|\\.)*'"      # character, not 1'000
    r'|^[ \t]*#(?:[^\n\\]|\\.|\\\n)*',           # preprocessor line
    re.DOTALL | re.MULTILINE)
SCOPE = re.compile(r"(?:^|[\s>])(namespace|class|struct|union|enum)\b")
CLASS = re.compile(
    r"^(?:template\s*<.*>\s*)?(?:class|struct)\s+(?:alignas\([^)]*\)\s*)?"
    r"(\w+)(?:\s+final)?\s*(?::[^:]|$)", re.DOTALL)
FUNCTION_END = re.compile(
    r"\)\s*(?:const|noexcept|override|final|mutable|volatile|&&?|"
    r"noexcept\s*\(.*\)|->\s*[\w:<>,*&\s]+|\s)*$", re.DOTALL)
INITIALISERS = re.compile(r"\)\s*(?:noexcept\s*)?:[^:]", re.DOTALL)
ACCESS = re.compile(r"\b(?:public|private|protected)\s*\Z")
OF_NAME = re.compile(r"\b([A-Z][A-Za-z0-9]*Of)\(")
WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
NOTE = re.compile(r"\b(TODO|FIXME|XXX)\b")


@dataclasses.dataclass(frozen=True)
class Function:
    head: str
    first_line: int  # of the opening brace
    last_line: int   # of the closing brace
    commented: bool

    @property
    def lines(self):
        return self.last_line - self.first_line + 1


@dataclasses.dataclass
class Scan:
    """What a file defines."""
    functions: list = dataclasses.field(default_factory=list)
    classes: list = dataclasses.field(default_factory=list)
    comment_lines: int = 0
    lines: int = 0  # not blank, comments included


def blanked(text):
    """The text without comments, strings and preprocessor lines, at the same
    offsets, and the line numbers that hold a comment."""
    comment_lines = set()

    def blank(match):
        if match[0].startswith(("//", "/*")):
            first = text.count("\n", 0, match.start()) + 1
            comment_lines.update(range(first, first + match[0].count("\n") + 1))
        return re.sub(r"[^\n]", " ", match[0])

    return TOKEN.sub(blank, text), comment_lines


def kind_of_scope(head, inside_function):
    """'namespace', 'class', 'function' or 'other' for the brace after head."""
    if inside_function:
        return "other"
    match = SCOPE.search(head)
    if match and match[1] == "namespace":
        return "namespace"
    if FUNCTION_END.search(head) or INITIALISERS.search(head):
        return "function"
    if match and "=" not in head and "(" not in head[match.end():]:
        return "other" if match[1] == "enum" else "class"
    return "other"


def is_named(kind, head, *_):
    """Whether a scope is a namespace with a name."""
    return kind == "namespace" and not head.endswith("namespace")


def is_initialiser(code, brace, head):
    """Whether a brace belongs to a member in a constructor's initialisers."""
    return bool(INITIALISERS.search(head)) and not code[brace - 1].isspace()


class Scanner:
    """Walks the braces of blanked code; fills a Scan."""

    def __init__(self, code, comments, result):
        self.code = code
        self.comments = comments
        self.result = result
        self.stack = []      # (kind, head, line of the opening brace)
        self.head_start = 0  # where the text before the next brace begins

    def run(self):
        line = 1
        for offset, character in enumerate(self.code):
            if character == "\n":
                line += 1
            elif character == "{":
                self.open(offset, line)
            elif character == "}" and self.stack:
                self.close(offset, line)
            elif character == ";" and not self.inside("initialiser"):
                self.head_start = offset + 1
            elif character == ":" and ACCESS.search(
                    self.code[self.head_start:offset]):
                self.head_start = offset + 1

    def inside(self, wanted):
        return any(kind == wanted for kind, *_ in self.stack)

    def open(self, offset, line):
        head = self.code[self.head_start:offset].strip()
        in_function = self.inside("function")
        if not in_function and is_initialiser(self.code, offset, head):
            self.stack.append(("initialiser", head, line))
            return
        kind = kind_of_scope(head, in_function)
        match = CLASS.match(head)
        if kind == "class" and match and all(
                is_named(*scope) for scope in self.stack):
            self.result.classes.append(match[1])
        self.stack.append((kind, head, line))
        self.head_start = offset + 1

    def close(self, offset, line):
        kind, head, first = self.stack.pop()
        if kind == "function":
            commented = not self.comments.isdisjoint(range(first, line + 1))
            self.result.functions.append(Function(head, first, line, commented))
        if kind != "initialiser":
            self.head_start = offset + 1


def scan(text):
    result = Scan()
    code, comments = blanked(text)
    plain = code.splitlines()
    for number, line in enumerate(text.splitlines(), 1):
        result.lines += bool(line.strip())
        result.comment_lines += (number in comments and
                                 not plain[number - 1].strip())
    Scanner(code, comments, result).run()
    return result


def percentile(values, share):
    """The smallest value that `share` of all values do not exceed."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def share(part, whole):
    return part / whole if whole else 0.0


@dataclasses.dataclass
class Measures:
    function_lines: list      # of every function, without tests
    long_functions: int       # of LONG_LINES and more, without tests
    uncommented: int          # those of them without a comment
    comment_share: float
    units: int
    circle_sizes: list        # units in each include circle
    class_words: list         # words in each class name
    of_names: list
    headers: int
    opened: int               # headers that open with a comment
    notes: int                # TODO, FIXME
    package_lines: dict       # package -> lines without tests
    package_all_lines: dict   # package -> lines with tests

    @property
    def uncommented_share(self):
        return share(self.uncommented, self.long_functions)

    @property
    def one_word_share(self):
        return share(self.class_words.count(1), len(self.class_words))

    def package_shares(self, with_tests=False):
        lines = self.package_all_lines if with_tests else self.package_lines
        whole = sum(lines.values())
        return {name: share(count, whole) for name, count in lines.items()}


def is_test(source):
    return source.is_testing or source.name.endswith("_test.cc")


def opens_with_comment(source):
    return bool(source.lines) and source.lines[0].startswith(("//", "/*"))


def measure(root):
    sources = check_include_order.read_sources(root)
    scans = {source.name: scan("\n".join(source.lines)) for source in sources}
    code = [source for source in sources if not is_test(source)]
    cc_scans = [scans[s.name] for s in code if s.name.endswith(".cc")]
    long = [function for s in code for function in scans[s.name].functions
            if function.lines >= LONG_LINES]
    units = [s for s in sources if not check_include_order.PROGRAM.search(s.name)]
    graph = check_include_order.include_graph(units, lambda s: s.unit)
    lines, all_lines = collections.Counter(), collections.Counter()
    for source in sources:
        all_lines[source.package] += scans[source.name].lines
        lines[source.package] += (0 if is_test(source) else
                                  scans[source.name].lines)
    return Measures(
        function_lines=[function.lines for source in code
                        for function in scans[source.name].functions],
        long_functions=len(long),
        uncommented=sum(not function.commented for function in long),
        comment_share=share(sum(one.comment_lines for one in cc_scans),
                            sum(one.lines for one in cc_scans)),
        units=len({source.unit for source in units}),
        circle_sizes=sorted(map(len, check_include_order.circles(graph))),
        class_words=[len(WORD.findall(name)) for source in code
                     for name in scans[source.name].classes],
        of_names=sorted({name for source in sources for line in source.lines
                         for name in OF_NAME.findall(line)}),
        headers=sum(s.name.endswith(".h") for s in sources),
        opened=sum(s.name.endswith(".h") and opens_with_comment(s)
                   for s in sources),
        notes=sum(bool(NOTE.search(line)) for s in sources for line in s.lines),
        package_lines=dict(sorted(lines.items())),
        package_all_lines=dict(sorted(all_lines.items())))


def percent(value):
    return f"{100 * value:.0f} %"


def yardsticks(measures):
    """Name and value of every yardstick, as text."""
    lines = measures.function_lines or [0]
    words = measures.class_words or [0]
    circles = measures.circle_sizes
    in_circles = sum(circles)
    return [
        ("function lines p50 / p90 / max", " / ".join(map(str, (
            percentile(lines, 0.5), percentile(lines, 0.9), max(lines))))),
        ("comment lines in .cc", percent(measures.comment_share)),
        (f"functions of {LONG_LINES} lines and more without a comment inside",
         f"{percent(measures.uncommented_share)} ({measures.uncommented} of "
         f"{measures.long_functions})"),
        ("units in include circles (largest)",
         f"{percent(share(in_circles, measures.units))} "
         f"({max(circles, default=0)}), {len(circles)} circles"),
        ("class names: mean words; of one word",
         f"{sum(words) / len(words):.1f}; {percent(measures.one_word_share)}"),
        ("`XxxOf()` function names", str(len(measures.of_names))),
        ("headers that open with what the file is",
         f"{measures.opened} of {measures.headers}"),
        ("TODO, FIXME", str(measures.notes))]


def package_rows(measures):
    """Package, lines and share without tests, lines and share with tests."""
    with_tests = measures.package_shares(with_tests=True)
    for package, part in measures.package_shares().items():
        yield (package, str(measures.package_lines[package]), percent(part),
               str(measures.package_all_lines[package]),
               percent(with_tests[package]))


def places(root):
    """Long functions without a comment and class names of one word."""
    for source in check_include_order.read_sources(root):
        if is_test(source):
            continue
        result = scan("\n".join(source.lines))
        for function in result.functions:
            if function.lines >= LONG_LINES and not function.commented:
                yield (f"{source.place(function.first_line)}: "
                       f"{function.lines} lines without a comment")
        for name in result.classes:
            if len(WORD.findall(name)) == 1:
                yield f"src/{source.package}/{source.name}: class {name}"


PACKAGE_HEAD = ("package", "lines", "share", "lines with tests", "share")


def as_markdown(rows, head):
    yield "| " + " | ".join(head) + " |"
    yield "|" + "---|" * len(head)
    yield from ("| " + " | ".join(row) + " |" for row in rows)


def as_text(rows, head):
    rows = [head, *rows]
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    for first, *others in rows:
        yield "  ".join([first.ljust(widths[0])] + [
            value.rjust(width) for value, width in zip(others, widths[1:])])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--markdown", action="store_true",
                      help="print tables for docs/architecture.md")
    form.add_argument("--list", action="store_true",
                      help="print the places to improve")
    parser.add_argument("repository", nargs="?", type=pathlib.Path,
                        default=pathlib.Path(__file__).resolve().parent.parent)
    options = parser.parse_args()
    if options.list:
        print("\n".join(places(options.repository)))
        return
    measures = measure(options.repository)
    form = as_markdown if options.markdown else as_text
    print("\n".join(form(yardsticks(measures), ("yardstick", "value"))))
    print()
    print("\n".join(form(package_rows(measures), PACKAGE_HEAD)))


if __name__ == "__main__":
    main()
