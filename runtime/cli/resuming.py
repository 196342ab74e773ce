"""Commands that go on: the file that `--save` wrote states what was asked."""

from __future__ import annotations

import inspect
import shlex
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, nullcontext
from contextvars import ContextVar
from enum import Enum
from pathlib import Path
from types import UnionType
from typing import TYPE_CHECKING, Any, NamedTuple, get_args

import typer

from nonsmooth.runtime.core.errors import InputError

if TYPE_CHECKING:
    from nonsmooth.runtime.model.kernels import OrbitKernels
    from nonsmooth.runtime.orbits.orbit import Orbit

_FILES = {"save", "resume", "overwrite"}
_TARGETS = {"orbit": "an orbit", "system": "a system"}
_HOLDERS = ("orbit", "events", "branches")  # entries whose parts hold a system, as files do


class _Running(NamedTuple):
    """The running command line, and what the files that it writes state of it."""

    beside: list[str]  # options that are not part of the question
    request: dict[str, Any]  # command and options, as files hold them


class _Held(NamedTuple):
    """An undeclared orbit as a file holds it, and its kernels."""

    content: Any
    kernels: OrbitKernels


_RUNNING: ContextVar[_Running] = ContextVar("the command that is running")


class Request:
    """What a command asks: some of its parameters, which a file states that it writes.

    `asked` names those that may be repeated beside the file only if they are the same, `anew`
    those that say how much is done and may change; `declared` are all of the command.
    """

    def __init__(
        self, asked: list[str], anew: list[str], declared: Mapping[str, inspect.Parameter]
    ) -> None:
        self._asked, self._stated = asked, [*asked, *anew]
        self._needed = [name for name, each in declared.items() if each.default is each.empty]
        self._kinds = {name: declared[name].annotation for name in self._stated}
        self.parameters = [
            each.replace(default=None) if name in self._needed else each
            for name, each in declared.items()
        ]

    @contextmanager
    def put(self, context: typer.Context, options: dict[str, Any]) -> Iterator[None]:
        """Take from the file of --resume what is not given, and let files state the question."""
        from nonsmooth.runtime.core.result_files import stating
        from nonsmooth.runtime.model.kernels import standing_for

        given, held, orbit = _given(context), dict[str, str](), None
        if options["resume"] is not None:
            given = _placed(given, options)
            repeated = given & {*self._asked}
            asked, held, orbit = _resumed(context, options, repeated, self._kinds)
            options |= {n: x for n, x in asked.items() if n in self._asked or n not in given}
            options["save"] = options["save"] or options["resume"]
        for name in self._needed:
            if options[name] is None:
                raise InputError(f"{_TARGETS[name]} is missing, or --resume FILE")
        stated = {n: _written(options[n]) for n in self._stated if _is_there(options[n])}
        beside = _words(context, options, given & options.keys() - {*self._stated} - _FILES)
        request = {"command": _name(context), "options": stated}
        target: str = options.get("orbit") or ""
        if orbit is None and options["save"] is not None:
            orbit = _to_hold(target)
        if orbit is not None:
            request["orbit"] = orbit.content
        at_hand = nullcontext() if orbit is None else standing_for(target, orbit.kernels)
        token = _RUNNING.set(_Running(beside, request))
        options |= held
        try:
            with stating(request), at_hand:
                yield
        finally:
            _RUNNING.reset(token)


def command_to_resume(path: Path) -> str:
    """The command line, quoted for a shell, that goes on with a file of the running command."""
    running = _RUNNING.get()
    name = running.request["command"].split()
    return shlex.join(["nonsmooth", *name, "--resume", str(path), *running.beside])


def hold(orbit: Orbit) -> None:
    """Let the files of the running command hold the orbit that it begins with.

    This serves files that may be written before they have a part that holds the system.
    """
    from nonsmooth.runtime.orbits.orbit_file import orbit_content

    request = _RUNNING.get().request
    if "orbit" not in request and not orbit.system.built_in:
        request["orbit"] = orbit_content(orbit)


def _to_hold(name: str) -> _Held | None:
    """The named orbit if another file holds it; None for a declared one.

    Parts of the result hold a declared one.
    """
    from nonsmooth.runtime.model.kernels import is_saved
    from nonsmooth.runtime.present.files.named_entries import orbit_to_hold

    return _as_held(orbit_to_hold(name), name) if is_saved(name) else None


def _as_held(content: Any, name: str) -> _Held:
    from nonsmooth.runtime.present.files.named_entries import held_kernels

    return _Held(content, held_kernels(content, name))


def _name(context: typer.Context) -> str:
    """The words that name the running command, such as ``certify box``."""
    name = str(context.command.name)
    above = context.parent
    return f"{above.command.name} {name}" if above is not None and above.parent else name


def _given(context: typer.Context) -> set[str]:
    """Names of the parameters that the command line gives."""
    sources = {name: context.get_parameter_source(name) for name in context.params}
    return {name for name, source in sources.items() if source and source.name == "COMMANDLINE"}


def _placed(given: set[str], options: dict[str, Any]) -> set[str]:
    """Names of what is given, once a leading ``NAME=VALUE`` is moved to the parameters.

    Such a text stands first, where an orbit or a system would, if those are left out.
    """
    for name in given & _TARGETS.keys():
        if "=" in options[name]:
            options["parameters"] = [options[name], *(options["parameters"] or [])]
            options[name] = None
            return given - {name} | {"parameters"}
    return given


