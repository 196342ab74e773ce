"""What a command answers: what it shows, and the files and pictures that it writes.

The rule of all commands that may run for long (find, sweep, continue, fit, design, certify):
`--save` begins a new file and replaces one only with `--overwrite`. What costs seconds (an orbit,
a motion, a picture) replaces what is there; a chart's folder is gone on with.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.cli.application import ANSWERED, NOT_MET, UNANSWERED, WRONG_INPUT, print_json
from nonsmooth.runtime.cli.keeping import INTERRUPTED, heeding, kept_of, say
from nonsmooth.runtime.core.errors import InputError, NonsmoothError

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PICTURES = (".png", ".svg", ".pdf")  # endings of files


@dataclass
class Reply:
    """The files that a running command reads and writes, and the form of its answer.

    A file that cannot be written and a picture that cannot be drawn, or that Ctrl-C ended,
    are reported only when all that was computed has been shown.
    """

    as_json: bool
    save: Path | None = None  # file of the answer
    plot: Path | None = None  # file of the picture
    resume: Path | None = None  # file of an earlier answer
    overwrite: bool = True  # whether the file of the answer may be there already
    kept: str = ""  # kind of the file that the command can go on with
    lists: bool = False  # whether JSON has a list of files, or that of the answer alone
    _written: list[str] = field(default_factory=list)
    _unsaved: list[InputError] = field(default_factory=list)
    _settled: bool = False
    _undrawn: NonsmoothError | KeyboardInterrupt | None = None

    def check(self) -> None:
        """Refuse files that could not be written, or may not be replaced, before any work."""
        from nonsmooth.runtime.core.files import check_ending, check_target

        if self.plot is not None:
            from nonsmooth.runtime.present.pictures.drawing import check_matplotlib

            check_ending(self.plot, PICTURES)
            check_target(self.plot)
            check_matplotlib()
        if self.save is None:
            return
        check_target(self.save)
        resumed = self.resume and os.path.realpath(self.save) == os.path.realpath(self.resume)
        if self.save.exists() and not (self.overwrite or resumed):
            goes_on = f"--resume {self.save} goes on with it, " if self.kept else ""
            raise InputError(f"{self.save} is there already: {goes_on}--overwrite replaces it")

    @property
    def known(self) -> Any:
        """The earlier answer to go on from; None if there is none."""
        from nonsmooth.runtime.present.files.kept import format_named

        return self.resume and format_named(f"nonsmooth {self.kept}").load(self.resume)

    @property
    def saved(self) -> Path | None:
        """The file of the answer if it was written, else None."""
        return self.save if str(self.save) in self._written else None

    @property
    def keep(self) -> Callable[[Any], object] | None:
        """A function that saves a state of the work; None if no file was asked for."""
        return None if self.save is None else lambda state: self.write(state.save)

    def write(self, save: Callable[[Path], object], path: Path | None = None) -> None:
        """Write a file by `save`, which takes its path: by default that of the answer, if any."""
        path = path or self.save
        if path is None:
            return
        try:
            save(path)
        except InputError as problem:
            self._unsaved.append(problem)
        else:
            self._written += [str(path)] * (str(path) not in self._written)

    def settle(self, save: Callable[[Path], object]) -> None:
        """Write the file of the answer once: `give` does so if it was not done before."""
        if not self._settled:
            self.write(save)
        self._settled = True

    def draw(self, figure: Callable[[], Figure]) -> None:
        """Draw the figure that `figure` makes, if a picture was asked for."""
        from nonsmooth.runtime.present.pictures.plot import save_figure

        if self.plot is None:
            return
        try:
            with heeding():
                save_figure(figure(), self.plot)
        except (NonsmoothError, KeyboardInterrupt) as problem:
            self._undrawn = problem
        else:
            self._written.append(str(self.plot))

    def show(self, told: Callable[[], Mapping[str, Any]], show: Callable[[], object]) -> int:
        """Show an answer and the files that were written; gives the exit code.

        `told` gives what JSON has, `show` shows the answer to people.
        """
        alone = self.saved is not None and not self.lists
        if self.as_json:
            files = {"files": self._written} if self.lists else {}
            print_json({**told(), **files, **({"file": str(self.saved)} if alone else {})})
        else:
            show()
            for path in self._written:
                print(f"{path} written")
        for problem in self._unsaved:
            say(f"error: not saved: {problem}")
        if isinstance(self._undrawn, KeyboardInterrupt):
            say("interrupted: no picture is drawn")
            return INTERRUPTED
        if self._undrawn is not None:
            say(f"error: no picture: {self._undrawn}")
        return ANSWERED if self._undrawn is None and not self._unsaved else WRONG_INPUT

    def give(
        self,
        found: Any,
        stopped: bool = False,
        *,
        done: str = "",
        enough: bool = True,
        require: object = None,
        claims: Mapping[str, str] | None = None,
        resumes: bool = True,
        told: Callable[[], Mapping[str, Any]] | None = None,
        show: Callable[[], object] | None = None,
        save: Callable[[Path], object] | None = None,
        figure: Callable[[], Figure] | None = None,
    ) -> int:
        """Save, draw and show a result; gives the exit code.

        `stopped` says whether Ctrl-C ended the work, `done` then how much is done, and
        `resumes` whether the command can go on with its file. The exit code is that of an
        answer if the result is `enough`; if all `claims`, by default those of the result, are
        required to be proved it says whether they are. The functions replace what the result
        itself does.
        """
        from nonsmooth.runtime.cli.display import show_result

        self.settle(save or found.save)
        if self.plot is not None:
            self.draw(figure or found.plot)
        code = self.show(told or found.to_json, show or (lambda: show_result(found)))
        if stopped:
            return kept_of(done, self.saved, resumes=resumes and bool(self.kept))
        code = code or (ANSWERED if enough else UNANSWERED)
        return proved(found.claims if claims is None else claims, code) if require else code


def proved(claims: Mapping[str, str], code: int) -> int:
    """The given exit code, or `NOT_MET` if a claim is not proved, which is named on stderr."""
    missed = [f"{name} {verdict}" for name, verdict in claims.items() if verdict != "proved"]
    if not missed:
        return code
    say(f"required: proved; found: {', '.join(missed)}")
    return NOT_MET


def met(verdicts: Mapping[str, object], required: Iterable[str] | None) -> int:
    """The exit code of an orbit with these verdicts; requirements not met are named on stderr."""
    code = ANSWERED
    for name in dict.fromkeys(required or ()):
        verdict = verdicts[name]
        if verdict == "undecided":
            code = code or UNANSWERED
        elif verdict not in ("stable", True):
            say(f"required: {name}; found: {'no' if verdict is False else verdict}")
            code = NOT_MET
    return code


def show_comparison(
    reply: Reply, told: Mapping[str, Any], differences: Sequence[str], source: str
) -> int:
    """Show how the files in a folder differ from their source; gives the exit code.

    `told` is the rest of the answer, "folder" among it; `source` says what the files are
    made from and how to make them again. Without differences they are up to date.
    """
    from nonsmooth.runtime.cli.display import show_differences

    if reply.as_json:
        print_json({**told, "same": not differences, "differences": list(differences)})
    elif differences:
        show_differences(differences)
    else:
        print(f"{told['folder']}: up to date")
    if not differences:
        return ANSWERED
    say(f"{told['folder']} differs from {source}")
    return UNANSWERED
