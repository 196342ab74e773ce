"""How results show themselves: a few lines in a console, a table in a notebook."""

from nonsmooth.runtime.core.registry import registered

__all__ = ["Shown"]


class Shown:
    """A result that tells what it is; `present.summaries` has the words of each kind."""

    def __repr__(self) -> str:
        text: str = registered("summary_text")(self)
        return text

    def _repr_html_(self) -> str:
        text: str = registered("summary_html")(self)
        return text
