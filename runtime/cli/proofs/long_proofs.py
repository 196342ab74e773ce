"""Proofs that may run for long: what they go on with, how they are kept, drawn and shown."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nonsmooth.runtime.cli.application import ANSWERED, UNANSWERED, check_drawing
from nonsmooth.runtime.cli.keeping import check_new, kept_of
from nonsmooth.runtime.cli.written import Written

__all__ = ["LongProof"]


@dataclass(frozen=True, kw_only=True)
class LongProof:
    """The question of a long proof, its files, and the form of its answer."""

    name: str  # SYSTEM/ORBIT, FILE.py:ORBIT, or the name of a system
    parameters: Sequence[str]  # NAME=VALUE and NAME=A:B
    near: Mapping[str, float] | None  # guess of the unknowns, in the system's units
    resume: Path | None  # file to go on from
    save: Path | None  # file of the answer
    plot: Path | None  # file of the picture
    overwrite: bool  # whether an existing file may be replaced
    as_json: bool  # whether the answer is shown as JSON

    def known(self, load: Callable[[Path], Any]) -> Any:
        """The earlier result to go on from, read by `load`; None if there is none.

        The files are checked first: InputError refuses one that cannot be read or written, or
        would be replaced unasked.
        """
        check_drawing(self.plot)
        check_new(self.save, self.overwrite, self.resume, resumes=True)
        return None if self.resume is None else load(self.resume)

    @property
    def keep(self) -> Callable[[Any], object] | None:
        """A function that saves a state of the work; None if no file was asked for."""
        return None if self.save is None else lambda state: Written().save(state.save, self.save)

    def answer(
        self,
        found: Any,
        stopped: bool,
        show: Callable[[Any], None],
        *,
        enough: bool,
        done: str,
    ) -> tuple[Mapping[str, str], int]:
        """Save, draw and show a result; gives its claims and the exit code.

        `show` shows the result to people, `stopped` says whether it was interrupted and `done`
        then how much is done. The exit code is that of an answer if the result is `enough`.
        """
        written = Written()
        written.save(found.save, self.save)
        if self.plot is not None:
            written.draw(found.plot, self.plot)
        code = written.show(found.to_json, lambda: show(found), as_json=self.as_json)
        if stopped:
            return found.claims, kept_of(done, written.kept(self.save))
        return found.claims, code or (ANSWERED if enough else UNANSWERED)
