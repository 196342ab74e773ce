"""Proofs that may run for long: what they go on with, how they are kept, drawn and shown."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nonsmooth.runtime.cli.application import ANSWERED, UNANSWERED, check_drawing
from nonsmooth.runtime.cli.keeping import check_new, kept_of
from nonsmooth.runtime.cli.written import Written
from nonsmooth.runtime.core.errors import InputError

__all__ = ["LongProof", "question_in"]


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


def question_in(path: Path) -> tuple[str, list[str], bool]:
    """Orbit and parameters of a saved box or branch, and whether it is a branch.

    Parameters
    ----------
    path : Path

    Returns
    -------
    tuple of (str, list of str, bool)
        ``SYSTEM/ORBIT``; ``NAME=VALUE`` and ``NAME=A:B``.

    Raises
    ------
    InputError
        If the file holds neither, or an orbit that has no name.
    """
    from nonsmooth.runtime.present.files.loading import load
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate
    from nonsmooth.runtime.proof.branch.certified_branch import CertifiedBranch

    found = load(path)
    if isinstance(found, BoxCertificate):
        ranges = found.box
    elif isinstance(found, CertifiedBranch):
        ranges = {found.parameter: found.interval}
    else:
        raise InputError(f"{path} does not hold its question: name the orbit and its parameters")
    if "," in found.orbit:  # told by its phases
        raise InputError(f"{path}: its orbit has no name: name the file that it is from")
    given = [f"{n}={value}" for n, value in found.parameters.items() if n not in found.chosen]
    spans = [f"{name}={low}:{high}" for name, (low, high) in ranges.items()]
    return found.orbit, [*given, *spans], isinstance(found, CertifiedBranch)
