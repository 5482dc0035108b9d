# SPDX-License-Identifier: GPL-3.0-or-later
"""A page of HTML as those who check it need it."""
import html.parser
import urllib.parse


class Page(html.parser.HTMLParser):
    """It has links, to which href and src lead, ids, and wrong, which is what is not closed or there twice."""

    VOID = {"meta", "br", "hr", "img", "link", "input"}

    def __init__(self, path):
        super().__init__()
        self.links, self.ids, self.open, self.wrong = [], [], [], []
        self.text = path.read_text()
        self.feed(self.text)
        self.wrong += [f"<{tag}> is not closed" for tag in self.open]
        self.wrong += [f"the id {name} is there {self.ids.count(name)} times" for name in sorted({i for i in self.ids if self.ids.count(i) > 1})]

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.links += [attributes[k] for k in ("href", "src") if k in attributes]
        if "id" in attributes:
            self.ids.append(attributes["id"])
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in self.VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.wrong.append(f"</{tag}> closes something else")


def wrong_links(pages, but=()):
    """Yields which links of the pages, {path: Page}, lead nowhere or need a network. but: links that are not looked at."""
    for path, page in pages.items():
        for link in page.links:
            target = urllib.parse.urlparse(link)
            file = path.parent / urllib.parse.unquote(target.path) if target.path else path
            if target.scheme == "data" or link in but:
                continue
            if target.scheme or target.netloc:
                yield f"{path.name}: {link} needs a network"
            elif not file.is_file():
                yield f"{path.name}: {link} leads nowhere"
            elif target.fragment and file in pages and target.fragment not in pages[file].ids:
                yield f"{path.name}: {link}: no such place in the page"
