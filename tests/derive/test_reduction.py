"""Reduced structures against the whole ones and closed forms; files of matrices; bad input."""

import gzip
import zipfile

import numpy as np
import pytest
import scipy.io
import scipy.sparse
from numpy.testing import assert_allclose
from scipy.linalg import eigh
from scipy.sparse.linalg import spsolve

from nonsmooth.derive import DeclarationError, oscillator, read_matrices, reduce_structure
from tests.beams import beam, cantilever

METHODS = ("craig-bampton", "free-interface")


def frequencies(mass, stiffness):
    return np.sqrt(np.maximum(eigh(stiffness.toarray(), mass.toarray(), eigvals_only=True), 0))


def grid(side):
    """A membrane of springs on a square grid, its edge fixed: mass and stiffness, sparse."""
    line = scipy.sparse.diags_array([2.0, -1.0, -1.0], offsets=[0, 1, -1], shape=(side, side))
    eye = scipy.sparse.eye_array(side)
    stiffness = scipy.sparse.kron(line, eye) + scipy.sparse.kron(eye, line)
    return scipy.sparse.eye_array(side**2).tocsc(), stiffness.tocsc()


@pytest.mark.parametrize("method", METHODS)
def test_frequencies_well_below_the_cutoff_are_those_of_the_whole(method):
    mass, stiffness = cantilever(30)
    whole = frequencies(mass, stiffness)
    reduced = reduce_structure(mass, stiffness, keep=[28, 58], modes=8, method=method)
    below = whole[whole < 0.5 * reduced.cutoff]
    assert len(below) >= 6
    # free modes are those of the whole structure
    error = 5e-3 if method == "craig-bampton" else 1e-7
    assert_allclose(reduced.frequencies[: len(below)], below, rtol=error)
    # Rayleigh's principle: a reduction only stiffens
    assert (reduced.frequencies >= whole[: len(reduced.frequencies)] * (1 - 1e-6)).all()


def test_the_cutoff_is_the_first_mode_left_out():
    mass, stiffness = cantilever(20)
    tip = mass.shape[0] - 2
    held = np.delete(np.arange(tip + 2), tip)
    fixed = frequencies(mass[held][:, held], stiffness[held][:, held])
    reduced = reduce_structure(mass, stiffness, keep=[tip], modes=3)
    assert reduced.cutoff == pytest.approx(fixed[3], rel=1e-9)
    free = reduce_structure(mass, stiffness, keep=[tip], modes=3, method="free-interface")
    whole = frequencies(mass, stiffness)
    assert free.cutoff == pytest.approx(whole[3], rel=1e-9)
    every = reduce_structure(mass, stiffness, keep=[tip], modes=39)
    assert_allclose(every.frequencies, whole, rtol=1e-6)
    assert every.cutoff == np.inf


