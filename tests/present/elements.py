"""What a page or a table of HTML holds, read by a parser of its own."""

from html.parser import HTMLParser

VOID = {"br", "hr", "img", "input", "link", "meta", "source", "wbr"}


class Elements(HTMLParser):
    """Start tags with their attributes, and texts; every element is closed in its turn."""

    def __init__(self, text):
        super().__init__()
        self.found = []
        self.texts = []
        self._open = []
        self.feed(text)
        self.close()
        assert not self._open

    def handle_starttag(self, tag, attributes):
        self.handle_startendtag(tag, attributes)
        if tag not in VOID:
            self._open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.found.append((tag, {name: value or "" for name, value in attributes}))

    def handle_endtag(self, tag):
        assert self._open.pop() == tag

    def handle_data(self, text):
        self.texts.append(text)

    @property
    def words(self):
        """All texts."""
        return "".join(self.texts)

    @property
    def tags(self):
        """Kinds of elements."""
        return {tag for tag, _ in self.found}

    def attributes(self, name, tag=""):
        """Values of an attribute, on one tag or on all."""
        return [own[name] for kind, own in self.found if name in own and kind in (tag or kind)]
