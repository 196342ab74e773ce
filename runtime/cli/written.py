"""What a command answers: files and pictures that it writes, and what it shows of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.cli.application import (
    ANSWERED,
    UNANSWERED,
    WRONG_INPUT,
    print_json,
)
from nonsmooth.runtime.cli.keeping import INTERRUPTED, heeding, say
from nonsmooth.runtime.core.errors import InputError, NonsmoothError

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["Written", "show_comparison"]


class Written:
    """The files and pictures that a command writes, which its answer names.

    A file that cannot be written and a picture that cannot be drawn, or that Ctrl-C ended,
    are reported only when all that was computed has been shown. The list `files` has the
    paths that are written so far.
    """

    def __init__(self) -> None:
        self.files: list[str] = []
        self._unsaved: list[InputError] = []
        self._problem: NonsmoothError | KeyboardInterrupt | None = None

    def save(self, save: Callable[[Path], object], path: Path | None) -> None:
        """Save a result by `save`, which takes the path; None is no path and nothing is saved."""
        if path is None:
            return
        try:
            save(path)
        except InputError as problem:
            self._unsaved.append(problem)
        else:
            self.files.append(str(path))

    def kept(self, path: Path | None) -> Path | None:
        """The path if its file was written, else None."""
        return path if str(path) in self.files else None

    def draw(self, figure: Callable[[], Figure], path: Path) -> None:
        """Draw the figure that `figure` makes, and remember the problem if that fails."""
        from nonsmooth.runtime.present.pictures.plot import save_figure

        try:
            with heeding():
                save_figure(figure(), path)
        except (NonsmoothError, KeyboardInterrupt) as problem:
            self._problem = problem
        else:
            self.files.append(str(path))

    def show(
        self, told: Callable[[], Mapping[str, Any]], show: Callable[[], None], *, as_json: bool
    ) -> int:
        """Show an answer and all files, as JSON by `told` or for people by `show`.

        It gives the exit code.
        """
        if as_json:
            print_json({**told(), "files": self.files})
        else:
            show()
            for path in self.files:
                print(f"{path} written")
        return self._ended()

    def _ended(self) -> int:
        """Report what could not be written or drawn; gives the exit code."""
        for problem in self._unsaved:
            say(f"error: not saved: {problem}")
        if isinstance(self._problem, KeyboardInterrupt):
            say("interrupted: no picture is drawn")
            return INTERRUPTED
        if self._problem is not None:
            say(f"error: no picture: {self._problem}")
        return ANSWERED if self._problem is None and not self._unsaved else WRONG_INPUT

    def show_one(
        self,
        told: Callable[[], Mapping[str, Any]],
        show: Callable[[], None],
        path: Path | None,
        *,
        as_json: bool,
    ) -> int:
        """Show an answer and the one file that it is kept in, as JSON or for people.

        `told` gives the answer ready for JSON, `show` shows it to people, and `path` is the
        file that was asked for, if any. The exit code is 2 if it could not be written.
        """
        kept = self.kept(path)
        if as_json:
            print_json(told() if kept is None else {**told(), "file": str(kept)})
        else:
            show()
            if kept is not None:
                print(f"\n{kept} written")
        return self._ended()


def show_comparison(
    told: Mapping[str, Any], differences: Sequence[str], source: str, *, as_json: bool
) -> int:
    """Show how the files in a folder differ from their source; gives the exit code.

    `told` is the rest of the answer, "folder" among it; `source` says what the files are
    made from and how to make them again. Without differences they are up to date.
    """
    from nonsmooth.runtime.cli.display import show_differences

    if as_json:
        print_json({**told, "same": not differences, "differences": list(differences)})
    elif differences:
        show_differences(differences)
    else:
        print(f"{told['folder']}: up to date")
    if not differences:
        return ANSWERED
    say(f"{told['folder']} differs from {source}")
    return UNANSWERED
