"""Wrong input is one line on stderr, and in JSON: nothing is answered, shown, or written."""

import shlex
import shutil

import pytest

from tests.cli.test_cli import refused_alike
from tests.places import GALLERY

STICK, SYMMETRIC, RIGID = "dry-friction/global-stick", "dry-friction/symmetric", "rigid-stop"
REST = "--from x1=0,x2=0,v1=0,v2=0"
FIXED = "chi=0.5 eta=1 us1=1 us2=1 ur1=4.0195 ur2=1.4831"
FRICTION = f"dry-friction {FIXED} V=1"
STRUCK = f"simulate {RIGID} m1=1 m2=2 k1=1 k2=5 r=0.8"
SAVED = "--from x1=0,x2=0.5,v1=1,v2=0 --transitions 6 --save o.npz --plot o.png"
SIMULATE = f"simulate {FRICTION} {REST}"
FIND = f"find {FRICTION} --starts 3 --transitions 60"
SWEEP = f"sweep dry-friction {FIXED} V=0.95:1.05:3"
SWEPT = f"{SWEEP} --quantity x1 --at slip-stick"
FOLLOW = f"continue {STICK} V=0.99:1.01"
CHART = f"chart {STICK} V=0.9:1.1:3 --out c.zarr"
BOX, BRANCH = f"certify box {STICK} V=0.99:1.01", f"certify branch {SYMMETRIC} V=0.9:1.2"
DESIGN = f"design {SYMMETRIC} V=0.6:1.3"
FIT = "fit identification.py impacts.csv c=0.05 h=0.2 w=2.1 k=2.3:2.7 r=0.7:1 --from x=-0.6,v=0.1"
# of commands, and what each is told
ORBITS = [
    ("dry-friction/global-stik", "did you mean 'dry-friction/global-stick'?"),
    (f"{STICK} chi=1.2", "chi = 1.2"),
    (f"{STICK} V=nan", "V: 'nan'"),
    (f"{STICK} eta", "'eta' is not of the form name=value"),
    (f"{STICK} eta=", "'eta=' is not of the form name=value"),
    (f"{STICK} eta=1 eta=1", "parameter eta is given twice"),
    (f"{STICK} --digits 0", "digits = 0"),
    (f"{STICK} --digits {10**9}", f"digits = {10**9}"),
    (f"{STICK} --guess tau", "'tau' is not of the form name=value"),
    (f"{STICK} --guess tau=nan", "tau: 'nan'"),
    (f"{STICK} --guess tau=2,tau=2", "unknown tau is given twice"),
    (f"{STICK} --unknown e1", "as many of one as of the other"),
    (f"{STICK} --unknown e1,e2 --given ta=1,ta=2", "unknown ta is given twice"),
    ("rigid-stop/one-impact T=1e6", "more than 100000 radians of its fastest oscillation"),
    ("dry-friction/solution-ii --unknown V --given ta=0", "'ta'; did you mean 'tau'?"),
]
WRONG = [
    *((f"{command} {words}", part) for words, part in ORBITS for command in ("solve", "verify")),
    (f"solve {STICK} --derivatives W", "unknown given parameter 'W'"),
    # equations
    ("equations dry-frictoin", "unknown system 'dry-frictoin'; did you mean 'dry-friction'?"),
    ("equations dry-friction/", "unknown orbit 'dry-friction/'"),
    ("equations dry-friction/global-stik", "did you mean 'dry-friction/global-stick'?"),
    ("equations found.json:1", "`nonsmooth find FILE.py ... --write FILE.py`"),
    ("regenerate dry-fricton", "did you mean 'dry-friction'?"),
    # simulate
    (f"{SIMULATE} --until 5 V=nan", "V: 'nan'"),
    (f"{SIMULATE} --until 5 V=1", "parameter V is given twice"),
    (f"simulate {FRICTION} --until 5 --from x1=nan", "x1: 'nan'"),
    (f"simulate {FRICTION} --until 5 --from x1", "'x1' is not of the form name=value"),
    (f"{SIMULATE},x1=0 --until 5", "state x1 is given twice"),
    (f"simulate {FRICTION} --until 5", f"the start is missing, such as {REST}"),
    (f"{SIMULATE} --transitions 0", "transitions = 0"),
    (SIMULATE, "nothing ends the motion"),
    (f"{SIMULATE} --until nan", "'nan'"),
    (f"{SIMULATE} --until 5 --in stick-stick", "v1 - 1 is -1 there, not 0"),
    (f"{SIMULATE} --until 5 --save m.txt", "m.txt does not end in .npz, .csv"),
    (f"{SIMULATE} --until 5 --plot m.gif", "m.gif does not end in .png, .svg, .pdf"),
    (f"{SIMULATE} --until 5 --observe --since 6", "since = 6.0"),
    (f"{SIMULATE.replace('v2=0', 'v2=sqrt(2)')} --prove --until 5", "not rational: no proof"),
    (
        f"{STRUCK} --from x1=2,x2=0,v1=1,v2=0 --until 5",
        "beyond first-reaches-stop, x1 - 1 is 1 > 0",
    ),
    (f"{STRUCK} {SAVED} --derivatives WRONG", "unknown parameter or start 'WRONG'"),
    (f"{STRUCK} {SAVED} --derivatives k1,x10,foo", "foo"),
    (f"{STRUCK} {SAVED} --observe --since soon", "soon"),
    (f"{STRUCK} {SAVED.replace('0.5', 'sqrt(2)')} --prove", "x2"),
    # find
    (f"{FIND} --transitions 1", "transitions = 1"),
    (f"{FIND} --seed -1", "-1 is no seed"),
    (f"{FIND} x1=2:1", "box of x1: 2.0 to 1.0 is no interval"),
    (f"{FIND} x1=nan:1", "'nan'"),
    (f"{FIND} z1=0:1", "unknown state 'z1'"),
    (f"{FIND} x1=0:1:5", "'x1=0:1:5' is not NAME=A:B"),
    (f"{FIND} x1=0:1 x1=0:1", "parameter x1 is given twice"),
    (f"{FIND} V=2", "parameter V is given twice"),
    (f"{FIND} z=16..30", "z: '16..30' is no number; a range, where one is taken, is 16:30"),
    (f"{FIND} --starts -3", "--starts takes an integer from 1 on"),
    (f"{FIND} --overwrite", "--overwrite"),
    (f"{FIND} --n 20", "no such option: --n; nonsmooth find --help"),
    # sweep
    (f"{SWEPT.replace('0.95:1.05:3', '1')} {REST}", "has to be a range A:B:N, not 0"),
    (f"{SWEPT.replace('chi=0.5', 'chi=0.4:0.6:3')} {REST}", "has to be a range A:B:N, not 2"),
    (f"{SWEPT.replace(':3', '')} {REST}", "is not NAME=A:B:N"),
    (f"{SWEPT.replace(':3', ':0')} {REST}", "values of V"),
    (f"{SWEPT.replace('0.95', 'nan')} {REST}", "'nan'"),
    (f"{SWEPT} V=1 {REST}", "parameter V is given twice"),
    (f"{SWEEP} --at slip-stick {REST}", "--quantity is missing"),
    (f"{SWEEP} --quantity x1 {REST}", "--at is missing"),
    (f"{SWEEP} {REST}", "--quantity and --at are missing"),
    (SWEPT, f"the start is missing, such as {REST}"),
    (f"{SWEPT} {REST} --plot d.gif", "d.gif does not end in .png, .svg, .pdf"),
    (f"solve {STICK} --samples 3", "; it is one of nonsmooth sweep"),
    # continue
    (f"continue {STICK} eta=1", "one parameter has to be a range"),
    (f"{FOLLOW} eta=1:2", "one parameter has to be a range"),
    (f"{FOLLOW} V=1", "parameter V is given twice"),
    (f"{FOLLOW}:5", "is not NAME=A:B"),
    (f"{FOLLOW} --from V=1.5", "is not in 0.99 to 1.01"),
    (f"{FOLLOW} --from eta=1", "--from is for parameters with a range, which eta has not"),
    (f"{FOLLOW} --plot branch.txt", "does not end in"),
    (f"{FOLLOW} --quantity trace", "--quantity"),
    (f"{FOLLOW} --over energy", "--over"),
    (f"{FOLLOW} --plot a.png --quantity speed", "'speed'"),
    (f"{FOLLOW} --plot a.png --over speed", "'speed'"),
    (f"{FOLLOW} eta=0.9:1.1 --follow flip --plot a.png --quantity trace", "--quantity"),
    (f"{FOLLOW} --overwrite", "--overwrite"),
    # chart
    (f"chart {RIGID} r=0.5:0.9:3 --out F.zarr", f"such as {REST}"),
    (f"{CHART} --transitions 300", "--transitions"),
    (f"{CHART} --workers 1 --scheduler tcp://127.0.0.1:1", "--workers"),
    # certify
    ("certify orbit", "missing argument"),
    (f"certify bx {STICK}", "Did you mean 'box'"),
    (f"certify {STICK} --digits 0", "an integer from 1 on"),
    (f"certify {STICK} eta=0", "eta"),
    (f"certify {STICK} etta=1", "did you mean"),
    (f"certify {STICK} --derivatives W", "unknown given parameter 'W'"),
    (f"certify {STICK} --derivatives us1", "unknown given parameter 'us1'"),
    (f"certify {STICK} --derivatives ''", "--derivatives: no parameter is named"),
    (f"certify {STICK} --derivatives ,", "--derivatives: no parameter is named"),
    (f"certify {STICK} V=0.99:1.01", "`certify box`"),
    (f"certify {STICK} --save .", "it is a folder"),
    (f"certify {STICK} --overwrite", "--overwrite"),
    (f"certify {STICK} --tiles 3", "--tiles"),
    ("certify check nowhere.json", "nowhere.json"),
    ("certify check a.json --tiles 3", "--tiles"),
    ("certify box --branch", "--branch"),
    (f"{BOX} --digits 30", "no such option"),
    (f"{BOX}:5", "NAME=A:B"),
    (f"{BOX} V=1", "given twice"),
    (f"{BOX} V=0.9:1.1", "given twice"),
    (f"{BOX} etta=0.99:1.01", "did you mean"),
    (f"{BOX} --plot x.bmp", "x.bmp"),
    (f"{BOX} --tiles 0", "tiles = 0"),
    (f"{BOX} --resume nowhere.json", "nowhere.json"),
    (f"certify box {STICK} V=1", "no parameter has a range"),
    (f"certify box {STICK} V=1.01:0.99", "below the upper"),
    (f"certify box {STICK} V=0.99:sqrt(2)", "rational"),
    (f"certify branch {SYMMETRIC}", "one parameter has to be a range"),
    (f"{BRANCH} eta=0.9:1.1", "one parameter has to be a range"),
    (f"{BRANCH} --digits 30", "no such option"),
    (f"{BRANCH} speed=3 --tiles 0", "not an integer from 1"),  # before it is followed
    (f"certify doubling {SYMMETRIC} V=1.08", "one parameter has to be a range"),
    (f"certify doubling {SYMMETRIC} V=1.2:1.3", "has no flips"),
    (f"certify event {STICK} V=1", "has to be a range"),
    (f"certify event {STICK} V=0.9:1.1 eta=0.9:1.1", "has to be a range"),
    # design
    (f"design {SYMMETRIC} V=1 --minimise period", "no parameter varies: give its bounds"),
    (DESIGN, "one of minimise, maximise and solve is given, not 0"),
    (f"{DESIGN} V=1 --minimise period", "parameter V is given twice"),
    (f"{DESIGN} --minimise perid", "did you mean 'period'"),
    (f"design {SYMMETRIC} us1=0.6:1.3 --minimise period", "depends on us1"),
    (f"{DESIGN} --solve period=4 --solve trace=1", "2 wanted values for 1"),
    (f"{DESIGN} --minimise period --overwrite", "--overwrite is for the file"),
    (f"{DESIGN} --minimise period --worst-over V=1:2", "V varies: it cannot"),
    # fit
    (FIT.replace("impacts.csv ", ""), "data are missing: name a file"),
    (FIT.replace("impacts.csv", "other.csv"), "other.csv"),
    (f"{FIT} data.txt", "'data.txt' is neither NAME=VALUE nor"),
    (FIT.replace("k=2.3:2.7", "k=2.7:2.3"), "the bounds of k, 2.7 and 2.3, are not in order"),
    (FIT.replace("k=2.3:2.7", "k=1:2:3:4"), "is not NAME=A:B or NAME=A:GUESS:B"),
    (FIT.replace(" h=0.2", ""), "needs a value for: h"),
    (f"{FIT} k=2", "parameter k is given twice"),
    (f"{FIT} --prior k=3", "the prior k=3 is not NAME=MEAN+-SIGMA"),
    (f"{FIT} --prior c=3+-1", "c has bounds or a prior, and is not free"),
    (f"{FIT} --sigma 0", "the sigma of wall-reaches-stop is not positive"),
    (f"{FIT} --events door", "unknown event 'door'"),
    (f"{FIT} --responses wall-reaches-stop=size:x", "unknown kind of response 'size'"),
    (f"{FIT} --loss other", "unknown loss 'other'; did you mean"),
    (f"{FIT} --starts 0", "--starts takes an integer"),
    (f"{FIT} --starts 4294967296", "4294967296 starts take at least"),
    (f"{FIT} --plot fit.txt", "does not end in"),
    (f"{FIT} c10=0:1", "c10 belongs to the forcing: free the offset of the clock instead"),
    (FIT.replace(" w=2.1", " w=0.01"), "there is no fit from the guess"),
]
USAGE = [
    *("solv", "simulate", "find", f"simulate {RIGID} --transitions many", "solve", "plot"),
    *(f"solve {STICK} --digits many", f"solve {STICK} --require proved"),
    *("plot orbit.json --kind phases", f"solve {STICK} --digts 3"),
    "equations dry-friction --format word",
]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder with what the fits take."""
    for name in ("identification.py", "impacts.csv"):
        shutil.copy(GALLERY / name, tmp_path)
    monkeypatch.setenv("NONSMOOTH_CACHE", "")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    ("command", "part"), [*WRONG, *((words, " --help shows the usage") for words in USAGE)]
)
def test_wrong_input_is_2_with_one_line(command, part, folder):
    before = sorted(folder.iterdir())
    assert part in refused_alike(*shlex.split(command))
    assert sorted(folder.iterdir()) == before
