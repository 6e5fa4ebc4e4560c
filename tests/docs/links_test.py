"""Links between documents lead to files and headings that there are, and so do names of documents in sources."""
import pathlib
import re
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
DOCUMENTS = [*SOURCE.glob("*.md"), *(SOURCE / "docs").rglob("*.md")]
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
        if not target.exists() or (anchor and anchor not in anchors(target)):
            yield link


def broken_names(file):
    """Of docs/….md in comments and texts."""
    try:
        text = file.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return []
    return [name for name in re.findall(r"\bdocs/[\w./-]+\.md\b", text) if not (SOURCE / name).exists()]


def main():
    sources = [file for folder in FOLDERS for file in (SOURCE / folder).rglob("*") if file.is_file()]
    broken = [(document, link) for document in DOCUMENTS for link in broken_links(document)]
    broken += [(file, name) for file in sources for name in broken_names(file)]
    for file, link in broken:
        print("FAILED: {}: {}".format(file.relative_to(SOURCE), link))
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
