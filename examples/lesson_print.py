#!/usr/bin/env python3
"""Writes a page of docs/ as one HTML file to be printed or handed out: lesson_print.py docs/lesson.md lesson.html

It has the Markdown that these pages are written in; pictures become part of the file.
"""
import base64
import html
import pathlib
import re
import sys

STYLE = """@page { size: A4; margin: 18mm } body { font: 11pt/1.45 Georgia, serif; max-width: 46em; margin: 2em auto; padding: 0 1em }
h1, h2 { font-family: sans-serif; break-after: avoid } pre { font-size: 8.5pt; background: #f3f3f1; padding: .6em; white-space: pre-wrap }
table { border-collapse: collapse; font-size: 9.5pt; margin: 1em 0; break-inside: avoid } th, td { padding: .15em .6em; border-bottom: 1px solid #ccc; text-align: right }
th:first-child, td:first-child, table:has(img) th { text-align: left } img { max-width: 100%; break-inside: avoid } a { color: inherit } @media print { a { text-decoration: none } }"""


def inline(text, folder):
    """Of a paragraph: code, pictures, links, bold and italic."""
    def picture(match):
        data = base64.b64encode((folder / match[2]).read_bytes()).decode()
        return f'<img alt="{match[1]}" src="data:image/{"jpeg" if match[2].endswith(".jpg") else "png"};base64,{data}">'

    parts = re.split(r"(`[^`]+`)", text)
    for i, part in enumerate(parts):
        if i % 2:
            parts[i] = f"<code>{html.escape(part[1:-1])}</code>"
            continue
        part = html.escape(part)
        part = re.sub(r"!\[([^\]]*)\]\(([^)]+)\)", picture, part)
        part = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", part)
        parts[i] = re.sub(r"\*(\S[^*]*?)\*", r"<i>\1</i>", part)
    return re.sub(r"\[([^\]]+)\]\(([^)]+)\)", r'<a href="\2">\1</a>', "".join(parts))


def anchor(title):
    """As GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def rows(block, folder):
    cells = [[inline(cell.strip(), folder) for cell in line.strip("|").split("|")] for line in block]
    row = lambda tag, line: "<tr>" + "".join(f"<{tag}>{cell}</{tag}>" for cell in line) + "</tr>"
    return "<table>" + row("th", cells[0]) + "".join(row("td", line) for line in cells[2:]) + "</table>"


def body(text, folder):
    for block in re.split(r"\n\s*\n", text.strip("\n")):
        lines = block.split("\n")
        if heading := re.match(r"(#+) (.*)", block):
            level = len(heading[1])
            yield f'<h{level} id="{anchor(heading[2])}">{inline(heading[2], folder)}</h{level}>'
        elif block.startswith("    "):
            yield "<pre>" + html.escape("\n".join(line[4:] for line in lines)) + "</pre>"
        elif block.startswith("|"):
            yield rows(lines, folder)
        elif first := re.match(r"(\d+)\. |- ", block):
            items = re.split(r"\n(?=\d+\. |- )", block)
            tag = f'ol start="{first[1]}"' if first[1] else "ul"
            items = "".join("<li>" + inline(re.sub(r"^(\d+\.|-) ", "", item), folder) + "</li>" for item in items)
            yield f"<{tag}>{items}</{tag[:2]}>"
        else:
            yield f"<p>{inline(block, folder)}</p>"


def main():
    source, target = map(pathlib.Path, sys.argv[1:3])
    text = source.read_text()
    title = html.escape(text.split("\n", 1)[0].lstrip("# "))
    target.write_text(f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{title}</title><style>{STYLE}</style>'
                      + "\n".join(body(text, source.parent)) + "</html>\n")


main()
