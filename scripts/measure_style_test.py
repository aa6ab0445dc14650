#!/usr/bin/env python3
"""The style measures on small made sources, and the limits of the tree."""

import pathlib
import tempfile
import unittest

import measure_style

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent

CODE = r'''// A store of rows.

#include "kg_core/low/row.h"
#define BRACES { \
  {

namespace kg_core {
namespace {

// Not counted: the namespace has no name.
struct Local {
  int a = 1;
};

}  // namespace

enum class Kind { kOne, kTwo };

template <typename T>
class RowStore final : public Base {
 public:
  explicit RowStore(int size) : size_{size}, name_("}{") {}

  bool Has(const T& row) const override {
    // A comment inside.
    for (int i = 0; i < 3; ++i) {
      if (Match(row, [](int a) { return a == '{'; })) return true;
    }
    return false;
  }
  int size() const noexcept { return size_; }

 private:
  struct Inner {
    int b = 0;
  };
  int size_{0};
  std::vector<int> lengths_ = {1, 2, 1'000};
};

class Forward;
struct Row {
  double x_m = 0.0;
};

const char* kText = R"(void f() { // no comment)";

auto LengthOf(const Row& row) -> double {
  return row.x_m;  // TODO: metres
}

}  // namespace kg_core
'''


def lines_of(scan):
    return [function.lines for function in scan.functions]


class Scanning(unittest.TestCase):

    def setUp(self):
        self.scan = measure_style.scan(CODE)

    def test_finds_functions_and_their_lines(self):
        heads = [function.head.split("(")[0].split()[-1]
                 for function in self.scan.functions]
        self.assertEqual(["RowStore", "Has", "size", "LengthOf"], heads)
        self.assertEqual([1, 7, 1, 3], lines_of(self.scan))

    def test_knows_which_functions_hold_a_comment(self):
        self.assertEqual([False, True, False, True], [
            function.commented for function in self.scan.functions])

    def test_finds_the_classes_of_named_namespaces(self):
        self.assertEqual(["RowStore", "Row"], self.scan.classes)

    def test_counts_lines_that_hold_only_a_comment(self):
        self.assertEqual(3, self.scan.comment_lines)
        self.assertEqual(sum(bool(line.strip()) for line in CODE.splitlines()),
                         self.scan.lines)

    def test_reads_constructor_initialisers_of_several_lines(self):
        scan = measure_style.scan(
            "namespace a {\nThing::Thing(int b)\n    : b_{b},\n"
            "      c_(Make({1, 2})) {\n  Run();\n}\nint After() { return 1; }\n"
            "}\n")
        self.assertEqual([3, 1], lines_of(scan))

    def test_reads_functions_of_tests_and_macros(self):
        scan = measure_style.scan("TEST(Row, Adds) {\n  EXPECT_EQ(1, 1);\n}\n")
        self.assertEqual([3], lines_of(scan))


class Percentiles(unittest.TestCase):

    def test_are_of_the_sorted_values(self):
        values = list(range(100, 0, -1))
        self.assertEqual(51, measure_style.percentile(values, 0.5))
        self.assertEqual(91, measure_style.percentile(values, 0.9))
        self.assertEqual(7, measure_style.percentile([7], 0.9))


class MadeTree(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.plant("kg_core/kg_core/low/a.h",
                   '// A.\n#include "kg_core/low/b.h"\n')
        self.plant("kg_core/kg_core/low/b.h", '#include "kg_core/low/a.h"\n')
        self.plant("kg_core/kg_core/low/b_test.cc", "int a;\n" * 7)
        body = "  Run();\n" * measure_style.LONG_LINES
        self.plant("kg_ros/kg_ros/low/c.cc", "".join((
            "// Text.\nvoid F() {\n", body, "}\n",
            "void G() {\n  // Why.\n", body, "}\n")))
        self.measures = measure_style.measure(self.root)

    def plant(self, path, text):
        file = self.root / "src" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def test_gives_circles_comments_and_shares(self):
        self.assertEqual([2], self.measures.circle_sizes)
        self.assertEqual(3, self.measures.units)
        self.assertEqual((1, 2), (self.measures.uncommented,
                                  self.measures.long_functions))
        self.assertEqual((1, 2), (self.measures.opened, self.measures.headers))
        self.assertEqual({"kg_core": 3, "kg_ros": 46},
                         self.measures.package_lines)
        self.assertEqual({"kg_core": 10, "kg_ros": 46},
                         self.measures.package_all_lines)

    def test_lists_the_places_to_improve(self):
        self.plant("kg_ros/kg_ros/low/d.h",
                   "namespace kg_ros {\nstruct Row {\n};\n}\n")
        self.assertEqual(["src/kg_ros/kg_ros/low/c.cc:2: 22 lines without a "
                          "comment", "src/kg_ros/kg_ros/low/d.h: class Row"],
                         list(measure_style.places(self.root)))

    def test_is_printed_as_text_and_as_markdown(self):
        rows = measure_style.yardsticks(self.measures)
        text = list(measure_style.as_text(rows, ("yardstick", "value")))
        self.assertEqual(9, len(text))
        self.assertEqual(1, len(set(map(len, text))))
        table = list(measure_style.as_markdown(
            measure_style.package_rows(self.measures),
            measure_style.PACKAGE_HEAD))
        self.assertEqual(["| kg_core | 3 | 6 % | 10 | 18 % |",
                          "| kg_ros | 46 | 94 % | 46 | 82 % |"], table[2:])


class TheTree(unittest.TestCase):
    """A ratchet: the limits may be lowered, not raised."""

    @classmethod
    def setUpClass(cls):
        cls.measures = measure_style.measure(REPOSITORY)

    def test_has_no_include_circle(self):
        self.assertEqual([], self.measures.circle_sizes)

    def test_comments_its_long_functions(self):
        self.assertLess(self.measures.uncommented_share, 0.35)

    def test_names_its_classes_with_two_words(self):
        self.assertLess(self.measures.one_word_share, 0.15)

    def test_has_no_package_above_a_quarter_of_the_code(self):
        large = {name: share for name, share in
                 self.measures.package_shares().items() if share > 0.25}
        self.assertEqual({}, large)

    def test_keeps_functions_short(self):
        lines = self.measures.function_lines
        self.assertGreater(len(lines), 1000)
        self.assertLessEqual(measure_style.percentile(lines, 0.5), 7)
        self.assertLessEqual(measure_style.percentile(lines, 0.9), 19)
        self.assertLessEqual(max(lines), 51)

    def test_opens_every_header_with_what_it_is(self):
        self.assertEqual(self.measures.headers, self.measures.opened)

    def test_has_no_note_of_unfinished_work(self):
        self.assertEqual(0, self.measures.notes)


if __name__ == "__main__":
    unittest.main()
