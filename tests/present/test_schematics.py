"""The paper's schematics: what they show, where it lies, and that files do not change."""

import re
from itertools import combinations, product

import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.path import Path as Outline
from matplotlib.text import Text
from matplotlib.transforms import Bbox

STOP, BELT, SECTIONS = "figure-01", "figure-06", "figure-11"
LABELS = {
    STOP: ["m1", "m2", "k1", "k2", "k3", "x1", "x2", "1"],
    BELT: ["m1", "m2", "k1", "k2", "x1", "x2", "F1", "F2", "V"],
    SECTIONS: [
        *(
            "Sigma0=Sigman",
            "Sigma1",
            "Sigmak-1",
            "Sigmak",
            "Sigman-1",
            "Phi1",
            "Phik",
            "Phin",
            "vdots",
            "vdots",
        ),
        *("P1", "Pk", "Pn", "P=PncirccdotscircP1", "Z", "P(Z)", "Z0"),
        *("periodicorbit", "neighbouringtrajectory"),
    ],
}


@pytest.fixture(params=LABELS)
def stem(request):
    """The name of each schematic."""
    return str(request.param)


@pytest.fixture
def figure(stem, paper):
    """Each schematic."""
    return paper.figures[stem]


def drawn(figure):
    """All artists of the one Axes, without its own frame."""
    FigureCanvasAgg(figure)
    figure.canvas.draw()
    (axes,) = figure.axes
    assert axes.get_position().bounds == (0, 0, 1, 1)
    assert not axes.axison
    return [*axes.lines, *axes.patches, *axes.texts, *axes.collections]


def texts(figure):
    """Boxes of the labels, in pixels."""
    return {
        f"{number} {artist.get_text()}": artist.get_window_extent()
        for number, artist in enumerate(drawn(figure))
        if isinstance(artist, Text)
    }


def place(figure, label):
    """Where the one label with that text is."""
    (text,) = [text for text in figure.axes[0].texts if text.get_text() == f"${label}$"]
    return np.array(text.get_position())


def strokes(artist):
    """Lines and edges of an artist, in pixels."""
    path = artist.get_transform().transform_path(artist.get_path())
    return [Outline(points) for points in path.to_polygons(closed_only=False)]


# --- files


@pytest.mark.parametrize("ending", ["svg", "png"])
def test_the_same_schematic_has_the_same_bytes(stem, ending, paper):
    first = (paper.folder / f"{stem}.{ending}").read_bytes()
    assert first.startswith({"svg": b"<?xml", "png": b"\x89PNG"}[ending])
    assert paper.again[f"{stem}.{ending}"] == first


def test_the_labels_are_those_of_the_paper(stem, figure):
    found = [re.sub(r"[$_{}\\ ]", "", text.get_text()) for text in figure.axes[0].texts]
    assert sorted(found) == sorted(LABELS[stem])


def test_the_paper_is_white_and_pyplot_knows_nothing(stem, paper):
    """Though who draws it has black paper."""
    assert not pyplot.get_fignums()
    pixels = pyplot.imread(paper.folder / f"{stem}.png")
    assert (pixels[[0, 0, -1, -1], [0, -1, 0, -1]] == 1).all()
    assert all(text.get_color() == "black" for text in paper.figures[stem].axes[0].texts)


# --- where it lies


def test_everything_lies_inside_the_figure(figure):
    for artist in drawn(figure):
        box = artist.get_window_extent()
        assert box.width + box.height > 0
        assert np.all(np.array(box.min) >= 0), artist
        assert np.all(np.array(box.max) <= np.array(figure.bbox.max)), artist


def test_no_label_overlaps_another(stem, figure):
    boxes = texts(figure)
    assert len(boxes) == len(LABELS[stem])
    for (one, first), (other, second) in combinations(boxes.items(), 2):
        assert Bbox.intersection(first, second) is None, (one, other)


def test_no_line_crosses_a_label(figure):
    boxes = texts(figure)
    lines, patches = figure.axes[0].lines, figure.axes[0].patches
    dots = [line for line in lines if line.get_linestyle() == "None"]
    edges = [*(line for line in lines if line not in dots), *patches]
    for edge in edges:
        for stroke, (label, box) in product(strokes(edge), boxes.items()):
            assert not stroke.intersects_bbox(box, filled=False), (label, edge)
    for line, (label, box) in product(dots, boxes.items()):
        points = line.get_transform().transform(line.get_xydata())
        assert not box.padded(line.get_markersize()).count_contains(points), label


# --- what it shows


@pytest.mark.parametrize(
    ("stem", "labels"),
    [(STOP, ("k_2", "m_2", "k_1", "m_1", "1", "k_3")), (BELT, ("k_1", "m_1", "k_2", "m_2"))],
)
def test_masses_springs_and_the_stop_stand_in_a_row(labels, figure):
    """The second mass is tied to the ground before the stop, and the first one on the belt."""
    assert (np.diff([place(figure, label)[0] for label in labels]) > 0).all()


def test_forces_act_between_the_belt_and_the_masses(paper):
    figure = paper.figures[BELT]
    for number in (1, 2):
        force, mass = place(figure, f"F_{number}"), place(figure, f"m_{number}")
        assert place(figure, "V")[1] < force[1] < mass[1]


@pytest.mark.parametrize("stem", [STOP, BELT])
def test_each_coordinate_is_above_its_mass(figure):
    for number in (1, 2):
        across, up = place(figure, f"x_{number}") - place(figure, f"m_{number}")
        assert 0 < across < up + 0.1


def test_the_trajectory_returns_nearer_to_the_periodic_orbit(paper):
    figure = paper.figures[SECTIONS]
    curves = [line for line in figure.axes[0].lines if line.get_marker() == "o"]
    trajectory, orbit = (np.array(curve.get_xydata()) for curve in curves)
    assert len(orbit) == 5
    assert len(trajectory) == 6
    start, image = np.linalg.norm(trajectory[[0, -1]] - orbit[0], axis=1)
    assert 0.1 < image < 0.6 * start


def test_the_configurations_and_their_maps_follow_the_clock(paper):
    figure = paper.figures[SECTIONS]
    middle = place(figure, r"P = P_n \circ \cdots \circ P_1")
    order = [r"\Sigma_1", r"\Sigma_{k{-}1}", r"\Phi_k", r"\Sigma_k", r"\Sigma_{n{-}1}", r"\Phi_n"]
    for labels in (
        [r"\Phi_1", *order],
        ["P_1", *order[:2], "P_k", *order[3:5], "P_n"],
    ):
        across, up = np.transpose([place(figure, label) - middle for label in labels])
        assert (np.diff(np.arctan2(across, up) % (2 * np.pi)) > 0).all()
