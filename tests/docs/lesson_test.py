"""The lesson's numbers of references are those of its grids: lesson_test.py BIN_FOLDER"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

LESSON = pathlib.Path(__file__).resolve().parent.parent.parent / "docs" / "lesson.md"


def main():
    tools = pathlib.Path(sys.argv[1]).resolve()
    rows = re.findall(r"(?m)^\| (\d+) \| [\d.]+ % \| (\d+) \|", LESSON.read_text(encoding="utf-8"))
    assert [row[0] for row in rows] == ["2", "4", "8", "16", "32", "64", "128"], rows
    with tempfile.TemporaryDirectory() as folder:
        def run(tool, *arguments):
            return subprocess.run([tools / tool, *arguments], cwd=folder, check=True, stdout=subprocess.PIPE).stdout
        run("nffgen", "teapot", "-o", "teapot.nff")
        run("nff2bin", "teapot.nff", "-o", "teapot.scene")
        for division, references in rows:
            run("gridbuild", "teapot.scene", "-o", "uniform.grid", "--division", division)
            found = json.loads(run("gridstat", "uniform.grid", "--json"))["references"]
            assert found == int(references), (division, found, references)


main()
