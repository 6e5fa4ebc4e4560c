"""Links between documents lead to files and headings that there are, in the source and as BUILD installs them, and so do
names of documents in sources: links_test.py BUILD. Every picture in docs/ is in a document."""
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
FOLDERS = ("api", "examples", "libgrid", "libscene", "renderer", "schemas", "tests", "tools")
FENCED = re.compile(r"(?ms)^```.*?^```$")


def anchors(document):
    """Of its headings, as GitHub makes them."""
    found = []
    for heading in re.findall(r"(?m)^#+ (.+)$", FENCED.sub("", document.read_text(encoding="utf-8"))):
        text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()
        anchor = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
        found.append("{}-{}".format(anchor, found.count(anchor)) if anchor in found else anchor)
    return found


def broken_links(document):
    for link in re.findall(r"\]\(([^)\s]+)\)", FENCED.sub("", document.read_text(encoding="utf-8"))):
        name, _, anchor = link.partition("#")
        target = document.parent / name if name else document
        if re.match(r"[a-z]+:", link):
            continue
        if not target.exists() or (anchor and target.suffix == ".md" and anchor not in anchors(target)):
            yield link


def broken_names(file):
    """Of docs/….md in comments and texts."""
    try:
        text = file.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return []
    return [name for name in re.findall(r"\bdocs/[\w./-]+\.md\b", text) if not (SOURCE / name).exists()]


def broken_in(folder):
    """Of the documents in a folder and its docs/."""
    documents = [*folder.glob("*.md"), *(folder / "docs").rglob("*.md")]
    assert len(documents) > 9, folder
    return [(document.relative_to(folder), link) for document in documents for link in broken_links(document)]


def broken_when_installed(build):
    with tempfile.TemporaryDirectory() as prefix:
        subprocess.run(["cmake", "--install", build, "--prefix", prefix, "--component", "tools"], check=True,
                       stdout=subprocess.DEVNULL)
        return [("installed", *each) for each in broken_in(pathlib.Path(prefix) / "share" / "doc" / "masu")]


def unused_pictures():
    documents = [SOURCE / "README.md", *(SOURCE / "docs").rglob("*.md")]
    linked = {(document.parent / link).resolve() for document in documents
              for link in re.findall(r"\]\(([^)\s#]+)", document.read_text(encoding="utf-8"))}
    pictures = [path for kind in ("*.png", "*.jpg") for path in (SOURCE / "docs").rglob(kind)]
    # Charts of single scenes are linked as a folder.
    return [(path.relative_to(SOURCE), "in no document") for path in pictures
            if path not in linked and path.parent not in linked]


def main():
    sources = [file for folder in FOLDERS for file in (SOURCE / folder).rglob("*") if file.is_file()]
    broken = broken_in(SOURCE) + broken_when_installed(sys.argv[1]) + unused_pictures()
    broken += [(file.relative_to(SOURCE), name) for file in sources for name in broken_names(file)]
    for each in broken:
        print("FAILED:", *each)
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