@pytest.mark.parametrize("method", METHODS)
def test_static_answers_at_kept_coordinates_are_exact(method):
    mass, stiffness = cantilever(25)
    keep = [12, 48]
    reduced = reduce_structure(mass, stiffness, keep=keep, modes=2, method=method)
    force = np.zeros(50)
    force[keep] = [1.0, -0.4]
    wanted = spsolve(stiffness, force)
    answer = np.linalg.solve(reduced.stiffness, reduced.transformation.T @ force)
    assert_allclose(reduced.transformation @ answer, wanted, rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sparse", [True, False])
def test_matrices_are_those_of_the_transformation(method, sparse):
    mass, stiffness = grid(6)
    damping = 0.01 * mass + 0.02 * stiffness
    given = (mass, stiffness, damping)
    if not sparse:
        given = tuple(m.toarray() for m in given)
    reduced = reduce_structure(*given, keep=[7, 20], modes=4, method=method)
    basis = reduced.transformation
    found = reduced.mass, reduced.stiffness, reduced.damping
    for one, matrix in zip(found, (mass, stiffness, damping), strict=True):
        assert (one == one.T).all()
        assert_allclose(one, basis.T @ (matrix @ basis), atol=1e-11)
    assert (basis[[7, 20]] == np.eye(2, 6)).all()
    if method == "craig-bampton":  # what is kept shares the mass of modes, and no stiffness
        other = reduce_structure(*given[:2], 0.02 * given[1], keep=[7, 20], modes=4)
        assert (reduced.stiffness[:2, 2:] == 0).all()
        assert (other.damping[:2, 2:] == 0).all()
        assert (reduced.mass[2:, 2:] == np.eye(4)).all()
        assert (reduced.mass[:2, 2:] != 0).any()


def test_a_free_beam_moves_as_a_rigid_body():
    mass, stiffness = beam(20)
    reduced = reduce_structure(mass, stiffness, keep=[0, 40], modes=5, method="free-interface")
    whole = frequencies(mass, stiffness)
    assert_allclose(reduced.frequencies[2:5], whole[2:5], rtol=1e-4)
    assert (reduced.frequencies[:2] < 1e-3).all()
    truncated = reduce_structure(mass, stiffness, keep=[], modes=5, method="free-interface")
    assert truncated.coordinates == ("q1", "q2", "q3", "q4", "q5")
    with pytest.raises(DeclarationError, match="not positive definite where all kept"):
        reduce_structure(mass, stiffness, keep=[0], modes=2)


def test_large_sparse_structures_go_by_lanczos(monkeypatch):
    mass, stiffness = grid(18)
    dense = reduce_structure(mass, stiffness, keep=[100], modes=6)
    monkeypatch.setattr("nonsmooth.derive.building.structure_matrices._DENSE", 50)
    lanczos = reduce_structure(mass, stiffness, keep=[100], modes=6)
    assert_allclose(lanczos.frequencies, dense.frequencies, rtol=1e-9)
    assert lanczos.cutoff == pytest.approx(dense.cutoff, rel=1e-9)
    again = reduce_structure(mass, stiffness, keep=[100], modes=6)
    assert (again.transformation == lanczos.transformation).all()


def test_directions_of_the_whole_structure_carry_over():
    mass, stiffness = cantilever(4)
    names = [f"{what}{node}" for node in range(1, 5) for what in ("y", "slope")]
    reduced = reduce_structure(mass, stiffness, keep=["y4"], modes=2, coordinates=names)
    assert reduced.coordinates == ("y4", "q1", "q2")
    assert reduced.direction("y4") == reduced.direction(6) == {"y4": 1.0}
    weights = np.arange(8.0)
    found = reduced.direction(weights)
    assert_allclose(list(found.values()), weights @ reduced.transformation)
    assert reduced.direction({"y1": 2, 2: -1}) == reduced.direction([2, 0, -1, 0, 0, 0, 0, 0])
    system = oscillator(
        "beam", reduced.coordinates, reduced.mass, reduced.stiffness, reduced.damping
    )
    assert len(system.states) == 6


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"mass": np.ones((2, 3))}, "mass is not square: its shape is (2, 3)"),
        ({"mass": np.ones(3)}, "mass is not square: its shape is (3,)"),
        ({"mass": np.zeros((0, 0))}, "mass is empty"),
        ({"mass": 1j * np.eye(3)}, "mass is complex"),
        ({"mass": [[1], [1, 2]]}, "mass is no matrix of real numbers"),
        ({"mass": [["a"]]}, "mass is no matrix of real numbers"),
        ({"stiffness": np.eye(2)}, "stiffness is 2 x 2, where mass is 3 x 3"),
        ({"damping": np.eye(4)}, "damping is 4 x 4, where mass is 3 x 3"),
        ({"stiffness": np.diag([1, np.nan, 1])}, "stiffness holds an entry that is not finite"),
        ({"stiffness": np.eye(3, k=1) + np.eye(3)}, "stiffness is not symmetric"),
        ({"mass": np.diag([1, -1, 1])}, "mass is not positive definite"),
        ({"keep": [], "modes": 0}, "the reduction keeps nothing: no coordinate and no mode"),
        ({"keep": 0}, "keep is 0, not a row of places or names of coordinates"),
        ({"keep": "x1"}, "keep is 'x1', not a row of places or names of coordinates"),
        ({"keep": ["z"]}, "keep: unknown coordinate 'z'"),
        ({"keep": [3]}, "keep: there is no coordinate 3 of 3"),
        ({"keep": [-1]}, "keep: there is no coordinate -1 of 3"),
        ({"keep": [1.5]}, "keep: 1.5 is neither a place nor a name of a coordinate"),
        ({"keep": [1, "x1"]}, "kept coordinate 'x1' is declared twice"),
        ({"modes": 3}, "modes is 3, but beside 1 kept of 3 coordinates there are 2"),
        ({"modes": -1}, "modes is -1, not a number of modes"),
        ({"modes": 1.0}, "modes is 1.0, not a number of modes"),
        ({"coordinates": ["a"]}, "there are 1 names for 3 coordinates"),
        ({"coordinates": ["a", "b", "a"]}, "coordinate 'a' is declared twice"),
        ({"coordinates": ["q1", "b", "c"]}, "reduced coordinate 'q1' is declared twice"),
        ({"method": "guyan"}, "method is 'guyan', not 'craig-bampton' or 'free-interface'"),
    ],
)
def test_bad_input_is_one_line(change, message):
    given = {"mass": np.eye(3), "stiffness": 2 * np.eye(3), "keep": [0], "modes": 1}
    given |= change
    with pytest.raises(DeclarationError) as caught:
        reduce_structure(given.pop("mass"), given.pop("stiffness"), **given)
    assert str(caught.value) == message


