"""A file is as its schema says, and a format of files whose content changes has another version."""

import copy
import json
from hashlib import sha256

import pytest
from jsonschema import Draft202012Validator

import nonsmooth as ns
from nonsmooth.runtime.present.files.loading import file_schemas
from tests.core.test_result_files import KINDS, TWO_MASSES, text_of

# by format: the version, and a hash of the names and types of all entries. A test that fails
# here asks for a higher version of the format, or of what all files hold of a system
KNOWN = {
    "nonsmooth basin certificate": (6, "10883acf4ac7"),
    "nonsmooth box certificate": (8, "e388857d3136"),
    "nonsmooth branch": (4, "1ae4eec6b276"),
    "nonsmooth census": (6, "2ae42dfdecb7"),
    "nonsmooth certificate": (6, "460fdfc2fa14"),
    "nonsmooth certified branch": (6, "5ccf189720b4"),
    "nonsmooth certified doubling": (3, "347985c4827a"),
    "nonsmooth chaos certificate": (6, "987c9691077d"),
    "nonsmooth design": (2, "2316c7be67fc"),
    "nonsmooth event certificate": (6, "d4733488a54e"),
    "nonsmooth fit": (3, "c3f7ea330e24"),
    "nonsmooth found orbits": (7, "b2f7a7b829c0"),
    "nonsmooth region certificate": (6, "22f38246ec29"),
    "nonsmooth locus": (3, "55c3d9a04af9"),
    "nonsmooth orbit": (5, "b0eb09cdf822"),
    "nonsmooth sweep": (4, "62878b5e297a"),
}
# of motions and charts, which have no schema of their own: what files hold beside numbers
MOTION = (
    *("format", "version", "package", "system", "tables", "derivation", "parameters", "states"),
    *("status", "end", "options", "open_at", "grazings", "sha256"),
)

CHART = (
    *("format", "kind", "orbit", "system", "derivation", "table", "kernels", "anchors"),
    *("parameters", "dimensions", "grid", "chunk", "version", "held", "arrays", "sha256"),
)


def unordered(entry):
    """A schema whose names of required entries are sorted, as the order of entries says nothing."""
    if isinstance(entry, list):
        return [unordered(part) for part in entry]
    if not isinstance(entry, dict):
        return entry
    found = {name: unordered(part) for name, part in entry.items()}
    return found | {n: sorted(part) for n, part in found.items() if n == "required" and part}


def digest(schema):
    """A hash of the names and types of all entries."""
    entries = {name: x for name, x in schema.items() if name not in ("title", "description")}
    return sha256(json.dumps(unordered(entries), sort_keys=True).encode()).hexdigest()[:12]


def test_a_format_of_other_entries_has_another_version():
    found = {
        name: (schema["properties"]["version"]["const"], digest(schema))
        for name, schema in file_schemas().items()
    }
    assert found == KNOWN


def test_a_motion_or_chart_of_other_entries_has_another_version(tmp_path):
    ns.simulate("rigid-stop", TWO_MASSES, [0, 0, 1.5, 0], transitions=2).save(tmp_path / "m.csv")
    lines = (tmp_path / "m.csv").read_text().splitlines()
    header = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
    assert (header["version"], sorted(header)) == ("5", sorted(MOTION))
    ns.chart("dry-friction/global-stick", V=[0.9, 1.0], store=tmp_path / "c.zarr")
    told = json.loads((tmp_path / "c.zarr" / "zarr.json").read_text())["attributes"]["nonsmooth"]
    assert (told["format"], sorted(told)) == ("nonsmooth chart 5", sorted(CHART))
    assert sorted(told["held"]) == ["given", "of"]


@pytest.mark.parametrize("kind", KINDS)
def test_files_are_as_their_schemas_say(kind):
    schema = file_schemas()[kind]
    Draft202012Validator.check_schema(schema)
    checked, content = Draft202012Validator(schema), json.loads(text_of(kind))
    assert not list(checked.iter_errors(content))
    for other in misshapen(content):
        assert not checked.is_valid(other)


def misshapen(content):
    """Content without an entry, with one more, and with each entry of another type."""
    yield {**content, "unheard": 0}
    for name in content:
        if name == "request":
            continue
        other = copy.deepcopy(content)
        other[name] = [[other[name]]]
        yield other
        if name not in ("derivatives", "directions", "no_derivatives", "cones"):
            yield {entry: content[entry] for entry in content if entry != name}
