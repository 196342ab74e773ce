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
    """An orbit in ranges of which something is to be proved, the files, and how it is shown.

    Attributes
    ----------
    name : str
        ``SYSTEM/ORBIT`` or ``FILE.py:ORBIT``.
    parameters : sequence of str
        ``NAME=VALUE`` and ``NAME=A:B``.
    near : dict of str to float or None
        A guess of the unknowns, in the system's units.
    resume : Path or None
        The file to go on from.
    save : Path or None
        The file to keep the answer in.
    plot : Path or None
        The picture's file.
    overwrite : bool
        Whether a file that is there may be replaced.
    as_json : bool
        Whether the answer is JSON.
    """

    name: str
    parameters: Sequence[str]
    near: Mapping[str, float] | None
    resume: Path | None
    save: Path | None
    plot: Path | None
    overwrite: bool
    as_json: bool

    def known(self, load: Callable[[Path], Any]) -> Any:
        """What to go on from, when the files are those that may be written.

        Parameters
        ----------
        load : callable
            Reads a file that was kept.

        Returns
        -------
        object or None

        Raises
        ------
        InputError
            If a file cannot be read or written, or would be replaced unasked.
        """
        check_drawing(self.plot)
        check_new(self.save, self.overwrite, self.resume, resumes=True)
        return None if self.resume is None else load(self.resume)

    @property
    def keep(self) -> Callable[[Any], object] | None:
        """What keeps a state by and by; None for nothing."""
        return None if self.save is None else lambda state: Written().save(state.save, self.save)

    def answer(
        self,
        found: Any,
        stopped: bool,
        told: Callable[[Any], Mapping[str, Any]],
        show: Callable[[Any], None],
        *,
        enough: bool,
        done: str,
    ) -> tuple[Mapping[str, str], int]:
        """Keep what is proved, draw and show it; gives its claims, and the exit code.

        Parameters
        ----------
        found : BoxCertificate, CertifiedBranch or CertifiedCascade
        stopped : bool
            Whether it was interrupted.
        told, show : callable
            What JSON has beside `to_json`, and what shows it to people.
        enough : bool
            Whether that answers the question.
        done : str
            What is done.

        Returns
        -------
        tuple of (dict, int)
        """
        written = Written()
        written.save(found.save, self.save)
        if self.plot is not None:
            written.draw(found.plot, self.plot)
        code = written.show(
            lambda: {**found.to_json(), **told(found)}, lambda: show(found), as_json=self.as_json
        )
        if stopped:
            return found.claims, kept_of(done, written.kept(self.save))
        return found.claims, code or (ANSWERED if enough else UNANSWERED)