def _flag(context: typer.Context, name: str) -> str:
    """The flag of an option and a space; empty for an argument."""
    flag = next(each.opts[0] for each in context.command.params if each.name == name)
    return f"{flag} " if flag.startswith("-") else ""


def _words(context: typer.Context, options: Mapping[str, Any], names: set[str]) -> list[str]:
    """The named options as words of a command line."""
    found: list[str] = []
    for name in sorted(names):
        values = options[name] if isinstance(options[name], list) else [options[name]]
        for value in values:
            told = [] if value is True else [str(_written(value))]
            found += [*_flag(context, name).split(), *told]
    return found


def _resumed(
    context: typer.Context, options: Mapping[str, Any], given: set[str], kinds: Mapping[str, Any]
) -> tuple[dict[str, Any], dict[str, str], _Held | None]:
    """The options that the file to resume states, and the orbit or system that it holds.

    All are empty if the file states no question, as when Python wrote it. What is given of
    the question has to agree with the file; InputError refuses the rest.
    """
    from nonsmooth.runtime.core.result_files import content_of, naming
    from nonsmooth.runtime.model.kernels import orbit_names

    with naming(options["resume"]):
        content = content_of(options["resume"])
        request = content.get("request")
        if request is None:
            if not given & _TARGETS.keys():
                raise InputError("it does not hold its question: name that too")
            return {}, {}, None
        if request["command"] != _name(context):
            raise InputError(f"`nonsmooth {request['command']}` wrote it")
        asked = {name: _read(name, kinds[name], x) for name, x in request["options"].items()}
        _check_same(context, {name: options[name] for name in given}, asked)
        targets = {name: asked[name] for name in _TARGETS.keys() & asked.keys() - given}
        if "orbit" in targets and "orbit" in request and targets["orbit"] not in orbit_names():
            return asked, {}, _as_held(request["orbit"], targets["orbit"])
        held = {target: _held(content, target, name) for target, name in targets.items()}
        return asked, held, None


def _is_there(value: Any) -> bool:
    """Whether an option has a value: 0 is one, while None, False and an empty list are none."""
    return value is not None and value is not False and value != []


def _written(value: Any) -> Any:
    """The value of an option as JSON has it."""
    return value.value if isinstance(value, Enum) else value


def _read(name: str, kind: Any, entry: Any) -> Any:
    """The value of an option of the annotated type `kind`, from its JSON entry."""
    own = get_args(kind)[0]  # of Annotated
    for each in get_args(own) if isinstance(own, UnionType) else (own,):
        if each == list[str]:
            if isinstance(entry, list) and all(isinstance(text, str) for text in entry):
                return entry
        elif issubclass(each, Enum):
            if entry in {one.value for one in each}:
                return each(entry)
        elif type(entry) is each or (each is float and type(entry) is int):
            return entry
    raise InputError(f"{name!r} is of the wrong type")


def _check_same(context: typer.Context, given: Mapping[str, Any], asked: Mapping[str, Any]) -> None:
    """Refuse options that are given beside a file and differ from those that it states."""
    for name, value in given.items():
        flag, known = _flag(context, name), _parts(asked.get(name))
        for first, text in _parts(value).items():
            if first not in known:
                raise InputError(f"asked without {flag.strip() if value is True else flag + text}")
            if not _same(text, known[first]):
                raise InputError(f"asked with {flag}{known[first]}, not {text}")


def _parts(value: Any) -> dict[str, str]:
    """Entries ``NAME=VALUE`` of an option by their names; a plain value under the empty name."""
    if not _is_there(value):
        return {}
    if not isinstance(value, list):
        return {"": str(_written(value))}
    texts = [text.strip() for option in value for text in option.split(",")]
    return {text.partition("=")[0].strip(): text for text in texts}


def _same(one: str, other: str) -> bool:
    """Whether two texts have the same exact meaning, as NAME=1/2 and NAME=0.5 have."""
    from nonsmooth.runtime.core.values import parse

    if one == other:
        return True
    parts = [text.partition("=")[2].split(":") for text in (one, other)]
    try:
        values = [[parse(part).exact for part in found] for found in parts]
    except InputError:
        return False
    return values[0] == values[1] and None not in values[0]


def _held(content: Mapping[str, Any], target: str, name: str) -> str:
    """The name under which a file holds the given orbit or system.

    Built-in names stay. InputError refuses a name whose system the file does not hold,
    because no declaration is run to find it.
    """
    from nonsmooth.runtime.model.kernels import is_saved, orbit_names, system_names
    from nonsmooth.runtime.model.naming import is_hashed

    if name in (*system_names(), *orbit_names()):
        return name
    held = [content.get(holder) for holder in _HOLDERS]
    lists = [entry if isinstance(entry, list) else [entry] for entry in held]
    parts = [content, *(part for entry in lists for part in entry if isinstance(part, dict))]
    system = next((part["system"] for part in parts if part.get("tables")), "")
    if is_saved(name) or not (isinstance(system, str) and is_hashed(system)):
        # a file of Python would be run, and that of an orbit may be another one by now
        raise InputError(f"it does not hold {name}: name that too")
    return f"{system}:{name.rpartition(':')[2]}" if target == "orbit" else system