def test_bad_directions_are_one_line():
    reduced = reduce_structure(np.eye(3), 2 * np.eye(3), keep=[0], modes=1)
    for direction, message in (
        ("z", "direction: unknown coordinate 'z'"),
        ([1, 2], "direction has shape (2,) where the structure has 3 coordinates"),
        ([1, 2, np.nan], "direction holds a weight that is not finite"),
    ):
        with pytest.raises(DeclarationError) as caught:
            reduced.direction(direction)
        assert str(caught.value) == message


def test_files_of_matrices(tmp_path):
    mass, stiffness = cantilever(3)
    scipy.io.mmwrite(tmp_path / "K.mtx", stiffness)
    scipy.io.savemat(tmp_path / "model.mat", {"M": mass, "K": stiffness.toarray(), "note": "x"})
    np.savez(tmp_path / "model.npz", M=mass.toarray(), K=stiffness.toarray(), tip=np.ones(6))
    scipy.sparse.save_npz(tmp_path / "stiff.npz", stiffness)
    wanted = stiffness.toarray()
    for name, key in (
        ("K.mtx", "K"),
        ("model.mat", "K"),
        ("model.npz", "K"),
        ("stiff.npz", "stiff"),
    ):
        found = read_matrices(tmp_path / name)
        matrix = found[key]
        dense = matrix if isinstance(matrix, np.ndarray) else matrix.toarray()
        assert_allclose(dense, wanted, rtol=1e-15)
    assert sorted(read_matrices(tmp_path / "model.mat")) == ["K", "M"]
    assert sorted(read_matrices(tmp_path / "model.npz")) == ["K", "M"]
    np.savez(tmp_path / "complex.npz", M=np.eye(2), K=(1 + 0.1j) * np.eye(2))
    damped = read_matrices(tmp_path / "complex.npz")
    with pytest.raises(DeclarationError, match="stiffness is complex"):
        reduce_structure(damped["M"], damped["K"], keep=[0], modes=1)


def test_bad_files_are_one_line(tmp_path):
    def message(name):
        with pytest.raises(DeclarationError) as caught:
            read_matrices(tmp_path / name)
        assert "\n" not in str(caught.value)
        return str(caught.value).removeprefix(f"{tmp_path / name}: ")

    assert message("none.mtx") == "no such file"
    assert message("matrix.csv") == "not a file of matrices (.mtx, .npz, .mat)"
    for name in ("bad.mtx", "bad.npz", "bad.mat"):
        (tmp_path / name).write_bytes(b"not a matrix")
        assert message(name).startswith("cannot be read: ")
    np.savez(tmp_path / "objects.npz", M=np.array([[None]]))
    assert message("objects.npz").startswith("cannot be read: ")
    np.savez(tmp_path / "empty.npz", v=np.ones(3))
    assert message("empty.npz") == "holds no matrix"


def test_what_a_small_file_unpacks_to_is_bounded(tmp_path, monkeypatch):
    monkeypatch.setattr("nonsmooth.derive.building.matrices._SMALL", 1 << 20)
    names = ("large.npz", "large.mat", "large.mtx.gz")
    zeros = {"K": np.zeros((1000, 1000))}
    np.savez_compressed(tmp_path / names[0], **zeros)
    scipy.io.savemat(tmp_path / names[1], zeros, do_compression=True)
    scipy.io.mmwrite(tmp_path / "large.mtx", zeros["K"])
    (tmp_path / names[2]).write_bytes(gzip.compress((tmp_path / "large.mtx").read_bytes()))
    with zipfile.ZipFile(tmp_path / "told.npz", "w") as file:  # its header says what is not there
        header = {"descr": "<f8", "fortran_order": False, "shape": (30_000, 30_000)}
        with file.open("K.npy", "w") as entry:
            np.lib.format.write_array_header_1_0(entry, header)
    np.savez_compressed(tmp_path / "small.npz", K=np.eye(300))
    scipy.sparse.save_npz(tmp_path / "wide.npz", scipy.sparse.eye_array(20_000).tocsc())
    for name in ("small.npz", "wide.npz"):
        assert read_matrices(tmp_path / name)
    for name in (*names, "told.npz"):
        with pytest.raises(DeclarationError, match=r"take [\d.e+]+ MB or more, packed .*sparse"):
            read_matrices(tmp_path / name)
