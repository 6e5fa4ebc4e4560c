"""What the documents print below a command is what it prints, and the lesson's counts are those of its grids.

samples_test.py BIN_FOLDER
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

DOCS = pathlib.Path(__file__).resolve().parent.parent.parent / "docs"
bin_folder = None


def samples(document):
    """(command, lines) of each block that begins with `$ command`."""
    for block in re.findall(r"(?m)^    \$ .*\n(?:    .+\n|\n(?=    ))+", (DOCS / document).read_text()):
        for sample in re.split(r"(?m)^\$ ", re.sub(r"(?m)^    ", "", block))[1:]:
            command, *lines = sample.splitlines()
            yield command, lines


class Samples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.run_line("nffgen teapot | nff2bin - -o teapot.scene")
        cls.run_line("gridbuild teapot.scene -o teapot.grid; gridbuild teapot.scene -o teapot-irregular.grid --merge irregular --division 13x13x5")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def run_line(cls, line):
        environment = {**os.environ, "PATH": f"{bin_folder}:{os.environ['PATH']}"}
        return subprocess.run(["sh", "-c", line], cwd=cls.folder.name, env=environment, check=True, stdout=subprocess.PIPE, text=True).stdout

    def test_samples_are_what_is_printed(self):
        for document in ["tools/gridstat.md", "lesson.md"]:
            found = list(samples(document))
            self.assertTrue(found)
            for command, lines in found:
                printed = self.run_line(command).splitlines()
                self.assertEqual(printed[-len(lines):] if lines else [], lines, command)

    def test_the_lessons_references_are_those_of_its_grids(self):
        rows = re.findall(r"(?m)^\| (\d+) \| [\d.]+ % \| (\d+) \|", (DOCS / "lesson.md").read_text())
        self.assertEqual([row[0] for row in rows], ["2", "4", "8", "16", "32", "64", "128"])
        for division, references in rows:
            self.run_line(f"gridbuild teapot.scene -o uniform.grid --division {division}")
            self.assertEqual(json.loads(self.run_line("gridstat uniform.grid --json"))["references"], int(references), division)


if __name__ == "__main__":
    bin_folder = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main(verbosity=2)
