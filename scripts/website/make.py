#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""make.py FOLDER [API [MODULE]]: writes the manual as a website that needs no server.

The website has the pages of docs/ with their pictures, the notebooks and a search. With API, the folder html that
scripts/api-reference.sh has made, it also has the reference of the library. With MODULE, the folder of the Python module,
the notebooks are run and show their results, which needs Matplotlib. Fails on a broken link. Needs python3-markdown."""

import html
import html.parser
import json
import os
import re
import shutil
import sys
import urllib.parse

import markdown

import notebook

here = os.path.dirname(os.path.abspath(__file__))
docs = os.path.normpath(os.path.join(here, "../../docs"))
notebooks = os.path.normpath(os.path.join(here, "../../examples/notebooks"))


def slug(title, separator="-"):
    """Returns the anchor of a heading, as the pages' links name it."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", separator)


def page_names():
    """Returns the manual first, then the pages in the order of its list, then all others."""
    with open(os.path.join(docs, "manual.md")) as file:
        listed = re.findall(r"\]\(([\w-]+\.md)\)", file.read())
    others = sorted(name for name in os.listdir(docs) if name.endswith(".md"))
    return list(dict.fromkeys(["manual.md", *listed, *others]))


def web_name(name):
    return "index.html" if name == "manual.md" else name[:-3] + ".html"


def target(link):
    """Returns the address on the website of a link in a page, or None if it leads to a file that is only in the sources."""
    parts = urllib.parse.urlsplit(link)
    if parts.scheme or not parts.path:
        return link
    if parts.path.startswith("../"):
        return None
    path = web_name(parts.path) if parts.path.endswith(".md") else parts.path
    return path + ("#" + parts.fragment if parts.fragment else "")


class Page:
    """A page of the website, converted from Markdown."""

    def __init__(self, name, text):
        converter = markdown.Markdown(extensions=["tables", "fenced_code", "toc", "sane_lists"],
                                      extension_configs={"toc": {"slugify": slug}})
        self.name, self.pictures = name, []
        self.body = re.sub(r'<a href="([^"]*)">(.*?)</a>', self.link, converter.convert(text), flags=re.S)
        self.body = re.sub(r'src="(\.\./[^"]*)"', self.picture, self.body)
        self.body = self.body.replace("<table>", '<div class="wide"><table>').replace("</table>", "</table></div>")
        self.title = html.unescape(re.sub("<.*?>", "", re.search(r"<h1.*?>(.*?)</h1>", self.body)[1]))

    @staticmethod
    def link(match):
        address = target(html.unescape(match[1]))
        return match[2] if address is None else f'<a href="{html.escape(address)}">{match[2]}</a>'

    def picture(self, match):
        """Returns the new address of a picture from elsewhere in the sources and notes the file, which is copied to the others."""
        self.pictures.append(os.path.join(docs, match[1]))
        return f'src="pictures/{os.path.basename(match[1])}"'

    def sections(self):
        """Yields the entries of the search: one section of the page for each heading."""
        pieces = re.split(r'<h[1-3] id="([^"]*)">(.*?)</h[1-3]>', self.body, flags=re.S)
        for anchor, title, text in zip(pieces[1::3], pieces[2::3], pieces[3::3]):
            plain = html.unescape(re.sub(r"\s+", " ", re.sub("<.*?>", " ", text))).strip()
            title = html.unescape(re.sub("<.*?>", "", title))
            yield {"page": self.title, "title": title, "href": f"{self.name}#{anchor}", "text": plain}


def written(page, pages, api):
    def item(one):
        return '<li><a href="%s"%s>%s</a></li>' % (one.name, ' aria-current="page"' if one is page else "",
                                                   html.escape(one.title))
    items = "".join(item(one) for one in pages if not one.name.startswith("notebook-"))
    if api:
        items += '<li><a href="api/index.html">Reference of the library</a></li>'
    cells = "".join(item(one) for one in pages if one.name.startswith("notebook-"))
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{html.escape(page.title)} – Wend</title>
<link rel="icon" href="wend.svg">
<link rel="stylesheet" href="style.css">
<script src="sections.js" defer></script>
<script src="search.js" defer></script>
</head>
<body>
<nav>
<h2><a href="index.html">Wend</a></h2>
<input id="search" type="search" placeholder="Search" aria-label="Search the manual">
<ul id="results"></ul>
<ul>{items}</ul>
<h3>Notebooks</h3>
<ul>{cells}</ul>
</nav>
<main>
{page.body}
</main>
</body>
</html>
"""


class Links(html.parser.HTMLParser):
    """The links and the anchors of a page."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key in ("href", "src") and value is not None:
                self.links.append(value)
            if key in ("id", "name") and value is not None:
                self.anchors.add(value)


def dead_links(folder):
    known = {}

    def links(path):
        if path not in known:
            with open(path, encoding="utf-8", errors="replace") as file:
                known[path] = Links(file.read())
        return known[path]

    for name in sorted(os.listdir(folder)):
        if not name.endswith(".html"):
            continue
        path = os.path.join(folder, name)
        for link in links(path).links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme:
                continue
            goal = os.path.join(folder, urllib.parse.unquote(parts.path)) if parts.path else path
            anchor = urllib.parse.unquote(parts.fragment)
            if not os.path.isfile(goal) or (anchor and goal.endswith(".html") and anchor not in links(goal).anchors):
                yield f"{name}: {link} leads nowhere"


def read(name):
    with open(os.path.join(docs, name)) as file:
        return file.read()


def main(folder, api=None, module=None):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder + "/pictures")
    if module:
        sys.path.insert(0, os.path.abspath(module))
    pages = [Page(web_name(name), read(name)) for name in page_names()]
    for name in sorted(os.listdir(notebooks)):
        text = notebook.text_of(os.path.join(notebooks, name), folder + "/pictures", module is not None)
        pages.append(Page(f"notebook-{name[:-6]}.html", text))
    own = [os.path.join(docs, "pictures", name) for name in os.listdir(docs + "/pictures")]
    for name in own + [one for page in pages for one in page.pictures]:
        if name.endswith((".png", ".svg", ".webp")):
            shutil.copy(name, folder + "/pictures")
    for name in (here + "/style.css", here + "/search.js", here + "/../../resources/icons/wend.svg"):
        shutil.copy(name, folder)
    if api:
        shutil.copytree(api, folder + "/api")
    with open(folder + "/sections.js", "w") as file:
        file.write("const sections = " + json.dumps([one for page in pages for one in page.sections()], ensure_ascii=False) + ";\n")
    for page in pages:
        with open(os.path.join(folder, page.name), "w") as file:
            file.write(written(page, pages, api))
    dead = list(dead_links(folder))
    print("\n".join(dead) or f"{len(pages)} pages, no dead link")
    return 1 if dead else 0


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
