# SPDX-License-Identifier: GPL-3.0-or-later
"""A page of HTML as those who check it need it."""
import html.parser


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
